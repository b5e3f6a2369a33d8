// YAML by yaml-cpp's events, so that depth and size are limited while reading, and keys can be compared.
#include "mechanism/document.hpp"

#include <fmt/format.h>
#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string_view>

namespace alembert {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Length of the well-formed UTF-8 sequence at `i` (no overlong forms, no surrogates), or 0.
std::size_t utf8_length(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t k) -> unsigned {
    return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0u;
  };
  const auto tail = [&](std::size_t k) { return (byte(k) & 0xC0u) == 0x80u; };
  const unsigned lead = byte(0);
  if (lead < 0x80u) return 1;
  if (lead >= 0xC2u && lead <= 0xDFu && tail(1)) return 2;
  if (lead >= 0xE0u && lead <= 0xEFu && tail(1) && tail(2)) {
    if ((lead == 0xE0u && byte(1) < 0xA0u) || (lead == 0xEDu && byte(1) > 0x9Fu)) return 0;
    return 3;
  }
  if (lead >= 0xF0u && lead <= 0xF4u && tail(1) && tail(2) && tail(3)) {
    if ((lead == 0xF0u && byte(1) < 0x90u) || (lead == 0xF4u && byte(1) > 0x8Fu)) return 0;
    return 4;
  }
  return 0;
}

}  // namespace

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// Takes yaml-cpp's events and builds the tree.
class TreeBuilder final : public YAML::EventHandler {
 public:
  explicit TreeBuilder(Document& document, int first_line_shift)
      : document_(document), first_line_shift_(first_line_shift) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ > 1) throw InputError(place(mark), "a second YAML document; a file holds one mechanism");
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    YamlNode& node = append(mark, YamlNode::Kind::null, anchor);
    // The mark of an absent value is that of whatever follows it: its key says better what lacks a value.
    if (!open_.empty() && open_.back()->kind == YamlNode::Kind::mapping) {
      const YamlNode& parent = *open_.back();
      if (parent.items.size() % 2 == 1) {
        node.line = parent.items.back()->line;
        node.column = parent.items.back()->column;
      }
    }
    attach(node);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    if (anchor >= anchors_.size() || anchors_[anchor] == nullptr)
      throw InputError(place(mark), "an alias without its anchor");
    const YamlNode& node = *anchors_[anchor];
    if (!node.finished) throw InputError(place(mark), "an alias inside the node that it names");
    if (expects_key()) throw InputError(place(mark), "a key must be a name, not an alias");
    attach(node);
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    YamlNode& node = append(mark, YamlNode::Kind::scalar, anchor);
    refuse_tag(mark, tag);
    node.plain = tag == "?" || tag.empty();
    node.text = value;
    node.expanded_text = value.size();
    if (!node.plain && !document_.quote_is_closed(node)) {
      throw InputError(document_.where(node), "this quote is never closed");
    }
    attach(node);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    begin(mark, tag, YamlNode::Kind::sequence, anchor);
  }
  void OnSequenceEnd() override { end(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    begin(mark, tag, YamlNode::Kind::mapping, anchor);
    keys_.emplace_back();
  }
  void OnMapEnd() override {
    keys_.pop_back();
    end();
  }

  SourceLocation place(const YAML::Mark& mark) const {
    if (mark.is_null()) return document_.start();
    const int lines = static_cast<int>(document_.line_starts_.size());
    const int shift = mark.line == 0 ? first_line_shift_ : 0;
    return {document_.source_, std::clamp(mark.line + 1, 1, lines), std::max(mark.column + 1 + shift, 1)};
  }
  const YamlNode* root() const { return root_; }

 private:
  bool expects_key() const {
    return !open_.empty() && open_.back()->kind == YamlNode::Kind::mapping &&
           open_.back()->items.size() % 2 == 0;
  }
  void refuse_tag(const YAML::Mark& mark, const std::string& tag) const {
    if (!tag.empty() && tag != "?" && tag != "!")
      throw InputError(place(mark),
                       fmt::format("YAML tags such as '{}' have no meaning here", printable(tag)));
  }
  YamlNode& append(const YAML::Mark& mark, YamlNode::Kind kind, YAML::anchor_t anchor) {
    const SourceLocation where = place(mark);
    YamlNode& node = document_.nodes_.emplace_back();
    node.kind = kind;
    node.line = where.line;
    node.column = where.column;
    if (anchor != 0) {
      if (anchor >= anchors_.size()) anchors_.resize(anchor + 1, nullptr);
      anchors_[anchor] = &node;
    }
    return node;
  }
  void begin(const YAML::Mark& mark, const std::string& tag, YamlNode::Kind kind, YAML::anchor_t anchor) {
    refuse_tag(mark, tag);
    if (expects_key()) throw InputError(place(mark), "a key must be a name, not a list or a mapping");
    if (open_.size() >= static_cast<std::size_t>(Document::kMaximumDepth))
      throw InputError(place(mark), fmt::format("nested more than {} levels deep", Document::kMaximumDepth));
    YamlNode& node = append(mark, kind, anchor);
    node.finished = false;
    open_.push_back(&node);
  }
  void end() {
    YamlNode& node = *open_.back();
    open_.pop_back();
    node.finished = true;
    attach(node);
  }
  /// Hangs a finished node under the innermost open one.
  void attach(const YamlNode& node) {
    if (open_.empty()) {
      root_ = &node;
      return;
    }
    YamlNode& parent = *open_.back();
    if (expects_key()) {
      const SourceLocation where = document_.where(node);
      if (node.kind != YamlNode::Kind::scalar) throw InputError(where, "a key must be a name");
      if (!keys_.back().insert(node.text).second)
        throw InputError(where, fmt::format("duplicate key '{}'", printable(node.text)));
    }
    parent.items.push_back(&node);
    parent.expanded += node.expanded;
    if (parent.expanded > Document::kMaximumNodes)
      throw InputError(document_.where(parent),
                       fmt::format("more than {} values, aliases counted as often as they are used",
                                   Document::kMaximumNodes));
    parent.expanded_text += node.expanded_text;
    if (parent.expanded_text > Document::kMaximumText)
      throw InputError(document_.where(parent),
                       fmt::format("more than {} MiB of text, aliases counted as often as they are used",
                                   Document::kMaximumText >> 20));
  }

  Document& document_;
  int first_line_shift_;
  int documents_ = 0;
  const YamlNode* root_ = nullptr;
  std::vector<YamlNode*> open_;
  std::vector<std::set<std::string_view>> keys_;
  std::vector<const YamlNode*> anchors_;
};

