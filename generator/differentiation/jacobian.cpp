// The portfolio. In: roots and variables. Out: the Jacobian by whichever method costs the fewest operations,
// roots and derivatives counted together after equal values have been merged.
#include "differentiation/jacobian.hpp"

#include <utility>

#include "differentiation/d_star.hpp"
#include "differentiation/forward.hpp"
#include "differentiation/reverse.hpp"
#include "symbolic/count_operations.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {

namespace {

/// Operations of the roots and the derivatives together, equal values counted once. Unweighted: where divisions
/// weigh more, other methods win and 11 of 542 functions get longer (inverse dynamics of the knee 238 to 246).
std::size_t cost(std::span<const Expr> roots, std::span<const Expr> derivatives) {
  std::vector<Expr> all(roots.begin(), roots.end());
  all.insert(all.end(), derivatives.begin(), derivatives.end());
  return count_operations(value_number(all)).all();
}

}  // namespace

Jacobian jacobian(std::span<const Expr> roots, std::span<const Expr> variables) {
  Jacobian best = jacobian_forward(roots, variables);
  std::size_t best_cost = cost(roots, best.entries);
  // Derivatives that are constants, or parts of the roots, cost nothing: there is nothing to be gained.
  if (best_cost == cost(roots, {})) return best;

  // On a tie the method that came first stays.
  const auto consider = [&](Jacobian&& other) {
    const std::size_t other_cost = cost(roots, other.entries);
    if (other_cost >= best_cost) return;
    best = std::move(other);
    best_cost = other_cost;
  };
  consider(jacobian_reverse(roots, variables));
  Jacobian factored = jacobian_d_star(roots, variables);
  const bool gave_up = factored.d_star_gave_up;
  if (!gave_up) consider(std::move(factored));  // otherwise it is the reverse mode once more
  best.d_star_gave_up = gave_up;
  return best;
}

}  // namespace alembert
