// Substitution. In: roots and replacements. Out: the roots with symbols replaced.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "symbolic/expr.hpp"

namespace alembert {

/// Replaces symbols by expressions, all at once (x -> y, y -> x swaps).
std::vector<Expr> substitute(std::span<const Expr> roots,
                             std::span<const std::pair<Expr, Expr>> replacements);

}  // namespace alembert