std::vector<std::size_t> line_starts(std::string_view text) {
  std::vector<std::size_t> starts{0};
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n') starts.push_back(i + 1);
  return starts;
}

SourceLocation place_in(const std::shared_ptr<const SourceText>& source,
                        const std::vector<std::size_t>& starts, std::size_t offset) {
  const auto line = std::ranges::upper_bound(starts, offset) - starts.begin();
  return {source, static_cast<int>(line),
          static_cast<int>(offset - starts[static_cast<std::size_t>(line - 1)]) + 1};
}

std::optional<std::size_t> strange_byte(std::string_view text, std::size_t from) {
  for (std::size_t i = from; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const std::size_t length = utf8_length(text, i);
    if (length == 0 || (byte < 0x20 && !is_space(text[i])) || byte == 0x7f) return i;
    i += length;
  }
  return std::nullopt;
}

std::string objection_to_byte(std::string_view text, std::size_t at) {
  const auto byte = static_cast<unsigned char>(text[at]);
  return utf8_length(text, at) == 0 ? fmt::format("byte 0x{:02x} is not UTF-8 text", byte)
                                    : fmt::format("control character 0x{:02x}; expected text", byte);
}

void check_characters(const std::shared_ptr<const SourceText>& source) {
  const std::string_view text = source->text;
  if (const std::optional<std::size_t> at = strange_byte(text, 0))
    throw InputError(place_in(source, line_starts(text), *at), objection_to_byte(text, *at));
}

Document::Document(std::shared_ptr<const SourceText> source, std::deque<YamlNode> nodes, const YamlNode& root)
    : source_(std::move(source)),
      line_starts_(line_starts(source_->text)),
      nodes_(std::move(nodes)),
      root_(&root) {}

