// Generalized forces of what acts besides gravity and external wrenches, the values of outputs and the rates of
// states (see the implementation).
#pragma once

#include <vector>

#include "dynamics/tree/motion_tree.hpp"
#include "dynamics/tree/speed_derivatives.hpp"
#include "mechanism/model.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

struct AppliedForces {
  std::vector<Expr> Q;        ///< nv; empty where the mechanism has no forces
  Expr potential;             ///< energy of the forces that have a potential
  std::vector<Expr> outputs;  ///< values of Mechanism::outputs, made of the same symbols
  std::vector<Expr> rates;    ///< of the states, likewise
};

/// Forces less those that act already: what actuators must add.
std::vector<Expr> less_applied(std::vector<Expr> forces, const AppliedForces& applied);

/// Throws InputError where a force or a rate has no value at the initial state.
AppliedForces applied_forces(const Mechanism& mechanism, const MotionTree& tree,
                             const SpeedDerivatives& derivatives, ExprGraph& graph);

/// Q of each name of force_names by itself, a row each.
std::vector<Expr> force_contributions(const Mechanism& mechanism, const MotionTree& tree,
                                      const SpeedDerivatives& derivatives, ExprGraph& graph);

}  // namespace alembert
