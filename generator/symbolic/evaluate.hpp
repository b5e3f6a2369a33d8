// Evaluation in double precision. In: roots and the values of all symbols. Out: the values of the roots, or
// of all nodes.
#pragma once

#include <span>
#include <vector>

#include "symbolic/expr.hpp"
#include "symbolic/postorder.hpp"

namespace alembert {

/// Values of the roots in double precision; `symbols[i]` is the value of the symbol with index i.
std::vector<double> evaluate(std::span<const Expr> roots, std::span<const double> symbols);
/// Value of an expression without symbols.
double value_of(Expr constant);

/// Values of all nodes of an order in double precision; symbols[i] belongs to the symbol with index i.
std::vector<double> node_values(const ExprGraph& graph, const Postorder& order,
                                std::span<const double> symbols);

}  // namespace alembert
