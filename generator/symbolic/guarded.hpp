// Expressions that a condition chooses, made safe to differentiate. In: the condition and what it chooses. Out: the same
// value where it is chosen, and a finite one elsewhere.
#pragma once

#include "symbolic/expr.hpp"

namespace alembert {

/// `x` as an operand of if_positive(c, x), or of unless_positive(c, x). Divisors, and arguments of roots, logarithms,
/// powers, asin and acos that may leave the domain, become 1 (0 for the last two) where x is not chosen. Of the derivatives
/// of a choice one factor is 0 there; no other may then be infinite or without value. Inner choices, and divisors that are
/// roots, as lengths are, stay as they are.
Expr guarded(Operation choice, const Expr& c, const Expr& x);

}  // namespace alembert
