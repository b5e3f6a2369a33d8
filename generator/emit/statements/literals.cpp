// Numbers, comments and strings of the emitted code.
#include "emit/statements/literals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "support/error.hpp"

namespace alembert {
namespace {

struct CodePoint {
  std::uint32_t value;
  std::size_t bytes;
};

/// The well-formed UTF-8 sequence at the start of `text`, if there is one (Unicode 15, table 3-7).
std::optional<CodePoint> decode_utf8(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i]));
  };
  const std::uint32_t first = byte(0);
  if (first < 0x80) return CodePoint{first, 1};
  const std::size_t length = first >= 0xC2 && first <= 0xDF   ? 2
                             : first >= 0xE0 && first <= 0xEF ? 3
                             : first >= 0xF0 && first <= 0xF4 ? 4
                                                              : 0;
  if (length == 0 || text.size() < length) return std::nullopt;
  std::uint32_t value = first & (0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0u) != 0x80u) return std::nullopt;
    value = value << 6 | (byte(i) & 0x3Fu);
  }
  const bool overlong = (length == 3 && value < 0x800) || (length == 4 && value < 0x10000);
  const bool surrogate = value >= 0xD800 && value <= 0xDFFF;
  if (overlong || surrogate || value > 0x10FFFF) return std::nullopt;
  return CodePoint{value, length};
}

/// Neither a control character nor one that hides, reorders or ends text.
bool is_plain(std::uint32_t c) {
  if (c < 0x80) return c >= 0x20 && c != 0x7F;
  if (c < 0xA0 || c == 0xAD || c == 0x61C) return false;
  if (c >= 0x2000 && c <= 0x206F) return c >= 0x2010 && c <= 0x2027;
  if (c >= 0xE000 && c <= 0xF8FF) return false;
  if (c == 0xFEFF || (c >= 0xFFF0 && c <= 0xFFFF)) return false;
  return c < 0xE0000;
}

}  // namespace

std::string number_literal(double value) {
  if (!std::isfinite(value)) throw InternalError("emit: a constant is not finite");
  std::string text = fmt::format("{}", value);  // shortest round trip; fmt asks no locale
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string comment_text(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::optional<CodePoint> c = decode_utf8(text);
    const std::size_t bytes = c ? c->bytes : 1;
    if (!c) {
      out += fmt::format("<{:02X}>", static_cast<unsigned>(static_cast<unsigned char>(text[0])));
    } else if (c->value == '\n' || c->value == '\r' || c->value == '\t') {
      out += ' ';
    } else if (c->value == '\\' || !is_plain(c->value)) {
      out += fmt::format("<U+{:04X}>", c->value);
    } else {
      // A blank between the halves of /*, */, // and ??
      const char previous = out.empty() ? ' ' : out.back();
      const bool splits = (c->value == '/' && (previous == '*' || previous == '/')) ||
                          (c->value == '*' && previous == '/') || (c->value == '?' && previous == '?');
      if (splits) out += ' ';
      out += text.substr(0, bytes);
    }
    text.remove_prefix(bytes);
  }
  return out;
}

std::string string_literal(std::string_view text) {
  std::string out = "\"";
  for (const char character : text) {
    const auto byte = static_cast<unsigned char>(character);
    if (byte < 0x20 || byte >= 0x7F) {
      out += fmt::format("\\{:03o}", static_cast<unsigned>(byte));
    } else {
      if (character == '"' || character == '\\' || character == '?') out += '\\';
      out += character;
    }
  }
  return out + '"';
}

std::string javascript_string(std::string_view text) {
  std::string out = "\"";
  for (const char character : text) {
    const auto byte = static_cast<unsigned char>(character);
    if (byte < 0x20 || byte >= 0x7F || character == '"' || character == '\\' || character == '<')
      out += fmt::format("\\x{:02x}", static_cast<unsigned>(byte));
    else
      out += character;
  }
  return out + '"';
}

std::string name_list(std::span<const std::string> names, std::size_t limit) {
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i == limit && names.size() > limit + 1)
      return out + fmt::format(" and {} more", names.size() - limit);
    out += (i == 0 ? "" : ", ") + comment_text(names[i]);
  }
  return out.empty() ? "none" : out;
}

std::string prefix_lines(std::string_view text, std::string_view prefix) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string line = std::string(prefix) + std::string(text.substr(0, end));
    line.erase(line.find_last_not_of(' ') + 1);
    out += line;
    if (end < text.size()) out += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

namespace {

std::string wrap_after(std::string_view separator, std::string_view text, std::size_t column,
                       std::size_t indent, std::size_t width) {
  std::string out;
  while (!text.empty()) {
    const std::size_t found = text.find(separator);
    const std::size_t end = found == std::string_view::npos ? text.size() : found + separator.size();
    const std::string_view item = text.substr(0, end);
    const std::size_t shown = item.size() - (item.ends_with(' ') ? 1 : 0);
    if (column + shown > width && column > indent && !out.empty()) {
      out.erase(out.find_last_not_of(' ') + 1);
      out += '\n';
      out.append(indent, ' ');
      column = indent;
    }
    out += item;
    column += item.size();
    text.remove_prefix(end);
  }
  return out;
}

}  // namespace

std::string wrap_words(std::string_view text, std::size_t column, std::size_t indent, std::size_t width) {
  return wrap_after(" ", text, column, indent, width);
}

std::string wrap_list(std::string_view list, std::size_t column, std::size_t indent, std::size_t width) {
  return wrap_after(", ", list, column, indent, width);
}

std::string wrap_behind(std::string_view start, std::string_view list, std::size_t most) {
  return wrap_list(list, start.size(), std::min(start.size(), most));
}

}  // namespace alembert
