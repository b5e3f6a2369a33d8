// Expressions along a motion, by the interpreter. In: expressions of coordinates, speeds, time, parameters, inputs and
// states. Out: their values at any state.
#pragma once

#include <span>
#include <vector>

#include "pipeline.hpp"
#include "simulation/dynamics_evaluator.hpp"

namespace alembert {

class StateProgram {
 public:
  /// Of nothing.
  StateProgram() = default;
  StateProgram(std::vector<Expr> values, const CompiledMechanism& compiled);

  bool empty() const { return values_.empty(); }
  /// With one result, `values`.
  const Program& program() const { return program_; }
  /// In their order; valid until the next call.
  std::span<const double> operator()(const EvaluationState& state);

 private:
  Program program_;
  std::vector<double> inputs_, scratch_, values_;
};

}  // namespace alembert
