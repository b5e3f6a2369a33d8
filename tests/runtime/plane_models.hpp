// Two bodies in a plane, free, hinged to each other, welded, or hinged by constraints: the same bodies in
// mechanisms of different topology, written by hand in the form in which the generator writes them.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "runtime/models.hpp"

namespace models {

/// Two rods in the x-y plane; each body's frame is at its centre of mass. Body 0's end (+l, 0) meets body 1's
/// end
/// (-l, 0) where they are hinged. From the centres (x, y), the angles and their derivatives along the speeds
/// of a Topology follows all that a mechanism has.
template <class Topology>
struct TwoRods {
  using Scalar = double;
  using Inputs = models::Inputs<double>;
  static constexpr int kNq = Topology::kSize, kNv = Topology::kSize, kNbodies = 2;
  static constexpr std::array<int, 0> kQuaternionOffsets{};
  static constexpr double l = 0.3, kMass[2] = {2.0, 0.7}, kInertia[2] = {0.06, 0.02};
  using Vector = Eigen::Matrix<double, kNq, 1>;
  using Pose = Eigen::Matrix<double, 3, 4>;
  using Jacobian = Eigen::Matrix<double, 12, kNv>;

  static std::array<Pose, 2> body_poses(const Vector& q, const Inputs&) {
    const std::array<Eigen::Vector3d, 2> place = Topology::places(q);  // x, y, angle
    std::array<Pose, 2> out;
    for (std::size_t b = 0; b < 2; ++b) {
      const double s = std::sin(place[b](2)), c = std::cos(place[b](2));
      out[b] << c, -s, 0, place[b](0), s, c, 0, place[b](1), 0, 0, 1, 0;
    }
    return out;
  }
  static Jacobian body_jacobians(const Vector& q, const Inputs&) {
    const Eigen::Matrix<double, 6, kNv> J = Topology::jacobian(q);  // rows x y angle of both
    Jacobian out = Jacobian::Zero();
    for (int b = 0; b < 2; ++b) {
      out.row(6 * b + 2) = J.row(3 * b + 2);
      out.row(6 * b + 3) = J.row(3 * b);
      out.row(6 * b + 4) = J.row(3 * b + 1);
    }
    return out;
  }
  static Eigen::Matrix<double, 2, 10> body_inertias(const Inputs&) {
    Eigen::Matrix<double, 2, 10> out = Eigen::Matrix<double, 2, 10>::Zero();
    for (int b = 0; b < 2; ++b) {
      out(b, 0) = kMass[b];
      out(b, 4) = out(b, 5) = out(b, 6) = kInertia[b];
    }
    return out;
  }
  static void mass_matrix_and_bias(const Vector& q, const Vector&, const Inputs&,
                                   Eigen::Matrix<double, kNv, kNv>& M, Vector& c) {
    const Eigen::Matrix<double, 6, kNv> J = Topology::jacobian(q);
    M.setZero();
    for (int b = 0; b < 2; ++b)
      for (int i = 0; i < kNv; ++i)
        for (int k = 0; k < kNv; ++k)
          M(i, k) += kMass[b] * (J(3 * b, i) * J(3 * b, k) + J(3 * b + 1, i) * J(3 * b + 1, k)) +
                     kInertia[b] * J(3 * b + 2, i) * J(3 * b + 2, k);
    c.setZero();  // not used: these mechanisms are not integrated
  }
  static Vector coordinate_rates(const Vector&, const Vector& u) { return u; }
};

/// q = x y angle of both.
struct Apart {
  static constexpr int kSize = 6;
  using Vector = Eigen::Matrix<double, 6, 1>;
  static std::array<Eigen::Vector3d, 2> places(const Vector& q) { return {q.head<3>(), q.tail<3>()}; }
  static Eigen::Matrix<double, 6, 6> jacobian(const Vector&) {
    return Eigen::Matrix<double, 6, 6>::Identity();
  }
};

/// q = x y of the hinge, angles of both.
struct Hinged {
  static constexpr int kSize = 4;
  using Vector = Eigen::Matrix<double, 4, 1>;
  static std::array<Eigen::Vector3d, 2> places(const Vector& q) {
    constexpr double l = TwoRods<Hinged>::l;
    return {Eigen::Vector3d(q(0) - l * std::cos(q(2)), q(1) - l * std::sin(q(2)), q(2)),
            Eigen::Vector3d(q(0) + l * std::cos(q(3)), q(1) + l * std::sin(q(3)), q(3))};
  }
  static Eigen::Matrix<double, 6, 4> jacobian(const Vector& q) {
    constexpr double l = TwoRods<Hinged>::l;
    Eigen::Matrix<double, 6, 4> J;
    J << 1, 0, l * std::sin(q(2)), 0, 0, 1, -l * std::cos(q(2)), 0, 0, 0, 1, 0,  //
        1, 0, 0, -l * std::sin(q(3)), 0, 1, 0, l * std::cos(q(3)), 0, 0, 0, 1;
    return J;
  }
};

/// One rigid body: q = x y of the hinge, the angle of both.
struct Welded {
  static constexpr int kSize = 3;
  using Vector = Eigen::Vector3d;
  static std::array<Eigen::Vector3d, 2> places(const Vector& q) {
    return Hinged::places(Eigen::Vector4d(q(0), q(1), q(2), q(2)));
  }
  static Eigen::Matrix<double, 6, 3> jacobian(const Vector& q) {
    const Eigen::Matrix<double, 6, 4> J = Hinged::jacobian(Eigen::Vector4d(q(0), q(1), q(2), q(2)));
    Eigen::Matrix<double, 6, 3> out;
    out << J.col(0), J.col(1), J.col(2) + J.col(3);
    return out;
  }
};

/// TwoRods<Apart> with two holonomic rows: the ends meet.
struct HingedByRows : TwoRods<Apart> {
  static constexpr int kNc = 2;
  using ConstraintMatrix = Eigen::Matrix<double, 2, 6>;
  using ConstraintVector = Eigen::Vector2d;
  static constexpr std::array<bool, 2> kHolonomic{true, true};
  static void constraints(const Vector& q, const Vector& u, const Inputs&, ConstraintMatrix& P,
                          ConstraintVector& gamma, ConstraintVector& velocity, ConstraintVector& position) {
    const double sa = std::sin(q(2)), ca = std::cos(q(2)), sb = std::sin(q(5)), cb = std::cos(q(5));
    P << 1, 0, -l * sa, -1, 0, -l * sb, 0, 1, l * ca, 0, -1, l * cb;
    position << q(0) + l * ca - q(3) + l * cb, q(1) + l * sa - q(4) + l * sb;
    velocity = P * u;
    gamma << -l * ca * u(2) * u(2) - l * cb * u(5) * u(5), -l * sa * u(2) * u(2) - l * sb * u(5) * u(5);
  }
};

}  // namespace models
