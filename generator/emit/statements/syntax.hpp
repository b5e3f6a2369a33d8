// What differs from language to language in statements: how numbers, inputs, tables and calls are written.
// The order of statements, what gets a name and what is a loop are the same in all.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "support/operation.hpp"

namespace alembert {

struct Syntax {
  std::string number;        ///< type of numbers: S, double, float
  std::string inputs;        ///< before `t`, `parameters` and `wrenches`
  std::string helpers;       ///< before the names of kHelpers
  std::string table;         ///< what a table of constants is declared as, but for its type
  std::string table_number;  ///< and its type
  bool templates;            ///< functions are brought in by `using` and take sizes as template arguments

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

/// The functions that generated code brings along, in the order in which it does: NAME stands in the templates
/// NAME.hpp and c99_NAME.c.
inline constexpr std::string_view kHelpers[] = {"sign", "if_positive", "unless_positive", "sines_and_cosines",
                                                "dot_products"};
/// Whether it is one of them.
bool is_helper(std::string_view function);

/// A literal of C for double or float: 0.5, 0.5f; INFINITY for what float cannot hold.
std::string c_literal(double value, std::string_view number);

}  // namespace alembert
