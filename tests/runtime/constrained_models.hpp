// Mechanisms with constraints, written by hand in the form in which the generator writes them, whose motions
// are known from books or from the same mechanism in fewer coordinates.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "runtime/models.hpp"

namespace models {

/// How the rod of PointOnRod is written down.
enum class Rod {
  once,
  twice,          ///< the same row two times, the second one scaled by 3
  contradictory,  ///< a second rod of twice the length
};

/// The pendulum of models.hpp as a point mass at (x, z) and a rod: (x^2 + z^2 - l^2) / 2 = 0.
template <class S = double, Rod rod = Rod::once>
struct PointOnRod {
  using Scalar = S;
  using Inputs = models::Inputs<S>;
  using Vector = Eigen::Matrix<S, 2, 1>;
  static constexpr int kNq = 2, kNv = 2, kNc = rod == Rod::once ? 1 : 2;
  using ConstraintMatrix = Eigen::Matrix<S, kNc, 2>;
  using ConstraintVector = Eigen::Matrix<S, kNc, 1>;
  static constexpr std::array<int, 0> kQuaternionOffsets{};
  static constexpr std::array<bool, 2> kHolonomic{true, true};
  static constexpr S m = Pendulum<S>::m, l = Pendulum<S>::l, g = Pendulum<S>::g;
  static void mass_matrix_and_bias(const Vector&, const Vector&, const Inputs&, Eigen::Matrix<S, 2, 2>& M,
                                   Vector& c) {
    M << m, 0, 0, m;
    c << 0, m * g;
  }
  static void inverse_dynamics_derivatives(const Vector&, const Vector&, const Vector&, const Inputs&,
                                           Eigen::Matrix<S, 2, 2>& tau_q, Eigen::Matrix<S, 2, 2>& tau_qd) {
    tau_q.setZero();
    tau_qd.setZero();
  }
  static void constraints(const Vector& q, const Vector& u, const Inputs&, ConstraintMatrix& P,
                          ConstraintVector& gamma, ConstraintVector& velocity, ConstraintVector& position) {
    for (int row = 0; row < kNc; ++row) {
      const S scale = row == 1 && rod == Rod::twice ? S(3) : S(1);
      const S length = row == 1 && rod == Rod::contradictory ? 2 * l : l;
      P.row(row) = scale * q.transpose();
      gamma(row) = scale * u.squaredNorm();
      velocity(row) = scale * q.dot(u);
      position(row) = scale * (q.squaredNorm() - length * length) / 2;
    }
  }
  static Vector coordinate_rates(const Vector&, const Vector& u) { return u; }
  static Eigen::Matrix<S, 2, 1> energy(const Vector& q, const Vector& u, const Inputs&) {
    return {m * u.squaredNorm() / 2, m * g * q(1)};
  }
};

/// Chaplygin's sleigh: a plate on a plane with a knife edge at (x, y), along its axis at the angle theta;
/// centre of mass a ahead of the edge. -xdot sin(theta) + ydot cos(theta) = 0.
template <class S = double>
struct Sleigh {
  using Scalar = S;
  using Inputs = models::Inputs<S>;
  using Vector = Eigen::Matrix<S, 3, 1>;
  static constexpr int kNq = 3, kNv = 3, kNc = 1;
  using ConstraintMatrix = Eigen::Matrix<S, 1, 3>;
  using ConstraintVector = Eigen::Matrix<S, 1, 1>;
  static constexpr std::array<int, 0> kQuaternionOffsets{};
  static constexpr std::array<bool, 1> kHolonomic{false};
  static constexpr S m = S(1.5), a = S(0.4), J = S(0.5);  // J about the knife edge
  static void mass_matrix_and_bias(const Vector& q, const Vector& u, const Inputs&, Eigen::Matrix<S, 3, 3>& M,
                                   Vector& c) {
    using std::cos;
    using std::sin;
    const S s = sin(q(2)), k = cos(q(2));
    M << m, 0, -m * a * s, 0, m, m * a * k, -m * a * s, m * a * k, J;
    c << -m * a * u(2) * u(2) * k, -m * a * u(2) * u(2) * s, 0;
  }
  static void constraints(const Vector& q, const Vector& u, const Inputs&, ConstraintMatrix& P,
                          ConstraintVector& gamma, ConstraintVector& velocity, ConstraintVector& position) {
    using std::cos;
    using std::sin;
    P << -sin(q(2)), cos(q(2)), 0;
    velocity(0) = P.dot(u);
    gamma(0) = -u(2) * (u(0) * cos(q(2)) + u(1) * sin(q(2)));
    position(0) = 0;
  }
  static Vector coordinate_rates(const Vector&, const Vector& u) { return u; }
};

/// A symmetric top held at a point: a free body (x y z, quaternion) whose point -d is at the origin. u is the
/// velocity of the centre of mass in world axes and the angular velocity in body axes.
template <class S = double>
struct HeldTop {
  using Scalar = S;
  using Inputs = models::Inputs<S>;
  using CoordinateVector = Eigen::Matrix<S, 7, 1>;
  using SpeedVector = Eigen::Matrix<S, 6, 1>;
  using Vector3 = Eigen::Matrix<S, 3, 1>;
  static constexpr int kNq = 7, kNv = 6, kNc = 3;
  using ConstraintMatrix = Eigen::Matrix<S, 3, 6>;
  using ConstraintVector = Vector3;
  static constexpr std::array<int, 1> kQuaternionOffsets{3};
  static constexpr std::array<bool, 3> kHolonomic{true, true, true};
  static constexpr S m = S(0.8), g = S(9.81), length = S(0.3);
  static Vector3 inertia() { return {S(0.01), S(0.01), S(0.02)}; }
  static Vector3 pivot() { return {0, 0, -length}; }  // from the centre of mass, body axes
  static Eigen::Matrix<S, 3, 3> rotation(const CoordinateVector& q) {
    return Eigen::Quaternion<S>(q(6), q(3), q(4), q(5)).toRotationMatrix();
  }
  static void mass_matrix_and_bias(const CoordinateVector&, const SpeedVector& u, const Inputs&,
                                   Eigen::Matrix<S, 6, 6>& M, SpeedVector& c) {
    M.setZero();
    for (int i = 0; i < 3; ++i) {
      M(i, i) = m;
      M(3 + i, 3 + i) = inertia()(i);
    }
    const Vector3 w = u.template tail<3>(), h = inertia().cwiseProduct(w);
    c.setZero();
    c(2) = m * g;
    c.template tail<3>() = w.cross(h);
  }
  static void inverse_dynamics_derivatives(const CoordinateVector&, const SpeedVector& u, const SpeedVector&,
                                           const Inputs&, Eigen::Matrix<S, 6, 6>& tau_q,
                                           Eigen::Matrix<S, 6, 6>& tau_qd) {
    tau_q.setZero();
    tau_qd.setZero();
    const Vector3 w = u.template tail<3>(), h = inertia().cwiseProduct(w);
    for (int k = 0; k < 3; ++k) {
      const Vector3 e = Vector3::Unit(k), change = inertia().cwiseProduct(e);
      tau_qd.template block<3, 1>(3, 3 + k) = e.cross(h) + w.cross(change);
    }
  }
  static void constraints(const CoordinateVector& q, const SpeedVector& u, const Inputs&, ConstraintMatrix& P,
                          ConstraintVector& gamma, ConstraintVector& velocity, ConstraintVector& position) {
    const Eigen::Matrix<S, 3, 3> R = rotation(q);
    const Vector3 d = pivot(), w = u.template tail<3>();
    for (int i = 0; i < 3; ++i) {
      P.col(i) = Vector3::Unit(i);
      const Vector3 axis = Vector3::Unit(i), arm = axis.cross(d);
      P.col(3 + i) = R * arm;
    }
    const Vector3 wd = w.cross(d), wwd = w.cross(wd);
    velocity = u.template head<3>() + R * wd;
    gamma = R * wwd;
    position = q.template head<3>() + R * d;
  }
  static CoordinateVector coordinate_rates(const CoordinateVector& q, const SpeedVector& u) {
    CoordinateVector out;
    out.template head<3>() = u.template head<3>();
    out.template tail<4>() = SpinningBody<S>::coordinate_rates(q.template tail<4>(), u.template tail<3>());
    return out;
  }
  static Eigen::Matrix<S, 2, 1> energy(const CoordinateVector& q, const SpeedVector& u, const Inputs&) {
    const Vector3 w = u.template tail<3>();
    return {(m * u.template head<3>().squaredNorm() + w.dot(inertia().cwiseProduct(w))) / 2, m * g * q(2)};
  }
};

}  // namespace models
