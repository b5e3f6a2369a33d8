// Forward dynamics under constraints and its derivatives. In: kinematics and equations of motion of the tree. Out:
// rates of the speeds and reactions, as straight-line expressions.
#pragma once

#include <vector>

#include "dynamics/choice/equations_of_motion.hpp"

namespace alembert {

/// M du/dt + c = tau + P^T lambda, P du/dt + gamma = 0. A row that follows from those before it has lambda = 0.
struct ConstrainedMotion {
  std::vector<Expr> rates;    ///< nv
  std::vector<Expr> lambdas;  ///< n_c
};
ConstrainedMotion constrained_forward_dynamics(const Kinematics& kinematics,
                                               const EquationsOfMotion& equations);

/// Row major, nv x nv and n_c x nv: along the speeds, by the speeds and by the forces.
struct ConstrainedDerivatives {
  std::vector<Expr> rates_along, rates_by_speeds, rates_by_forces;
  std::vector<Expr> lambdas_along, lambdas_by_speeds, lambdas_by_forces;
};
ConstrainedDerivatives constrained_forward_dynamics_derivatives(const Kinematics& kinematics,
                                                                const EquationsOfMotion& equations);

}  // namespace alembert
