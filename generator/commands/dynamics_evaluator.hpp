// Numbers from compiled programs, through the interpreter: what `evaluate`, `simulate` and `check` stand on.
#pragma once

#include <Eigen/Dense>
#include <span>
#include <vector>

#include "pipeline.hpp"

namespace alembert {

/// One state and what acts on it. Sizes: q nq, qd and qdd nv, parameters and wrenches as the generated
/// functions take them.
struct EvaluationState {
  std::vector<double> q, qd, qdd;
  double t = 0;
  std::vector<double> parameters, wrenches;
  std::vector<double> tau;  ///< only for forward_dynamics
};

/// Evaluates the functions of one compiled mechanism.
class DynamicsEvaluator {
 public:
  explicit DynamicsEvaluator(const CompiledMechanism& compiled) : compiled_(compiled) {}

  /// The mechanism's initial state at rest, parameters at their defaults, no wrenches.
  EvaluationState initial_state() const;
  /// All outputs of a function, concatenated.
  std::vector<double> operator()(FunctionKind kind, const EvaluationState& state);
  /// M^-1 (tau - c) by Cholesky; empty if M is not positive definite or a value is not finite.
  std::vector<double> forward_dynamics(const EvaluationState& state, std::span<const double> tau);

 private:
  const CompiledMechanism& compiled_;
  std::vector<double> inputs_, scratch_;
};

}  // namespace alembert
