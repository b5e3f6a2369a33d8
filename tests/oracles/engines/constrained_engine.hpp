// Constrained motion in an engine's own words: what is a list of rows in a description is a ball joint, a
// rolling contact or a prescribed motion there. Said by hand, mechanism by mechanism.
#pragma once

#include "oracles/engines/engine.hpp"
#include "oracles/taylor/numeric_lagrangian.hpp"

namespace alembert::oracles {

/// Accelerations of all bodies, without forces but gravity, at a state that keeps the constraints. Throws
/// NotExpressible for mechanisms that are not written down. Empty: the engine was not there when this was
/// built.
using ConstrainedEngine = std::function<BodyAccelerations(const Description&, const State&)>;

ConstrainedEngine constrained_simbody();

BodyAccelerations simbody_constrained_accelerations(const Description& description, const State& state);

}  // namespace alembert::oracles
