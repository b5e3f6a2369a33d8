// The Coriolis matrix: equations of motion in, the shortest of what several methods give out.
#pragma once

#include <vector>

#include "dynamics/choice/equations_of_motion.hpp"

namespace alembert {

/// C, nv x nv, row major: C_ij = sum over particles m D_i r . d(D_j r)/dt, so that c is C u with gravity, applied
/// forces and what time adds, and dM/dt = C + C^T.
std::vector<Expr> coriolis_matrix(const Kinematics& kinematics, const EquationsOfMotion& equations);

}  // namespace alembert
