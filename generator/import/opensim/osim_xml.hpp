// Elements of a model file of OpenSim as values: every property is an element whose text is its value.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "import/common/xml_text.hpp"

namespace alembert {

/// What names of sockets ended in before 4.0: <socket_parent_connectee_name>.
inline constexpr std::string_view kOlderSocketEnd = "_connectee_name";

class OsimXml {
 public:
  explicit OsimXml(const XmlText& xml);

  SourceLocation where(pugi::xml_node element) const { return xml_.where(element); }
  void warn(Warning warning) const { xml_.warn(std::move(warning)); }
  /// The element's type and name: `PinJoint 'elbow'`.
  static std::string title(pugi::xml_node element);
  static std::string name_of(pugi::xml_node element) { return element.attribute("name").value(); }

  /// A property's element: the object's own, or that of the model's <defaults> for its type. Null if neither has one.
  pugi::xml_node property(pugi::xml_node element, const char* name) const;
  /// Text of a property without white space around it, or of a socket by its older name; empty where there is none.
  static std::string text(pugi::xml_node element, const char* property);
  /// The first of several properties that has a text.
  static std::string text(pugi::xml_node element, std::initializer_list<const char*> properties);
  static std::vector<std::string> words(pugi::xml_node element, const char* property);
  /// Throws InputError at what is neither true nor false.
  bool flag(pugi::xml_node element, const char* property, bool otherwise) const;
  /// A finite number. Throws InputError at anything else.
  double number(pugi::xml_node element, const char* property, double otherwise) const;
  /// The same, where Inf and -Inf are numbers too.
  double number_or_infinite(pugi::xml_node element, const char* property, double otherwise) const;
  /// One that must be positive, or 0 where that has a meaning.
  double positive_number(pugi::xml_node element, const char* property, double otherwise,
                         bool or_zero = false) const;
  /// A number that must be there.
  double required_number(pugi::xml_node element, const char* property) const;
  /// Of as many finite numbers as the array has.
  template <std::size_t kCount>
  std::array<double, kCount> vector(pugi::xml_node element, const char* property,
                                    const std::array<double, kCount>& otherwise) const {
    const pugi::xml_node found = this->property(element, property);
    if (!found || is_left_blank(found, otherwise)) return otherwise;
    const std::vector<double> values = numbers(found, kCount);
    std::array<double, kCount> out{};
    std::ranges::copy(values, out.begin());
    return out;
  }
  /// Two numbers; nothing if one of them is infinite.
  std::optional<std::array<double, 2>> range(pugi::xml_node element, const char* property) const;
  /// All numbers of an element; exactly `count`, unless that is 0.
  std::vector<double> numbers(pugi::xml_node element, std::size_t count = 0) const;

  /// Elements of a set, such as BodySet: those of its <objects>. Throws InputError at a set in another file.
  std::vector<pugi::xml_node> objects(pugi::xml_node parent, const char* set) const;
  /// Of a model: what stands in <components> and in its sets of components.
  std::vector<pugi::xml_node> components(pugi::xml_node model) const;
  /// Elements that are no text or comment.
  static std::vector<pugi::xml_node> elements(pugi::xml_node parent);

 private:
  /// Whether nothing stands in an element; then with a warning.
  bool is_left_blank(pugi::xml_node element, std::span<const double> otherwise) const;

  const XmlText& xml_;
  std::map<std::string_view, pugi::xml_node> defaults_;  // by type
};

}  // namespace alembert
