#include "import/common/description_nodes.hpp"

#include <utility>

#include "import/common/described.hpp"
#include "import/common/fit_names.hpp"
#include "import/common/snapped_angle.hpp"

namespace alembert {

YamlNode& DescriptionNodes::make(YamlNode::Kind kind, const SourceLocation& where) {
  YamlNode& node = nodes_.emplace_back();
  node.kind = kind;
  node.plain = true;
  const auto place = places_.find(where.source.get());
  const SourceLocation& at = place == places_.end() ? where : place->second;
  node.line = at.line;
  node.column = at.column;
  return node;
}

const YamlNode& DescriptionNodes::text(std::string value, const SourceLocation& where) {
  YamlNode& node = make(YamlNode::Kind::scalar, where);
  node.text = std::move(value);
  return node;
}

const YamlNode& DescriptionNodes::list(std::initializer_list<std::string> values,
                                       const SourceLocation& where) {
  YamlNode& node = sequence(where);
  for (const std::string& value : values) node.items.push_back(&text(value, where));
  return node;
}

const YamlNode& DescriptionNodes::numbers(const std::array<double, 3>& values, const SourceLocation& where) {
  return list({number_text(values[0]), number_text(values[1]), number_text(values[2])}, where);
}

void DescriptionNodes::put(YamlNode& mapping, std::string key, const YamlNode& value) {
  mapping.items.push_back(&text(std::move(key), {nullptr, value.line, value.column}));
  mapping.items.push_back(&value);
}

YamlNode& DescriptionNodes::add_named(YamlNode& list, std::string name, const SourceLocation& where) {
  YamlNode& node = mapping(where);
  put(node, "name", text(std::move(name), where));
  list.items.push_back(&node);
  return node;
}

void DescriptionNodes::put_friction(YamlNode& coordinate, double force, const SourceLocation& where) {
  YamlNode& friction = mapping(where);
  put(friction, "force", text(number_text(force), where));
  put(friction, "velocity", text(number_text(kFrictionVelocity), where));
  put(coordinate, "friction", friction);
}

void DescriptionNodes::add_holonomic(YamlNode& list, std::string name,
                                     const std::vector<std::string>& equations, const SourceLocation& where) {
  YamlNode& node = add_named(list, std::move(name), where);
  put(node, "type", text("holonomic", where));
  YamlNode& rows = sequence(where);
  for (const std::string& equation : equations) rows.items.push_back(&text(equation, where));
  put(node, "equations", rows);
}

YamlNode& DescriptionNodes::root(const std::string& name, std::string description,
                                 const SourceLocation& where) {
  YamlNode& out = mapping(where);
  put(out, "alembert", text("1", where));
  put(out, "name", text(fit_mechanism_name(name), where));
  put(out, "description", text(std::move(description), where));
  return out;
}

const YamlNode& DescriptionNodes::single(std::string key, const YamlNode& value) {
  YamlNode& node = mapping({nullptr, value.line, value.column});
  put(node, std::move(key), value);
  return node;
}

}  // namespace alembert
