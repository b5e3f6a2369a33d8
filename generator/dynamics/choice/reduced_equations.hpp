// Equations by the reduced form (README.md, 2) with the fewest operations that the passes find: trees of
// motions that describe the same dynamics in, the shortest Q, M and c out.
#pragma once

#include "dynamics/choice/equations_of_motion.hpp"

namespace alembert {

/// See equations_of_motion.
EquationsOfMotion reduced_equations(const Kinematics& kinematics, Passes passes);

}  // namespace alembert
