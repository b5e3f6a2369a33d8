// Numbers from compiled programs (see the header).
#include "simulation/dynamics_evaluator.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "program/interpret.hpp"

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

const Coordinate* normalise_quaternions(const Mechanism& mechanism, std::vector<double>& q) {
  constexpr double kRounding = 1e-15;
  for (const Coordinate& coordinate : mechanism.coordinates) {
    if (coordinate.type != CoordinateType::quaternion) continue;
    const std::span<double> parts = std::span(q).subspan(static_cast<std::size_t>(coordinate.first_q), 4);
    const double norm = std::hypot(std::hypot(parts[0], parts[1]), std::hypot(parts[2], parts[3]));
    if (!(norm > 0) || !std::isfinite(norm)) return &coordinate;
    if (std::abs(norm - 1) <= kRounding) continue;
    for (double& part : parts) part /= norm;
  }
  return nullptr;
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
        case ArgumentKind::mu:
          return state.mu.empty() ? 1.0 : state.mu.at(slot.index);
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
