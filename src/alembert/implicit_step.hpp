// Steps in time for stiff forces: contacts, hard springs, strong dampers. In: as for integrate.hpp, and a
// mechanism's derivatives of inverse dynamics. Out: the state one step later, or a status and the state as it
// was. No heap where sizes are fixed and matrices fit the stack (matrix.hpp), no exceptions.
//
// With f the rates of the speeds and f_q, f_u their derivatives along and by the speeds, the linearly implicit
// (Rosenbrock) Euler method is
//
//   (1 - h f_u - h^2 f_q) du = h (f + h f_q u),    u' = u + du,    q' = q + h N(q) u',
//
// a Newton step of the implicit Euler method, du = h f(q', u'). With f_q = -M^-1 K and f_u = -M^-1 C, where K
// and C are the derivatives of inverse dynamics at f, and with rows of constraints P du/dt + gamma = 0,
//
//   [M + h C + h^2 K  -P^T] [du      ]   [h (tau - c) - h^2 K u]
//   [P                 0  ] [h lambda] = [-h gamma             ]
//
// (linearly_implicit_euler_step), which implicit_euler_step follows up with more of them. The time is that of the
// step's end in all but the rows of constraints, so that what is prescribed in time is met.
//
// States besides q and u follow with the step's end: (1 - h r_s) ds = h r(q', u', s), r being their rates and r_s the
// derivatives of these by the states.
//
// Both are of order 1 and L-stable: what is stiff and linear fades in one step, however long, and what is slow
// is damped: an undamped oscillation of w rad/s loses w^2 h of its energy a second.
// E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, sections IV.3 and IV.7.
#pragma once

#include <cmath>
#include <limits>
#include <utility>

#include "alembert/integrate.hpp"

namespace alembert {

namespace detail {

/// Solves A x = b in place, by elimination with the largest pivot of a column. A, of any regular matrix, is
/// spoilt.
/// \return not_finite; or singular_step if a pivot is lost in the rounding of its column. x is spoilt then.
template <class S, int N, int K>
[[nodiscard]] Status solve_regular(Eigen::Matrix<S, N, N>& A, Eigen::Matrix<S, K, 1>& x) {
  using std::abs;
  if (!all_finite(A) || !all_finite(x)) return Status::not_finite;
  const Eigen::Index n = A.rows();
  const S rounding = S(n) * std::numeric_limits<S>::epsilon();
  for (Eigen::Index k = 0; k < n; ++k) {
    Eigen::Index row = k;
    S largest(0);  // of what is done of the column
    for (Eigen::Index i = 0; i < n; ++i) {
      if (i >= k && abs(A(i, k)) > abs(A(row, k))) row = i;
      if (i < k && abs(A(i, k)) > largest) largest = abs(A(i, k));
    }
    const S pivot = A(row, k);
    if (!is_finite(pivot)) return Status::not_finite;
    if (!(abs(pivot) > S(0)) || !(abs(pivot) > rounding * largest)) return Status::singular_step;
    if (row != k) {
      for (Eigen::Index j = k; j < n; ++j) std::swap(A(k, j), A(row, j));
      std::swap(x(k), x(row));
    }
    for (Eigen::Index i = k + 1; i < n; ++i) A(i, k) /= pivot;
    for (Eigen::Index j = k + 1; j < n; ++j)
      for (Eigen::Index i = k + 1; i < n; ++i) A(i, j) -= A(i, k) * A(k, j);
    for (Eigen::Index i = k + 1; i < n; ++i) x(i) -= A(i, k) * x(k);
  }
  for (Eigen::Index k = n - 1; k >= 0; --k) {
    x(k) /= A(k, k);
    for (Eigen::Index i = 0; i < k; ++i) x(i) -= A(i, k) * x(k);
  }
  return all_finite(x) ? Status::ok : Status::not_finite;
}

/// The equations above, and those of the implicit Euler method, for the change of the speeds and h lambda: in
/// units in which M, where the step begins, has ones on its diagonal, and rows are of length one.
template <class System>
class ImplicitEquations {
 public:
  using S = typename System::Scalar;
  static constexpr int kNq = System::kNq, kNv = System::kNv, kNc = System::kNc;
  static constexpr int kSize = kNv == Eigen::Dynamic || kNc == Eigen::Dynamic ? Eigen::Dynamic : kNv + kNc;
  using Coordinates = Eigen::Matrix<S, kNq, 1>;
  using Speeds = Eigen::Matrix<S, kNv, 1>;
  using Unknowns = Eigen::Matrix<S, kSize, 1>;

