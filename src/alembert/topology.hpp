// Changes of topology: a chain that breaks in two, a foot that leaves the ground, a hand that grasps. In: the
// state of one mechanism, and another one of which some bodies are the same. Out: the state of the other that
// is closest, or a status. No heap where matrices fit the stack (matrix.hpp), no exceptions.
//
//   std::array<BodyMotion<double>, After::kNbodies> bodies;                            // nothing known yet
//   take_bodies(body_motions<Before>(q, qd, in), same_names(before::kBodyNames, after::kBodyNames), bodies);
//   change_topology<After>(bodies, after_in, after_q, after_qd);                       // after_q: a guess
//
// Coordinates: Gauss-Newton on the integral over all particles of the bodies of |x' - x|^2 dm, with x where a
// particle was and x' where the other mechanism puts it: m |dr|^2 of the centres of mass, and the turn about
// them weighed by the inertia.
//
// Speeds: of the speeds u of the other mechanism those with the least sum over bodies of (J u - V)^T I (J u -
// V), where V is a body's angular velocity and the velocity of its centre of mass as they were, J u what they
// become, and I its inertia. So sum J^T I J u = sum J^T I V, which says:
//
//   - The momentum along every motion that the other mechanism allows is the same before and after. If it can
//     shift as a whole along an axis, linear momentum along that axis is kept, if it can turn as a whole
//     about an axis, so is angular momentum about it; what a support takes up is not.
//   - The kinetic energy falls by 1/2 sum (J u - V)^T I (J u - V) (Carnot's theorem): the change is a
//     perfectly inelastic impact. If the other mechanism allows all motions of the bodies known, as when a chain breaks, nothing
//     is lost and all velocities stay.
//
// Constraints of the other mechanism are kept, by projections in the same metric (consistent_state.hpp). A
// body of the first mechanism that is fixed to another in the second must be a body there too, fixed by a
// constant transform. Motion prescribed in time is not taken into account: the Jacobians do not hold it.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "alembert/body_motion.hpp"
#include "alembert/bound_mechanism.hpp"
#include "alembert/consistent_state.hpp"
#include "alembert/energy.hpp"
#include "alembert/forward_dynamics.hpp"
#include "alembert/mechanism.hpp"

namespace alembert {

/// Bounds of the search for coordinates, and how far bodies may jump.
template <class S>
struct TopologyOptions {
  S largest_distance =
      S(1e-3);  ///< m, between a centre of mass before and after; this and the others may be infinite
  S largest_angle = S(1e-3);  ///< rad, likewise of a body's axes
  int iterations = 100;
  S longest_step = S(0.5);  ///< no coordinate's change in one iteration is larger, in rad or m
};

/// What came of a change.
template <class S>
struct TopologyChange {
  S distance = S(0);        ///< largest distance that a centre of mass jumped, m
  S angle = S(0);           ///< largest angle that a body turned by in the change, rad
  int body = -1;            ///< with residual_too_large: a body of the new mechanism that jumped too far
  S kinetic_before = S(0);  ///< kinetic energy of the bodies known, J
  S kinetic_after = S(0);
  int inconsistent_row = -1;  ///< with inconsistent_constraints: the row of the new mechanism
};

namespace detail {

/// Mass, centre of mass in the body's frame and, in world axes at a pose, the inertia about it.
template <class S>
struct WorldInertia {
  template <class Row>
  WorldInertia(const Row& row, const Eigen::Matrix<S, 3, 4>& pose) : mass(row(0)) {
    const Eigen::Matrix<S, 3, 3> R = pose.template leftCols<3>();
    Eigen::Matrix<S, 3, 3> J;
    J << row(4), row(7), row(8), row(7), row(5), row(9), row(8), row(9), row(6);
    const Eigen::Matrix<S, 3, 3> RJ = R * J;
    inertia = RJ * R.transpose();
    spread = S(0.5) * J.trace() * Eigen::Matrix<S, 3, 3>::Identity() - J;
    com << row(1), row(2), row(3);
  }
  Eigen::Matrix<S, 3, 1> com_at(const Eigen::Matrix<S, 3, 4>& pose) const {
    const Eigen::Matrix<S, 3, 3> R = pose.template leftCols<3>();
    return R * com + pose.col(3);
  }
  S mass;
  Eigen::Matrix<S, 3, 1> com;
  Eigen::Matrix<S, 3, 3> inertia;
  Eigen::Matrix<S, 3, 3> spread;  // second moments about the centre of mass, integral of p p^T dm, body axes
};

/// The rotation vector that leads from one rotation to another, in world axes.
template <class S>
Eigen::Matrix<S, 3, 1> rotation_vector(const Eigen::Matrix<S, 3, 4>& from, const Eigen::Matrix<S, 3, 4>& to) {
  using std::atan2;
  const Eigen::Matrix<S, 3, 3> a = from.template leftCols<3>(), b = to.template leftCols<3>();
  const Eigen::Matrix<S, 3, 3> turn = b * a.transpose();
  const Eigen::Quaternion<S> p(turn);
  const Eigen::Matrix<S, 3, 1> v = p.vec();
  const S sine = v.norm();
  if (!(sine > S(0))) return Eigen::Matrix<S, 3, 1>::Zero();
  const S half = p.w() < S(0) ? atan2(-sine, -p.w()) : atan2(sine, p.w());
  return (S(2) * half / sine) * v;
}

/// Whether the bodies that are known have finite poses and velocities.
template <class Bodies>
bool are_finite(const Bodies& bodies) {
  for (const auto& body : bodies)
    if (body.known && !(all_finite(body.pose) && all_finite(body.angular) && all_finite(body.linear)))
      return false;
  return true;
}

template <class S>
bool are_bounds(const TopologyOptions<S>& options) {
  return is_bound(options.largest_distance) && is_bound(options.largest_angle) &&
         is_bound(options.longest_step);
}

/// Bodies of a mechanism against those that they are to be: H = sum J^T I J and g = sum J^T (moment, force).
template <class M>
struct BodyFit {
  using S = typename M::Scalar;
  using Bodies = std::array<BodyMotion<S>, static_cast<std::size_t>(M::kNbodies)>;
  using Vector3 = Eigen::Matrix<S, 3, 1>;

