// Differentiation behind one door. In: roots and symbols. Out: all partial derivatives. Three methods, each a
// test of the others: forward, reverse, and D* (Guenter 2007) on the derivative graph.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "symbolic/expr.hpp"

namespace alembert {

enum class DerivativeMethod { forward, reverse, d_star };

/// Partial derivatives, row major: entry(i, j) = d root_i / d variable_j.
struct Jacobian {
  std::size_t rows = 0, columns = 0;
  std::vector<Expr> entries;
  Expr operator()(std::size_t i, std::size_t j) const { return entries[i * columns + j]; }
  DerivativeMethod method = DerivativeMethod::forward;  ///< the one that was kept
  bool d_star_gave_up = false;  ///< the step cap was reached; forward or reverse was used instead
};

/// The portfolio: all three, the one with the fewest operations (roots and derivatives together, after value
/// numbering) kept; a call of sin, cos or tan counts as one operation. On a tie forward is preferred, then
/// reverse.
Jacobian jacobian(std::span<const Expr> roots, std::span<const Expr> variables);

}  // namespace alembert
