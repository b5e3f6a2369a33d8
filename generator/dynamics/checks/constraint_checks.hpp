// Checks of constraints that need numbers: their rates against motion, which rows depend on others, and
// whether the initial state obeys them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "dynamics/choice/equations_of_motion.hpp"
#include "dynamics/equations.hpp"
#include "dynamics/recursions/constraints.hpp"

namespace alembert {

/// Worst differences at random states, relative to the larger of 1 and the values, of rates as derived and as
/// measured by finite differences along a motion. States at which the differences themselves are not accurate
/// are passed over; none if too few are left, or no row is concerned.
struct ConstraintLaws {
  std::optional<double> position_rate;  ///< holonomic rows: d/dt position = velocity
  std::optional<double> velocity_rate;  ///< all rows: d/dt velocity = P du/dt + gamma
};
ConstraintLaws constraint_laws(const Kinematics& kinematics, const ConstraintEquations& equations);

/// Indices of the rows of P that are linear combinations of the rows before them at the initial state, where M is the
/// mass matrix, row by row.
std::vector<std::size_t> redundant_rows(const Kinematics& kinematics, const ConstraintEquations& equations,
                                        std::span<const Expr> M);

/// A row that the initial state, at rest, does not obey.
struct InitialResidual {
  std::size_t row;
  double position, velocity;
};
/// Those with a residual above `tolerance` times the magnitude of its own terms.
std::vector<InitialResidual> initial_residuals(const Kinematics& kinematics,
                                               const ConstraintEquations& equations, double tolerance);

}  // namespace alembert