  /// What is known at the start: the rows, where the state keeps them, and generalized forces, which are held.
  ImplicitEquations(System& system, const Coordinates& q, const Speeds& u, const Speeds& tau, S h)
      : system_(system), q_(q), u_(u), tau_(tau), start_(system.time()), h_(h) {
    const Eigen::Index n = u.rows(), rows = system.nc();
    A_.setZero(n + rows, n + rows);
    unit_.setZero(n);
    P_.setZero(rows, n);
    sides_.setZero(rows);
    redundant_.setConstant(rows, true);
  }

  [[nodiscard]] Status set_constraints(const StepOptions<S>& options, Speeds& rate,
                                       ConstraintReport<kNc>& report) {
    if (const Status status = accelerations(system_, q_, u_, tau_, options, rate, report);
        status != Status::ok)
      return status;
    if constexpr (kNc != 0) {
      Eigen::Matrix<S, kNc, 1> gamma, velocity, position;
      system_.constraints(q_, u_, P_, gamma, velocity, position);
      redundant_ = report.redundant;
      sides_ = -(gamma + (2 * options.gains.velocity) * velocity +
                 (options.gains.position * options.gains.position) * position);
    }
    return Status::ok;
  }

  /// M and c of the start, at the time of the end, and units by them.
  [[nodiscard]] Status begin() {
    system_.set_time(start_ + h_);  // so that a motion prescribed in time is followed
    system_.mass_matrix_and_bias(q_, u_, mass_, c_);
    return set_units();
  }
  /// x of the linearly implicit step. \return not_positive_definite where M is singular
  [[nodiscard]] Status predict(Speeds& rate, Unknowns& x) {
    x.setZero(A_.rows());
    if (system_.nc() == 0) {
      auto factor = mass_;
      rate = c_;
      if (const Status status = solve_for_rates(tau_, factor, rate); status != Status::ok) return status;
    }
    system_.inverse_dynamics_derivatives(q_, u_, rate, K_, C_);
    const Eigen::Index n = u_.rows();
    for (Eigen::Index i = 0; i < n; ++i) {
      S side = tau_(i) - c_(i);
      for (Eigen::Index j = 0; j < n; ++j) side -= h_ * (K_(i, j) * u_(j));
      x(i) = h_ * unit_(i) * side;
    }
    for (Eigen::Index r = 0; r < P_.rows(); ++r) x(n + r) = h_ * sides_(r);
    set_matrix();
    return solve_regular(A_, x);
  }

  /// Newton's method for x of the implicit Euler method, from the linearly implicit step x or from no change,
  /// whichever is nearer to it. Its steps are halved until they lead nearer; where none does, as at a jump of a
  /// force, it ends.
  /// \return whether the equations are kept to 64 sqrt(epsilon) of the speeds, or to what the next step of Newton's
  ///         method moves by no more than the rounding of the coordinates, as at rest on hard ground
  [[nodiscard]] bool refine(Unknowns& x) {
    using std::abs;
    using std::sqrt;
    constexpr int kIterations = 20;
    Unknowns left = x, trial = x, trial_left = x;
    trial.setZero();
    const bool stays = find_rest(trial, trial_left);
    if (!find_rest(x, left) || (stays && !(left.norm() < trial_left.norm()))) {
      x = trial;
      if (!find_rest(x, left)) return false;
    }
    const S epsilon = std::numeric_limits<S>::epsilon();
    const S enough = S(64) * sqrt(epsilon) * (left.norm() + u_.cwiseQuotient(unit_).norm());
    const S rounding = S(64) * epsilon * size_of_coordinates();
    for (int k = 0; k < kIterations && !(left.norm() <= enough); ++k) {
      const Speeds rate = unit_.cwiseProduct(x.head(u_.rows())) / h_;
      system_.inverse_dynamics_derivatives(next_q_, next_u_, rate, K_, C_);
      set_matrix();
      Unknowns change = -left;
      if (solve_regular(A_, change) != Status::ok) return false;
      if (abs(h_) * change.head(u_.rows()).norm() <= rounding) return true;
      bool nearer = false;
      for (S a(1); !nearer && a > S(0.01); a *= S(0.5)) {
        trial = x + a * change;
        nearer = find_rest(trial, trial_left) && trial_left.norm() <= (S(1) - S(0.1) * a) * left.norm();
      }
      if (!nearer) return false;
      x = trial;
      left = trial_left;
    }
    return left.norm() <= enough;
  }

