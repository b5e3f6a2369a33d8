// Stages `kinematics` and `equations`: typed mechanism in, equations of motion and the other output functions
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

/// The kinematics as the description has them: nothing is simplified, which ExprGraph::leave_as_written sees to, or peeled.
Kinematics plain_kinematics(const Mechanism& mechanism, ExprGraph& graph);

/// Stage `equations`. Q by the formulation; M by `coefficient`, or by composite bodies where that is shorter;
/// c by `substitute`. The passes are for the reduced form.
EquationsOfMotion equations_of_motion(const Kinematics& kinematics, Formulation formulation,
                                      Passes passes = {});

}  // namespace alembert
