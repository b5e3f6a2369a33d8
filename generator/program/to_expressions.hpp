// A program as expressions again, for what only expressions can do. In: a program. Out: its outputs in a
// graph.
#pragma once

#include <optional>
#include <vector>

#include "program/program.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// The symbols `input 0`, `input 1`, ... of `graph`, one for each input of the program, made if need be in
/// this order.
std::vector<Expr> input_symbols(const Program& program, ExprGraph& graph);

/// Elements of all outputs, in order, over `input_symbols`; constants are what `ExprGraph::real` makes of
/// them. Nothing if the program divides by the constant zero or applies a function to constants, which
/// expressions may refuse.
std::optional<std::vector<Expr>> to_expressions(const Program& program, ExprGraph& graph);

}  // namespace alembert
