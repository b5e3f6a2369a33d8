// Equations by the reduced form (README.md, 2) with the fewest operations that the passes find: trees of
// motions that describe the same dynamics in, the shortest Q, M and c out.
#pragma once

#include "dynamics/equations.hpp"

namespace alembert {

/// See equations_of_motion.
EquationsOfMotion reduced_equations(const Kinematics& kinematics, Passes passes);

/// Operations of the optimised program of these values, trigonometric functions and divisions among them:
/// what counts in the end.
std::size_t program_weight(const Kinematics& kinematics, std::span<const Expr> values);

}  // namespace alembert
