// Programs run: values of inputs in, values of outputs out.
#pragma once

#include <span>
#include <vector>

#include "program/program.hpp"

namespace alembert {

/// Values of all inputs, in the order of program.inputs, to values of all outputs, concatenated in order.
/// Each instruction is one rounding to double, as in code compiled with -ffp-contract=off. Scratch is resized
/// on first use and holds the values of all instructions after. Throws InternalError if a span has the wrong
/// size.
void interpret(const Program& program, std::span<const double> inputs, std::span<double> outputs,
               std::vector<double>& scratch);

}  // namespace alembert
