// Reads off a motion what acts: forces, inputs and outputs, where paths go and where contacts are. In: states, one after
// the other. Out: their values, as the viewer takes them.
#pragma once

#include <span>

#include "simulation/state_program.hpp"
#include "viewer/scene.hpp"

namespace alembert {

class ForceReadings {
 public:
  explicit ForceReadings(const CompiledMechanism& compiled);

  /// Names, units and limits, without values.
  const Acting& nothing_yet() const { return empty_; }
  /// Gives what append() adds at a state, in the order of Acting; empty if that is nothing.
  const StateProgram& program() const { return program_; }
  /// Values of the forces at a state; valid until the next call.
  std::span<const double> forces(const EvaluationState& state);
  /// Adds the values at a state. `acting` began as nothing_yet().
  void append(const EvaluationState& state, Acting& acting);

 private:
  Acting empty_;
  StateProgram program_;  ///< series in their order, points of lines, points of contacts
};

}  // namespace alembert
