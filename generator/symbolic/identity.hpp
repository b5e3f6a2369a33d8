// Identities that are proved, not sampled: whether expressions are zero, or independent of symbols, whatever
// the symbols are.
#pragma once

#include <span>
#include <vector>

#include "symbolic/expr.hpp"

namespace alembert {

/// Points at which an identity is tested. A wrong one passes at one of them by a chance of 2^-61, but of 1/2
/// where only the sign of a root is wrong, which the field does not know.
inline constexpr unsigned kIdentityPoints = 40;

/// Whether each root is zero for all values of its symbols. Without symbols: to all digits of Extended,
/// relative to `size`, the largest of what it is a sum of. With symbols: in the field with p^2 elements at
/// fresh random points, where functions that are flat to rounding somewhere are still what they are; what is
/// zero by identities of its functions' arguments only (sin(a + b)) is not seen to be zero.
std::vector<char> vanishing(std::span<const Expr> roots, double size);
bool vanishes(Expr x, double size);

}  // namespace alembert
