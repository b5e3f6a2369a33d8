// Text that goes into code: numbers, and names and descriptions of the user made harmless in comments and
// strings.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace alembert {

/// Shortest decimal text that reads back as the same double, with a point or an exponent; independent of the
/// locale. InternalError for NaN and infinity.
std::string number_literal(double value);

/// One line of plain text that ends neither a line comment nor a block comment and starts none: no line
/// breaks, backslashes, comment marks or trigraphs. Control characters, text that changes the direction of
/// reading and what is no UTF-8 appear as <U+202E> or <FF>.
std::string comment_text(std::string_view text);

/// A string literal of C and C++, quotes included, whose value is `text`.
std::string string_literal(std::string_view text);

/// A string literal of JavaScript, quotes included, which cannot end an element of HTML. Bytes beyond ASCII
/// stand for themselves.
std::string javascript_string(std::string_view text);

/// `a, b, c`, for comments; past `limit` names the rest is counted.
std::string name_list(std::span<const std::string> names, std::size_t limit = 12);

/// Each line of `text` behind `prefix`, without blanks at the ends of lines.
std::string prefix_lines(std::string_view text, std::string_view prefix);

/// Breaks a text at blanks so that no line passes `width` if it can be helped, given that it starts at
/// `column` and goes on at `indent`.
std::string wrap_words(std::string_view text, std::size_t column, std::size_t indent,
                       std::size_t width = 118);

/// The same for a list, broken after `, ` only.
std::string wrap_list(std::string_view list, std::size_t column, std::size_t indent, std::size_t width = 118);

/// A list that stands behind `start`: its lines go on below its first item, but not right of column `most`.
std::string wrap_behind(std::string_view start, std::string_view list, std::size_t most = 40);

}  // namespace alembert
