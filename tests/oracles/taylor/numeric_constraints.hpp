// Constraints on numbers: a mechanism and a state in; the rows of its constraints, and the accelerations and
// multipliers of constrained motion out. Rolling is taken from what it means, that the material points in
// contact have one velocity along the surfaces; no formula of the generator is shared.
#pragma once

#include <optional>

#include "oracles/state.hpp"
#include "oracles/taylor/poses.hpp"

namespace alembert::oracles {

/// Rows in the order of the file. velocity = P u + (part from time), its rate is P du/dt + gamma. Rolling
/// rows are along the tangents p0 and p1 of the mate's second surface, where that is now.
template <class R>
struct ConstraintRowsOf {
  MatrixOf<R> P;
  VectorOf<R> gamma, velocity;
  VectorOf<R> position;  ///< of holonomic rows; 0 for others
};
using ConstraintRows = ConstraintRowsOf<double>;
/// R is double, or long double for a reference that has digits to spare.
template <class R = double>
ConstraintRowsOf<R> numeric_constraints(const Description& description, const State& state);

/// P^T multipliers, and P rates + gamma with the state's rates. On jets, their derivatives along whatever the state
/// moves along.
template <class R>
struct ConstraintActions {
  std::vector<R> forces, accelerations;
};
template <class R>
ConstraintActions<R> constraint_actions(const Description& description, const StateOf<R>& state,
                                        const std::vector<R>& multipliers);

/// M rates + c = tau + P^T multipliers, P rates + gamma = 0.
struct ConstrainedMotion {
  Eigen::VectorXd rates;
  Eigen::VectorXd multipliers;  ///< of least norm (with rows scaled) if rows are redundant
  double condition = 0;         ///< of P M^-1 P^T scaled to a unit diagonal; infinite if rows are redundant
  double inconsistency = 0;     ///< max |P rates + gamma|
};

/// Solves the whole system at once, by a complete orthogonal decomposition of [M -P^T; P 0] with speeds and
/// rows scaled.
ConstrainedMotion constrained_motion(const Dynamics& dynamics, const ConstraintRows& rows);

/// The state with its coordinates moved to where the rows' positions are 0, by Newton's method, and its
/// speeds to where their velocities are. Nothing if Newton's method does not get there.
std::optional<State> consistent(const Description& description, const State& state);

/// The state with its speeds moved, by the least change, to where the rows' velocities are 0.
State with_consistent_speeds(const Description& description, State state);

}  // namespace alembert::oracles
