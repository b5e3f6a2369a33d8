// Fixed-step integration of a mechanism in time. In: a state, forces as a function of time and state, a step.
// Out: the state one step later with unit quaternions, or a status and the state as it was. No heap, no
// exceptions.
#pragma once

#include "alembert/forward_dynamics.hpp"
#include "alembert/mechanism.hpp"

namespace alembert {

/// Scales the quaternions in q to unit length. Integration keeps their length only to its own order.
/// \return not_finite if a quaternion has length zero or is not finite; q is left as it was then.
template <class M>
[[nodiscard]] Status normalize_quaternions(CoordinateVector<M>& q) {
  using std::isfinite;
  using std::sqrt;
  using S = typename M::Scalar;
  CoordinateVector<M> out = q;
  for (const int first : M::kQuaternionOffsets) {
    const S norm = sqrt(q(first) * q(first) + q(first + 1) * q(first + 1) + q(first + 2) * q(first + 2) +
                        q(first + 3) * q(first + 3));
    if (!isfinite(norm) || !(norm > S(0))) return Status::not_finite;
    for (int i = first; i < first + 4; ++i) out(i) = q(i) / norm;
  }
  q = out;
  return Status::ok;
}

/// One step of the classical Runge-Kutta method of order 4 for dq/dt = N(q) u, du/dt = M^-1 (tau - c).
///
/// \param q      coordinates, n_q x 1; advanced by h
/// \param qd     speeds, n_v x 1; advanced by h
/// \param in     inputs at the start of the step; in.t advanced by h
/// \param h      step, s
/// \param force  callable (t, q, qd) -> generalized forces, n_v x 1
/// \return       ok, or what went wrong at one of the four stages; q, qd and in are left as they were then
template <class M, class Force>
[[nodiscard]] Status rk4_step(CoordinateVector<M>& q, SpeedVector<M>& qd, typename M::Inputs& in,
                              typename M::Scalar h, Force&& force) {
  static_assert(is_mechanism_v<M>, "M lacks something that alembert/mechanism.hpp asks for");
  using S = typename M::Scalar;
  const S half = h * S(0.5);
  const S offsets[4] = {S(0), half, half, h};
  const S weights[4] = {h / S(6), h / S(3), h / S(3), h / S(6)};

  typename M::Inputs now = in;
  CoordinateVector<M> stage_q = q, q_rate, next_q = q;
  SpeedVector<M> stage_qd = qd, qd_rate = SpeedVector<M>::Zero(), next_qd = qd;
  for (int stage = 0; stage < 4; ++stage) {
    if (stage > 0) {
      stage_q = q + offsets[stage] * q_rate;
      stage_qd = qd + offsets[stage] * qd_rate;
      now.t = in.t + offsets[stage];
    }
    // Accelerations are those of the unit quaternion, but N(q) u is taken at q as it is: so both are smooth
    // functions off the unit sphere too, and the method keeps its order.
    CoordinateVector<M> unit_q = stage_q;
    if (const Status status = normalize_quaternions<M>(unit_q); status != Status::ok) return status;
    const SpeedVector<M> tau = force(now.t, unit_q, stage_qd);
    if (const Status status = forward_dynamics<M>(unit_q, stage_qd, tau, now, qd_rate); status != Status::ok)
      return status;
    q_rate = M::coordinate_rates(stage_q, stage_qd);
    next_q += weights[stage] * q_rate;
    next_qd += weights[stage] * qd_rate;
  }
  if (!detail::all_finite(next_q) || !detail::all_finite(next_qd)) return Status::not_finite;
  if (const Status status = normalize_quaternions<M>(next_q); status != Status::ok) return status;
  q = next_q;
  qd = next_qd;
  in.t = in.t + h;
  return Status::ok;
}

/// One step of the semi-implicit (symplectic) Euler method: u' = u + h M^-1 (tau - c), q' = q + h N(q) u'.
/// First order, one evaluation a step, and for mechanical systems without the drift in energy of the explicit
/// method. Arguments and result as for rk4_step.
template <class M, class Force>
[[nodiscard]] Status semi_implicit_euler_step(CoordinateVector<M>& q, SpeedVector<M>& qd,
                                              typename M::Inputs& in, typename M::Scalar h, Force&& force) {
  static_assert(is_mechanism_v<M>, "M lacks something that alembert/mechanism.hpp asks for");
  SpeedVector<M> rate;
  const SpeedVector<M> tau = force(in.t, q, qd);
  if (const Status status = forward_dynamics<M>(q, qd, tau, in, rate); status != Status::ok) return status;
  const SpeedVector<M> next_qd = qd + h * rate;
  CoordinateVector<M> next_q = q + h * CoordinateVector<M>(M::coordinate_rates(q, next_qd));
  if (!detail::all_finite(next_q) || !detail::all_finite(next_qd)) return Status::not_finite;
  if (const Status status = normalize_quaternions<M>(next_q); status != Status::ok) return status;
  q = next_q;
  qd = next_qd;
  in.t = in.t + h;
  return Status::ok;
}

}  // namespace alembert
