// Numbers and names as languages write them, see the header.
#include "emit/statements/syntax.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "emit/statements/literals.hpp"

namespace alembert {

bool is_helper(std::string_view function) {
  return std::ranges::find(kHelpers, function) != std::end(kHelpers);
}

std::string c_literal(double value, std::string_view number) {
  if (number != "float") return number_literal(value);
  const auto rounded = static_cast<float>(value);
  if (std::isinf(rounded)) return rounded < 0 ? "-INFINITY" : "INFINITY";
  std::string text = fmt::format("{}", rounded);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text + "f";
}

std::string Syntax::constant(double value) const {
  if (dialect == Dialect::cpp) return fmt::format("{}({})", number, number_literal(value));
  const std::string literal = c_literal(value, number);
  return literal.starts_with('-') ? "(" + literal + ")" : literal;
}

std::string Syntax::table_constant(double value) const {
  return c_literal(value, table_number);
}

std::string Syntax::row_entry(std::uint32_t index) const {
  if (dialect == Dialect::javascript) return fmt::format("table[row + {}]", index);
  const std::string entry = fmt::format("row[{}]", index);
  return dialect == Dialect::cpp ? fmt::format("{}({})", number, entry) : entry;
}

std::string Syntax::definition(std::string_view name, std::string_view value, bool varies) const {
  if (dialect == Dialect::javascript)
    return fmt::format("{} {} = {};", varies ? "let" : "const", name, value);
  return fmt::format("{}{} {} = {};", varies ? "" : "const ", number, name, value);
}

std::string Syntax::array(std::string_view name, std::string_view items) const {
  if (dialect == Dialect::javascript) return fmt::format("const {} = [{}];", name, items);
  return fmt::format("const {} {}[] = {{{}}};", number, name, items);
}

std::string Syntax::table_definition(std::string_view items) const {
  if (dialect == Dialect::javascript) return fmt::format("{} table = [\n    {}];", table, items);
  return fmt::format("{} {} table[] = {{\n    {}}};", table, table_number, items);
}

std::string_view Syntax::counter() const {
  return dialect == Dialect::javascript ? "let" : "int";
}

std::string Syntax::table_row(std::uint32_t columns) const {
  if (dialect == Dialect::javascript) return fmt::format("const row = {} * k;", columns);
  return fmt::format("const {}* const row = table + {} * k;", table_number, columns);
}

std::string Syntax::function(std::string_view name) const {
  if (is_helper(name)) return helpers + std::string(name);
  if (dialect == Dialect::cpp) return std::string(name);
  if (dialect == Dialect::javascript) return fmt::format("Math.{}", name);
  // Of <math.h>.
  const std::string base = name == "abs" ? "fabs" : std::string(name);
  return number == "float" ? base + "f" : base;
}

Syntax cpp_syntax() {
  return {.number = "S",
          .inputs = "in.",
          .helpers = "",
          .table = "static constexpr",
          .table_number = "double",
          .dialect = Dialect::cpp};
}

Syntax c_syntax(const std::string& number, const std::string& prefix) {
  return {.number = number,
          .inputs = "",
          .helpers = prefix,
          .table = "static const",
          .table_number = number,
          .dialect = Dialect::c};
}

Syntax javascript_syntax() {
  return {.number = "",
          .inputs = "given.",
          .helpers = "",
          .table = "const",
          .table_number = "",
          .dialect = Dialect::javascript};
}

}  // namespace alembert
