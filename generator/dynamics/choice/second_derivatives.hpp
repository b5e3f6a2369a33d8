// Second derivatives of inverse dynamics, summed with weights mu of the forces: what an optimiser's Hessian
// needs of the dynamics.
#pragma once

#include <vector>

#include "dynamics/choice/equations_of_motion.hpp"

namespace alembert {

/// Of f = sum_k mu_k Q_k(q, u, ud), nv x nv each, row major; D_k is the derivative along speed k.
struct SecondForceDerivatives {
  std::vector<Expr> along_speeds_twice;      ///< [j][k]: D_k D_j f
  std::vector<Expr> along_speeds_by_speeds;  ///< [j][k]: D_j df/du_k
  std::vector<Expr> by_speeds_twice;         ///< [j][k]: d^2 f/(du_j du_k)
  std::vector<Expr> along_speeds_by_rates;   ///< [j][k]: D_j df/dud_k
};

/// The first derivatives of f, nv each.
struct WeightedGradient {
  std::vector<Expr> along_speeds, by_speeds, by_rates;
  std::vector<Expr> all() const;  ///< one after another
};

WeightedGradient weighted_gradient(const Kinematics& kinematics, const std::vector<Expr>& Q);
SecondForceDerivatives second_force_derivatives(const Kinematics& kinematics,
                                                const EquationsOfMotion& equations);

}  // namespace alembert
