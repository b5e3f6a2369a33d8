// Checks that need numbers: frames that exist at the initial state, a mass matrix that is positive definite.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "dynamics/choice/equations_of_motion.hpp"
#include "mechanism/model.hpp"
#include "support/error.hpp"

namespace alembert {

class PlainEquations;
struct Kinematics;

/// What check_mass_matrix throws where M is singular: equations that divide by it have no value, others do.
struct SingularMassMatrix : InputError {
  using InputError::InputError;
};
/// A coordinate for which a mass matrix has no inertia of its own.
struct WithoutInertia {
  const Coordinate* coordinate = nullptr;
  /// What is left of the inertia along it once all others move freely, as a fraction of what it is with them
  /// held.
  double fraction = 0;
};
/// The share of a coordinate's inertia that is left while the others move freely. Below kSingular M is singular; 50
/// digits tell that from rounding. Below kNearlySingular double precision may lose 10 digits of what is divided by M.
inline constexpr double kSingular = 1e-30, kNearlySingular = 1e-6;
/// A coordinate with no more than the share `least`, at the initial state and at random states alike.
std::optional<WithoutInertia> light_coordinate(const Kinematics& kinematics, const PlainEquations& plain,
                                               double least);
/// Throws SingularMassMatrix, which names the light coordinate, if there is one.
void check_mass_matrix(const Kinematics& kinematics, const PlainEquations& plain, double least = kSingular);

/// Values of all symbols at the k-th of a sequence of reproducible states: over the limits, near the initial
/// state, far from it; slow, fast, at rest; runtime parameters within a third of their defaults.
std::vector<double> state_in_range(const Kinematics& kinematics, unsigned k);

/// The coordinate that M, nv x nv, has no inertia for, or none if M is positive definite beyond the rounding
/// of double precision. M must be finite.
std::optional<WithoutInertia> coordinate_without_inertia(const Mechanism& mechanism,
                                                         std::span<const double> M);

}  // namespace alembert
