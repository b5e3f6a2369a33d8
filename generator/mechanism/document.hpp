// Text of a description in; a tree of YAML nodes out, each with its place. What is wrong as text or as YAML
// (encoding, tabs, duplicate keys, nesting, aliases that multiply) is found here, before any meaning is
// looked at. Readers of other formats make such trees too, with places in their own text.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "support/error.hpp"

namespace alembert {

/// One node of the tree. Aliases share the node they name.
struct YamlNode {
  enum class Kind { null, scalar, sequence, mapping };
  Kind kind = Kind::null;
  bool plain = false;                  ///< a scalar without quotes
  bool finished = true;                ///< false while its children are being read
  int line = 1, column = 1;            ///< of its first character (of the key, if null)
  std::size_t expanded = 1;            ///< nodes below and including this one, aliases followed
  std::size_t expanded_text = 0;       ///< characters of scalars, counted likewise
  std::string text;                    ///< of a scalar
  std::vector<const YamlNode*> items;  ///< of a sequence; of a mapping: key, value, key, value ...
};

/// Space, tab or end of a line.
bool is_space(char c);
/// Offsets at which the lines of a text begin.
std::vector<std::size_t> line_starts(std::string_view text);
/// The place of an offset in a text whose lines begin at `starts`.
SourceLocation place_in(const std::shared_ptr<const SourceText>& source,
                        const std::vector<std::size_t>& starts, std::size_t offset);
/// Offset, from `from` on, of the first byte that is not UTF-8 or a control character other than white space,
/// and what is wrong with it.
std::optional<std::size_t> strange_byte(std::string_view text, std::size_t from);
std::string objection_to_byte(std::string_view text, std::size_t at);
/// Throws InputError at the first byte that is not UTF-8 or a control character other than white space.
void check_characters(const std::shared_ptr<const SourceText>& source);

/// A parsed text. Nodes live as long as the document.
class Document {
 public:
  /// Throws InputError at what is not UTF-8 text or not one YAML document within the limits below.
  explicit Document(std::shared_ptr<const SourceText> source);
  /// The tree that another reader made from a text: `root` and all that it leads to are among `nodes`.
  Document(std::shared_ptr<const SourceText> source, std::deque<YamlNode> nodes, const YamlNode& root);
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  const YamlNode& root() const { return *root_; }
  SourceLocation where(const YamlNode& node) const { return {source_, node.line, node.column}; }
  /// Place of the character at `offset` of a scalar's text: exact for plain, block and one-line quoted
  /// scalars without escapes, the scalar's beginning otherwise.
  SourceLocation where(const YamlNode& scalar, std::size_t offset) const;
  SourceLocation start() const { return {source_, 1, 1}; }

  static constexpr int kMaximumDepth = 64;
  static constexpr std::size_t kMaximumNodes = 1000000;
  static constexpr std::size_t kMaximumText = std::size_t{32} << 20;

 private:
  friend class TreeBuilder;
  void check_layout() const;
  bool quote_is_closed(const YamlNode& scalar) const;
  std::size_t position(int line, int column) const;

  std::shared_ptr<const SourceText> source_;
  std::vector<std::size_t> line_starts_;
  std::deque<YamlNode> nodes_;
  const YamlNode* root_ = nullptr;
};

}  // namespace alembert
