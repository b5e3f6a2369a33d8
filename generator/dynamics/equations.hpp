// Stages `kinematics` and `equations`: typed mechanism in, equations of motion and what else can be asked for
// out.
//
// Letters: q coordinates, u speeds (qd), ud their rates (qdd), qdot = N(q) u; M(q) ud + c(q, u, t) = Q.
// A_i transform of body i in its parent, W_i = W_p(i) A_i in the world.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dynamics/choice/equations_of_motion.hpp"
#include "dynamics/choice/program_lengths.hpp"
#include "dynamics/tree/motion_tree.hpp"
#include "dynamics/tree/speed_derivatives.hpp"
#include "mechanism/model.hpp"
#include "program/lower.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

std::string_view to_string(Formulation formulation);

/// Throws InputError where a transform has no frame, or none at the initial state.
Kinematics symbolic_kinematics(const Mechanism& mechanism, ExprGraph& graph);

/// Stage `equations`. Q by the formulation; M by `coefficient`, or by composite bodies where that is shorter;
/// c by `substitute`. The passes are for the reduced form.
EquationsOfMotion equations_of_motion(const Kinematics& kinematics, Formulation formulation,
                                      Passes passes = {});

/// The functions that can be asked for.
enum class FunctionKind {
  inverse_dynamics,
  mass_matrix,
  bias,
  mass_matrix_and_bias,
  forward_dynamics,
  coordinate_rates,
  energy,
  body_poses,
  frame_poses,
  frame_jacobians,
  constraints,
  body_jacobians,
  body_inertias,
  inverse_dynamics_derivatives,
};
std::string_view to_string(FunctionKind kind);
std::span<const FunctionKind> all_function_kinds();

/// The results of one function as expressions over the bound symbols: tau; M; c; M and c; qdd; qdot; energy
/// (kinetic, potential); poses (rows [R | p] of each body); frames (likewise); J (6 x nv of each frame); P,
/// gamma, velocity and position of the constraints (constraints.hpp); J (6 x nv of each body's centre of
/// mass); inertias (10 of each body: mass, centre of mass, inertia about it xx yy zz xy xz yz, body axes);
/// derivatives of tau along the speeds and by them (nv x nv each) at given qdd.
///
/// The equations of motion are those of the tree: constraints act through M ud + c = tau + P^T lambda.
std::vector<OutputExpressions> function_outputs(const Kinematics& kinematics,
                                                const EquationsOfMotion& equations, FunctionKind kind);

}  // namespace alembert
