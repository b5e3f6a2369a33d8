// <actuator> in; what each pulls at, and its force as a function of input, length and velocity, out.
#pragma once

#include "import/mjcf/context.hpp"

namespace alembert {

void read_actuators(MjcfContext& context);

}  // namespace alembert