  Speeds speeds(const Unknowns& x) const { return u_ + unit_.cwiseProduct(x.head(u_.rows())); }
  Coordinates coordinates(const Speeds& next_u) const {
    return q_ + h_ * Coordinates(system_.coordinate_rates(q_, next_u));
  }

 private:
  /// What the equations of the implicit Euler method are off by. \return whether it is finite.
  [[nodiscard]] bool find_rest(const Unknowns& x, Unknowns& left) {
    const Eigen::Index n = u_.rows();
    next_u_ = speeds(x);
    next_q_ = coordinates(next_u_);
    if (!is_finite_state(start_, next_q_, next_u_) || normalize(system_, next_q_) != Status::ok) return false;
    system_.mass_matrix_and_bias(next_q_, next_u_, mass_, c_);
    for (Eigen::Index i = 0; i < n; ++i) {
      S sum = h_ * (c_(i) - tau_(i));
      for (Eigen::Index j = 0; j < n; ++j) sum += mass_(i, j) * (next_u_(j) - u_(j));
      left(i) = unit_(i) * sum;
      for (Eigen::Index r = 0; r < P_.rows(); ++r) left(i) -= P_(r, i) * x(n + r);
    }
    for (Eigen::Index r = 0; r < P_.rows(); ++r) {
      left(n + r) = -(h_ * sides_(r));
      for (Eigen::Index j = 0; j < n; ++j) left(n + r) += P_(r, j) * x(j);
    }
    return all_finite(left);
  }
  /// The length of q in the units of the speeds: along each speed, that of the coordinates it moves. Quaternions
  /// have length one.
  [[nodiscard]] S size_of_coordinates() {
    using std::sqrt;
    const Eigen::Index n = u_.rows();
    Coordinates size = q_.cwiseAbs();
    for (const int start : system_.quaternion_offsets())
      for (int i = start; i < start + 4; ++i) size(i) = S(1);
    Speeds along = u_;
    S squares(0);
    for (Eigen::Index j = 0; j < n; ++j) {
      along.setZero();
      along(j) = S(1);
      const Coordinates rates = system_.coordinate_rates(q_, along);
      S rate_squares(0), size_squares(0);
      for (Eigen::Index i = 0; i < q_.rows(); ++i) {
        rate_squares += rates(i) * rates(i);
        if (rates(i) < S(0) || rates(i) > S(0)) size_squares += size(i) * size(i);
      }
      if (rate_squares > S(0)) squares += size_squares / (rate_squares * unit_(j) * unit_(j));
    }
    return sqrt(squares);
  }
  /// Units of the speeds; rows are brought to length one.
  [[nodiscard]] Status set_units() {
    using std::sqrt;
    unit_.setZero(u_.rows());
    for (Eigen::Index i = 0; i < u_.rows(); ++i) {
      if (!is_finite(mass_(i, i))) return Status::not_finite;
      if (!(mass_(i, i) > S(0))) return Status::not_positive_definite;
      unit_(i) = S(1) / sqrt(mass_(i, i));
    }
    for (Eigen::Index r = 0; r < P_.rows(); ++r) {
      S squares(0);
      for (Eigen::Index j = 0; j < u_.rows(); ++j) {
        P_(r, j) *= redundant_(r) ? S(0) : unit_(j);
        squares += P_(r, j) * P_(r, j);
      }
      const S scale = redundant_(r) ? S(0) : S(1) / sqrt(squares);
      for (Eigen::Index j = 0; j < u_.rows(); ++j) P_(r, j) *= scale;
      sides_(r) = redundant_(r) ? S(0) : scale * sides_(r);
    }
    return Status::ok;
  }
  void set_matrix() {
    const Eigen::Index n = u_.rows();
    A_.setZero();
    for (Eigen::Index j = 0; j < n; ++j)
      for (Eigen::Index i = 0; i < n; ++i)
        A_(i, j) = unit_(i) * unit_(j) * (mass_(i, j) + h_ * (C_(i, j) + h_ * K_(i, j)));
    for (Eigen::Index r = 0; r < P_.rows(); ++r) {
      for (Eigen::Index j = 0; j < n; ++j) {
        A_(n + r, j) = P_(r, j);
        A_(j, n + r) = -P_(r, j);
      }
      if (redundant_(r)) A_(n + r, n + r) = S(1);
    }
  }

