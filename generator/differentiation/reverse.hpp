// Reverse differentiation, one row of the Jacobian a sweep.
#pragma once

#include <span>

#include "differentiation/jacobian.hpp"

namespace alembert {

/// The same, one row a sweep, from the root down.
Jacobian jacobian_reverse(std::span<const Expr> roots, std::span<const Expr> variables);

}  // namespace alembert