  /// Sums over the bodies that are known. pull(b, inertia, moment, force) gives those of body b, and returns
  /// its share of `squares`.
  template <class Jacobians, class Inertias, class Poses, class Pull>
  void sum(const Bodies& bodies, const Jacobians& J, const Inertias& inertias, const Poses& poses,
           Pull&& pull) {
    H.setZero();
    g.setZero();
    squares = S(0);
    for (int b = 0; b < M::kNbodies; ++b) {
      const std::size_t index = static_cast<std::size_t>(b);
      if (!bodies[index].known) continue;
      const WorldInertia<S> body(inertias.row(b), poses[index]);
      Vector3 moment, force;
      squares += pull(index, body, moment, force);
      for (int i = 0; i < M::kNv; ++i) {
        const Vector3 turn = J.template block<3, 1>(6 * b, i), shift = J.template block<3, 1>(6 * b + 3, i);
        g(i) += turn.dot(moment) + shift.dot(force);
        const Vector3 spin = body.inertia * turn, momentum = body.mass * shift;
        for (int k = 0; k <= i; ++k) {
          const Vector3 other_turn = J.template block<3, 1>(6 * b, k);
          const Vector3 other_shift = J.template block<3, 1>(6 * b + 3, k);
          H(i, k) += other_turn.dot(spin) + other_shift.dot(momentum);
        }
      }
    }
  }

