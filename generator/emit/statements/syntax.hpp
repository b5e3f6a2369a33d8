// What differs from language to language in statements: how numbers, inputs, tables and calls are written.
// The order of statements, what gets a name and what is a loop are the same in all.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "support/operation.hpp"

namespace alembert {

enum class Dialect : std::uint8_t { cpp, c, javascript };

struct Syntax {
  std::string number;        ///< type of numbers: S, double, float; in JavaScript none
  std::string inputs;        ///< before `t`, `parameters` and `wrenches`
  std::string helpers;       ///< before the names of kHelpers
  std::string table;         ///< what a table of constants is declared as, its type apart
  std::string table_number;  ///< and its type
  /// cpp: functions are brought in by `using` and take sizes as template arguments. javascript: w belongs to the
  /// module, and there are no pointers into arrays.
  Dialect dialect;

  /// `const S x = value;`, or of a variable `S x = value;`
  std::string definition(std::string_view name, std::string_view value, bool varies = false) const;
  /// `const S x[] = {items};`
  std::string array(std::string_view name, std::string_view items) const;
  /// `static constexpr double table[] = {` and the items, below.
  std::string table_definition(std::string_view items) const;
  /// What counts a loop: int.
  std::string_view counter() const;
  /// `const S* const row = table + columns * k;`
  std::string table_row(std::uint32_t columns) const;
  /// A constant in an expression or a table; an entry of a table's row.
  std::string constant(double value) const;
  std::string table_constant(double value) const;
  std::string row_entry(std::uint32_t index) const;
  /// What a function that is called is called here: one of operation_name or of the helpers.
  std::string function(std::string_view name) const;
};

/// Templates over a scalar type S.
Syntax cpp_syntax();

/// C99, for double or float; names of helpers begin with `prefix`.
Syntax c_syntax(const std::string& number, const std::string& prefix);

/// JavaScript; inputs are members of `given`.
Syntax javascript_syntax();

/// The functions that generated code brings along, in the order in which it does: NAME stands in the templates
/// NAME.hpp, c99_NAME.c and javascript_NAME.mjs.
inline constexpr std::string_view kHelpers[] = {"sign",     "if_positive",       "unless_positive",
                                                "rounding", "sines_and_cosines", "dot_products"};
/// Whether it is one of them.
bool is_helper(std::string_view function);

/// A literal of C for double or float: 0.5, 0.5f; INFINITY for what float cannot hold.
std::string c_literal(double value, std::string_view number);

}  // namespace alembert
