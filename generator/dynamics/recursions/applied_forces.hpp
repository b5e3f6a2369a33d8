// Generalized forces of what acts besides gravity and external wrenches, the values of outputs and the rates of
// states (see the implementation).
#pragma once

#include <vector>

#include "dynamics/tree/motion_tree.hpp"
#include "dynamics/tree/spatial_vectors.hpp"
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

/// What forces do to bodies, summed by body: moment and force about the origin of the body's node (or of the world), in
/// its axes. Those along a speed act in a joint and are not among them; a potential or a path pulls at the frames
/// that it is a function of. Empty where there are no forces.
std::vector<Wrench> applied_wrenches(const Mechanism& mechanism, const MotionTree& tree,
                                     const SpeedDerivatives& derivatives, ExprGraph& graph);

/// Q of each name of force_names by itself, a row each.
std::vector<Expr> force_contributions(const Mechanism& mechanism, const MotionTree& tree,
                                      const SpeedDerivatives& derivatives, ExprGraph& graph);

}  // namespace alembert
