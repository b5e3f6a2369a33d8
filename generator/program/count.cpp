// Stage `count`: program in, operation counts out, by the convention in the header.
#include "program/count.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/operation.hpp"

namespace alembert {
namespace {

// Which instructions are computed from constants alone.
std::vector<std::uint8_t> constants_alone(const Program& program) {
  std::vector<std::uint8_t> alone(program.code.size(), 0);
  for (std::size_t i = 0; i < program.code.size(); ++i) {
    const Instruction& c = program.code[i];
    const int operands = operand_count(c.op);
    alone[i] =
        c.op == Operation::constant || (operands > 0 && alone[c.a] != 0 && (operands < 2 || alone[c.b] != 0));
  }
  return alone;
}

// Which values are used, and by nothing but sin, cos and tan.
std::vector<std::uint8_t> angles_only(const Program& program) {
  enum : std::uint8_t { trig = 1, elsewhere = 2 };
  std::vector<std::uint8_t> used(program.code.size(), 0);
  for (const Instruction& c : program.code) {
    const int operands = operand_count(c.op);
    if (operands > 0) used[c.a] |= is_trigonometric(c.op) ? trig : elsewhere;
    if (operands > 1) used[c.b] |= elsewhere;
  }
  for (const OutputArray& output : program.outputs)
    for (const std::uint32_t v : output.values) used[v] |= elsewhere;
  for (std::uint8_t& u : used) u = u == trig;
  return used;
}

}  // namespace

OperationCount count(const Program& program) {
  const std::vector<std::uint8_t> alone = constants_alone(program);
  const std::vector<std::uint8_t> angle = angles_only(program);
  // |value| of an operand that is a constant itself, otherwise 0, which no rule below asks for.
  const auto magnitude = [&program](std::uint32_t v) {
    const Instruction& c = program.code[v];
    return c.op == Operation::constant ? std::abs(program.constants[c.a]) : 0.0;
  };
  OperationCount n;
  for (std::size_t i = 0; i < program.code.size(); ++i) {
    const Instruction& c = program.code[i];
    if (alone[i] != 0) continue;
    // An offset of an angle belongs to the call.
    if (angle[i] != 0 && facts(c.op).counted == Counted::add && (alone[c.a] != 0 || alone[c.b] != 0))
      continue;
    const double factor = c.op == Operation::mul ? std::max(magnitude(c.a), magnitude(c.b)) : 0;
    if (factor != 1) n.include(c.op, factor == 2);
  }
  return n;
}

}  // namespace alembert
