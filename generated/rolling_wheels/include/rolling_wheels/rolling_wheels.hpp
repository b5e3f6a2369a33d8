// rolling_wheels: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "rolling_wheels". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// The interface for C++ with vectors and matrices of Eigen. Over plain arrays: rolling_wheels_raw.hpp; in C: rolling_wheels.h.
#pragma once

#include <Eigen/Core>
#include <alembert/matrix.hpp>
#include <alembert/version.hpp>
#include <array>

#include "rolling_wheels_raw.hpp"

#if ALEMBERT_VERSION_MAJOR != 0
#error "rolling_wheels was generated for version 0 of the alembert runtime, and <alembert/version.hpp> is of another: generate it anew or install version 0"
#endif

namespace alembert::mechanisms::rolling_wheels {

/// The mechanism as a type without state, for the templates of the alembert runtime and for direct use.
/// Vectors and matrices have fixed sizes; no call takes memory from the heap or throws, unless a matrix is too large for
/// the stack (alembert::SizedMatrix in <alembert/matrix.hpp>). Arguments are those of rolling_wheels_raw.hpp.
template <class S = double>
struct Mechanism {
  using Scalar = S;
  using Coordinate = ::alembert::mechanisms::rolling_wheels::Coordinate;
  using Speed = ::alembert::mechanisms::rolling_wheels::Speed;
  using Body = ::alembert::mechanisms::rolling_wheels::Body;
  using Wrench = ::alembert::mechanisms::rolling_wheels::Wrench;
  using Inputs = ::alembert::mechanisms::rolling_wheels::Inputs<S>;
  static constexpr int kNq = ::alembert::mechanisms::rolling_wheels::kNq;
  static constexpr int kNv = ::alembert::mechanisms::rolling_wheels::kNv;
  static constexpr int kNc = ::alembert::mechanisms::rolling_wheels::kNc;
  static constexpr int kNbodies = ::alembert::mechanisms::rolling_wheels::kBodyCount;
  static constexpr int kNframes = ::alembert::mechanisms::rolling_wheels::kFrameCount;
  static constexpr int kNoutputs = ::alembert::mechanisms::rolling_wheels::kOutputCount;
  static constexpr int kNforces = ::alembert::mechanisms::rolling_wheels::kForceCount;
  static constexpr int kNparameters = ::alembert::mechanisms::rolling_wheels::kParameterCount - ::alembert::mechanisms::rolling_wheels::kInputCount - ::alembert::mechanisms::rolling_wheels::kStateCount;
  static constexpr int kNbase = 0;  ///< columns of base_regressor, where that is written
  static constexpr int kNinputs = ::alembert::mechanisms::rolling_wheels::kInputCount;
  static constexpr int kNstates = ::alembert::mechanisms::rolling_wheels::kStateCount;
  static constexpr auto kQuaternionOffsets = ::alembert::mechanisms::rolling_wheels::kQuaternionOffsets;
  /// Of each speed the last one before it to which M(q), or L of M = L^T D L, ties it, or -1; and whose M.
  static constexpr ::std::array<int, kNv> kSpeedParents = {{-1, 0}};
  using SpeedParentsOf = Mechanism;
  static constexpr auto kConstraintNames = ::alembert::mechanisms::rolling_wheels::kConstraintNames;
  static constexpr auto kHolonomic = ::alembert::mechanisms::rolling_wheels::kHolonomic;
  static constexpr auto kRowLengths = ::alembert::mechanisms::rolling_wheels::kRowLengths;
  using CoordinateVector = ::Eigen::Matrix<S, kNq, 1>;
  using SpeedVector = ::Eigen::Matrix<S, kNv, 1>;
  using SpeedMatrix = ::alembert::SizedMatrix<S, kNv, kNv>;
  using ConstraintMatrix = ::alembert::SizedMatrix<S, kNc, kNv>;
  using ConstraintVector = ::Eigen::Matrix<S, kNc, 1>;
  using Pose = ::Eigen::Matrix<S, 3, 4>;  ///< [R p]: columns are the axes and the origin, in world coordinates

