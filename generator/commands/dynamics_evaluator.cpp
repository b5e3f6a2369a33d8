// Numbers from compiled programs (see the header).
#include "commands/dynamics_evaluator.hpp"

#include <algorithm>
#include <cmath>

#include "program/passes.hpp"

namespace alembert {

EvaluationState DynamicsEvaluator::initial_state() const {
  const Mechanism& mechanism = *compiled_.mechanism;
  EvaluationState state;
  for (const Coordinate& coordinate : mechanism.coordinates) {
    state.q.insert(state.q.end(), coordinate.initial.begin(), coordinate.initial.end());
  }
  state.qd.assign(static_cast<std::size_t>(mechanism.nv), 0.0);
  state.qdd = state.qd;
  for (const Parameter& parameter : mechanism.parameters) {
    if (parameter.runtime) state.parameters.push_back(parameter.value);
  }
  const auto wrenches = std::count_if(mechanism.bodies.begin(), mechanism.bodies.end(),
                                      [](const Body& b) { return b.external_wrench; });
  state.wrenches.assign(6 * static_cast<std::size_t>(wrenches), 0.0);
  return state;
}

std::vector<double> DynamicsEvaluator::operator()(FunctionKind kind, const EvaluationState& state) {
  const Program& program = compiled_.function(kind).program;
  inputs_.clear();
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
          return state.tau.at(slot.index);
      }
      return 0;
    };
    inputs_.push_back(value());
  }
  std::size_t size = 0;
  for (const OutputArray& output : program.outputs) size += output.values.size();
  std::vector<double> outputs(size);
  interpret(program, inputs_, outputs, scratch_);
  return outputs;
}

std::vector<double> DynamicsEvaluator::forward_dynamics(const EvaluationState& state,
                                                        std::span<const double> tau) {
  const Eigen::Index n = compiled_.mechanism->nv;
  const std::vector<double> values = (*this)(FunctionKind::mass_matrix_and_bias, state);
  const Eigen::Map<const Eigen::MatrixXd> M(values.data(), n, n);
  const Eigen::Map<const Eigen::VectorXd> c(values.data() + n * n, n);
  const Eigen::LLT<Eigen::MatrixXd> cholesky(M);
  if (cholesky.info() != Eigen::Success) return {};
  const Eigen::VectorXd qdd = cholesky.solve(Eigen::Map<const Eigen::VectorXd>(tau.data(), n) - c);
  if (!qdd.allFinite()) return {};
  return {qdd.data(), qdd.data() + n};
}

}  // namespace alembert
