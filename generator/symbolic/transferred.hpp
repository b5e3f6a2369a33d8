// Roots in another graph. In: roots. Out: the same expressions, node for node.
#pragma once

#include <span>
#include <vector>

#include "symbolic/expr.hpp"

namespace alembert {

/// The roots in the graph `to`, whose rules of construction are not applied. Symbols are those of the same names; a symbol
/// that `to` does not have yet is assumed in the interval that it has here.
std::vector<Expr> transferred(std::span<const Expr> roots, ExprGraph& to);

}  // namespace alembert
