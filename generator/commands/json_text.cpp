// Places for the events of nlohmann's parser (see the header): each event is the next token of the text.
#include "commands/json_text.hpp"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>

#include "support/error.hpp"

namespace alembert {

namespace {

constexpr std::size_t kMostLevels = 64;

/// Walks over the tokens of a text that is right up to where it walks.
class TokenWalk {
 public:
  explicit TokenWalk(std::string_view text) : text_(text) {}

  /// Offset of the next token.
  std::size_t next() {
    at_ = std::min(text_.find_first_not_of("\xEF\xBB\xBF \t\r\n,:", at_), text_.size());
    return at_;
  }
  /// The same, and goes on behind the token: a bracket, a text, or a word or number.
  std::size_t take() {
    const std::size_t begin = next();
    if (begin == text_.size()) return begin;
    if (text_[begin] == '"') {
      for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_)
        if (text_[at_] == '\\') ++at_;
      ++at_;
    } else if (std::string_view("[]{}").find(text_[begin]) != std::string_view::npos) {
      ++at_;
    } else {
      at_ = text_.find_first_of(" \t\r\n,:[]{}\"", begin);
    }
    at_ = std::min(at_, text_.size());
    return begin;
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

/// Takes the parser's events and builds the tree.
class JsonTree {
 public:
  explicit JsonTree(std::string_view text) : walk_(text) {}
  JsonValue root;

  bool null() { return leaf(JsonValue::Kind::null); }
  bool boolean(bool) { return leaf(JsonValue::Kind::boolean); }
  bool number_integer(std::int64_t value) { return leaf(JsonValue::Kind::number, double(value)); }
  bool number_unsigned(std::uint64_t value) { return leaf(JsonValue::Kind::number, double(value)); }
  bool number_float(double value, const std::string&) { return leaf(JsonValue::Kind::number, value); }
  bool string(const std::string&) { return leaf(JsonValue::Kind::text); }
  bool binary(const std::vector<std::uint8_t>&) { return leaf(JsonValue::Kind::text); }
  bool start_array(std::size_t) { return open(JsonValue::Kind::array); }
  bool start_object(std::size_t) { return open(JsonValue::Kind::object); }
  bool end_array() { return close(); }
  bool end_object() { return close(); }
  bool key(const std::string& name) {
    const std::size_t at = walk_.take();
    if (!known_.back().insert(name).second) throw JsonError(at, "'" + printable(name) + "' is given twice");
    open_.back()->keys.push_back({name, at});
    return true;
  }
  bool parse_error(std::size_t position, const std::string& token, const nlohmann::json::exception& error) {
    if (dynamic_cast<const nlohmann::json::out_of_range*>(&error) != nullptr)
      throw JsonError(walk_.next(), "'" + printable(token) + "' is out of the range of numbers");
    std::string reason = error.what();  // [json.exception...] parse error at line 1, column 9: reason
    if (const std::size_t place = reason.find("column "); place != std::string::npos)
      reason.erase(0, std::min(reason.find(": ", place) + 2, reason.size()));
    throw JsonError(position > 0 ? position - 1 : 0, "this is no JSON object: " + printable(reason, 200));
  }

 private:
  JsonValue& add(JsonValue::Kind kind) {
    JsonValue& value = open_.empty() ? root : open_.back()->items.emplace_back();
    value.kind = kind;
    value.at = walk_.take();
    return value;
  }
  bool leaf(JsonValue::Kind kind, double number = 0) {
    add(kind).number = number;
    return true;
  }
  bool open(JsonValue::Kind kind) {
    open_.push_back(&add(kind));
    known_.emplace_back();
    if (open_.size() > kMostLevels)
      throw JsonError(open_.back()->at,
                      "JSON nested more than " + std::to_string(kMostLevels) + " levels deep");
    return true;
  }
  bool close() {
    walk_.take();
    open_.pop_back();
    known_.pop_back();
    return true;
  }

  TokenWalk walk_;
  std::vector<JsonValue*> open_;              // no list grows before its last entry is closed
  std::vector<std::set<std::string>> known_;  // keys of those
};

}  // namespace

JsonValue parse_json(std::string_view text) {
  JsonTree tree(text);
  nlohmann::json::sax_parse(text.begin(), text.end(), &tree);
  return std::move(tree.root);
}

}  // namespace alembert
