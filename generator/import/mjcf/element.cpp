#include "import/mjcf/element.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "import/mjcf/spelling.hpp"

namespace alembert {
namespace {

constexpr const char* kMain = "main";

std::string what_of(const MjcfText& text, pugi::xml_node node) {
  const pugi::xml_attribute name = node.attribute("name");
  if (name.value()[0] != '\0') return fmt::format("{} '{}'", node.name(), printable(name.value()));
  return fmt::format("the {} of line {}", printable(node.name()), text.where(node).line);
}

}  // namespace

SourceLocation MjcfElement::where(const char* name) const {
  const pugi::xml_attribute found = attribute(name);
  return found ? text_->where(found) : where();
}

pugi::xml_attribute MjcfElement::attribute(const char* name) const {
  for (const pugi::xml_node layer : layers_)
    if (const pugi::xml_attribute found = layer.attribute(name)) return found;
  return {};
}

std::string MjcfElement::string(const char* name, const char* otherwise) const {
  const pugi::xml_attribute found = attribute(name);
  return found ? found.value() : otherwise;
}

double MjcfElement::number(const char* name, double otherwise) const {
  const pugi::xml_attribute found = attribute(name);
  return found ? text_->of(found).number(found, fmt::format("the {} of {}", name, what_)) : otherwise;
}

std::vector<double> MjcfElement::list(const char* name, std::size_t least, std::size_t most) const {
  const pugi::xml_attribute found = attribute(name);
  if (!found) return {};
  return text_->of(found).number_list(found, fmt::format("the {} of {}", name, what_), least, most);
}

std::optional<std::array<double, 3>> MjcfElement::colour() const {
  std::vector<double> rgba;
  if (const pugi::xml_attribute found = attribute("rgba"))
    text_->of(found).tolerate("it has the usual colour", [&] { rgba = list("rgba", 4, 4); });
  if (rgba.empty()) return std::nullopt;
  return std::array{rgba[0], rgba[1], rgba[2]};
}

std::vector<double> MjcfElement::overlaid(const char* name, std::size_t most) const {
  std::vector<double> out;
  for (auto layer = layers_.rbegin(); layer != layers_.rend(); ++layer) {
    const std::vector<double> own = MjcfElement(*text_, {*layer}, what_).list(name, 1, most);
    out.resize(std::max(out.size(), own.size()));
    std::ranges::copy(own, out.begin());
  }
  return out;
}

Eigen::Vector3d MjcfElement::vector(const char* name, const Eigen::Vector3d& otherwise) const {
  const std::vector<double> values = list(name, 3, 3);
  return values.empty() ? otherwise : Eigen::Vector3d(values[0], values[1], values[2]);
}

std::size_t MjcfElement::word(const char* name, std::initializer_list<std::string_view> words,
                              std::size_t otherwise) const {
  const pugi::xml_attribute found = attribute(name);
  if (!found) return otherwise;
  const auto at = std::ranges::find(words, std::string_view(found.value()));
  if (at == words.end())
    throw error(name, fmt::format("the {} of {} is one of {}, not '{}'", name, what_, fmt::join(words, ", "),
                                  printable(found.value())));
  return static_cast<std::size_t>(at - words.begin());
}

bool MjcfElement::flag(const char* name, bool otherwise) const {
  return word(name, {"false", "true"}, otherwise ? 1 : 0) == 1;
}

std::optional<bool> MjcfElement::flag_or_auto(const char* name) const {
  const std::size_t value = word(name, {"false", "true", "auto"}, 2);
  return value == 2 ? std::nullopt : std::optional(value == 1);
}

MjcfDefaults::MjcfDefaults(const MjcfText& text) : text_(&text) {
  classes_[kMain];
  for (const pugi::xml_node top : text.children(text.root(), "default")) read(top, "", 0);
}

void MjcfDefaults::read(pugi::xml_node element, const std::string& parent, int depth) {
  const pugi::xml_attribute attribute = element.attribute("class");
  const bool top = depth == 0;
  if (!attribute && !top)
    throw InputError(text_->where(element),
                     "a default class below another needs a name: no attribute 'class'");
  const std::string name = attribute ? attribute.value() : kMain;
  // The top class may have any name; it is the main one.
  Class& of = classes_[top ? kMain : name];
  if (!top && (name == kMain || !of.parent.empty()))
    throw InputError(text_->where(element), fmt::format("a second default class '{}'", printable(name)));
  of.parent = parent;
  if (!top) of.of_parent = classes_.find(parent)->second.elements.size();
  std::vector<pugi::xml_node> inner;
  for (const pugi::xml_node child : text_->children(element)) {
    if (std::string_view(child.name()) == "default") {
      inner.push_back(child);
      continue;
    }
    check_attributes(*text_, child);
    of.elements.push_back(child);
  }
  if (top && name != kMain && !classes_.contains(name)) {
    Class& alias = classes_[name];
    alias.parent = kMain;
    alias.of_parent = std::numeric_limits<std::size_t>::max();
  }
  for (const pugi::xml_node child : inner) read(child, top ? kMain : name, depth + 1);
}

void MjcfDefaults::require(pugi::xml_attribute name) const {
  if (!name || classes_.contains(name.value())) return;
  std::vector<std::string> known;
  for (const auto& [each, of] : classes_) known.push_back(each);
  throw InputError(text_->where(name),
                   fmt::format("there is no default class '{}'{}", printable(name.value()),
                               did_you_mean(name.value(), known)));
}

MjcfElement MjcfDefaults::element(pugi::xml_node node, const std::vector<std::string>& tags,
                                  const std::string& scope) const {
  // Elements of equalities and tendons are called as others and have attributes of their own.
  if (std::ranges::find(tags, std::string_view(node.name())) != tags.end()) check_attributes(*text_, node);
  std::vector<pugi::xml_node> layers{node};
  const pugi::xml_attribute own = node.attribute("class");
  require(own);
  std::string name = own ? own.value() : scope.empty() ? kMain : scope;
  for (std::size_t count = classes_.find(name)->second.elements.size(); !name.empty();) {
    const Class& of = classes_.find(name)->second;
    for (std::size_t i = std::min(count, of.elements.size()); i-- > 0;)
      if (std::ranges::find(tags, std::string_view(of.elements[i].name())) != tags.end())
        layers.push_back(of.elements[i]);
    name = of.parent;
    count = of.of_parent;
  }
  return {*text_, std::move(layers), what_of(*text_, node)};
}

}  // namespace alembert
