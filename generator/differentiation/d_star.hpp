// Differentiation by D* (Guenter 2007), on the derivative graph.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "differentiation/jacobian.hpp"

namespace alembert {

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

}  // namespace alembert
