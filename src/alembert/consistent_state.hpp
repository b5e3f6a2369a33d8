// States that keep the constraints. In: a state nearby. Out: the state that keeps them, by the least change
// of the coordinates and then of the speeds in the metric of the kinetic energy; or a status. No heap where
// sizes are fixed and matrices fit the stack (matrix.hpp), no exceptions.
//
// Speeds:       u -= M^-1 P^T S^-1 velocity,  S = P M^-1 P^T. Of all speeds that keep the constraints this
//               has the least kinetic energy of the difference, and it is what a perfectly inelastic impact
//               would do.
// Coordinates:  Newton's method on the holonomic rows, q += a N(q) x with x = -M^-1 P^T S^-1 position, the
//               length a found by halving until the sum of squares of the positions falls.
#pragma once

#include <cmath>
#include <limits>

#include "alembert/bound_mechanism.hpp"
#include "alembert/constrained_dynamics.hpp"
#include "alembert/constraint_factorization.hpp"
#include "alembert/mechanism.hpp"

namespace alembert {

/// Bounds of the iteration, and speeds that must not change.
template <class S, int Nv>
struct ProjectionOptions {
  /// Holonomic rows count as kept below this, in their own units. Where rounding stops the iteration, a
  /// thousand times as much will do.
  S tolerance = S(1024) * std::numeric_limits<S>::epsilon();
  int iterations = 100;
  S longest_step =
      S(0.5);  ///< no coordinate's change in one iteration is larger, in rad or m; may be infinite
  /// Speeds held: neither they nor the coordinates that they move are changed. Empty or n_v flags.
  Eigen::Array<bool, Eigen::Dynamic, 1, 0, Nv, 1> held;
};

/// ProjectionOptions of a mechanism or System.
template <class M>
using ProjectionOptionsOf = ProjectionOptions<typename M::Scalar, M::kNv>;

namespace detail {

/// Scales the quaternions in q to unit length; not_finite if there is none, q being left as it was.
template <class System, class Vector>
[[nodiscard]] Status normalize(const System& system, Vector& q) {
  using std::sqrt;
  using S = typename System::Scalar;
  for (const auto first : system.quaternion_offsets()) {
    const S norm = sqrt(q(first) * q(first) + q(first + 1) * q(first + 1) + q(first + 2) * q(first + 2) +
                        q(first + 3) * q(first + 3));
    if (!is_finite(norm) || !(norm > S(0))) return Status::not_finite;
  }
  for (const auto first : system.quaternion_offsets()) {
    const S norm = sqrt(q(first) * q(first) + q(first + 1) * q(first + 1) + q(first + 2) * q(first + 2) +
                        q(first + 3) * q(first + 3));
    for (auto i = first; i < first + 4; ++i) q(i) /= norm;
  }
  return Status::ok;
}

/// Whether bounds bound anything.
template <class S, int Nv>
bool are_bounds(const ProjectionOptions<S, Nv>& options) {
  return is_finite(options.tolerance) && is_bound(options.longest_step);
}

/// Takes the held speeds out of the metric and of the rows, so that they cannot change.
template <class Held, class Mass, class Rows>
void hold(const Held& held, Mass& mass, Rows& P) {
  using S = typename Mass::Scalar;
  for (Eigen::Index i = 0; i < held.rows(); ++i) {
    if (!held(i)) continue;
    for (Eigen::Index j = 0; j < mass.rows(); ++j) mass(i, j) = mass(j, i) = S(i == j ? 1 : 0);
    for (Eigen::Index row = 0; row < P.rows(); ++row) P(row, i) = S(0);
  }
}

}  // namespace detail

/// Projects the speeds of any System with constraints.
/// \return ok; not_finite; not_positive_definite; inconsistent_constraints with the row in the report.
///         u is left as it was unless ok.
template <class System, class Vector>
[[nodiscard]] Status project_speeds(const System& system,
                                    const Eigen::Matrix<typename System::Scalar, System::kNq, 1>& q,
                                    Vector& u, const ProjectionOptionsOf<System>& options,
                                    ConstraintReport<System::kNc>& report) {
  using std::sqrt;
  using S = typename System::Scalar;
  using Factorization = ConstraintFactorization<S, System::kNv, System::kNc>;
  typename Factorization::SpeedMatrix mass;
  typename Factorization::SpeedVector c, x;
  typename Factorization::ConstraintMatrix P;
  typename Factorization::ConstraintVector gamma, velocity, position, lambda;
  report.inconsistent_row = -1;
  if (!detail::is_finite_state(system.time(), q, u)) return Status::not_finite;
  system.mass_matrix_and_bias(q, u, mass, c);
  system.constraints(q, u, P, gamma, velocity, position);
  if (!detail::all_finite(mass) || !detail::all_finite(velocity)) return Status::not_finite;
  S squares(0);
  for (Eigen::Index i = 0; i < u.rows(); ++i)
    for (Eigen::Index j = 0; j < u.rows(); ++j) squares += u(i) * mass(i, j) * u(j);
  if (!detail::is_finite(squares)) return Status::not_finite;
  detail::hold(options.held, mass, P);
  Factorization factorization;
  if (const Status status = factorization.factor(mass, P, detail::row_lengths(system)); status != Status::ok)
    return status;
  report.rank = factorization.rank();
  report.redundant = factorization.redundant();
  velocity = -velocity;
  c.setZero();
  report.inconsistent_row =
      factorization.solve(c, velocity, x, lambda, squares > S(0) ? S(sqrt(squares)) : S(0));
  if (!detail::all_finite(x)) return Status::not_finite;
  if (report.inconsistent_row >= 0) return Status::inconsistent_constraints;
  u += x;
  return Status::ok;
}

/// Projects the coordinates of any System with constraints on its holonomic rows; does nothing if there are
/// none.
/// \return ok; not_finite; not_positive_definite; no_convergence; inconsistent_constraints if the iteration
///         stops where a row depends on the others and is not kept: it contradicts them, or the mechanism is
///         singular there. q is left as it was unless ok. The report is that of the last iteration.
template <class System, class Vector>
[[nodiscard]] Status project_coordinates(const System& system, Vector& q,
                                         const ProjectionOptionsOf<System>& options,
                                         ConstraintReport<System::kNc>& report) {
  using std::abs;
  using S = typename System::Scalar;
  using Factorization = ConstraintFactorization<S, System::kNv, System::kNc>;
  const int nv = system.nv(), nc = system.nc();
  typename Factorization::SpeedMatrix mass;
  typename Factorization::SpeedVector zero, c, x;
  typename Factorization::ConstraintMatrix P;
  typename Factorization::ConstraintVector gamma, velocity, position, lambda;
  zero.setZero(nv);
  Vector now = q, next = q;
  report.inconsistent_row = -1;
  report.rank = 0;
  report.redundant.setConstant(nc, false);
  if (!detail::is_finite_state(system.time(), q, zero) || !detail::are_bounds(options))
    return Status::not_finite;

  const auto largest = [](const auto& values) {
    S most(0);
    for (Eigen::Index i = 0; i < values.rows(); ++i) most = abs(values(i)) > most ? S(abs(values(i))) : most;
    return most;
  };
  const auto evaluate = [&](const Vector& at) {  // P and position; rows that bind speeds only count as kept
    system.constraints(at, zero, P, gamma, velocity, position);
    for (int row = 0; row < nc; ++row) {
      if (system.holonomic(row)) continue;
      position(row) = S(0);
      P.row(row).setZero();
    }
    return detail::all_finite(position) && detail::all_finite(P);
  };
  if (!evaluate(now)) return Status::not_finite;
  for (int iteration = 0; !(largest(position) <= options.tolerance); ++iteration) {
    if (iteration >= options.iterations) return Status::no_convergence;
    const S before = position.squaredNorm(), before_largest = largest(position);
    system.mass_matrix_and_bias(now, zero, mass, c);
    if (!detail::all_finite(mass)) return Status::not_finite;
    detail::hold(options.held, mass, P);
    Factorization factorization;
    if (const Status status = factorization.factor(mass, P, detail::row_lengths(system));
        status != Status::ok)
      return status;
    report.rank = factorization.rank();
    report.redundant = factorization.redundant();
    const typename Factorization::ConstraintVector wanted = -position;
    factorization.solve(zero, wanted, x, lambda);
    if (!detail::all_finite(x)) return Status::not_finite;
    const S length = largest(x);
    S a = length > options.longest_step ? S(options.longest_step / length) : S(1);
    bool better = false;
    for (int halving = 0; halving < 30 && !better; ++halving, a *= S(0.5)) {
      next = now + a * system.coordinate_rates(now, x);
      better = detail::normalize(system, next) == Status::ok && evaluate(next) &&
               position.squaredNorm() <= (S(1) - S(1e-4) * a) * before;
    }
    if (better) {
      now = next;
      continue;
    }
    if (before_largest <= S(1000) * options.tolerance) break;
    int worst = -1;
    for (int row = 0; row < nc; ++row) {
      if (!system.holonomic(row) || !factorization.redundant(row)) continue;
      if (abs(wanted(row)) > S(1000) * options.tolerance &&
          (worst < 0 || abs(wanted(row)) > abs(wanted(worst))))
        worst = row;
    }
    report.inconsistent_row = worst;
    return worst < 0 ? Status::no_convergence : Status::inconsistent_constraints;
  }
  q = now;
  return Status::ok;
}

/// Projects coordinates, then speeds, of any System with constraints. q and u are left as they were unless
/// ok.
template <class System, class Coordinates, class Speeds>
[[nodiscard]] Status project_state(const System& system, Coordinates& q, Speeds& u,
                                   const ProjectionOptionsOf<System>& options,
                                   ConstraintReport<System::kNc>& report) {
  Coordinates next = q;
  if (const Status status = project_coordinates(system, next, options, report); status != Status::ok)
    return status;
  if (const Status status = project_speeds(system, next, u, options, report); status != Status::ok)
    return status;
  q = next;
  return Status::ok;
}

/// Changes the speeds least, in kinetic energy, so that they keep all rows of the constraints.
/// \param q, in    coordinates and inputs at which the constraints hold
/// \param qd       speeds, n_v x 1; changed
/// \param report   rank, redundant rows, the row at fault
/// \param options  speeds to be held
template <class M>
[[nodiscard]] Status project_velocities(const CoordinateVector<M>& q, SpeedVector<M>& qd,
                                        const typename M::Inputs& in,
                                        ConstraintReport<detail::ConstraintCount<M>::value>& report,
                                        const ProjectionOptionsOf<M>& options = {}) {
  static_assert(has_constraints_v<M>, "M has no constraints");
  typename M::Inputs inputs = in;
  return project_speeds(BoundMechanism<M>(inputs), q, qd, options, report);
}

/// Changes the coordinates so that they keep the holonomic rows, nearly least in the metric of M. Arguments
/// as for project_velocities.
template <class M>
[[nodiscard]] Status project_positions(CoordinateVector<M>& q, const typename M::Inputs& in,
                                       ConstraintReport<detail::ConstraintCount<M>::value>& report,
                                       const ProjectionOptionsOf<M>& options = {}) {
  static_assert(has_constraints_v<M>, "M has no constraints");
  typename M::Inputs inputs = in;
  return project_coordinates(BoundMechanism<M>(inputs), q, options, report);
}

/// Makes a state keep all constraints: project_positions, then project_velocities. For initial states.
template <class M>
[[nodiscard]] Status consistent_state(CoordinateVector<M>& q, SpeedVector<M>& qd,
                                      const typename M::Inputs& in,
                                      ConstraintReport<detail::ConstraintCount<M>::value>& report,
                                      const ProjectionOptionsOf<M>& options = {}) {
  static_assert(has_constraints_v<M>, "M has no constraints");
  typename M::Inputs inputs = in;
  return project_state(BoundMechanism<M>(inputs), q, qd, options, report);
}

}  // namespace alembert
