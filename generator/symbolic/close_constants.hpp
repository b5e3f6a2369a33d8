// Constants that agree to rounding. In: roots. Out: the same roots with one constant for each group of such.
// Private to this room.
#pragma once

#include <span>
#include <vector>

#include "symbolic/expr.hpp"

namespace alembert {

/// Roots in which a computed constant (a real number) that agrees with another one, or with a rational, to
/// four units in the last place, up to sign, is that one: a rational, if there is one so close, or else the
/// one found first.
///
/// Numbers that were computed in two ways differ in their last digits, and with them all products that they
/// are in. Rationals are what was written, and stay apart. What is computed from constants alone keeps the
/// constants it has: only there is a difference of two of them more than rounding.
std::vector<Expr> merge_close_constants(std::span<const Expr> roots);

}  // namespace alembert
