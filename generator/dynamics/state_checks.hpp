// Checks that need numbers: frames that exist at the initial state, a mass matrix that is positive definite.
#pragma once

#include <span>
#include <vector>

#include "mechanism/model.hpp"

namespace alembert {

/// Throws InputError at the first transform factor that has no value at the initial state (a curve or surface
/// frame that is singular there).
void check_transforms(const Mechanism& mechanism, ExprGraph& graph);

/// Values of all symbols of the graph at a state: the initial one for `seed` 0, else a reproducible random
/// one around it. Speeds, rates and wrenches are zero at the initial state and random elsewhere; runtime
/// parameters have their defaults.
std::vector<double> state_values(const Mechanism& mechanism, ExprGraph& graph, unsigned seed);

/// What check_mass_matrix throws where M is singular: equations that divide by it have no value, others do.
struct SingularMassMatrix : InputError {
  using InputError::InputError;
};

/// The coordinate that M, nv x nv, has no inertia for, or none if M is positive definite well beyond
/// rounding. M must be finite.
const Coordinate* coordinate_without_inertia(const Mechanism& mechanism, std::span<const double> M);

}  // namespace alembert
