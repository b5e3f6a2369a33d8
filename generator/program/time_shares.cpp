// Estimates what time is spent on (see the header).
#include "program/time_shares.hpp"

namespace alembert {

TimeShares estimated_shares(const Program& program) {
  TimeShares shares;
  const double access = facts(Operation::add).weight;
  for (const Instruction& instruction : program.code) {
    const OperationFacts& operation = facts(instruction.op);
    const double weight = operation.weight;
    switch (operation.counted) {
      case Counted::free:
        if (instruction.op == Operation::input) shares.memory += access;
        break;
      case Counted::add:
      case Counted::mul:
        shares.arithmetic += weight;
        break;
      case Counted::div:
        shares.division += weight;
        break;
      case Counted::trig:
        shares.trig += weight;
        break;
      case Counted::other:
        shares.other += weight;
        break;
    }
  }
  for (const OutputArray& output : program.outputs)
    shares.memory += access * static_cast<double>(output.values.size());
  const double sum = shares.arithmetic + shares.division + shares.trig + shares.other + shares.memory;
  for (double* share : {&shares.arithmetic, &shares.division, &shares.trig, &shares.other, &shares.memory})
    *share /= sum > 0 ? sum : 1;
  return shares;
}

}  // namespace alembert
