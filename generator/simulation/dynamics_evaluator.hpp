// Numbers from compiled programs, through the interpreter: what `evaluate`, `simulate` and `check` stand on.
#pragma once

#include <vector>

#include "pipeline.hpp"

namespace alembert {

/// One state and what acts on it. Sizes: q nq, qd and qdd nv, parameters and wrenches as the generated
/// functions take them.
struct EvaluationState {
  std::vector<double> q, qd, qdd;
  double t = 0;
  std::vector<double> parameters, wrenches;
  std::vector<double> tau;  ///< generalized forces; empty: none
  std::vector<double> mu;   ///< weights of generalized forces; empty: 1 each
};

/// Scales each quaternion among the coordinates to unit length; those that rounding explains are left as they
/// are. \return the first that has no direction, if there is one: its coordinates are left as they were.
const Coordinate* normalise_quaternions(const Mechanism& mechanism, std::vector<double>& q);

/// Values for the inputs of a program, in their order.
void program_inputs(const Program& program, const EvaluationState& state, std::vector<double>& inputs);

/// Evaluates the functions of one compiled mechanism.
class DynamicsEvaluator {
 public:
  explicit DynamicsEvaluator(const CompiledMechanism& compiled) : compiled_(compiled) {}

  /// The mechanism's initial state with its initial speeds, no accelerations, parameters at their defaults,
  /// no wrenches.
  EvaluationState initial_state() const;
  /// All outputs of a function, concatenated.
  std::vector<double> operator()(FunctionKind kind, const EvaluationState& state);

 private:
  const CompiledMechanism& compiled_;
  std::vector<double> inputs_, scratch_;
};

}  // namespace alembert
