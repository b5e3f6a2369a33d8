// Energies, poses of bodies and frames, Jacobians of both, inertias of bodies.
#pragma once

#include <span>
#include <vector>

#include "dynamics/tree/motion_tree.hpp"
#include "dynamics/tree/speed_derivatives.hpp"
#include "mechanism/model.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// Kinetic and potential energy, in this order.
std::vector<Expr> energies(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph);

/// World poses of the bodies' own frames, 12 expressions each: rows of [R | p].
std::vector<Expr> body_poses(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph);
/// World poses of the named frames, likewise.
std::vector<Expr> frame_poses(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph);
/// Jacobians of the named frames, 6 x nv each, row major: angular velocity, then velocity of the origin,
/// world axes.
std::vector<Expr> frame_jacobians(const Mechanism& mechanism, const SpeedDerivatives& derivatives,
                                  std::span<const Expr> poses, ExprGraph& graph);
/// Jacobians of the bodies, 6 x nv each, row major: angular velocity, then velocity of the centre of mass,
/// world axes.
std::vector<Expr> body_jacobians(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph);
/// Ten of each body: mass, centre of mass, inertia about it xx yy zz xy xz yz, all in the body's axes.
std::vector<Expr> body_inertias(const Mechanism& mechanism);

}  // namespace alembert