  System& system_;
  const Coordinates& q_;
  const Speeds &u_, &tau_;
  S start_, h_;
  SizedMatrix<S, kNv, kNv> mass_, K_, C_;
  Speeds c_, unit_, next_u_;
  Coordinates next_q_;
  SizedMatrix<S, kNc, kNv> P_;
  Eigen::Matrix<S, kNc, 1> sides_;
  Eigen::Array<bool, kNc, 1> redundant_;
  SizedMatrix<S, kSize, kSize> A_;
};

/// A step under forces that are held.
/// \param iterate    whether with Newton's method
/// \param converged  result: whether that came to its end, if the status is ok
template <class System, class Coordinates, class Speeds>
[[nodiscard]] Status step_implicitly(System& system, Coordinates& q, Speeds& u, const Speeds& tau,
                                     typename System::Scalar h, bool iterate, bool& converged,
                                     const StepOptions<typename System::Scalar>& options,
                                     ConstraintReport<System::kNc>& report) {
  using Equations = ImplicitEquations<System>;
  Equations equations(system, q, u, tau, h);
  Speeds rate = u;
  if (system.nc() != 0) {
    if (const Status status = equations.set_constraints(options, rate, report); status != Status::ok)
      return status;
  }
  if (const Status status = equations.begin(); status != Status::ok) return status;
  typename Equations::Unknowns x;
  const Status predicted = equations.predict(rate, x);
  if (predicted != Status::ok) {
    if (predicted == Status::not_finite || !iterate) return predicted;
    x.setZero();  // the step's end may be regular all the same, by the forces
  }
  converged = !iterate || !(h < 0 || h > 0) || equations.refine(x);
  if (!converged && predicted != Status::ok) return predicted;
  Speeds next_u = equations.speeds(x);
  Coordinates next_q = equations.coordinates(next_u);
  if (const Status status = settle(system, next_q, next_u, options, report); status != Status::ok)
    return status;
  q = next_q;
  u = next_u;
  return Status::ok;
}

/// Steps of half the length where Newton's method comes to no end, down to h / 2^halvings, where it need not.
template <class System, class Coordinates, class Speeds>
[[nodiscard]] Status halve_until_converged(System& system, Coordinates& q, Speeds& u, const Speeds& tau,
                                           typename System::Scalar h, int halvings,
                                           const StepOptions<typename System::Scalar>& options,
                                           ConstraintReport<System::kNc>& report) {
  const auto start = system.time();
  Coordinates next_q = q;
  Speeds next_u = u;
  bool converged = false;
  Status status = step_implicitly(system, next_q, next_u, tau, h, true, converged, options, report);
  if (halvings > 0 && !(status == Status::ok && converged)) {
    next_q = q;
    next_u = u;
    system.set_time(start);
    const auto half = h / 2;
    for (int part = 0; part < 2; ++part) {
      status = halve_until_converged(system, next_q, next_u, tau, half, halvings - 1, options, report);
      if (status != Status::ok) return status;
    }
    system.set_time(start + h);
  }
  if (status != Status::ok) return status;
  q = next_q;
  u = next_u;
  return Status::ok;
}

/// The states besides q and u, by a linearly implicit step to the system's time.
template <class System, class Coordinates, class Speeds>
[[nodiscard]] Status step_states(System& system, const Coordinates& q, const Speeds& u,
                                 typename System::Scalar h) {
  if constexpr (System::kNs != 0) {
    using S = typename System::Scalar;
    auto states = system.states();
    const Eigen::Index n = states.rows();
    if (n == 0) return Status::ok;
    auto change = states;
    change = h * system.state_rates(q, u);
    Eigen::Matrix<S, System::kNs, System::kNs> A = -h * system.state_rate_derivatives(q, u);
    for (Eigen::Index i = 0; i < n; ++i) A(i, i) += S(1);
    if (const Status status = solve_regular(A, change); status != Status::ok) return status;
    states += change;
    if (!all_finite(states)) return Status::not_finite;
    system.set_states(states);
  }
  return Status::ok;
}

/// A step of any System (bound_mechanism.hpp) that has inverse_dynamics_derivatives, whose time is advanced too:
/// the linearly implicit one, or the implicit one.
template <class System, class Coordinates, class Speeds, class Force>
[[nodiscard]] Status advance_implicitly(System& system, Coordinates& q, Speeds& u, typename System::Scalar h,
                                        bool iterate, Force&& force,
                                        const StepOptions<typename System::Scalar>& options,
                                        ConstraintReport<System::kNc>& report) {
  constexpr int kHalvings = 5;
  if (!is_finite(h)) return Status::not_finite;
  const auto start = system.time();
  const Speeds tau = forces_of(system, q, u, force);
  if (!is_finite_state(start, q, u) || !all_finite(tau)) return Status::not_finite;
  bool converged = true;
  Coordinates next_q = q;
  Speeds next_u = u;
  Status status = iterate
                      ? halve_until_converged(system, next_q, next_u, tau, h, kHalvings, options, report)
                      : step_implicitly(system, next_q, next_u, tau, h, false, converged, options, report);
  if (status == Status::ok) status = step_states(system, next_q, next_u, h);
  if (status != Status::ok) {
    system.set_time(start);
    return status;
  }
  q = next_q;
  u = next_u;
  return Status::ok;
}

}  // namespace detail

/// linearly_implicit_euler_step of any System (bound_mechanism.hpp) that has inverse_dynamics_derivatives, whose
/// time is advanced too.
template <class System, class Coordinates, class Speeds, class Force>
[[nodiscard]] Status advance_by_linearly_implicit_euler(System& system, Coordinates& q, Speeds& u,
                                                        typename System::Scalar h, Force&& force,
                                                        const StepOptions<typename System::Scalar>& options,
                                                        ConstraintReport<System::kNc>& report) {
  return detail::advance_implicitly(system, q, u, h, false, force, options, report);
}

/// implicit_euler_step likewise.
template <class System, class Coordinates, class Speeds, class Force>
[[nodiscard]] Status advance_by_implicit_euler(System& system, Coordinates& q, Speeds& u,
                                               typename System::Scalar h, Force&& force,
                                               const StepOptions<typename System::Scalar>& options,
                                               ConstraintReport<System::kNc>& report) {
  return detail::advance_implicitly(system, q, u, h, true, force, options, report);
}

/// One step of the linearly implicit Euler method (see the top of this file): one evaluation of the derivatives
/// and one solution of linear equations a step. For forces that are stiff at the step and smooth over it: hard
/// springs, strong dampers. rk4_step and semi_implicit_euler_step need h below about 2 sqrt(m/k) and 2 m/b, or the
/// motion diverges. Where friction or a contact changes much within a step, it overshoots, and can gain energy:
/// implicit_euler_step does not.
///
/// Stiff forces must be those of the mechanism (`forces`, `damping`, `stiffness`, ... of its description). What
/// `force` returns is taken at the start of the step and held, and so are the directions of reactions.
///
/// Arguments and result as for rk4_step; M must have been generated with inverse_dynamics_derivatives, and with
/// state_rates_derivatives if it has states.
/// singular_step: h is just so long that the equations have no solution, which can be where the state is unstable
/// and h of the size of its time scale; a shorter step has one.
template <class M, class Force>
[[nodiscard]] Status linearly_implicit_euler_step(
    CoordinateVector<M>& q, SpeedVector<M>& qd, typename M::Inputs& in, typename M::Scalar h, Force&& force,
    const StepOptions<typename M::Scalar>& options = {},
    ConstraintReport<BoundMechanism<M>::kNc>* report = nullptr) {
  static_assert(has_derivatives_v<M>, "generate M with inverse_dynamics_derivatives");
  BoundMechanism<M> system(in);
  ConstraintReport<BoundMechanism<M>::kNc> unused;
  return advance_by_linearly_implicit_euler(system, q, qd, h, force, options,
                                            report == nullptr ? unused : *report);
}

/// One step of the implicit Euler method: the linearly implicit one, then Newton's method until the equations are
/// kept to 64 sqrt(epsilon) of the speeds, or as far as the coordinates' rounding lets them. Where that comes to no end, two steps of half the length are made, and so
/// on down to h / 32, where the nearest state will do. For hard ground with friction at the length of a frame:
/// contacts that begin within a step are felt in it, friction stops what slides instead of throwing it back, and
/// bounces die. Without constraints it goes on where M is singular, if dampers or springs make the step regular.
///
/// Arguments and result as for linearly_implicit_euler_step.
template <class M, class Force>
[[nodiscard]] Status implicit_euler_step(CoordinateVector<M>& q, SpeedVector<M>& qd, typename M::Inputs& in,
                                         typename M::Scalar h, Force&& force,
                                         const StepOptions<typename M::Scalar>& options = {},
                                         ConstraintReport<BoundMechanism<M>::kNc>* report = nullptr) {
  static_assert(has_derivatives_v<M>, "generate M with inverse_dynamics_derivatives");
  BoundMechanism<M> system(in);
  ConstraintReport<BoundMechanism<M>::kNc> unused;
  return advance_by_implicit_euler(system, q, qd, h, force, options, report == nullptr ? unused : *report);
}

}  // namespace alembert
