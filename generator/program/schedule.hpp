// Stage `schedule`: a program in, the same in another order out.
#pragma once

#include "program/program.hpp"

namespace alembert {

/// Stage `schedule`: orders instructions depth first from the outputs, sin and cos of one argument adjacent,
/// and drops those that no output needs. Same values, bit for bit.
Program schedule(Program program);

}  // namespace alembert
