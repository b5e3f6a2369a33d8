// The formulations of the equations of motion, each from the tree of motions (or the bodies' transforms) to
// expressions.
//
// Letters: om, al angular velocity and its rate, acc acceleration of a frame's origin, f, n force and moment,
// all in the axes of the frame they belong to; U = skew(al) + skew(om)^2; h = m c first moment; J inertia
// about the frame's origin.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "dynamics/tree/motion_tree.hpp"
#include "dynamics/tree/speed_derivatives.hpp"
#include "mechanism/model.hpp"

namespace alembert {

/// World force at the centre of mass and world torque of a body with external_wrench; symbols
/// `wrench(body).fx` ... `.tz`.
struct WrenchSymbols {
  int body;
  Vec3 force, torque;
};
std::vector<WrenchSymbols> wrench_symbols(const Mechanism& mechanism, ExprGraph& graph);

/// The generalized force of a speed, `tau(coordinate)`; of a quaternion's speeds with .x .y .z.
Expr tau_symbol(const Mechanism& mechanism, int speed, ExprGraph& graph);

/// Q by the reduced form: outward twists and accelerations, inward forces (README.md, 2).
std::vector<Expr> reduced_inverse_dynamics(const Mechanism& mechanism, const MotionTree& tree,
                                           ExprGraph& graph);

/// Q by eq. (13), literally: 4x4 transforms, their first and second derivatives, phi recursion.
std::vector<Expr> factored_inverse_dynamics(const Mechanism& mechanism, const SpeedDerivatives& derivatives,
                                            ExprGraph& graph);

/// By speed: inertia of its own (armature.cpp), and the force that accelerates it.
std::vector<Expr> armatures(const Mechanism& mechanism);
std::vector<Expr> armature_forces(const Mechanism& mechanism);

/// How the momentum of a unit motion comes to those far inward of it.
enum class FarPairs {
  carry,       ///< from joint to joint
  meet,        ///< in a common frame, where that is estimated to take less (meeting_frames.hpp)
  meet_sooner  ///< the same, with an estimate that is in favour of common frames
};
/// M (nv x nv, row major, symmetric) by composite bodies over the tree, contracted where speeds are shared.
std::vector<Expr> composite_mass_matrix(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph,
                                        FarPairs far = FarPairs::carry);

/// M by `coefficient` (lower triangle of Q, mirrored).
std::vector<Expr> coefficient_mass_matrix(const Mechanism& mechanism, std::span<const Expr> Q);

/// c by `substitute`: Q with the rates of the speeds zero.
std::vector<Expr> bias_by_substitution(const Mechanism& mechanism, std::span<const Expr> Q, ExprGraph& graph);

/// ud = M^-1 (tau - c) by L^T D L from the last speed to the first, which keeps the zeros of a tree; straight
/// line.
std::vector<Expr> straight_line_solve(std::vector<Expr> M, std::vector<Expr> right_side);

/// The same by articulated bodies over a tree of the mechanism's motions, O(n); nothing where a speed moves
/// several bodies' joints (articulated_bodies.cpp). M is not positive: division by zero.
std::optional<std::vector<Expr>> articulated_solve(const Mechanism& mechanism, const MotionTree& tree,
                                                   std::span<const Expr> right_side, ExprGraph& graph);

/// D_l Q_k, then dQ_k/du_l (nv x nv each, row major), by recursions over a tree of the mechanism's motions.
std::vector<Expr> recursive_force_derivatives(const Mechanism& mechanism, const MotionTree& tree,
                                              const SpeedDerivatives& derivatives, ExprGraph& graph,
                                              FarPairs far);

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
