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

/// All partial derivatives, one column a sweep, from the variables up.
/// `variables` must be distinct symbols of the roots' graph, otherwise std::invalid_argument is thrown; a
/// variable that does not occur has derivative zero. Differentiating `sign` gives zero, `abs` gives `sign`.
Jacobian jacobian_forward(std::span<const Expr> roots, std::span<const Expr> variables);
/// The same, one row a sweep, from the root down.
Jacobian jacobian_reverse(std::span<const Expr> roots, std::span<const Expr> variables);

struct DStarOptions {
  std::size_t max_steps = 20000;         ///< factorings before it gives up
  std::uint64_t max_work = 200'000'000;  ///< edges visited before it gives up, about a second or two
  bool check = false;  ///< verify the path sums modulo a prime after every step (tests, debug)
};
/// The same by factoring the derivative graph: d root / d variable is the sum over all paths between them of
/// the products of local derivatives, and whatever lies between a vertex and its dominator or postdominator
/// on many paths becomes one factor. Returns the reverse-mode result with d_star_gave_up set if a limit is
/// reached. Throws InternalError if a result is not the sum over its paths (always checked, at a random point
/// modulo a prime). Guenter, "Efficient symbolic differentiation for graphics applications", SIGGRAPH 2007.
Jacobian jacobian_d_star(std::span<const Expr> roots, std::span<const Expr> variables,
                         DStarOptions options = {});

/// The portfolio: all three, the one with the fewest operations (roots and derivatives together, after value
/// numbering) kept; a call of sin, cos or tan counts as one operation. On a tie forward is preferred, then
/// reverse.
Jacobian jacobian(std::span<const Expr> roots, std::span<const Expr> variables);

}  // namespace alembert
