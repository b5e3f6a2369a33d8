// tree_every_joint: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "tree_every_joint". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Sizes and names, the inputs, and the functions over plain arrays. Needs the standard library only.
//
// A floating tree with one joint of every kind.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#ifdef ALEMBERT_VECTOR_TRIG
#include <alembert/sines_and_cosines.hpp>
#endif

#ifdef tree_every_joint
#error "tree_every_joint names this mechanism's namespace and is a macro here: undefine the macro before, or rename the mechanism"
#endif

namespace alembert::mechanisms::tree_every_joint {

inline constexpr std::string_view kName = "tree_every_joint";

inline constexpr int kNq = 22;  ///< coordinates: size of q
inline constexpr int kNv = 20;  ///< speeds: size of qd, qdd, tau, c; M is kNv x kNv
inline constexpr int kBodyCount = 10;
inline constexpr int kFrameCount = 1;
inline constexpr int kOutputCount = 0;
inline constexpr int kForceCount = 0;
inline constexpr int kParameterCount = 0;  ///< runtime parameters, then inputs, then states
inline constexpr int kInputCount = 0;
inline constexpr int kStateCount = 0;
inline constexpr int kWrenchCount = 2;  ///< bodies with an external wrench
inline constexpr int kNc = 0;  ///< rows of the constraints

/// Entries of q. A quaternion has four, x y z w.
inline constexpr ::std::array<::std::string_view, kNq> kCoordinateNames = {{
    "x", "y", "z", "attitude.x", "attitude.y", "attitude.z", "attitude.w", "shoulder", "slide", "screw",
    "twist", "reach", "pitch", "roll", "px", "py", "pa", "ball.x", "ball.y", "ball.z", "ball.w", "bend"}};
/// Entries of qd. A quaternion has three: the angular velocity in the child's axes.
inline constexpr ::std::array<::std::string_view, kNv> kSpeedNames = {{
    "d(x)", "d(y)", "d(z)", "d(attitude).x", "d(attitude).y", "d(attitude).z", "d(shoulder)", "d(slide)",
    "d(screw)", "d(twist)", "d(reach)", "d(pitch)", "d(roll)", "d(px)", "d(py)", "d(pa)", "d(ball).x",
    "d(ball).y", "d(ball).z", "d(bend)"}};
inline constexpr ::std::array<::std::string_view, kBodyCount> kBodyNames = {{
    "trunk", "arm", "piston", "drill", "tube", "gimbal", "slab", "hand", "finger", "thumb"}};
inline constexpr ::std::array<::std::string_view, kFrameCount> kFrameNames = {{"drill_tip"}};
inline constexpr ::std::array<::std::string_view, kOutputCount> kOutputNames = {};
/// Forces of the description, those of its coordinates too.
inline constexpr ::std::array<::std::string_view, kForceCount> kForceNames = {};
inline constexpr ::std::array<::std::string_view, kParameterCount> kParameterNames = {};
/// Bodies that take an external wrench, in the order of Inputs::wrenches.
inline constexpr ::std::array<::std::string_view, kWrenchCount> kWrenchBodyNames = {{"trunk", "drill"}};
/// Rows of the constraints.
inline constexpr ::std::array<const char*, kNc> kConstraintNames = {};
/// Whether the row is the rate of an equation in the coordinates alone, which then has to hold as well.
inline constexpr ::std::array<bool, kNc> kHolonomic = {};
/// About how long the terms are that each row of P is made of, in the metric of M^-1, over those of the longest row: where
/// the units of rows lie far apart, by these what is rounding of a row is told from the row.
inline constexpr ::std::array<double, kNc> kRowLengths = {};

/// The initial state of the description: coordinates and speeds.
inline constexpr ::std::array<double, kNq> kInitialCoordinates = {{
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0,
    0.0}};
inline constexpr ::std::array<double, kNv> kInitialSpeeds = {{
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}};
/// Limits of the coordinates as described, infinite where there are none. The equations do not enforce them.
inline constexpr ::std::array<double, kNq> kLowerLimits = {{
    -::std::numeric_limits<double>::infinity(), -::std::numeric_limits<double>::infinity(),
    -::std::numeric_limits<double>::infinity(), -::std::numeric_limits<double>::infinity(),
    -::std::numeric_limits<double>::infinity(), -::std::numeric_limits<double>::infinity(),
    -::std::numeric_limits<double>::infinity(), -::std::numeric_limits<double>::infinity(),
    -::std::numeric_limits<double>::infinity(), -::std::numeric_limits<double>::infinity(),
    -::std::numeric_limits<double>::infinity(), -::std::numeric_limits<double>::infinity(),
    -::std::numeric_limits<double>::infinity(), -::std::numeric_limits<double>::infinity(),
    -::std::numeric_limits<double>::infinity(), -::std::numeric_limits<double>::infinity(),
    -::std::numeric_limits<double>::infinity(), -::std::numeric_limits<double>::infinity(),
    -::std::numeric_limits<double>::infinity(), -::std::numeric_limits<double>::infinity(),
    -::std::numeric_limits<double>::infinity(), -::std::numeric_limits<double>::infinity()}};
inline constexpr ::std::array<double, kNq> kUpperLimits = {{
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity()}};
/// The drives' largest force and speed, magnitudes, infinite where there are none. No equation depends on them.
inline constexpr ::std::array<double, kNv> kEffortLimits = {{
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity()}};
inline constexpr ::std::array<double, kNv> kSpeedLimits = {{
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity()}};
/// Where the unit quaternions (x y z w) start in q.
inline constexpr ::std::array<int, 2> kQuaternionOffsets = {{3, 17}};

/// Names for indices: q(Coordinate::NAME), qd(Speed::NAME), frame_poses(q)[Frame::NAME]. Of a quaternion that of
/// its first entry. Wrenches begin at 6 * Wrench::NAME.
struct Coordinate { enum : int {
    x = 0, y = 1, z = 2, attitude = 3, shoulder = 7, slide = 8, screw = 9, twist = 10, reach = 11, pitch = 12,
    roll = 13, px = 14, py = 15, pa = 16, ball = 17, bend = 21 }; };
struct Speed { enum : int {
    x = 0, y = 1, z = 2, attitude = 3, shoulder = 6, slide = 7, screw = 8, twist = 9, reach = 10, pitch = 11,
    roll = 12, px = 13, py = 14, pa = 15, ball = 16, bend = 19 }; };
struct Body { enum : int {
    trunk = 0, arm = 1, piston = 2, drill = 3, tube = 4, gimbal = 5, slab = 6, hand = 7, finger = 8, thumb = 9 }; };
struct Frame { enum : int { drill_tip = 0 }; };
struct Wrench { enum : int { trunk = 0, drill = 1 }; };

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
//   q    [22] coordinates: x, y, z, attitude.x, attitude.y, attitude.z, attitude.w, shoulder, slide, screw, twist, reach and 10 more
//   qd   [20] speeds: d(x), d(y), d(z), d(attitude).x, d(attitude).y, d(attitude).z, d(shoulder), d(slide), d(screw), d(twist), d(reach), d(pitch) and 8 more
//   qdd  [20] rates of the speeds
//   tau  [20] generalized forces: N m for a speed in rad/s, N for one in m/s
//
// Angles are in rad and lengths in m. They are compiled for double and float; for any other scalar type include
// <tree_every_joint/tree_every_joint_impl.hpp>, which asks of it + - * / and, found by argument, the functions of <cmath> that are called.

namespace detail {

/// Sines and cosines of n angles. With the macro ALEMBERT_VECTOR_TRIG those of doubles are vectorised.
template <class S>
void sines_and_cosines(int n, const S* angle, S* sine, S* cosine) {
  using ::std::cos;
  using ::std::sin;
  for (int i = 0; i < n; ++i) {
    sine[i] = sin(angle[i]);
    cosine[i] = cos(angle[i]);
  }
}
#ifdef ALEMBERT_VECTOR_TRIG
using ::alembert::sines_and_cosines;
#endif

}  // namespace detail

/// Inverse dynamics: the generalized forces that give the speeds the rates qdd.
///   tau = M(q) qdd + c(q, qd)
/// tau [20]: generalized forces, N m for a speed in rad/s, N for one in m/s.
/// Source: Guenter and Lee, Symbolic Lagrangian Multibody Dynamics, eq. 13.
/// Operations: 919 multiplications, 877 additions, 16 sin/cos/tan (reduced formulation; relative error 4.6e-16 where it was measured).
template <class S>
void inverse_dynamics(const S* q, const S* qd, const S* qdd, const Inputs<S>& in, S* tau);

/// Mass matrix (joint-space inertia matrix), symmetric and in full.
///   kinetic energy = 1/2 qd^T M(q) qd, where no motion is prescribed in time
/// M [20 x 20], row by row: in units of tau / qdd.
/// Operations: 856 multiplications, 766 additions, 16 sin/cos/tan (reduced formulation; relative error 5.5e-16 where it was measured).
template <class S>
void mass_matrix(const S* q, const Inputs<S>& in, S* M);

/// Bias forces: Coriolis, centrifugal and gravity terms, less external wrenches and other forces.
///   tau = M(q) qdd + c(q, qd)
/// c [20]: bias forces, in units of tau.
/// Operations: 888 multiplications, 810 additions, 16 sin/cos/tan (reduced formulation; relative error 6.4e-16 where it was measured).
template <class S>
void bias(const S* q, const S* qd, const Inputs<S>& in, S* c);

/// Mass matrix and bias forces at once: shorter than one after the other.
///   tau = M(q) qdd + c(q, qd)
/// M [20 x 20], row by row: mass matrix, symmetric and in full, in units of tau / qdd.
/// c [20]: bias forces, in units of tau.
/// Operations: 1710 multiplications, 1524 additions, 16 sin/cos/tan (reduced formulation; relative error 6.4e-16 where it was measured).
template <class S>
void mass_matrix_and_bias(const S* q, const S* qd, const Inputs<S>& in, S* M, S* c);

/// Rates of the coordinates: the speeds, but for a quaternion p half of p (w, 0), with w in the axes of its body.
///   dq/dt = N(q) qd
/// qdot [22]: per second.
/// Operations: 30 multiplications, 16 additions (reduced formulation; relative error 9.7e-17 where it was measured).
template <class S>
void coordinate_rates(const S* q, const S* qd, S* qdot);

/// Kinetic and potential energy.
///   e[0] = 1/2 sum (m |v|^2 + w^T J w), e[1] = -sum m g^T r, zero at the world's origin
/// e [2]: kinetic and potential energy, J.
/// Operations: 792 multiplications, 653 additions, 16 sin/cos/tan (reduced formulation; relative error 6.8e-16 where it was measured).
template <class S>
void energy(const S* q, const S* qd, const Inputs<S>& in, S* e);

/// Poses of the bodies in the world.
/// W [10 x 3 x 4], row by row: for each body of kBodyNames the matrix [R p]: the columns of R are the body's axes,
///   p is its origin, m.
/// Operations: 274 multiplications, 239 additions, 16 sin/cos/tan (reduced formulation; relative error 3.3e-16 where it was measured).
template <class S>
void body_poses(const S* q, const Inputs<S>& in, S* W);

/// Poses of the named frames in the world.
/// F [1 x 3 x 4], row by row: for each frame of kFrameNames the matrix [R p]: the columns of R are the frame's
///   axes, p is its origin, m.
/// Operations: 82 multiplications, 76 additions, 4 sin/cos/tan (reduced formulation; relative error 5e-16 where it was measured).
template <class S>
void frame_poses(const S* q, const Inputs<S>& in, S* F);

/// Geometric Jacobians of the named frames' origins: angular rows first, in world axes.
///   J(q) qd = (angular velocity x y z, velocity of the frame's origin x y z), less what motion prescribed in time adds
/// J [1 x 6 x 20], row by row: for each frame of kFrameNames 6 rows: 3 angular, then 3 linear.
/// Operations: 527 multiplications, 395 additions, 4 sin/cos/tan (reduced formulation; relative error 5.1e-16 where it was measured).
template <class S>
void frame_jacobians(const S* q, const Inputs<S>& in, S* J);

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
extern template void frame_poses<double>(const double*, const Inputs<double>&, double*);
extern template void frame_poses<float>(const float*, const Inputs<float>&, float*);
extern template void frame_jacobians<double>(const double*, const Inputs<double>&, double*);
extern template void frame_jacobians<float>(const float*, const Inputs<float>&, float*);

}  // namespace alembert::mechanisms::tree_every_joint
