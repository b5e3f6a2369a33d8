// Programs run: values of inputs in, values of outputs out.
#pragma once

#include <span>
#include <vector>

#include "program/program.hpp"

namespace alembert {

/// The value of an operation at one operand or two.
using OperationValue = double (*)(Operation op, double a, double b);

/// Values of all inputs, in the order of program.inputs, to values of all outputs, concatenated in order.
/// Each instruction is one rounding to double, as in code compiled with -ffp-contract=off. Scratch is resized
/// on first use and holds the values of all instructions after. `function`, if given, stands in for the
/// functions of the C library, whose rounding differs between machines. Throws InternalError if a span has the
/// wrong size.
void interpret(const Program& program, std::span<const double> inputs, std::span<double> outputs,
               std::vector<double>& scratch, OperationValue function = nullptr);

}  // namespace alembert
