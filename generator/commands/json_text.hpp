// JSON whose values know their places. In: a text. Out: a tree, or the offset and reason of what is wrong
// with it: syntax, numbers out of range, keys that are given twice, nesting that no input here has.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace alembert {

/// A value of a JSON text. Texts are not kept: no input here has any.
struct JsonValue {
  enum class Kind { null, boolean, number, text, array, object };
  struct Key {
    std::string name;
    std::size_t at;
  };

  Kind kind = Kind::null;
  std::size_t at = 0;            ///< offset of its first character
  double number = 0;             ///< of a number
  std::vector<JsonValue> items;  ///< of an array; of an object the values, in the order of the text
  std::vector<Key> keys;         ///< of an object, one a value
};

/// What is wrong, and where.
class JsonError : public std::runtime_error {
 public:
  JsonError(std::size_t at, const std::string& message) : std::runtime_error(message), at_(at) {}
  std::size_t at() const { return at_; }

 private:
  std::size_t at_;
};

/// Throws JsonError. Numbers of the tree are finite.
JsonValue parse_json(std::string_view text);

}  // namespace alembert
