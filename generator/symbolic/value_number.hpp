// Value numbering. In: roots. Out: the same with equal values found, however they are written.
#pragma once

#include <span>
#include <vector>

#include "symbolic/expr.hpp"

namespace alembert {

/// Merges nodes that have equal values (up to sign, or to a constant factor 0) at two random points of the
/// modular field, confirmed at two fresh points: probabilistic value numbering. Throws std::domain_error as
/// `simplify` does.
std::vector<Expr> value_number(std::span<const Expr> roots);
/// In place, all at once: what these share is found.
void value_number_all(const std::vector<std::vector<Expr>*>& arrays);

}  // namespace alembert
