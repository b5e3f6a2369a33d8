// The last check of D*: in: the derivative graph before factoring, and the derivatives that came out. Out:
// whether each derivative is the sum over its paths.
#pragma once

#include <cstdint>
#include <span>

#include "differentiation/labelled_graph.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

enum class PathComparison : std::uint8_t { equal, different, undecided };

/// Compares `derivatives[p]` with the sum over the paths of pair p at a random point: modulo a prime, where
/// all arithmetic is exact. Where expressions are not represented exactly in that field (constants rounded to
/// double, abs and sign, roots of roots and of constants) the comparison is repeated in double precision; if
/// that cannot confirm them either, the result is `undecided`.
PathComparison compare_with_paths(ExprGraph& expressions, const LabelledGraph& original,
                                  std::span<const Expr> derivatives);

}  // namespace alembert
