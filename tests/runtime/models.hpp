// Mechanisms written by hand, in the form in which the generator writes them, with dynamics known from books.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <cstddef>

#include "alembert/mechanism.hpp"

namespace models {

template <class S>
struct Inputs {
  S t = S(0);
};

/// Point mass m on a massless rod of length l: m l^2 qdd + m g l sin q = tau.
template <class S = double>
struct Pendulum {
  using Scalar = S;
  using Inputs = models::Inputs<S>;
  using Vector = Eigen::Matrix<S, 1, 1>;
  static constexpr int kNq = 1, kNv = 1;
  static constexpr std::array<int, 0> kQuaternionOffsets{};
  static constexpr S m = S(2), l = S(0.5), g = S(9.81);
  static void mass_matrix_and_bias(const Vector& q, const Vector&, const Inputs&, Vector& M, Vector& c) {
    using std::sin;
    M(0) = m * l * l;
    c(0) = m * g * l * sin(q(0));
  }
  static void inverse_dynamics_derivatives(const Vector& q, const Vector&, const Vector&, const Inputs&,
                                           Vector& tau_q, Vector& tau_qd) {
    using std::cos;
    tau_q(0) = m * g * l * cos(q(0));
    tau_qd(0) = S(0);
  }
  static Vector coordinate_rates(const Vector&, const Vector& qd) { return qd; }
  static Eigen::Matrix<S, 2, 1> energy(const Vector& q, const Vector& qd, const Inputs&) {
    using std::cos;
    return {m * l * l * qd(0) * qd(0) / 2, -m * g * l * cos(q(0))};
  }
};

/// Rigid body on a ball joint at its centre: J dw/dt + w x J w = tau, in body axes; dp/dt = p (w, 0) / 2.
template <class S = double>
struct SpinningBody {
  using Scalar = S;
  using Inputs = models::Inputs<S>;
  using Quaternion = Eigen::Matrix<S, 4, 1>;
  using Vector = Eigen::Matrix<S, 3, 1>;
  static constexpr int kNq = 4, kNv = 3;
  static constexpr std::array<int, 1> kQuaternionOffsets{0};
  static Vector inertia() { return {S(1), S(2), S(2.5)}; }
  static void mass_matrix_and_bias(const Quaternion&, const Vector& w, const Inputs&,
                                   Eigen::Matrix<S, 3, 3>& M, Vector& c) {
    M.setZero();
    for (int i = 0; i < 3; ++i) M(i, i) = inertia()(i);
    const Vector h(M(0, 0) * w(0), M(1, 1) * w(1), M(2, 2) * w(2));
    c = w.cross(h);
  }
  static void inverse_dynamics_derivatives(const Quaternion&, const Vector& w, const Vector&, const Inputs&,
                                           Eigen::Matrix<S, 3, 3>& tau_q, Eigen::Matrix<S, 3, 3>& tau_qd) {
    tau_q.setZero();
    const Vector h = inertia().cwiseProduct(w);
    for (int k = 0; k < 3; ++k) {
      const Vector e = Vector::Unit(k);
      const Vector change = inertia().cwiseProduct(e);
      tau_qd.col(k) = e.cross(h) + w.cross(change);
    }
  }
  static Quaternion coordinate_rates(const Quaternion& p, const Vector& w) {
    return S(0.5) *
           Quaternion(p(3) * w(0) + p(1) * w(2) - p(2) * w(1), p(3) * w(1) + p(2) * w(0) - p(0) * w(2),
                      p(3) * w(2) + p(0) * w(1) - p(1) * w(0), -p(0) * w(0) - p(1) * w(1) - p(2) * w(2));
  }
  static Eigen::Matrix<S, 2, 1> energy(const Quaternion&, const Vector& w, const Inputs&) {
    return {S(0.5) * (inertia()(0) * w(0) * w(0) + inertia()(1) * w(1) * w(1) + inertia()(2) * w(2) * w(2)),
            S(0)};
  }
};

/// M = Hilbert-like matrix plus an offset on its diagonal, c = 0: for solvers of any size. The offset is
/// `in.t`.
template <int N>
struct Dense {
  using Scalar = double;
  using Inputs = models::Inputs<double>;
  using Vector = Eigen::Matrix<double, N, 1>;
  static constexpr int kNq = N, kNv = N;
  static constexpr std::array<int, 0> kQuaternionOffsets{};
  static void mass_matrix_and_bias(const Vector&, const Vector& qd, const Inputs& in,
                                   Eigen::Matrix<double, N, N>& M, Vector& c) {
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j) M(i, j) = 1.0 / (1 + i + j) + (i == j ? in.t : 0.0);
    c = qd;
  }
  static Vector coordinate_rates(const Vector&, const Vector& qd) { return qd; }
};

/// What the pendulum's generated functions give, counted and, at will, as they are at a singular state.
template <std::size_t Parameters, std::size_t OfInputs = 0>
struct WrittenPendulum : Pendulum<> {
  static constexpr int kNparameters =
      static_cast<int>(Parameters - OfInputs);  // as generated classes count them
  struct Inputs : models::Inputs<double> {
    std::array<double, Parameters> parameters{};
  };
  static inline int rates_asked = 0, derivatives_asked = 0;
  static inline double singular = 0;
  static void mass_matrix_and_bias(const Vector& q, const Vector& qd, const Inputs& in, Vector& M,
                                   Vector& c) {
    Pendulum::mass_matrix_and_bias(q, qd, in, M, c);
  }
  static Vector forward_dynamics(const Vector& q, const Vector&, const Vector& tau, const Inputs&) {
    ++rates_asked;
    return Vector(singular != 0 ? singular : tau(0) / (m * l * l) - g / l * std::sin(q(0)));
  }
  static void forward_dynamics_derivatives(const Vector& q, const Vector&, const Vector&, const Inputs&,
                                           Vector& qdd_q, Vector& qdd_qd, Vector& qdd_tau) {
    ++derivatives_asked;
    qdd_q(0) = -g / l * std::cos(q(0));
    qdd_qd(0) = 0;
    qdd_tau(0) = 1 / (m * l * l);
  }
};

/// Two hinges about one axis. Where the body between them has little inertia, M is singular but for rounding; the
/// written rates without forces are zero all the same.
struct HingesInLine {
  using Scalar = double;
  static constexpr int kNq = 2, kNv = 2;
  static constexpr std::array<int, 0> kQuaternionOffsets{};
  using Vector = Eigen::Vector2d;
  using Inputs = models::Inputs<double>;
  static inline double inner = 0.5;
  static void mass_matrix_and_bias(const Vector&, const Vector&, const Inputs&, Eigen::Matrix2d& M,
                                   Vector& c) {
    M << 1 + inner, 1, 1, 1;
    c.setZero();
  }
  static Vector forward_dynamics(const Vector&, const Vector&, const Vector& tau, const Inputs&) {
    const double rate = (tau(0) - tau(1)) / inner;
    return {rate, tau(1) - rate};
  }
  static Vector coordinate_rates(const Vector&, const Vector& qd) { return qd; }
};

/// Has sizes and nothing else.
struct NotAMechanism {
  using Scalar = double;
  static constexpr int kNq = 1, kNv = 1;
};

/// Motion that nothing but gravity drives, for the functions that integrate.
template <class M>
alembert::SpeedVector<M> no_force(typename M::Scalar, const alembert::CoordinateVector<M>&,
                                  const alembert::SpeedVector<M>&) {
  return alembert::SpeedVector<M>::Zero();
}

}  // namespace models
