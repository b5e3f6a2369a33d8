// YAML nodes in; values of the kind that a place of the language expects out, or an error that says what was
// expected, what was found and which known key is near.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mechanism/document.hpp"

namespace alembert {

/// `a list`, `a mapping`, `nothing` or the quoted text of a scalar.
std::string description_of(const YamlNode& node);

/// Throws `expected EXPECTED, found ...` at the node.
[[noreturn]] void fail_expected(const Document& document, const YamlNode& node, std::string_view expected);

/// Whether an unquoted expression lacks a closing parenthesis, as when a list or mapping in brackets cut it
/// at its comma.
bool is_cut_at_comma(const YamlNode& node);
inline constexpr std::string_view kCutNote = "inside [ ] and { } an expression with a comma needs quotes";

/// The items of a list; `what` names the place (`transform of body 'arm'`), `count` is its length, or -1 for
/// any.
const std::vector<const YamlNode*>& expect_list(const Document& document, const YamlNode& node,
                                                std::string_view what, int count = -1);
const std::string& expect_text(const Document& document, const YamlNode& node, std::string_view what);
bool expect_boolean(const Document& document, const YamlNode& node, std::string_view what);

/// A mapping with known keys.
class Section {
 public:
  /// Throws if the node is no mapping or has a key that is not among `keys`.
  Section(const Document& document, const YamlNode& node, std::string what,
          std::initializer_list<std::string_view> keys);

  const YamlNode* find(std::string_view key) const;      ///< the value of a key, or null
  const YamlNode& require(std::string_view key) const;   ///< throws at the mapping if the key is missing
  SourceLocation where_key(std::string_view key) const;  ///< place of a key that exists
  const YamlNode& node() const { return *node_; }
  const std::string& what() const { return what_; }

 private:
  const Document* document_;
  const YamlNode* node_;
  std::string what_;
};

}  // namespace alembert
