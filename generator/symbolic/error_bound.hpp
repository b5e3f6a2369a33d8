// Running error analysis: how far a computed value can be from the exact one. In: an operation, its operands
// with their errors, its result; or roots and the values of all symbols. Out: the error of the result; the
// values of the roots with theirs.
#pragma once

#include <span>
#include <vector>

#include "symbolic/expr.hpp"

namespace alembert {

/// Half the distance from 1 to the next double.
inline constexpr double kUnitRoundoff = 0x1p-53;

/// A computed value and a bound on its distance to the exact value, to first order.
struct Approximate {
  double value = 0;
  double error = 0;
};

/// Error of `result` = op(a, b): that of the operands carried through the derivative, and the operation's own
/// rounding. Infinite where the operation is not continuous within the errors of its operands. Source: N. J.
/// Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., section 3.3 (running error analysis).
double error_bound(Op op, Approximate a, Approximate b, double result);

/// Values of the roots in double precision; symbols are exact, `symbols[i]` the one with index i.
std::vector<Approximate> evaluate_bounded(std::span<const Expr> roots, std::span<const double> symbols);

}  // namespace alembert
