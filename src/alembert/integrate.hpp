// Fixed-step integration of a mechanism in time. In: a state, forces as a function of time and state, a step.
// Out: the state one step later with unit quaternions and constraints kept, or a status and the state as it
// was. No heap where sizes are fixed and matrices fit the stack (matrix.hpp), no exceptions.
//
// States besides coordinates and speeds, which stand at the end of the inputs' parameters, are integrated with
// them.
//
// A mechanism with constraints takes its accelerations from constrained_dynamics.hpp, and its state is
// projected on the constraints after each step (consistent_state.hpp). The projections are of the size of the
// method's error of one step. That of the speeds takes away kinetic energy of second order in it, and that of
// the coordinates changes the potential energy by no more than the step itself does.
#pragma once

#include <type_traits>

#include "alembert/bound_mechanism.hpp"
#include "alembert/consistent_state.hpp"
#include "alembert/constrained_dynamics.hpp"
#include "alembert/forward_dynamics.hpp"
#include "alembert/mechanism.hpp"

namespace alembert {

/// Scales the quaternions in q to unit length. Integration keeps their length only to its own order.
/// \return not_finite if a quaternion has length zero or is not finite; q is left as it was then.
template <class M>
[[nodiscard]] Status normalize_quaternions(CoordinateVector<M>& q) {
  typename M::Inputs unused{};
  return detail::normalize(BoundMechanism<M>(unused), q);
}

/// Calls step() `count` times, each of which is to advance t by h, and counts time instead of adding it up:
/// after k steps t is t_0 + k h, to the last digit. Added up, a million steps of 1e-3 s end 1.7e-8 s off.
///
///   repeat_step(in.t, h, n, [&] { return rk4_step<M>(q, qd, in, h, force); });
///
/// \param t  time, where the steps find it: `t` of their inputs
/// \return   ok, or the status of the first step that failed, which is the last one called: t and what the
///           steps advance are as it left them
template <class S, class Step>
[[nodiscard]] Status repeat_step(S& t, S h, long long count, Step&& step) {
  const S start = t;
  for (long long k = 1; k <= count; ++k) {
    if (const Status status = step(); status != Status::ok) return status;
    t = start + static_cast<S>(k) * h;
  }
  return Status::ok;
}

/// How constraints are kept during a step; of no effect on a mechanism without them.
template <class S>
struct StepOptions {
  bool project = true;     ///< project the state after the step
  Stabilisation<S> gains;  ///< Baumgarte's, for those who do not project
};

namespace detail {

/// Whether what a callable returns holds its own numbers, or stands for those of another object that stays.
/// An expression of Eigen refers to variables of the callable, which are gone when it is evaluated.
template <class Result, class = void>
struct OutlivesCall : std::bool_constant<!std::is_rvalue_reference_v<Result>> {};
template <class Result>
struct OutlivesCall<Result, std::void_t<typename std::decay_t<Result>::PlainObject>>
    : std::bool_constant<
          !std::is_rvalue_reference_v<Result> &&
          std::is_base_of_v<typename std::decay_t<Result>::PlainObject, std::decay_t<Result>>> {};

/// Generalized forces by the caller's callable.
template <class System, class Coordinates, class Speeds, class Force>
Speeds forces_of(const System& system, const Coordinates& q, const Speeds& u, Force&& force) {
  using Result = decltype(force(system.time(), q, u));
  static_assert(OutlivesCall<Result>::value,
                "force must return a vector by value, not an expression of Eigen: give the lambda its return "
                "type, as in "
                "[](double t, const auto& q, const auto& qd) -> M::SpeedVector { return ...; }");
  return force(system.time(), q, u);
}

/// Rates of the speeds, under constraints if there are any.
template <class System, class Speeds>
[[nodiscard]] Status accelerations(const System& system,
                                   const Eigen::Matrix<typename System::Scalar, System::kNq, 1>& q,
                                   const Speeds& u, const Speeds& tau,
                                   const StepOptions<typename System::Scalar>& options, Speeds& rate,
                                   ConstraintReport<System::kNc>& report) {
  if constexpr (System::kNc != 0) {
    if (system.nc() != 0) {
      ConstrainedMotion<typename System::Scalar, System::kNv, System::kNc> motion;
      const Status status = constrained_accelerations(system, q, u, tau, options.gains, motion);
      report = motion;
      if (status == Status::ok) rate = motion.qdd;
      return status;
    }
  }
  return system.forward_dynamics(q, u, tau, rate);
}

/// The end of a step: finite, with unit quaternions, on the constraints.
template <class System, class Coordinates, class Speeds>
[[nodiscard]] Status settle(const System& system, Coordinates& q, Speeds& u,
                            const StepOptions<typename System::Scalar>& options,
                            ConstraintReport<System::kNc>& report) {
  if (!is_finite_state(system.time(), q, u)) return Status::not_finite;
  if (const Status status = normalize(system, q); status != Status::ok) return status;
  if constexpr (System::kNc != 0) {
    if (options.project && system.nc() != 0) return project_state(system, q, u, {}, report);
  }
  return Status::ok;
}

}  // namespace detail

/// rk4_step of any System (bound_mechanism.hpp), whose time is advanced too.
template <class System, class Coordinates, class Speeds, class Force>
[[nodiscard]] Status advance_by_rk4(System& system, Coordinates& q, Speeds& u, typename System::Scalar h,
                                    Force&& force, const StepOptions<typename System::Scalar>& options,
                                    ConstraintReport<System::kNc>& report) {
  using S = typename System::Scalar;
  if (!detail::is_finite(h)) return Status::not_finite;
  const S half = h * S(0.5);
  const S offsets[4] = {S(0), half, half, h};
  const S weights[4] = {h / S(6), h / S(3), h / S(3), h / S(6)};

  const S start = system.time();
  const auto states = system.states();
  const auto advance = [&]() -> Status {
    Coordinates stage_q = q, q_rate = Coordinates::Zero(q.rows()), unit_q, next_q = q;
    Speeds stage_u = u, u_rate = Speeds::Zero(u.rows()), next_u = u;
    auto next_states = states, state_rate = states;
    for (int stage = 0; stage < 4; ++stage) {
      if (stage > 0) {
        stage_q = q + offsets[stage] * q_rate;
        stage_u = u + offsets[stage] * u_rate;
        system.set_states(states + offsets[stage] * state_rate);
        system.set_time(start + offsets[stage]);
      }
      // Accelerations are those of the unit quaternion, but N(q) u is taken at q as it is: so both are smooth
      // functions off the unit sphere too, and the method keeps its order.
      unit_q = stage_q;
      if (const Status status = detail::normalize(system, unit_q); status != Status::ok) return status;
      const Speeds tau = detail::forces_of(system, unit_q, stage_u, force);
      if (const Status status = detail::accelerations(system, unit_q, stage_u, tau, options, u_rate, report);
          status != Status::ok)
        return status;
      q_rate = system.coordinate_rates(stage_q, stage_u);
      state_rate = system.state_rates(unit_q, stage_u);
      next_q += weights[stage] * q_rate;
      next_u += weights[stage] * u_rate;
      next_states += weights[stage] * state_rate;
    }
    if (!detail::all_finite(next_states)) return Status::not_finite;
    system.set_time(start + h);
    system.set_states(next_states);
    if (const Status status = detail::settle(system, next_q, next_u, options, report); status != Status::ok)
      return status;
    q = next_q;
    u = next_u;
    return Status::ok;
  };
  const Status status = advance();
  if (status != Status::ok) {
    system.set_time(start);
    system.set_states(states);
  }
  return status;
}

/// semi_implicit_euler_step of any System (bound_mechanism.hpp), whose time is advanced too.
template <class System, class Coordinates, class Speeds, class Force>
[[nodiscard]] Status advance_by_semi_implicit_euler(System& system, Coordinates& q, Speeds& u,
                                                    typename System::Scalar h, Force&& force,
                                                    const StepOptions<typename System::Scalar>& options,
                                                    ConstraintReport<System::kNc>& report) {
  Speeds rate;
  if (!detail::is_finite(h)) return Status::not_finite;
  const Speeds tau = detail::forces_of(system, q, u, force);
  if (const Status status = detail::accelerations(system, q, u, tau, options, rate, report);
      status != Status::ok)
    return status;
  Speeds next_u = u + h * rate;
  Coordinates next_q = q + h * Coordinates(system.coordinate_rates(q, next_u));
  const auto start = system.time();
  const auto states = system.states();
  auto next_states = states;
  next_states += h * system.state_rates(q, next_u);
  if (!detail::all_finite(next_states)) return Status::not_finite;
  system.set_time(start + h);
  system.set_states(next_states);
  if (const Status status = detail::settle(system, next_q, next_u, options, report); status != Status::ok) {
    system.set_time(start);
    system.set_states(states);
    return status;
  }
  q = next_q;
  u = next_u;
  return Status::ok;
}

/// One step of the classical Runge-Kutta method of order 4 for dq/dt = N(q) u and du/dt by forward_dynamics,
/// or by constrained_forward_dynamics where M has constraints.
///
/// \param q        coordinates, n_q x 1; advanced by h
/// \param qd       speeds, n_v x 1; advanced by h
/// \param in       inputs at the start of the step; in.t and the states among in.parameters advanced by h
/// \param h        step, s; negative steps lead back in time, and one of zero advances nothing
/// \param force    callable (t, q, qd) -> generalized forces, n_v x 1, by value or by reference to a vector
///                 that stays
/// \param options  how constraints are kept
/// \param report   if given, what is known of the constraints after the call
/// \return         ok; not_finite, also of h and t; or what else went wrong at one of the four stages or in
///                 the projection; q, qd and in are left as they were then
template <class M, class Force>
[[nodiscard]] Status rk4_step(CoordinateVector<M>& q, SpeedVector<M>& qd, typename M::Inputs& in,
                              typename M::Scalar h, Force&& force,
                              const StepOptions<typename M::Scalar>& options = {},
                              ConstraintReport<BoundMechanism<M>::kNc>* report = nullptr) {
  BoundMechanism<M> system(in);
  ConstraintReport<BoundMechanism<M>::kNc> unused;
  return advance_by_rk4(system, q, qd, h, force, options, report == nullptr ? unused : *report);
}

/// One step of the semi-implicit (symplectic) Euler method: u' = u + h du/dt, q' = q + h N(q) u'. First
/// order, one evaluation a step, and for mechanical systems without constraints free of the drift in energy
/// of the explicit method. Arguments and result as for rk4_step.
template <class M, class Force>
[[nodiscard]] Status semi_implicit_euler_step(CoordinateVector<M>& q, SpeedVector<M>& qd,
                                              typename M::Inputs& in, typename M::Scalar h, Force&& force,
                                              const StepOptions<typename M::Scalar>& options = {},
                                              ConstraintReport<BoundMechanism<M>::kNc>* report = nullptr) {
  BoundMechanism<M> system(in);
  ConstraintReport<BoundMechanism<M>::kNc> unused;
  return advance_by_semi_implicit_euler(system, q, qd, h, force, options,
                                        report == nullptr ? unused : *report);
}

}  // namespace alembert
