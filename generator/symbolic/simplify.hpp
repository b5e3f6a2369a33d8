// Simplification. In: roots. Out: equal ones that need no more operations.
#pragma once

#include <span>
#include <vector>

#include "symbolic/expr.hpp"

namespace alembert {

/// Equal roots, smaller: sin^2+cos^2 with common factors, common factors of sums, like terms, sqrt of squares
/// under proven sign, cancellation of quotients. The set never needs more operations than it was given.
/// Throws std::domain_error if a divisor turns out to be zero everywhere.
std::vector<Expr> simplify(std::span<const Expr> roots);

}  // namespace alembert