  SpeedMatrix<M> H;  ///< lower triangle
  SpeedVector<M> g;
  S squares = S(0);
};

/// The integral of |x' - x|^2 dm as `squares`; 2 g is minus its gradient along the speeds, and 2 H is its
/// second derivative where it is zero.
template <class M, class Bodies>
void fit_poses(const CoordinateVector<M>& q, const typename M::Inputs& in, const Bodies& bodies,
               BodyFit<M>& fit) {
  using S = typename M::Scalar;
  using Matrix3 = Eigen::Matrix<S, 3, 3>;
  const auto poses = M::body_poses(q, in);
  fit.sum(bodies, M::body_jacobians(q, in), M::body_inertias(in), poses,
          [&](std::size_t b, const WorldInertia<S>& body, auto& moment, auto& force) {
            const Eigen::Matrix<S, 3, 4> now = poses[b];
            const Matrix3 R = now.template leftCols<3>(), wanted = bodies[b].pose.template leftCols<3>();
            const Eigen::Matrix<S, 3, 1> distance = body.com_at(bodies[b].pose) - body.com_at(now);
            const Matrix3 apart = wanted - R, spread = apart * body.spread;
            const Matrix3 RK = R * body.spread, C = RK * apart.transpose();
            moment << C(1, 2) - C(2, 1), C(2, 0) - C(0, 2), C(0, 1) - C(1, 0);
            force = body.mass * distance;
            return force.dot(distance) + spread.cwiseProduct(apart).sum();
          });
}

}  // namespace detail

/// Coordinates of M at which its bodies are closest to given poses, by Gauss-Newton from a guess.
/// \param bodies   the poses; bodies that are not known do not count
/// \param in       inputs of M
/// \param q        n_q x 1: a guess, from which angles are within half a turn; then the result
/// \param options  bounds
/// \param change   distance, angle and body at the result
/// \return         ok; not_finite; not_positive_definite: some coordinate moves no body that is known and
///                 has inertia; no_convergence; residual_too_large: a body would jump. q is left as it was unless ok, and
///                 change unless ok or residual_too_large.
template <class M>
[[nodiscard]] Status coordinates_of_bodies(
    const std::array<BodyMotion<typename M::Scalar>, static_cast<std::size_t>(M::kNbodies)>& bodies,
    const typename M::Inputs& in, CoordinateVector<M>& q, const TopologyOptions<typename M::Scalar>& options,
    TopologyChange<typename M::Scalar>& change) {
  static_assert(has_bodies_v<M>, "generate M with body_poses, body_jacobians and body_inertias");
  using S = typename M::Scalar;
  using std::pow;
  const S tolerance = S(64) * pow(std::numeric_limits<S>::epsilon(), S(0.75));
  typename M::Inputs inputs = in;
  const BoundMechanism<M> system(inputs);
  if (!detail::is_finite(in.t) || !detail::all_finite(q) || !detail::are_finite(bodies) ||
      !detail::are_bounds(options))
    return Status::not_finite;
  CoordinateVector<M> now = q, next;
  if (const Status status = detail::normalize(system, now); status != Status::ok) return status;
  detail::BodyFit<M> fit, trial;
  detail::fit_poses<M>(now, in, bodies, fit);
  bool done = false;
  for (int iteration = 0; !done; ++iteration) {
    if (iteration >= options.iterations) return Status::no_convergence;
    if (!detail::all_finite(fit.H) || !detail::all_finite(fit.g) || !detail::is_finite(fit.squares))
      return Status::not_finite;
    if (const Status status = factor_ldlt(fit.H); status != Status::ok) return status;
    SpeedVector<M> x = fit.g;
    solve_ldlt(fit.H, x);
    if (!detail::all_finite(x)) return Status::not_finite;
    const S length = x.cwiseAbs().maxCoeff();
    done = length <= tolerance;
    S a = length > options.longest_step ? S(options.longest_step / length) : S(1);
    bool better = false;
    for (int halving = 0; halving < 30 && !better; ++halving, a *= S(0.5)) {
      next = now + a * CoordinateVector<M>(M::coordinate_rates(now, x));
      if (detail::normalize(system, next) != Status::ok) continue;
      detail::fit_poses<M>(next, in, bodies, trial);
      better = detail::is_finite(trial.squares) &&
               (trial.squares < fit.squares || (done && trial.squares == fit.squares));
    }
    if (better) {
      now = next;
      fit = trial;
    } else if (!done) {
      // Rounding hides any further gain where the step is this small.
      if (!(length <= S(1e3) * tolerance)) return Status::no_convergence;
      done = true;
    }
  }
  const auto poses = M::body_poses(now, in);
  const auto inertias = M::body_inertias(in);
  change.distance = change.angle = S(0);
  change.body = -1;
  for (int b = 0; b < M::kNbodies; ++b) {
    const std::size_t index = static_cast<std::size_t>(b);
    if (!bodies[index].known) continue;
    const Eigen::Matrix<S, 3, 4> pose = poses[index];
    const detail::WorldInertia<S> body(inertias.row(b), pose);
    if (!(body.mass > S(0)) && !(body.inertia.trace() > S(0))) continue;  // moves with the others
    const S distance = (body.com_at(pose) - body.com_at(bodies[index].pose)).norm();
    const S angle =
        body.inertia.trace() > S(0) ? detail::rotation_vector<S>(pose, bodies[index].pose).norm() : S(0);
    if (change.body < 0 && !(distance <= options.largest_distance && angle <= options.largest_angle))
      change.body = b;
    change.distance = distance > change.distance ? distance : change.distance;
    change.angle = angle > change.angle ? angle : change.angle;
  }
  if (change.body >= 0) return Status::residual_too_large;
  q = now;
  return Status::ok;
}

/// Speeds of M with the momenta of given bodies along all motions that M allows; see the top of this file.
/// \param bodies  velocities; bodies that are not known do not count
/// \param in, q   inputs and coordinates of M
/// \param qd      result, n_v x 1
/// \param change  kinetic energies before and after
/// \return        ok; not_finite; not_positive_definite as for coordinates_of_bodies. qd and change are as
///                they were unless ok.
template <class M>
[[nodiscard]] Status speeds_of_bodies(
    const std::array<BodyMotion<typename M::Scalar>, static_cast<std::size_t>(M::kNbodies)>& bodies,
    const typename M::Inputs& in, const CoordinateVector<M>& q, SpeedVector<M>& qd,
    TopologyChange<typename M::Scalar>& change) {
  static_assert(has_bodies_v<M>, "generate M with body_poses, body_jacobians and body_inertias");
  using S = typename M::Scalar;
  if (!detail::is_finite(in.t) || !detail::all_finite(q) || !detail::are_finite(bodies))
    return Status::not_finite;
  detail::BodyFit<M> fit;
  fit.sum(bodies, M::body_jacobians(q, in), M::body_inertias(in), M::body_poses(q, in),
          [&](std::size_t b, const detail::WorldInertia<S>& body, auto& moment, auto& force) {
            moment = body.inertia * bodies[b].angular;
            force = body.mass * bodies[b].linear;
            return moment.dot(bodies[b].angular) + force.dot(bodies[b].linear);
          });
  if (!detail::all_finite(fit.H) || !detail::all_finite(fit.g)) return Status::not_finite;
  SpeedMatrix<M> H = fit.H;
  if (const Status status = factor_ldlt(H); status != Status::ok) return status;
  SpeedVector<M> u = fit.g;
  solve_ldlt(H, u);
  if (!detail::all_finite(u)) return Status::not_finite;
  S after(0);
  for (int i = 0; i < M::kNv; ++i) after += S(0.5) * u(i) * fit.g(i);
  if (!detail::is_finite(fit.squares) || !detail::is_finite(after)) return Status::not_finite;
  change.kinetic_before = S(0.5) * fit.squares;
  change.kinetic_after = after;
  qd = u;
  return Status::ok;
}

/// The state of M after a change of topology: coordinates_of_bodies, then speeds_of_bodies, then the
/// constraints of M if it has any.
///
/// \param bodies   the bodies of M as they are before the change (body_motions, take_bodies)
/// \param in       inputs of M
/// \param q        n_q x 1: a guess, then the coordinates after the change
/// \param qd       n_v x 1: the speeds after the change
/// \param change   how far bodies jumped and what energy was lost, if wanted
/// \param options  bounds
/// \return         ok, or the status of the step that failed; q and qd are left as they were then, and
///                 `change` holds what was known before it
template <class M>
[[nodiscard]] Status change_topology(
    const std::array<BodyMotion<typename M::Scalar>, static_cast<std::size_t>(M::kNbodies)>& bodies,
    const typename M::Inputs& in, CoordinateVector<M>& q, SpeedVector<M>& qd,
    TopologyChange<typename M::Scalar>* change = nullptr,
    const TopologyOptions<typename M::Scalar>& options = {}) {
  using S = typename M::Scalar;
  TopologyChange<S> unused;
  TopologyChange<S>& result = change == nullptr ? unused : *change;
  result = {};
  CoordinateVector<M> next_q = q;
  SpeedVector<M> next_qd = SpeedVector<M>::Zero();
  if (const Status status = coordinates_of_bodies<M>(bodies, in, next_q, options, result);
      status != Status::ok)
    return status;
  if constexpr (has_constraints_v<M>) {
    ConstraintReport<M::kNc> report;
    Status status = project_positions<M>(next_q, in, report);
    if (status == Status::ok) status = speeds_of_bodies<M>(bodies, in, next_q, next_qd, result);
    if (status == Status::ok) status = project_velocities<M>(next_q, next_qd, in, report);
    result.inconsistent_row = report.inconsistent_row;
    if (status != Status::ok) return status;
    if (status = kinetic_energy<M>(next_q, next_qd, in, result.kinetic_after); status != Status::ok)
      return status;
  } else {
    if (const Status status = speeds_of_bodies<M>(bodies, in, next_q, next_qd, result); status != Status::ok)
      return status;
  }
  q = next_q;
  qd = next_qd;
  return Status::ok;
}

}  // namespace alembert
