// Stage `interpret`: a program and the values of its inputs in, the values of its outputs out. Every
// instruction is one rounding to double, so that the result equals that of the compiled code bit for bit.
#include "program/interpret.hpp"

#include <cstddef>
#include <string>

#include "support/error.hpp"
#include "support/operation.hpp"

namespace alembert {

void interpret(const Program& program, std::span<const double> inputs, std::span<double> outputs,
               std::vector<double>& scratch, OperationValue function) {
  std::size_t expected = 0;
  for (const OutputArray& output : program.outputs) expected += output.values.size();
  if (inputs.size() != program.inputs.size() || outputs.size() != expected)
    throw InternalError("interpret: " + program.function + " takes " + std::to_string(program.inputs.size()) +
                        " inputs and gives " + std::to_string(expected) + " outputs, not " +
                        std::to_string(inputs.size()) + " and " + std::to_string(outputs.size()));
  const std::size_t n = program.code.size();
  if (scratch.size() < n) scratch.resize(n);
  double* const v = scratch.data();
  for (std::size_t i = 0; i < n; ++i) {
    const Instruction c = program.code[i];
    if (c.op == Operation::constant) {
      v[i] = program.constants[c.a];
    } else if (c.op == Operation::input) {
      v[i] = inputs[c.a];
    } else {
      const double b = operand_count(c.op) == 2 ? v[c.b] : 0.0;
      const bool stands_in = function != nullptr && is_of_library(c.op);
      v[i] = stands_in ? function(c.op, v[c.a], b) : apply(c.op, v[c.a], b);
    }
  }
  std::size_t k = 0;
  for (const OutputArray& output : program.outputs)
    for (const std::uint32_t value : output.values) outputs[k++] = v[value];
}

}  // namespace alembert
