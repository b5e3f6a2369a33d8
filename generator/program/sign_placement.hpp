// Signs of values: a value program in, instructions with few negations out.
#pragma once

#include "program/value_graph.hpp"

namespace alembert {

/// Writes a program in `live_order`, choosing for each node whether it or its negative is computed so that
/// few negations remain: -(a - b) becomes b - a, -(2.5*x) becomes -2.5*x, and products pass a sign to the
/// factor that can take it.
Program place_signs(const ValueProgram& program);

}  // namespace alembert
