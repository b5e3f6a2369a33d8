// stanford: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "stanford". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Sizes and names, the inputs, and the functions over plain arrays. Needs the standard library only.
//
// Stanford arm geometry (third joint prismatic) with inertias of its own.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#ifdef ALEMBERT_VECTOR_TRIG
#include <alembert/sines_and_cosines.hpp>
#endif

#ifdef stanford
#error "stanford names this mechanism's namespace and is a macro here: undefine the macro before, or rename the mechanism"
#endif

namespace alembert::mechanisms::stanford {

inline constexpr std::string_view kName = "stanford";

inline constexpr int kNq = 6;  ///< coordinates: size of q
inline constexpr int kNv = 6;  ///< speeds: size of qd, qdd, tau, c; M is kNv x kNv
inline constexpr int kBodyCount = 6;
inline constexpr int kFrameCount = 0;
inline constexpr int kOutputCount = 0;
inline constexpr int kForceCount = 0;
inline constexpr int kParameterCount = 0;  ///< runtime parameters, then inputs, then states
inline constexpr int kInputCount = 0;
inline constexpr int kStateCount = 0;
inline constexpr int kWrenchCount = 0;  ///< bodies with an external wrench
inline constexpr int kNc = 0;  ///< rows of the constraints

/// Entries of q. A quaternion has four, x y z w.
inline constexpr ::std::array<::std::string_view, kNq> kCoordinateNames = {{"q1", "q2", "q3", "q4", "q5", "q6"}};
/// Entries of qd. A quaternion has three: the angular velocity in the child's axes.
inline constexpr ::std::array<::std::string_view, kNv> kSpeedNames = {{"d(q1)", "d(q2)", "d(q3)", "d(q4)", "d(q5)", "d(q6)"}};
inline constexpr ::std::array<::std::string_view, kBodyCount> kBodyNames = {{"link1", "link2", "link3", "link4", "link5", "link6"}};
inline constexpr ::std::array<::std::string_view, kFrameCount> kFrameNames = {};
inline constexpr ::std::array<::std::string_view, kOutputCount> kOutputNames = {};
/// Forces of the description, those of its coordinates too.
inline constexpr ::std::array<::std::string_view, kForceCount> kForceNames = {};
inline constexpr ::std::array<::std::string_view, kParameterCount> kParameterNames = {};
/// Bodies that take an external wrench, in the order of Inputs::wrenches.
inline constexpr ::std::array<::std::string_view, kWrenchCount> kWrenchBodyNames = {};
/// Rows of the constraints.
inline constexpr ::std::array<const char*, kNc> kConstraintNames = {};
/// Whether the row is the rate of an equation in the coordinates alone, which then has to hold as well.
inline constexpr ::std::array<bool, kNc> kHolonomic = {};
/// About how long the terms are that each row of P is made of, in the metric of M^-1, over those of the longest row: where
/// the units of rows lie far apart, by these what is rounding of a row is told from the row.
inline constexpr ::std::array<double, kNc> kRowLengths = {};

/// The initial state of the description: coordinates and speeds.
inline constexpr ::std::array<double, kNq> kInitialCoordinates = {{0.0, 0.0, 0.5, 0.0, 0.0, 0.0}};
inline constexpr ::std::array<double, kNv> kInitialSpeeds = {{0.0, 0.0, 0.0, 0.0, 0.0, 0.0}};
/// Limits of the coordinates as described, infinite where there are none. The equations do not enforce them.
inline constexpr ::std::array<double, kNq> kLowerLimits = {{
    -::std::numeric_limits<double>::infinity(), -::std::numeric_limits<double>::infinity(), 0.15,
    -::std::numeric_limits<double>::infinity(), -::std::numeric_limits<double>::infinity(),
    -::std::numeric_limits<double>::infinity()}};
inline constexpr ::std::array<double, kNq> kUpperLimits = {{
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(), 1.1,
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity()}};
/// The drives' largest force and speed, magnitudes, infinite where there are none. No equation depends on them.
inline constexpr ::std::array<double, kNv> kEffortLimits = {{
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity()}};
inline constexpr ::std::array<double, kNv> kSpeedLimits = {{
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity(),
    ::std::numeric_limits<double>::infinity(), ::std::numeric_limits<double>::infinity()}};
/// Where the unit quaternions (x y z w) start in q.
inline constexpr ::std::array<int, 0> kQuaternionOffsets = {};

/// Names for indices: q(Coordinate::NAME), qd(Speed::NAME).
struct Coordinate { enum : int { q1 = 0, q2 = 1, q3 = 2, q4 = 3, q5 = 4, q6 = 5 }; };
struct Speed { enum : int { q1 = 0, q2 = 1, q3 = 2, q4 = 3, q5 = 4, q6 = 5 }; };
struct Body { enum : int {
    link1 = 0, link2 = 1, link3 = 2, link4 = 3, link5 = 4, link6 = 5 }; };

/// What the functions take besides the state.
template <class S>
struct Inputs {
  S t = S(0.0);  ///< time, s
  ::std::array<S, 0> parameters = {};  ///< there are no runtime parameters
  ::std::array<S, 0> wrenches = {};  ///< no body takes an external wrench
};

// Arguments of the functions below; arrays must not overlap.
//
//   q    [6] coordinates: q1, q2, q3, q4, q5, q6
//   qd   [6] speeds: d(q1), d(q2), d(q3), d(q4), d(q5), d(q6)
//   qdd  [6] rates of the speeds
//   tau  [6] generalized forces: N m for a speed in rad/s, N for one in m/s
//
// Angles are in rad and lengths in m. They are compiled for double and float; for any other scalar type include
// <stanford/stanford_impl.hpp>, which asks of it + - * / and, found by argument, the functions of <cmath> that are called.

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
/// tau [6]: generalized forces, N m for a speed in rad/s, N for one in m/s.
/// Source: Guenter and Lee, Symbolic Lagrangian Multibody Dynamics, eq. 13.
/// Operations: 135 multiplications, 104 additions, 8 sin/cos/tan (reduced formulation; relative error 2.3e-16 where it was measured).
template <class S>
void inverse_dynamics(const S* q, const S* qd, const S* qdd, const Inputs<S>& in, S* tau);

/// Mass matrix (joint-space inertia matrix), symmetric and in full.
///   kinetic energy = 1/2 qd^T M(q) qd, where no motion is prescribed in time
/// M [6 x 6], row by row: in units of tau / qdd.
/// Operations: 50 multiplications, 37 additions, 6 sin/cos/tan (reduced formulation; relative error 2.7e-16 where it was measured).
template <class S>
void mass_matrix(const S* q, const Inputs<S>& in, S* M);

/// Bias forces: Coriolis, centrifugal and gravity terms, less external wrenches and other forces.
///   tau = M(q) qdd + c(q, qd)
/// c [6]: bias forces, in units of tau.
/// Operations: 126 multiplications, 89 additions, 8 sin/cos/tan (reduced formulation; relative error 2.2e-16 where it was measured).
template <class S>
void bias(const S* q, const S* qd, const Inputs<S>& in, S* c);

/// Mass matrix and bias forces at once: shorter than one after the other.
///   tau = M(q) qdd + c(q, qd)
/// M [6 x 6], row by row: mass matrix, symmetric and in full, in units of tau / qdd.
/// c [6]: bias forces, in units of tau.
/// Operations: 176 multiplications, 125 additions, 8 sin/cos/tan (reduced formulation; relative error 2.7e-16 where it was measured).
template <class S>
void mass_matrix_and_bias(const S* q, const S* qd, const Inputs<S>& in, S* M, S* c);

/// Rates of the coordinates: the speeds, but for a quaternion p half of p (w, 0), with w in the axes of its body.
///   dq/dt = N(q) qd
/// qdot [6]: per second.
/// Operations: 0 multiplications, 0 additions (reduced formulation; relative error 0 where it was measured).
template <class S>
void coordinate_rates(const S* q, const S* qd, S* qdot);

/// Kinetic and potential energy.
///   e[0] = 1/2 sum (m |v|^2 + w^T J w), e[1] = -sum m g^T r, zero at the world's origin
/// e [2]: kinetic and potential energy, J.
/// Operations: 88 multiplications, 56 additions, 8 sin/cos/tan (reduced formulation; relative error 2.6e-16 where it was measured).
template <class S>
void energy(const S* q, const S* qd, const Inputs<S>& in, S* e);

/// Poses of the bodies in the world.
/// W [6 x 3 x 4], row by row: for each body of kBodyNames the matrix [R p]: the columns of R are the body's axes, p
///   is its origin, m.
/// Operations: 43 multiplications, 19 additions, 10 sin/cos/tan (reduced formulation; relative error 2e-16 where it was measured).
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

}  // namespace alembert::mechanisms::stanford
