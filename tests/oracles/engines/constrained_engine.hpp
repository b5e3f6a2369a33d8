// Constrained motion in an engine's own words: what is a list of rows in a description is a ball joint, a
// rolling contact or a prescribed motion there. Said by hand, mechanism by mechanism.
#pragma once

#include "oracles/engines/engine.hpp"
#include "oracles/taylor/numeric_lagrangian.hpp"

namespace alembert::oracles {

struct ConstrainedEngine {
  /// Whether a mechanism is written down. Empty, like the other: the engine was not there when this was
  /// built.
  std::function<bool(const Description&)> expresses;
  /// Accelerations of all bodies, without forces but gravity, at a state that keeps the constraints.
  std::function<BodyAccelerations(const Description&, const State&)> accelerations;
};

ConstrainedEngine constrained_simbody();

bool simbody_expresses_constraints(const Description& description);
BodyAccelerations simbody_constrained_accelerations(const Description& description, const State& state);

}  // namespace alembert::oracles
