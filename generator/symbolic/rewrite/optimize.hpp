// Stage `optimise`: expressions in, equal ones of no more operations out.
#pragma once

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

}  // namespace alembert
