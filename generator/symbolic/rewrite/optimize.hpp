// Stage `optimise`: expressions in, equal ones of no more operations out.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "symbolic/expr.hpp"

namespace alembert {

/// Stage `optimise`: constants as doubles, value numbering, a*b + a*c -> a*(b + c) with single-use products,
/// products that share pairs of factors, shared reciprocals and merged quotients; each kept only if it lowers
/// the weight of all operations (OperationCount), so that the result never costs more. Values change by
/// rounding only, except that 0*x and x - x are 0 whatever x is. Throws InternalError if a constant has no
/// finite value.
std::vector<Expr> optimize(std::span<const Expr> roots);

/// Where a list may be given up: behind the first round of rewrites, and before other ways to factor are tried.
inline constexpr std::size_t kOptimizeStages = 2;
/// Whether optimising goes on with a list that takes so many operations at a stage.
using GoesOn = std::function<bool(std::size_t stage, std::size_t operations)>;
/// As above; nothing where the list was given up.
std::optional<std::vector<Expr>> optimize(std::span<const Expr> roots, const GoesOn& goes_on);

}  // namespace alembert
