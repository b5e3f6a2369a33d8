// Forward dynamics under constraints. In: a mechanism with rows of constraints, a state, generalized forces.
// Out: the rates of the speeds that keep the constraints, the reactions, which rows are redundant, or a
// status that says why there are none. No heap where sizes are fixed and matrices fit the stack (matrix.hpp),
// no exceptions.
//
//   [M -P^T] [qdd   ]   [tau - c]
//   [P   0 ] [lambda] = [-gamma*]      gamma* = gamma + 2 a velocity + b^2 position
//
// by the Schur complement of the L D L^T factor of M (constraint_factorization.hpp). a and b are the gains of
// Baumgarte's stabilisation, zero by default: integrate.hpp projects the state after each step instead, which
// needs no tuning.
#pragma once

#include "alembert/bound_mechanism.hpp"
#include "alembert/constraint_factorization.hpp"
#include "alembert/forward_dynamics.hpp"
#include "alembert/mechanism.hpp"

namespace alembert {

/// Gains by which a violation of the constraints fades: holonomic rows as phi'' + 2 a phi' + b^2 phi = 0, the
/// others as v' + 2 a v = 0. In 1/s. J. Baumgarte, Computer Methods in Applied Mechanics and Engineering 1
/// (1972).
template <class S>
struct Stabilisation {
  S velocity = S(0);  ///< a
  S position = S(0);  ///< b
};

/// What is known of the rows of constraints after a call. N_c may be Eigen::Dynamic.
template <int Nc>
struct ConstraintReport {
  /// With inconsistent_constraints: the row that contradicts the others. Else -1.
  int inconsistent_row = -1;
  int rank = 0;  ///< number of independent rows
  Eigen::Array<bool, Nc, 1> redundant =
      detail::cleared<Eigen::Array<bool, Nc, 1>>();  ///< rows that follow from the others, here
};

/// Accelerations and reactions under constraints. Nv and Nc may be Eigen::Dynamic.
template <class S, int Nv, int Nc>
struct ConstrainedMotion : ConstraintReport<Nc> {
  Eigen::Matrix<S, Nv, 1> qdd = detail::cleared<Eigen::Matrix<S, Nv, 1>>();  ///< rates of the speeds
  /// Reactions, one a row, so that P^T lambda are generalized forces; 0 for redundant rows. Where rows depend
  /// on each other only the sum P^T lambda is determined, and which row bears it may change along a motion.
  Eigen::Matrix<S, Nc, 1> lambda = detail::cleared<Eigen::Matrix<S, Nc, 1>>();
};

/// ConstrainedMotion of a mechanism or System.
template <class M>
using ConstrainedMotionOf = ConstrainedMotion<typename M::Scalar, M::kNv, detail::ConstraintCount<M>::value>;

/// Rates of the speeds and reactions of any System (bound_mechanism.hpp) with constraints.
/// \return ok; not_finite; not_positive_definite (of M); inconsistent_constraints: the row in the result asks
///         for another acceleration than those it depends on. qdd and lambda are left as they were unless ok;
///         rank and redundant are left as they were unless M and P could be factored.
template <class System, class Vector>
[[nodiscard]] Status constrained_accelerations(
    const System& system, const Eigen::Matrix<typename System::Scalar, System::kNq, 1>& q, const Vector& u,
    const Vector& tau, const Stabilisation<typename System::Scalar>& gains,
    ConstrainedMotion<typename System::Scalar, System::kNv, System::kNc>& result) {
  using Factorization = ConstraintFactorization<typename System::Scalar, System::kNv, System::kNc>;
  typename Factorization::SpeedMatrix mass;
  typename Factorization::SpeedVector force, qdd;
  typename Factorization::ConstraintMatrix P;
  typename Factorization::ConstraintVector gamma, velocity, position, lambda;
  result.inconsistent_row = -1;
  if (!detail::is_finite_state(system.time(), q, u) || !detail::is_finite(gains.velocity) ||
      !detail::is_finite(gains.position))
    return Status::not_finite;
  system.mass_matrix_and_bias(q, u, mass, force);
  system.constraints(q, u, P, gamma, velocity, position);
  force = tau - force;
  gamma += (2 * gains.velocity) * velocity + (gains.position * gains.position) * position;
  if (!detail::all_finite(mass) || !detail::all_finite(force) || !detail::all_finite(gamma))
    return Status::not_finite;
  Factorization factorization;
  if (const Status status = factorization.factor(mass, P, detail::row_lengths(system)); status != Status::ok)
    return status;
  result.rank = factorization.rank();
  result.redundant = factorization.redundant();
  gamma = -gamma;
  result.inconsistent_row = factorization.solve(force, gamma, qdd, lambda);
  if (!detail::all_finite(qdd) || !detail::all_finite(lambda)) return Status::not_finite;
  if (result.inconsistent_row >= 0) return Status::inconsistent_constraints;
  result.qdd = qdd;
  result.lambda = lambda;
  return Status::ok;
}

/// Rates of the speeds and reactions under given forces: the qdd and lambda with M qdd + c = tau + P^T lambda
/// and P qdd + gamma = 0.
///
/// \param q       coordinates, n_q x 1
/// \param qd      speeds, n_v x 1; they should keep the constraints (consistent_state.hpp)
/// \param tau     generalized forces, n_v x 1
/// \param in      time, runtime parameters, external wrenches
/// \param result  qdd, lambda, rank, redundant rows, and the row at fault if there is one
/// \param gains   Baumgarte's, zero by default
/// \return        as constrained_accelerations
template <class M>
[[nodiscard]] Status constrained_forward_dynamics(const CoordinateVector<M>& q, const SpeedVector<M>& qd,
                                                  const SpeedVector<M>& tau, const typename M::Inputs& in,
                                                  ConstrainedMotionOf<M>& result,
                                                  const Stabilisation<typename M::Scalar>& gains = {}) {
  static_assert(has_constraints_v<M>, "M has no constraints: use forward_dynamics");
  typename M::Inputs inputs = in;
  return constrained_accelerations(BoundMechanism<M>(inputs), q, qd, tau, gains, result);
}

}  // namespace alembert
