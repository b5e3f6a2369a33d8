// Inverse dynamics by the factored Lagrangian (README.md, 1).
#pragma once

#include <vector>

#include "dynamics/tree/speed_derivatives.hpp"
#include "mechanism/model.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// Q by eq. (13), literally: 4x4 transforms, their first and second derivatives, phi recursion.
std::vector<Expr> factored_inverse_dynamics(const Mechanism& mechanism, const SpeedDerivatives& derivatives,
                                            ExprGraph& graph);

}  // namespace alembert
