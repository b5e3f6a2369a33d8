// States as `evaluate` takes them. In: lines, each a JSON object of q, qd, qdd, t, tau, parameters and
// wrenches. Out: states, what is not given being as in the description; or an error at the value that is
// wrong.
#pragma once

#include <string>

#include "commands/json_text.hpp"
#include "simulation/dynamics_evaluator.hpp"

namespace alembert {

class StateReader {
 public:
  StateReader(const Mechanism& mechanism, const EvaluationState& defaults)
      : mechanism_(mechanism), defaults_(defaults) {}

  /// Throws InputError at `line` of standard input. Quaternions must be of norm 1 within 1e-6 and are scaled
  /// to it.
  EvaluationState read(const std::string& text, int line) const;

 private:
  const Mechanism& mechanism_;
  const EvaluationState& defaults_;
};

}  // namespace alembert
