// spherical_pendulum: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "spherical_pendulum". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Sizes and names, the inputs, and the functions over plain arrays. Needs the standard library only.
//
// A rigid body hung by a spherical joint.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#ifdef ALEMBERT_VECTOR_TRIG
#include <alembert/sines_and_cosines.hpp>
#endif

#ifdef spherical_pendulum
#error "spherical_pendulum names this mechanism's namespace and is a macro here: undefine the macro before, or rename the mechanism"
#endif

namespace alembert::mechanisms::spherical_pendulum {

inline constexpr std::string_view kName = "spherical_pendulum";

inline constexpr int kNq = 4;  ///< coordinates: size of q
inline constexpr int kNv = 3;  ///< speeds: size of qd, qdd, tau, c; M is kNv x kNv
inline constexpr int kBodyCount = 1;
inline constexpr int kFrameCount = 0;
inline constexpr int kOutputCount = 0;
inline constexpr int kForceCount = 0;
inline constexpr int kParameterCount = 0;  ///< runtime parameters, then inputs, then states
inline constexpr int kInputCount = 0;
inline constexpr int kStateCount = 0;
inline constexpr int kWrenchCount = 1;  ///< bodies with an external wrench
inline constexpr int kNc = 0;  ///< rows of the constraints

/// Entries of q. A quaternion has four, x y z w.
inline constexpr ::std::array<::std::string_view, kNq> kCoordinateNames = {{"turn.x", "turn.y", "turn.z", "turn.w"}};
/// Entries of qd. A quaternion has three: the angular velocity in the child's axes.
inline constexpr ::std::array<::std::string_view, kNv> kSpeedNames = {{"d(turn).x", "d(turn).y", "d(turn).z"}};
inline constexpr ::std::array<::std::string_view, kBodyCount> kBodyNames = {{"bob"}};
inline constexpr ::std::array<::std::string_view, kFrameCount> kFrameNames = {};
inline constexpr ::std::array<::std::string_view, kOutputCount> kOutputNames = {};
/// Forces of the description, those of its coordinates too.
inline constexpr ::std::array<::std::string_view, kForceCount> kForceNames = {};
inline constexpr ::std::array<::std::string_view, kParameterCount> kParameterNames = {};
/// Bodies that take an external wrench, in the order of Inputs::wrenches.
inline constexpr ::std::array<::std::string_view, kWrenchCount> kWrenchBodyNames = {{"bob"}};
/// Rows of the constraints.
inline constexpr ::std::array<const char*, kNc> kConstraintNames = {};
/// Whether the row is the rate of an equation in the coordinates alone, which then has to hold as well.
inline constexpr ::std::array<bool, kNc> kHolonomic = {};
/// About how long the terms are that each row of P is made of, in the metric of M^-1, over those of the longest row: where
/// the units of rows lie far apart, by these what is rounding of a row is told from the row.
inline constexpr ::std::array<double, kNc> kRowLengths = {};

/// The initial state of the description: coordinates and speeds.
inline constexpr ::std::array<double, kNq> kInitialCoordinates = {{0.0, 0.0, 0.0, 1.0}};
inline constexpr ::std::array<double, kNv> kInitialSpeeds = {{0.0, 0.0, 0.0}};
/// Limits of the coordinates as described, infinite where there are none. The equations do not enforce them.
inline constexpr ::std::array<double, kNq> kLowerLimits = {{
    -::std::numeric_limits<double>::infinity(), -::std::numeric_limits<double>::infinity(),
    -::std::numeric_limits<double>::infinity(), -::std::numeric_limits<double>::infinity()}};
inline constexpr ::std::array<double, kNq> kUpperLimits = {{
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity()}};
/// The drives' largest force and speed, magnitudes, infinite where there are none. No equation depends on them.
inline constexpr ::std::array<double, kNv> kEffortLimits = {{
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity()}};
inline constexpr ::std::array<double, kNv> kSpeedLimits = {{
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity()}};
/// Where the unit quaternions (x y z w) start in q.
inline constexpr ::std::array<int, 1> kQuaternionOffsets = {{0}};

/// Names for indices: q(Coordinate::NAME), qd(Speed::NAME). Of a quaternion that of its first entry. Wrenches
/// begin at 6 * Wrench::NAME.
struct Coordinate { enum : int { turn = 0 }; };
struct Speed { enum : int { turn = 0 }; };
struct Body { enum : int { bob = 0 }; };
struct Wrench { enum : int { bob = 0 }; };

/// What the functions take besides the state.
template <class S>
struct Inputs {
  S t = S(0.0);  ///< time, s
  ::std::array<S, 0> parameters = {};  ///< there are no runtime parameters
  /// Six per body of kWrenchBodyNames: force x y z at its centre of mass, N, and torque x y z, N m, both in world axes.
  ::std::array<S, 6 * kWrenchCount> wrenches = {};
};

// Arguments of the functions below; arrays must not overlap.
//
//   q    [4] coordinates: turn.x, turn.y, turn.z, turn.w
//   qd   [3] speeds: d(turn).x, d(turn).y, d(turn).z
//   qdd  [3] rates of the speeds
//   tau  [3] generalized forces: N m for a speed in rad/s, N for one in m/s
//
// Angles are in rad and lengths in m. They are compiled for double and float; for any other scalar type include
// <spherical_pendulum/spherical_pendulum_impl.hpp>, which asks of it + - * / and, found by argument, the functions of <cmath> that are called.

/// Inverse dynamics: the generalized forces that give the speeds the rates qdd.
///   tau = M(q) qdd + c(q, qd)
/// tau [3]: generalized forces, N m for a speed in rad/s, N for one in m/s.
/// Source: Guenter and Lee, Symbolic Lagrangian Multibody Dynamics, eq. 13.
/// Operations: 60 multiplications, 69 additions (reduced formulation; relative error 3.6e-16 where it was measured).
template <class S>
void inverse_dynamics(const S* q, const S* qd, const S* qdd, const Inputs<S>& in, S* tau);

/// Mass matrix (joint-space inertia matrix), symmetric and in full.
///   kinetic energy = 1/2 qd^T M(q) qd, where no motion is prescribed in time
/// M [3 x 3], row by row: in units of tau / qdd.
/// Operations: 0 multiplications, 0 additions (reduced formulation; relative error 7.6e-17 where it was measured).
template <class S>
void mass_matrix(const S* q, const Inputs<S>& in, S* M);

/// Bias forces: Coriolis, centrifugal and gravity terms, less external wrenches and other forces.
///   tau = M(q) qdd + c(q, qd)
/// c [3]: bias forces, in units of tau.
/// Operations: 57 multiplications, 60 additions (reduced formulation; relative error 1.5e-15 where it was measured).
template <class S>
void bias(const S* q, const S* qd, const Inputs<S>& in, S* c);

/// Mass matrix and bias forces at once: shorter than one after the other.
///   tau = M(q) qdd + c(q, qd)
/// M [3 x 3], row by row: mass matrix, symmetric and in full, in units of tau / qdd.
/// c [3]: bias forces, in units of tau.
/// Operations: 57 multiplications, 60 additions (reduced formulation; relative error 1.5e-15 where it was measured).
template <class S>
void mass_matrix_and_bias(const S* q, const S* qd, const Inputs<S>& in, S* M, S* c);

/// Rates of the coordinates: the speeds, but for a quaternion p half of p (w, 0), with w in the axes of its body.
///   dq/dt = N(q) qd
/// qdot [4]: per second.
/// Operations: 15 multiplications, 8 additions (reduced formulation; relative error 1.7e-16 where it was measured).
template <class S>
void coordinate_rates(const S* q, const S* qd, S* qdot);

/// Kinetic and potential energy.
///   e[0] = 1/2 sum (m |v|^2 + w^T J w), e[1] = -sum m g^T r, zero at the world's origin
/// e [2]: kinetic and potential energy, J.
/// Operations: 23 multiplications, 15 additions (reduced formulation; relative error 4.7e-15 where it was measured).
template <class S>
void energy(const S* q, const S* qd, const Inputs<S>& in, S* e);

/// Poses of the bodies in the world.
/// W [1 x 3 x 4], row by row: for each body of kBodyNames the matrix [R p]: the columns of R are the body's axes, p
///   is its origin, m.
/// Operations: 9 multiplications, 21 additions (reduced formulation; relative error 2e-16 where it was measured).
template <class S>
void body_poses(const S* q, const Inputs<S>& in, S* W);

extern template void inverse_dynamics<double>(const double*, const double*, const double*, const Inputs<double>&, double*);
extern template void inverse_dynamics<float>(const float*, const float*, const float*, const Inputs<float>&, float*);
extern template void mass_matrix<double>(const double*, const Inputs<double>&, double*);
extern template void mass_matrix<float>(const float*, const Inputs<float>&, float*);
extern template void bias<double>(const double*, const double*, const Inputs<double>&, double*);
extern template void bias<float>(const float*, const float*, const Inputs<float>&, float*);
extern template void mass_matrix_and_bias<double>(const double*, const double*, const Inputs<double>&, double*, double*);
extern template void mass_matrix_and_bias<float>(const float*, const float*, const Inputs<float>&, float*, float*);
extern template void coordinate_rates<double>(const double*, const double*, double*);
extern template void coordinate_rates<float>(const float*, const float*, float*);
extern template void energy<double>(const double*, const double*, const Inputs<double>&, double*);
extern template void energy<float>(const float*, const float*, const Inputs<float>&, float*);
extern template void body_poses<double>(const double*, const Inputs<double>&, double*);
extern template void body_poses<float>(const float*, const Inputs<float>&, float*);

}  // namespace alembert::mechanisms::spherical_pendulum
