// The portfolio. In: roots and variables. Out: the Jacobian by whichever method costs the fewest operations,
// roots and derivatives counted together after equal values have been merged.
#include "differentiation/jacobian.hpp"

#include <utility>

#include "symbolic/passes.hpp"

namespace alembert {

namespace {

/// Operations of the roots and all derivatives together, equal values counted once.
std::size_t cost(std::span<const Expr> roots, const Jacobian& jacobian) {
  std::vector<Expr> all(roots.begin(), roots.end());
  all.insert(all.end(), jacobian.entries.begin(), jacobian.entries.end());
  const ExprCount count = count_operations(value_number(all));
  return count.total() + count.trig;
}

}  // namespace

Jacobian jacobian(std::span<const Expr> roots, std::span<const Expr> variables) {
  Jacobian best = jacobian_forward(roots, variables);
  const std::size_t forward_cost = cost(roots, best);
  Jacobian reverse = jacobian_reverse(roots, variables);
  if (cost(roots, reverse) < forward_cost) best = std::move(reverse);
  return best;
}

}  // namespace alembert
