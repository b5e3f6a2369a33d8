// Numerals of all scalars (see the header).
#include "mechanism/extreme_number.hpp"

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "mechanism/document.hpp"

namespace alembert {

namespace {

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Keeps the most extreme of the numbers that it sees.
class ExtremeNumber {
 public:
  explicit ExtremeNumber(const Document& document) : document_(document), place_(document.start()) {}
  const SourceLocation& place() const { return place_; }

  void look_below(const YamlNode& node) {
    if (node.kind == YamlNode::Kind::scalar) look_at(node);
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      const bool mapping = node.kind == YamlNode::Kind::mapping;
      if (mapping && i % 2 == 0) continue;  // a key
      if (mapping && (node.items[i - 1]->text == "name" || node.items[i - 1]->text == "description"))
        continue;
      look_below(*node.items[i]);
    }
  }

 private:
  void look_at(const YamlNode& scalar) {
    const std::string& text = scalar.text;
    std::size_t at = 0;
    const auto number = [&]() -> double {  // the one that begins here; 0 if none does
      const bool digit =
          at < text.size() && (std::isdigit(static_cast<unsigned char>(text[at])) != 0 || text[at] == '.');
      if (!digit) return 0;
      char* end = nullptr;
      const double value = std::strtod(&text[at], &end);
      at = static_cast<std::size_t>(end - text.data());
      return value;
    };
    while (at < text.size()) {
      const std::size_t begin = at;
      const double value = number();
      if (at == begin) {  // a name ends where its letters do, digits among them
        do ++at;
        while (at < text.size() && is_word(text[at - 1]) && is_word(text[at]));
        continue;
      }
      double size = value > 0 ? std::abs(std::log10(value)) : 0;
      if (at < text.size() && text[at] == '^') {
        ++at;
        if (at < text.size() && text[at] == '-') ++at;
        size *= number();
      }
      if (!(size > size_)) continue;
      size_ = size;
      place_ = document_.where(scalar, begin);
    }
  }

  const Document& document_;
  SourceLocation place_;
  double size_ = 0;
};

}  // namespace

SourceLocation most_extreme_number(const std::shared_ptr<const SourceText>& source) {
  const Document document(source);
  ExtremeNumber extreme(document);
  extreme.look_below(document.root());
  return extreme.place();
}

}  // namespace alembert
