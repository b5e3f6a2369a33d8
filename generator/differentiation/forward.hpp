// Forward differentiation, one column of the Jacobian a sweep.
#pragma once

#include <span>

#include "differentiation/jacobian.hpp"

namespace alembert {

/// All partial derivatives, one column a sweep, from the variables up.
/// `variables` must be distinct symbols of the roots' graph, otherwise std::invalid_argument is thrown; a
/// variable that does not occur has derivative zero. Differentiating `sign` gives zero, `abs` gives `sign`.
Jacobian jacobian_forward(std::span<const Expr> roots, std::span<const Expr> variables);

}  // namespace alembert