Document::Document(std::shared_ptr<const SourceText> source)
    : source_(std::move(source)), line_starts_(line_starts(source_->text)) {
  check_characters(source_);
  check_layout();
  const std::string& text = source_->text;
  const bool marked = text.starts_with(kByteOrderMark);
  std::istringstream stream(marked ? text.substr(kByteOrderMark.size()) : text);
  TreeBuilder builder(*this, marked ? static_cast<int>(kByteOrderMark.size()) : 0);
  try {
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const YAML::DeepRecursion& error) {
    throw InputError(builder.place(error.mark),
                     fmt::format("nested more than {} levels deep", kMaximumDepth));
  } catch (const YAML::Exception& error) {
    throw InputError(builder.place(error.mark), fmt::format("not valid YAML: {}", error.msg),
                     "text that holds ': ', ' #', a leading '*', '&', '[' or '{' needs quotes");
  }
  root_ = builder.root();
  if (root_ == nullptr || root_->kind == YamlNode::Kind::null)
    throw InputError(start(),
                     "is empty; expected a mechanism description, a mapping that begins with 'alembert: 1'");
}

/// Finds indents with tabs, and lists opened so deep that yaml-cpp would read the whole text before the
/// first.
void Document::check_layout() const {
  const std::string_view text = source_->text;
  bool indentation = true;
  std::size_t tab = std::string_view::npos;
  int opened = 0;  // lists and mappings opened in a row
  for (std::size_t i = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '[' || c == '{') {
      if (++opened > kMaximumDepth)
        throw InputError(place_in(source_, line_starts_, i),
                         fmt::format("nested more than {} levels deep", kMaximumDepth));
    } else if (!is_space(c)) {
      opened = 0;
    }
    if (c == '\n') {
      indentation = true;
      tab = std::string_view::npos;
    } else if (c == '\t') {
      if (indentation && tab == std::string_view::npos) tab = i;
    } else if (c != ' ' && c != '\r') {
      if (indentation && tab != std::string_view::npos && c != '#')
        throw InputError(place_in(source_, line_starts_, tab), "tab in the indentation",
                         "YAML indents by spaces");
      indentation = false;
    }
  }
}

/// yaml-cpp lets a quoted scalar end with the file.
bool Document::quote_is_closed(const YamlNode& scalar) const {
  const std::string_view text = source_->text;
  std::size_t at = position(scalar.line, scalar.column);
  const char quote = at < text.size() ? text[at] : '\0';
  if (quote != '"' && quote != '\'') return true;
  for (++at; at < text.size(); ++at) {
    if (text[at] == quote) {
      const bool doubled = quote == '\'' && at + 1 < text.size() && text[at + 1] == quote;
      if (!doubled) return true;
      ++at;
    } else if (quote == '"' && text[at] == '\\') {
      ++at;
    }
  }
  return false;
}

std::size_t Document::position(int line, int column) const {
  const std::size_t start = line_starts_[static_cast<std::size_t>(line - 1)];
  return std::min(start + static_cast<std::size_t>(column - 1), source_->text.size());
}

SourceLocation Document::where(const YamlNode& scalar, std::size_t offset) const {
  const std::string& text = source_->text;
  const std::string_view value = scalar.text;
  std::size_t at = position(scalar.line, scalar.column);
  if (at < text.size() && (text[at] == '"' || text[at] == '\'')) ++at;
  if (at < text.size() && (text[at] == '|' || text[at] == '>') && !scalar.plain)
    at = std::min(text.find('\n', at), text.size());
  // Walk text and value together. Folding changes white space only, so the other characters pair off; where
  // they do not (escapes), there is no exact place.
  const auto skip = [](std::string_view s, std::size_t i) {
    while (i < s.size() && is_space(s[i])) ++i;
    return i;
  };
  std::size_t v = 0;
  while (v < offset && v < value.size()) {
    if (is_space(value[v]) && at < text.size() && value[v] == text[at]) {
      ++v, ++at;
    } else if (is_space(value[v]) || (at < text.size() && is_space(text[at]))) {
      v = std::max(v, std::min(skip(value, v), offset));
      at = skip(text, at);
    } else if (at < text.size() && value[v] == text[at]) {
      ++v, ++at;
    } else {
      return where(scalar);
    }
  }
  if (v < value.size() && !is_space(value[v])) {
    at = skip(text, at);
    if (at >= text.size() || text[at] != value[v]) return where(scalar);
  }
  return place_in(source_, line_starts_, at);
}

}  // namespace alembert
