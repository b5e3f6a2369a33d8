// Text in; XML out, every element and attribute with its place. What is misspelt is an error where it would
// change the equations, and a warning elsewhere.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <pugixml.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/error.hpp"

namespace alembert {

/// Names that xacro expands, which URDF does not know, and what to do about them.
inline constexpr std::string_view kXacroPrefix = "xacro:";
inline constexpr const char* kExpandXacro = "expand it first: xacro FILE > robot.urdf";

/// What a format calls its root, and the elements and attributes that its equations are made of.
struct XmlFormat {
  std::string_view root;
  std::span<const std::string_view> vital;
  std::string_view older_end = {};  ///< what names of elements may end in besides
  bool called_by_name = false;      ///< an element may be called what its attribute `name` says
};

/// The text of an element, which comments may split; without white space around it.
std::string text_of_element(pugi::xml_node element);

/// A parsed XML text.
class XmlText {
 public:
  /// Throws InputError at what is not one well-formed element. Mends, with a warning, what robots' own
  /// engines read too: bytes that are no text become question marks, attributes get a blank between them, and
  /// `<!` that begins neither a comment nor anything else is passed over.
  XmlText(std::shared_ptr<const SourceText> source, Warnings& warnings, const XmlFormat& format);

  pugi::xml_node root() const { return document_.document_element(); }
  static constexpr std::size_t kMaximumWarnings = 20000;
  SourceLocation where(pugi::xml_node element) const;         ///< of its `<`
  SourceLocation where(pugi::xml_attribute attribute) const;  ///< of its value
  bool holds(const char* name) const;  ///< whether the name of an element or attribute stands in this text
  const std::shared_ptr<const SourceText>& source() const { return source_; }

  /// Further ones than a great many are not kept.
  void warn(Warning warning) const {
    if (warnings_->size() < kMaximumWarnings) warnings_->push_back(std::move(warning));
  }
  /// What `read` throws is a warning, with this consequence.
  template <class Read>
  void tolerate(const std::string& consequence, Read read) const {
    try {
      read();
    } catch (const InputError& error) {
      warn_instead(error, consequence);
    }
  }

  /// Warns of elements among the children, and of attributes, other than those known; throws at one that is
  /// nearly one of those that make the equations. Names with a prefix belong to others and are passed over.
  /// `what` is the element in messages.
  void check_spelling(pugi::xml_node element, std::string_view what,
                      std::initializer_list<std::string_view> children,
                      std::initializer_list<std::string_view> attributes) const;

  /// The first child of a name, or none. Warns of a second one.
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
    std::ranges::copy(number_list(attribute, what, kCount, kCount), out.begin());
    return out;
  }
  /// From `least` to `most` of them.
  std::vector<double> number_list(pugi::xml_attribute attribute, std::string_view what, std::size_t least,
                                  std::size_t most) const;
  double number(pugi::xml_attribute attribute, std::string_view what) const {
    return numbers<1>(attribute, what)[0];
  }
  /// The same of an element's text.
  std::vector<double> number_list(pugi::xml_node element, std::string_view what, std::size_t least,
                                  std::size_t most) const;
  /// Of an element's text, without the white space before it; of the element where it has none.
  SourceLocation where_text(pugi::xml_node element) const;

 private:
  std::vector<double> number_list(std::string_view text, const SourceLocation& where, std::string_view what,
                                  std::size_t least, std::size_t most) const;
  void blank_strange_bytes();
  void mend_markup();
  std::size_t end_of_tag(std::size_t begin, std::vector<std::size_t>& blanks) const;
  void insert_blanks(const std::vector<std::size_t>& before);
  void check_duplicate_attributes() const;
  void warn_instead(const InputError& error, const std::string& consequence) const;
  bool passed_over(std::string_view name, SourceLocation where) const;
  SourceLocation place(std::size_t offset) const;
  SourceLocation place_of(const char* in_buffer, std::size_t before) const;

  XmlFormat format_;
  std::shared_ptr<const SourceText> source_;
  std::vector<std::size_t> line_starts_;
  std::string buffer_;  // parsed in place, so that names and values stay where they are in the text
  std::vector<std::size_t> inserted_;  // blanks in the buffer that the text lacks, in order
  pugi::xml_document document_;
  Warnings* warnings_;
};

}  // namespace alembert