  /// The initial coordinates of the description.
  static CoordinateVector initial_coordinates() {
    CoordinateVector q;
    for (int i = 0; i < kNq; ++i) q(i) = S(::alembert::mechanisms::rolling_wheels::kInitialCoordinates[static_cast<unsigned>(i)]);
    return q;
  }
  /// The initial speeds of the description.
  static SpeedVector initial_speeds() {
    SpeedVector qd;
    for (int i = 0; i < kNv; ++i) qd(i) = S(::alembert::mechanisms::rolling_wheels::kInitialSpeeds[static_cast<unsigned>(i)]);
    return qd;
  }

  /// Inverse dynamics: the generalized forces that give the speeds the rates qdd.
  ///   tau = M(q) qdd + c(q, qd)
  static SpeedVector inverse_dynamics(const CoordinateVector& q, const SpeedVector& qd, const SpeedVector& qdd,
                                      const Inputs& in = Inputs()) {
    SpeedVector tau;
    ::alembert::mechanisms::rolling_wheels::inverse_dynamics<S>(q.data(), qd.data(), qdd.data(), in, tau.data());
    return tau;
  }

  /// Mass matrix (joint-space inertia matrix), symmetric and in full.
  ///   kinetic energy = 1/2 qd^T M(q) qd, where no motion is prescribed in time
  static SpeedMatrix mass_matrix(const CoordinateVector& q, const Inputs& in = Inputs()) {
    SpeedMatrix M;
    ::alembert::mechanisms::rolling_wheels::mass_matrix<S>(q.data(), in, M.data());
    return M;
  }

  /// Bias forces: Coriolis, centrifugal and gravity terms, less external wrenches and other forces.
  ///   tau = M(q) qdd + c(q, qd)
  static SpeedVector bias(const CoordinateVector& q, const SpeedVector& qd, const Inputs& in = Inputs()) {
    SpeedVector c;
    ::alembert::mechanisms::rolling_wheels::bias<S>(q.data(), qd.data(), in, c.data());
    return c;
  }

  /// Mass matrix and bias forces at once: shorter than one after the other.
  ///   tau = M(q) qdd + c(q, qd)
  static void mass_matrix_and_bias(const CoordinateVector& q, const SpeedVector& qd, const Inputs& in, SpeedMatrix& M,
                                   SpeedVector& c) {
    ::alembert::mechanisms::rolling_wheels::mass_matrix_and_bias<S>(q.data(), qd.data(), in, M.data(), c.data());
  }

  /// Rates of the coordinates: the speeds, but for a quaternion p half of p (w, 0), with w in the axes of its body.
  ///   dq/dt = N(q) qd
  static CoordinateVector coordinate_rates(const CoordinateVector& q, const SpeedVector& qd) {
    CoordinateVector qdot;
    ::alembert::mechanisms::rolling_wheels::coordinate_rates<S>(q.data(), qd.data(), qdot.data());
    return qdot;
  }

  /// Kinetic and potential energy.
  ///   e[0] = 1/2 sum (m |v|^2 + w^T J w), e[1] = -sum m g^T r, zero at the world's origin
  static ::Eigen::Matrix<S, 2, 1> energy(const CoordinateVector& q, const SpeedVector& qd, const Inputs& in = Inputs()) {
    ::Eigen::Matrix<S, 2, 1> e;
    ::alembert::mechanisms::rolling_wheels::energy<S>(q.data(), qd.data(), in, e.data());
    return e;
  }

  /// Poses of the bodies in the world.
  static ::std::array<Pose, kNbodies> body_poses(const CoordinateVector& q, const Inputs& in = Inputs()) {
    ::std::array<Pose, kNbodies> W;
    ::alembert::SizedMatrix<S, kNbodies * 3 * 4, 1> W_rows;
    ::alembert::mechanisms::rolling_wheels::body_poses<S>(q.data(), in, W_rows.data());
    ::alembert::from_rows(W_rows.data(), W);
    return W;
  }
};

}  // namespace alembert::mechanisms::rolling_wheels
