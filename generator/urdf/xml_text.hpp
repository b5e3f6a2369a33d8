// Text in; XML out, every element and attribute with its place, and errors at what is misspelt.
#pragma once

#include <array>
#include <initializer_list>
#include <memory>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "support/error.hpp"

namespace alembert {

/// A parsed XML text.
class XmlText {
 public:
  /// Throws InputError at what is not UTF-8 or not one well-formed element.
  explicit XmlText(std::shared_ptr<const SourceText> source);

  pugi::xml_node root() const { return document_.document_element(); }
  SourceLocation where(pugi::xml_node element) const;         ///< of its `<`
  SourceLocation where(pugi::xml_attribute attribute) const;  ///< of its value
  const std::shared_ptr<const SourceText>& source() const { return source_; }

  /// Throws at an element among the children, or an attribute, that is nearly one of those known; what is
  /// unlike all of them belongs to others and is passed over. `what` is the element in messages.
  void check_spelling(pugi::xml_node element, std::string_view what,
                      std::initializer_list<std::string_view> children,
                      std::initializer_list<std::string_view> attributes) const;

  /// The only child of a name, or none. Throws at a second one.
  pugi::xml_node find(pugi::xml_node element, const char* child, std::string_view what) const;
  /// The same, where there must be one.
  pugi::xml_node require(pugi::xml_node element, const char* child, std::string_view what) const;
  /// An attribute that must be there, and not be empty.
  pugi::xml_attribute require_attribute(pugi::xml_node element, const char* name,
                                        std::string_view what) const;

  /// Numbers separated by white space, exactly so many and all finite.
  template <std::size_t kCount>
  std::array<double, kCount> numbers(pugi::xml_attribute attribute, std::string_view what) const {
    std::array<double, kCount> out;
    read_numbers(attribute, what, out.data(), kCount);
    return out;
  }
  double number(pugi::xml_attribute attribute, std::string_view what) const {
    return numbers<1>(attribute, what)[0];
  }

 private:
  void refuse_duplicate_attributes() const;
  void read_numbers(pugi::xml_attribute attribute, std::string_view what, double* out,
                    std::size_t count) const;
  SourceLocation place(std::size_t offset) const;
  SourceLocation place_of(const char* in_buffer, std::size_t before) const;

  std::shared_ptr<const SourceText> source_;
  std::vector<std::size_t> line_starts_;
  std::string buffer_;  // parsed in place, so that names and values stay where they are in the text
  pugi::xml_document document_;
};

}  // namespace alembert
