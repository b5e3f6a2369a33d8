// Inertia where no joint has moved, for what a model gives relative to it.
#pragma once

#include "import/mjcf/mjcf_model.hpp"

namespace alembert {

/// The diagonal entry of M of a hinge or slide.
double inertia_at_reference(const MjcfModel& model, std::size_t joint);

/// Gives each joint with a `spring_damper` its stiffness and damping: with I, the number of its speeds over the sum of
/// their diagonal entries of M^-1, time constant T and damping ratio D these are I/(T D)^2 and 2 I/T. As MuJoCo does, it
/// leaves armatures out of the I of a body that only slides along its own axes. Throws where M is singular or too large.
void work_out_spring_dampers(MjcfModel& model);

}  // namespace alembert
