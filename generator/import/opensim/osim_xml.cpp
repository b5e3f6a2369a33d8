#include "import/opensim/osim_xml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "import/common/snapped_angle.hpp"

namespace alembert {
namespace {

constexpr std::string_view kBlank = " \t\r\n";

/// Of "Inf", "-Infinity" and the like.
std::optional<double> infinity_of(std::string_view word) {
  const std::size_t letter = word.find_first_of("iI");
  if (letter == std::string_view::npos) return std::nullopt;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return word.substr(0, letter).find('-') == std::string_view::npos ? kInfinity : -kInfinity;
}

std::vector<std::string> split(std::string_view text) {
  std::vector<std::string> out;
  for (std::size_t at = text.find_first_not_of(kBlank); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kBlank, at), text.size());
    out.emplace_back(text.substr(at, end - at));
    at = text.find_first_not_of(kBlank, end);
  }
  return out;
}

}  // namespace

OsimXml::OsimXml(const XmlText& xml) : xml_(xml) {
  const auto add = [&](pugi::xml_node owner) {
    for (const pugi::xml_node object : elements(owner.child("defaults")))
      defaults_.try_emplace(object.name(), object);
  };
  const pugi::xml_node model = xml.root().child("Model");
  add(model);
  for (const pugi::xml_node set : elements(model)) add(set);
}

pugi::xml_node OsimXml::property(pugi::xml_node element, const char* name) const {
  if (const pugi::xml_node own = element.child(name)) return own;
  const auto found = defaults_.find(element.name());
  return found == defaults_.end() ? pugi::xml_node() : found->second.child(name);
}

std::string OsimXml::title(pugi::xml_node element) {
  const std::string name = name_of(element);
  return name.empty() ? fmt::format("<{}>", printable(element.name()))
                      : fmt::format("{} '{}'", printable(element.name()), printable(name));
}

std::string OsimXml::text(pugi::xml_node element, const char* property) {
  const pugi::xml_node found = element.child(property);
  if (found || !std::string_view(property).starts_with("socket_")) return text_of_element(found);
  return text_of_element(element.child((property + std::string(kOlderSocketEnd)).c_str()));
}

std::string OsimXml::text(pugi::xml_node element, std::initializer_list<const char*> properties) {
  for (const char* property : properties)
    if (std::string found = text(element, property); !found.empty()) return found;
  return {};
}

std::vector<std::string> OsimXml::words(pugi::xml_node element, const char* property) {
  return split(text_of_element(element.child(property)));
}

bool OsimXml::is_left_blank(pugi::xml_node element, std::span<const double> otherwise) const {
  if (!text_of_element(element).empty()) return false;
  warn({where(element),
        fmt::format("<{}> of {} is empty; {} is taken", element.name(), title(element.parent()),
                    fmt::join(otherwise, " ")),
        {},
        "empty"});
  return true;
}

bool OsimXml::flag(pugi::xml_node element, const char* property, bool otherwise) const {
  // Of the model's defaults, too.
  const pugi::xml_node found = this->property(element, property);
  std::string value = text_of_element(found);
  std::ranges::transform(value, value.begin(),
                         [](char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
  if (value.empty()) return otherwise;
  if (value == "true" || value == "1") return true;
  if (value == "false" || value == "0") return false;
  throw InputError(where(found),
                   fmt::format("expected true or false as <{}>, found '{}'", property, printable(value)));
}

double OsimXml::number(pugi::xml_node element, const char* property, double otherwise) const {
  return vector<1>(element, property, {otherwise})[0];
}

double OsimXml::number_or_infinite(pugi::xml_node element, const char* property, double otherwise) const {
  const std::string value = text_of_element(this->property(element, property));
  const std::optional<double> infinity = infinity_of(value);
  return infinity ? *infinity : number(element, property, otherwise);
}

std::optional<std::array<double, 2>> OsimXml::range(pugi::xml_node element, const char* property) const {
  const auto infinite = [](const std::string& word) { return infinity_of(word).has_value(); };
  if (std::ranges::any_of(words(element, property), infinite)) return std::nullopt;
  return vector<2>(element, property, {0, 0});
}

double OsimXml::positive_number(pugi::xml_node element, const char* property, double otherwise,
                                bool or_zero) const {
  const double value = number(element, property, otherwise);
  if (value > 0 || (or_zero && value == 0)) return value;
  throw InputError(where(element), fmt::format("<{}> of {} is {}; expected a positive number", property,
                                               title(element), number_text(value)));
}

double OsimXml::required_number(pugi::xml_node element, const char* property) const {
  const pugi::xml_node found = this->property(element, property);
  if (!found) throw InputError(where(element), fmt::format("no <{}> in {}", property, title(element)));
  return numbers(found, 1)[0];
}

std::vector<double> OsimXml::numbers(pugi::xml_node element, std::size_t count) const {
  const auto fail = [&] {
    const std::string expected =
        count == 0 ? "numbers" : (count == 1 ? "a number" : fmt::format("{} numbers", count));
    return InputError(where(element), fmt::format("expected {} as <{}>, found '{}'", expected, element.name(),
                                                  printable(text_of_element(element))));
  };
  std::vector<double> out;
  for (const std::string& word : split(text_of_element(element))) {
    const char* const begin = word.data() + (word[0] == '+' ? 1 : 0);
    const char* const end = word.data() + word.size();
    double value = 0;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc() || stop != end || !std::isfinite(value)) throw fail();
    out.push_back(value);
  }
  if (count != 0 && out.size() != count) throw fail();
  return out;
}

std::vector<pugi::xml_node> OsimXml::objects(pugi::xml_node parent, const char* set) const {
  const pugi::xml_node found = parent.child(set);
  if (const pugi::xml_attribute file = found.attribute("file"); file.value()[0] != '\0')
    throw InputError(
        xml_.where(file),
        fmt::format("<{}> stands in another file, '{}', which is not read", set, printable(file.value())),
        "write it into this file");
  return elements(found.child("objects"));
}

std::vector<pugi::xml_node> OsimXml::components(pugi::xml_node model) const {
  std::vector<pugi::xml_node> out = elements(model.child("components"));
  for (const char* set : {"ComponentSet", "MiscModelComponentSet"})
    std::ranges::copy(objects(model, set), std::back_inserter(out));
  return out;
}

std::vector<pugi::xml_node> OsimXml::elements(pugi::xml_node parent) {
  std::vector<pugi::xml_node> out;
  for (const pugi::xml_node child : parent.children())
    if (child.type() == pugi::node_element) out.push_back(child);
  return out;
}

}  // namespace alembert
