// Running error analysis: how far a computed value can be from the exact one. In: an operation, its operands
// with their errors, its result; or roots and the values of all symbols. Out: the error of the result; the
// values of the roots with theirs.
#pragma once

#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "symbolic/expr.hpp"

namespace alembert {

/// About the sum of the magnitudes of the terms that `value` is the sum of: |value| + error / epsilon.
inline double terms_of(const Approximate& sum) {
  return std::abs(sum.value) + sum.error / std::numeric_limits<double>::epsilon();
}

/// Values of the roots in double precision; symbols are exact, `symbols[i]` the one with index i.
std::vector<Approximate> evaluate_bounded(std::span<const Expr> roots, std::span<const double> symbols);
/// The same at several points, one after the other.
std::vector<std::vector<Approximate>> evaluate_bounded(std::span<const Expr> roots,
                                                       std::span<const std::vector<double>> points);

}  // namespace alembert
