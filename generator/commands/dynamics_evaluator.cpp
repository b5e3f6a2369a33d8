// Numbers from compiled programs (see the header).
#include "commands/dynamics_evaluator.hpp"

#include <algorithm>

#include "program/passes.hpp"

namespace alembert {

EvaluationState DynamicsEvaluator::initial_state() const {
  const Mechanism& mechanism = *compiled_.mechanism;
  EvaluationState state;
  for (const Coordinate& coordinate : mechanism.coordinates) {
    state.q.insert(state.q.end(), coordinate.initial.begin(), coordinate.initial.end());
    state.qd.insert(state.qd.end(), coordinate.initial_speed.begin(), coordinate.initial_speed.end());
  }
  state.qdd.assign(static_cast<std::size_t>(mechanism.nv), 0.0);
  for (const Parameter& parameter : mechanism.parameters) {
    if (parameter.runtime) state.parameters.push_back(parameter.value);
  }
  const auto wrenches = std::count_if(mechanism.bodies.begin(), mechanism.bodies.end(),
                                      [](const Body& b) { return b.external_wrench; });
  state.wrenches.assign(6 * static_cast<std::size_t>(wrenches), 0.0);
  return state;
}

void program_inputs(const Program& program, const EvaluationState& state, std::vector<double>& inputs) {
  inputs.clear();
  for (const InputSlot& slot : program.inputs) {
    const auto value = [&]() -> double {
      switch (slot.kind) {
        case ArgumentKind::q:
          return state.q.at(slot.index);
        case ArgumentKind::qd:
          return state.qd.at(slot.index);
        case ArgumentKind::qdd:
          return state.qdd.at(slot.index);
        case ArgumentKind::time:
          return state.t;
        case ArgumentKind::parameter:
          return state.parameters.at(slot.index);
        case ArgumentKind::wrench:
          return state.wrenches.at(slot.index);
        case ArgumentKind::tau:
          return state.tau.empty() ? 0.0 : state.tau.at(slot.index);
      }
      return 0;
    };
    inputs.push_back(value());
  }
}

std::vector<double> DynamicsEvaluator::operator()(FunctionKind kind, const EvaluationState& state) {
  const Program& program = compiled_.function(kind).program;
  program_inputs(program, state, inputs_);
  std::size_t size = 0;
  for (const OutputArray& output : program.outputs) size += output.values.size();
  std::vector<double> outputs(size);
  interpret(program, inputs_, outputs, scratch_);
  return outputs;
}

}  // namespace alembert
