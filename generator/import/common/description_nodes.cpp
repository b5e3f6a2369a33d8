#include "import/common/description_nodes.hpp"

#include <utility>

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

const YamlNode& DescriptionNodes::single(std::string key, const YamlNode& value) {
  YamlNode& node = mapping({nullptr, value.line, value.column});
  put(node, std::move(key), value);
  return node;
}

}  // namespace alembert
