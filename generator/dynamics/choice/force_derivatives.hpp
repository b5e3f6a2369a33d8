// Derivatives of the forces of inverse dynamics, along the speeds and by them: equations of motion in, the
// shortest derivatives that the methods give out.
#pragma once

#include <vector>

#include "dynamics/choice/equations_of_motion.hpp"

namespace alembert {

/// D_l Q_k, then dQ_k/du_l (nv x nv each, row major), where D_l is the derivative along speed l.
std::vector<Expr> force_derivatives(const Kinematics& kinematics, const EquationsOfMotion& equations);

/// The same of any forces Q, nv, by differentiating them as they stand.
std::vector<Expr> derivatives_of_the_whole(const Kinematics& kinematics, const std::vector<Expr>& Q);

}  // namespace alembert
