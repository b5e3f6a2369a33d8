// The table of output functions: a row says what a function is called, takes, gives and means. Declarations
// in every language, wrappers, docstrings, help and reports are made from it; the expressions of a function
// are built by its entry in dynamics/function_builders.cpp. A function that is in both works everywhere.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>

#include "program/program.hpp"

namespace alembert {

/// Up to N values, in constant expressions too.
template <class T, std::size_t N>
class Few {
 public:
  constexpr Few(std::initializer_list<T> values) {
    for (const T& value : values) values_[size_++] = value;
  }
  constexpr const T* begin() const { return values_.data(); }
  constexpr const T* end() const { return values_.data() + size_; }
  constexpr std::size_t size() const { return size_; }
  constexpr const T& operator[](std::size_t i) const { return values_[i]; }
  constexpr const T& back() const { return values_[size_ - 1]; }

 private:
  std::array<T, N> values_{};
  std::size_t size_ = 0;
};

/// A number of rows or columns: so many, or as many as the mechanism has of something.
struct Extent {
  enum class Of : std::uint8_t {
    number,
    coordinates,
    speeds,
    constraint_rows,
    outputs,
    parameters,
    inputs,
    states,
    forces,
    bodies,
    base_parameters
  };
  Of of = Of::number;
  int number = 1;  ///< for each of them, if they are something
  constexpr Extent() = default;
  constexpr Extent(int n) : number(n) {}
  constexpr Extent(Of what, int for_each = 1) : of(what), number(for_each) {}
  constexpr bool operator==(const Extent&) const = default;
};
inline constexpr Extent kPerCoordinate = Extent::Of::coordinates, kPerSpeed = Extent::Of::speeds,
                        kPerConstraintRow = Extent::Of::constraint_rows, kPerOutput = Extent::Of::outputs,
                        kPerParameter = Extent::Of::parameters, kPerInput = Extent::Of::inputs,
                        kPerState = Extent::Of::states, kPerForce = Extent::Of::forces;
inline constexpr Extent kPerBaseParameter = Extent::Of::base_parameters;
/// Of a body: m, m c x y z, and its inertia about the origin of its frame xx yy zz xy xz yz, in its axes.
inline constexpr Extent kPerStandardParameter{Extent::Of::bodies, 10};

/// What a result has one block of rows and columns for.
enum class Per : std::uint8_t { mechanism, body, frame };

/// How Eigen's interface returns blocks: an array of matrices, or one matrix with the blocks below each
/// other.
enum class Blocks : std::uint8_t { in_array, stacked };

/// An array that a function fills, row by row.
struct ResultArray {
  std::string_view name;
  std::string_view meaning;        ///< with units, frames and the order of rows
  Extent rows = {}, columns = {};  ///< of each block
  Per per = Per::mechanism;
  Blocks blocks = Blocks::in_array;
  bool symmetric = false;
};

/// What functions are about; `report` counts those of dynamics unless told otherwise.
enum class Topic : std::uint8_t { dynamics, kinematics, derivatives };

/// What a mechanism must have for a function to be of any use, besides what its results are sized by.
enum class Needs : std::uint8_t {
  nothing,
  forces,
  outputs_of_position,
  mass,
  inertia,  ///< or mass
  regular_mass_matrix,
  regular_constrained_motion,
};

/// A row of the table. The function takes the arrays of `arguments` in this order, then the inputs (time,
/// parameters, wrenches) if `takes_inputs`, then its results, whether a given mechanism uses them or not.
struct OutputFunction {
  std::string_view name;
  Topic topic;
  bool by_default;  ///< `generate` writes it unless told otherwise
  Few<ArgumentKind, 4> arguments;
  bool takes_inputs;
  std::string_view summary;  ///< one sentence
  std::string_view formula;  ///< empty: there is none
  Few<ResultArray, 6> results;
  std::string_view remark;  ///< guarantee, errors, frames; empty: none
  std::string_view source;  ///< where the formula stands, or is explained; empty: it is the definition
  Needs needs = Needs::nothing;
};

// clang-format off
inline constexpr OutputFunction kOutputFunctions[] = {
    {"inverse_dynamics", Topic::dynamics, true, {ArgumentKind::q, ArgumentKind::qd, ArgumentKind::qdd}, true,
     "Inverse dynamics: the generalized forces that give the speeds the rates qdd.",
     "tau = M(q) qdd + c(q, qd)",
     {{"tau", "generalized forces, N m for a speed in rad/s, N for one in m/s", kPerSpeed}},
     "", "Guenter and Lee, Symbolic Lagrangian Multibody Dynamics, eq. 13"},
    {"mass_matrix", Topic::dynamics, true, {ArgumentKind::q}, true,
     "Mass matrix (joint-space inertia matrix), symmetric and in full.",
     "kinetic energy = 1/2 qd^T M(q) qd, where no motion is prescribed in time",
     {{"M", "in units of tau / qdd", kPerSpeed, kPerSpeed, Per::mechanism, Blocks::in_array,
       true}},
     "", ""},
    {"bias", Topic::dynamics, true, {ArgumentKind::q, ArgumentKind::qd}, true,
     "Bias forces: Coriolis, centrifugal and gravity terms, less external wrenches and other forces.",
     "tau = M(q) qdd + c(q, qd)",
     {{"c", "bias forces, in units of tau", kPerSpeed}},
     "", ""},
    {"gravity", Topic::dynamics, false, {ArgumentKind::q}, true,
     "Gravity forces: the part of the bias forces that gravity makes, whatever moves.",
     "g = (derivative of the potential energy along the speeds), the part of c(q, qd) that is linear in gravity",
     {{"g", "gravity forces, in units of tau", kPerSpeed}},
     "To hold the mechanism still, apply tau = g, if no motion is prescribed in time.", ""},
    {"coriolis_matrix", Topic::dynamics, false, {ArgumentKind::q, ArgumentKind::qd}, true,
     "Coriolis matrix: makes the bias forces that are quadratic in the speeds, and the rate of the mass matrix.",
     "dM/dt = C + C^T, C_ij = sum over particles m D_i r . d(D_j r)/dt; c = C qd + g, less applied forces, where no motion is prescribed",
     {{"C", "in units of tau / qd", kPerSpeed, kPerSpeed}},
     "D_j r is the velocity of a particle at unit speed j. For real coordinates these are Christoffel's symbols times the speeds.",
     "Echeandia and Wensing, Numerical methods to compute the Coriolis matrix and Christoffel symbols, ASME J. Computational and "
     "Nonlinear Dynamics 16, 2021"},
    {"applied_forces", Topic::dynamics, false, {ArgumentKind::q, ArgumentKind::qd}, true,
     "Generalized forces of what the description has under forces, damping, friction and stiffness.",
     "tau = M(q) qdd + c(q, qd), where c contains -Q",
     {{"Q", "generalized forces, in units of tau", kPerSpeed}},
     "", "", Needs::forces},
    {"force_contributions", Topic::dynamics, false, {ArgumentKind::q, ArgumentKind::qd}, true,
     "Generalized forces of each force alone, such as the moments of one muscle about the joints.",
     "applied_forces = sum of the rows",
     {{"Q", "a row for each name of kForceNames, in units of tau", kPerForce, kPerSpeed}},
     "", ""},
    {"outputs", Topic::kinematics, true, {ArgumentKind::q, ArgumentKind::qd}, true,
     "Outputs: what the description has under outputs.",
     "",
     {{"y", "for each name of kOutputNames its value", kPerOutput}},
     "", ""},
    {"outputs_jacobian", Topic::kinematics, false, {ArgumentKind::q}, true,
     "Jacobian of the outputs: their derivatives along the speeds.",
     "dy/dt = J(q) qd, less what motion prescribed in time adds, at constant inputs and states",
     {{"J", "a row for each name of kOutputNames", kPerOutput, kPerSpeed}},
     "Outputs that depend on speeds have none.", "", Needs::outputs_of_position},
    {"outputs_rate", Topic::kinematics, false, {ArgumentKind::q, ArgumentKind::qd}, true,
     "Rates of the outputs.",
     "dy/dt = J(q) qd + (part from time), at constant inputs and states",
     {{"rate", "for each name of kOutputNames, per second", kPerOutput}},
     "", "", Needs::outputs_of_position},
    {"outputs_bias", Topic::kinematics, false, {ArgumentKind::q, ArgumentKind::qd}, true,
     "The part of the outputs' second derivatives that is left without qdd.",
     "d^2y/dt^2 = J(q) qdd + bias(q, qd), at constant inputs and states",
     {{"bias", "for each name of kOutputNames, per second squared", kPerOutput}},
     "", "", Needs::outputs_of_position},
    {"state_rates", Topic::dynamics, true, {ArgumentKind::q, ArgumentKind::qd}, true,
     "Rates of the states, to be integrated beside coordinates and speeds.",
     "ds/dt = r(q, qd, s, inputs, t)",
     {{"sdot", "for each state its rate, in the state's unit per second", kPerState}},
     "", ""},
    {"mass_matrix_and_bias", Topic::dynamics, true, {ArgumentKind::q, ArgumentKind::qd}, true,
     "Mass matrix and bias forces at once: shorter than one after the other.",
     "tau = M(q) qdd + c(q, qd)",
     {{"M", "mass matrix, symmetric and in full, in units of tau / qdd", kPerSpeed, kPerSpeed, Per::mechanism,
       Blocks::in_array, true},
      {"c", "bias forces, in units of tau", kPerSpeed}},
     "", ""},
    {"forward_dynamics", Topic::dynamics, false, {ArgumentKind::q, ArgumentKind::qd, ArgumentKind::tau}, true,
     "Forward dynamics without a branch: the rates of the speeds under the generalized forces tau.",
     "qdd = M(q)^-1 (tau - c(q, qd))",
     {{"qdd", "rates of the speeds, rad/s^2 or m/s^2", kPerSpeed}},
     "Constraints are left out. Where M is singular, qdd is not finite: check it, or call alembert::forward_dynamics of the "
     "runtime, which returns a status.",
     "Featherstone, Rigid Body Dynamics Algorithms, chapter 7, or a Cholesky factorization, whichever is shorter",
     Needs::regular_mass_matrix},
    {"mass_matrix_inverse", Topic::dynamics, false, {ArgumentKind::q}, true,
     "Inverse of the mass matrix, symmetric and in full.",
     "qdd = M(q)^-1 (tau - c(q, qd))",
     {{"Minv", "in units of qdd / tau", kPerSpeed, kPerSpeed, Per::mechanism, Blocks::in_array, true}},
     "Constraints are left out. Where M is singular, its entries are not finite.",
     "Featherstone, Rigid Body Dynamics Algorithms, chapter 7, or a Cholesky factorization, whichever is shorter",
     Needs::regular_mass_matrix},
    {"coordinate_rates", Topic::dynamics, true, {ArgumentKind::q, ArgumentKind::qd}, false,
     "Rates of the coordinates: the speeds, but for a quaternion p half of p (w, 0), with w in the axes of its body.",
     "dq/dt = N(q) qd",
     {{"qdot", "per second", kPerCoordinate}},
     "", ""},
    {"energy", Topic::dynamics, true, {ArgumentKind::q, ArgumentKind::qd}, true,
     "Kinetic and potential energy.",
     "e[0] = 1/2 sum (m |v|^2 + w^T J w), e[1] = -sum m g^T r, zero at the world's origin",
     {{"e", "kinetic and potential energy, J", 2}},
     "", ""},
    {"body_poses", Topic::kinematics, true, {ArgumentKind::q}, true,
     "Poses of the bodies in the world.",
     "",
     {{"W", "for each body of kBodyNames the matrix [R p]: the columns of R are the body's axes, p is its origin, m",
       3, 4, Per::body}},
     "", ""},
    {"frame_poses", Topic::kinematics, true, {ArgumentKind::q}, true,
     "Poses of the named frames in the world.",
     "",
     {{"F", "for each frame of kFrameNames the matrix [R p]: the columns of R are the frame's axes, p is its origin, m",
       3, 4, Per::frame}},
     "", ""},
    {"frame_jacobians", Topic::kinematics, true, {ArgumentKind::q}, true,
     "Geometric Jacobians of the named frames' origins: angular rows first, in world axes.",
     "J(q) qd = (angular velocity x y z, velocity of the frame's origin x y z), less what motion prescribed in time adds",
     {{"J", "for each frame of kFrameNames 6 rows: 3 angular, then 3 linear",
       6, kPerSpeed, Per::frame}},
     "", ""},
    {"frame_velocities", Topic::kinematics, false, {ArgumentKind::q, ArgumentKind::qd}, true,
     "Velocities of the named frames, in world axes: angular first.",
     "V = J(q) qd and what motion prescribed in time adds, J of frame_jacobians",
     {{"V", "for each frame of kFrameNames its angular velocity x y z, rad/s, and the velocity of its origin x y z, m/s", 6, 1,
       Per::frame, Blocks::stacked}},
     "", ""},
    {"frame_bias_accelerations", Topic::kinematics, false, {ArgumentKind::q, ArgumentKind::qd}, true,
     "The part of the frames' accelerations that is left without qdd, in world axes: angular first.",
     "dV/dt = J(q) qdd + bias(q, qd), J of frame_jacobians and V of frame_velocities",
     {{"bias", "for each frame of kFrameNames its part of the angular acceleration x y z, rad/s^2, and of its origin's acceleration "
       "x y z, m/s^2", 6, 1, Per::frame, Blocks::stacked}},
     "", ""},
    {"frame_jacobian_rates", Topic::kinematics, false, {ArgumentKind::q, ArgumentKind::qd}, true,
     "Rates of the named frames' Jacobians.",
     "Jdot = dJ/dt, J of frame_jacobians",
     {{"Jdot", "for each frame of kFrameNames 6 rows: 3 angular, then 3 linear", 6, kPerSpeed, Per::frame}},
     "", ""},
    {"constraints", Topic::dynamics, true, {ArgumentKind::q, ArgumentKind::qd}, true,
     "Constraints at a state: a row for each name of kConstraintNames, where the mechanism has any.",
     "velocity = P(q) qd + (part from time) = 0, its rate P qdd + gamma = 0; M qdd + c = tau + P^T lambda",
     {{"P", "constraint matrix, a row for each constraint", kPerConstraintRow, kPerSpeed},
      {"gamma", "part of the rates that is left without qdd", kPerConstraintRow},
      {"velocity", "residuals of the speeds", kPerConstraintRow},
      {"position", "phi(q, t), the equation whose rate a row of kHolonomic is; 0 for the others", kPerConstraintRow}},
     "M, c and the other functions are those of the mechanism without constraints.", ""},
    {"constrained_forward_dynamics", Topic::dynamics, false, {ArgumentKind::q, ArgumentKind::qd, ArgumentKind::tau}, true,
     "Forward dynamics under the constraints, without a branch: the rates of the speeds and the reactions of the constraints.",
     "M qdd + c = tau + P^T lambda, P qdd + gamma = 0, with P and gamma of constraints",
     {{"qdd", "rates of the speeds, rad/s^2 or m/s^2", kPerSpeed},
      {"lambda", "for each name of kConstraintNames its reaction: P^T lambda are generalized forces", kPerConstraintRow}},
     "A row that follows from those before it is left out; its lambda is 0. In double precision that is told to an angle of about "
     "1e-7; in float leave such rows out of the description. Where rows contradict each other, the first ones are kept and nothing "
     "tells: alembert::constrained_forward_dynamics of the runtime does. Where M is singular, results may not be finite.",
     "", Needs::regular_constrained_motion},
    {"body_jacobians", Topic::kinematics, false, {ArgumentKind::q}, true,
     "Geometric Jacobians of the bodies' centres of mass: angular rows first, in world axes.",
     "J(q) qd = (angular velocity x y z, velocity of the centre of mass x y z), less what motion prescribed in time adds",
     {{"J", "for each body of kBodyNames 6 rows: 3 angular, then 3 linear",
       6, kPerSpeed, Per::body, Blocks::stacked}},
     "", ""},
    {"body_velocities", Topic::kinematics, false, {ArgumentKind::q, ArgumentKind::qd}, true,
     "Velocities of the bodies, in world axes: angular first.",
     "V = J(q) qd and what motion prescribed in time adds, J of body_jacobians",
     {{"V", "for each body of kBodyNames its angular velocity x y z, rad/s, and the velocity of its centre of mass x y z, m/s", 6, 1,
       Per::body, Blocks::stacked}},
     "", ""},
    {"body_accelerations", Topic::kinematics, false, {ArgumentKind::q, ArgumentKind::qd, ArgumentKind::qdd}, true,
     "Accelerations of the bodies, in world axes: angular first.",
     "A = dV/dt, V of body_velocities",
     {{"A", "for each body of kBodyNames its angular acceleration x y z, rad/s^2, and the acceleration of its centre of mass x y z, "
       "m/s^2", 6, 1, Per::body, Blocks::stacked}},
     "Gravity is left out: what hangs still has none.", ""},
    {"centroidal_momentum", Topic::dynamics, false, {ArgumentKind::q, ArgumentKind::qd}, true,
     "Momentum of all bodies about their centre of mass, in world axes: angular first.",
     "h = A(q) qd and what motion prescribed in time adds, dh/dt = A qdd + bias",
     {{"h", "angular momentum x y z about the centre of mass, kg m^2/s, and momentum x y z, kg m/s", 6},
      {"A", "a column for each of the speeds", 6, kPerSpeed},
      {"bias", "part of the rate of h that is left without qdd", 6},
      {"com", "centre of mass x y z, m", 3}},
     "Rotors of armatures are left out.", "Orin, Goswami and Lee, Centroidal dynamics of a humanoid robot, Autonomous Robots 35, 2013",
     Needs::mass},
    {"joint_reactions", Topic::dynamics, false, {ArgumentKind::q, ArgumentKind::qd, ArgumentKind::qdd}, true,
     "Wrenches in the joints: what the parent of each body exerts on it, in the body's axes, about its origin, moment first.",
     "w = inertia of the body and of all that hangs on it - gravity, external wrenches and forces that act on these bodies",
     {{"w", "for each body of kBodyNames the moment x y z about the origin of its frame, N m, and the force x y z, N, in the axes "
       "of its frame", 6, 1, Per::body, Blocks::stacked}},
     "Along the joints' motions they are what inverse_dynamics gives plus the forces that act in the joints (springs, damping and "
     "friction of coordinates, forces on coordinates), less what accelerates armatures. Reactions of constraints are left out: add "
     "them as external wrenches.",
     "Featherstone, Rigid Body Dynamics Algorithms, section 5.3"},
    {"body_inertias", Topic::kinematics, false, {}, true,
     "Masses, centres of mass and inertias of the bodies, in the axes of each body.",
     "",
     {{"inertias", "for each body of kBodyNames its mass, kg, its centre of mass x y z, m, and its inertia about it "
       "xx yy zz xy xz yz, kg m^2",
       1, 10, Per::body, Blocks::stacked}},
     "", ""},
    {"regressor", Topic::dynamics, false, {ArgumentKind::q, ArgumentKind::qd, ArgumentKind::qdd}, true,
     "Regressor of inverse dynamics: the forces are linear in the masses, first moments and inertias of the bodies.",
     "inverse_dynamics = Y theta, less applied forces and wrenches, and the forces that armatures take",
     {{"Y", "for each body of kBodyNames ten columns: its mass, kg, mass times centre of mass x y z, kg m, and its inertia about the "
       "origin of its frame, in its axes, xx yy zz xy xz yz, kg m^2", kPerSpeed, kPerStandardParameter}},
     "Columns of bodies without mass, and those of the inertia of a point mass in its origin, are zero.",
     "Atkeson, An and Hollerbach, Estimation of inertial parameters of manipulator loads and links, Int. J. Robotics Research 5, 1986",
     Needs::inertia},
    {"base_regressor", Topic::dynamics, false, {ArgumentKind::q, ArgumentKind::qd, ArgumentKind::qdd}, true,
     "Regressor of inverse dynamics in the base parameters: independent columns, of which the others are combinations.",
     "inverse_dynamics = Y theta_base, less applied forces and wrenches, and the forces that armatures take",
     {{"Y", "a column for each base parameter, in the order in which `alembert identify` lists them and the standard parameters "
       "that each joins", kPerSpeed, kPerBaseParameter}},
     "The columns are those of regressor that depend on none before them.",
     "Gautier and Khalil, Direct calculation of minimum set of inertial parameters of serial robots, IEEE Trans. Robotics and "
     "Automation 6, 1990", Needs::inertia},
    {"static_regressor", Topic::dynamics, false, {ArgumentKind::q}, true,
     "Regressor of the gravity forces: what regressor is at rest.",
     "gravity = Y theta",
     {{"Y", "columns as those of regressor", kPerSpeed, kPerStandardParameter}},
     "", "", Needs::inertia},
    {"energy_regressor", Topic::dynamics, false, {ArgumentKind::q, ArgumentKind::qd}, true,
     "Regressor of the energies: both are linear in the masses, first moments and inertias of the bodies.",
     "energy = Y theta, less that of armatures and of applied forces",
     {{"Y", "a row for the kinetic, one for the potential energy; columns as those of regressor", 2, kPerStandardParameter}},
     "", "", Needs::inertia},
    {"inverse_dynamics_derivatives", Topic::derivatives, false, {ArgumentKind::q, ArgumentKind::qd, ArgumentKind::qdd}, true,
     "Partial derivatives of inverse dynamics: along the speeds, that is by the coordinates, and by the speeds.",
     "tau_q[.][k] = change of tau(q, qd, qdd) as q changes by N(q) e_k, tau_qd = d tau / d qd",
     {{"tau_q", "column k is the derivative by coordinate k; of a quaternion, by a turn about an axis "
       "of its body",
       kPerSpeed, kPerSpeed},
      {"tau_qd", "column k is the derivative by speed k", kPerSpeed, kPerSpeed}},
     "By the rates qdd they are M(q). Those of forward dynamics at the same state are -M^-1 tau_q and -M^-1 tau_qd.", ""},
    {"inverse_dynamics_second_derivatives", Topic::derivatives, false,
     {ArgumentKind::q, ArgumentKind::qd, ArgumentKind::qdd, ArgumentKind::mu}, true,
     "Second partial derivatives of inverse dynamics, summed with the weights mu: what an optimiser's Hessian needs of the dynamics.",
     "f = mu . tau(q, qd, qdd); tau_qq[j][k] = change of (change of f as q changes by N(q) e_j) as q changes by N(q) e_k, "
     "tau_qqd[j][k] = change of df/dqd[k] as q changes by N(q) e_j, tau_qdqd = d^2 f/dqd^2, tau_qqdd[j][k] = change of df/dqdd[k] "
     "as q changes by N(q) e_j",
     {{"tau_qq", "twice by the coordinates: symmetric, but for turns of one quaternion, whose order counts", kPerSpeed, kPerSpeed},
      {"tau_qqd", "a row for each coordinate, a column for each speed", kPerSpeed, kPerSpeed},
      {"tau_qdqd", "twice by the speeds: symmetric", kPerSpeed, kPerSpeed, Per::mechanism, Blocks::in_array, true},
      {"tau_qqdd", "a row for each coordinate, a column for each rate", kPerSpeed, kPerSpeed}},
     "By the speeds and the rates, and twice by the rates, they are zero. Where a force has a kink, they are those of the branch "
     "that is taken.", ""},
    {"inverse_dynamics_parameter_derivatives", Topic::derivatives, false,
     {ArgumentKind::q, ArgumentKind::qd, ArgumentKind::qdd}, true,
     "Partial derivatives of inverse dynamics by the runtime parameters, lengths too.",
     "tau_p = d tau(q, qd, qdd) / d(parameters)",
     {{"tau_p", "a column for each of the runtime parameters, in their order", kPerSpeed, kPerParameter}},
     "Those of forward dynamics are -M^-1 tau_p.", ""},
    {"forward_dynamics_derivatives", Topic::derivatives, false, {ArgumentKind::q, ArgumentKind::qd, ArgumentKind::tau}, true,
     "Partial derivatives of forward dynamics: along the speeds, that is by the coordinates, by the speeds and by the forces.",
     "qdd_q[.][k] = change of qdd(q, qd, tau) as q changes by N(q) e_k, qdd_qd = d qdd / d qd, qdd_tau = M(q)^-1",
     {{"qdd_q", "column k is the derivative by coordinate k; of a quaternion, by a turn about an axis of its body", kPerSpeed,
       kPerSpeed},
      {"qdd_qd", "column k is the derivative by speed k", kPerSpeed, kPerSpeed},
      {"qdd_tau", "column k is the derivative by force k: symmetric", kPerSpeed, kPerSpeed, Per::mechanism, Blocks::in_array, true}},
     "Constraints are left out. Where M is singular, they are not finite.",
     "Carpentier and Mansard, Analytical derivatives of rigid body dynamics algorithms, RSS 2018",
     Needs::regular_mass_matrix},
    {"constrained_forward_dynamics_derivatives", Topic::derivatives, false,
     {ArgumentKind::q, ArgumentKind::qd, ArgumentKind::tau}, true,
     "Partial derivatives of forward dynamics under the constraints, and of their reactions.",
     "[M -P^T; P 0] [d qdd; d lambda] = [d tau - d(M qdd + c - P^T lambda); -d(P qdd + gamma)], at constant qdd and lambda on the right",
     {{"qdd_q", "column k is the derivative by coordinate k; of a quaternion, by a turn about an axis of its body", kPerSpeed,
       kPerSpeed},
      {"qdd_qd", "column k is the derivative by speed k", kPerSpeed, kPerSpeed},
      {"qdd_tau", "column k is the derivative by force k: symmetric", kPerSpeed, kPerSpeed, Per::mechanism, Blocks::in_array, true},
      {"lambda_q", "for each name of kConstraintNames a row of derivatives by the coordinates, as above", kPerConstraintRow,
       kPerSpeed},
      {"lambda_qd", "by the speeds", kPerConstraintRow, kPerSpeed},
      {"lambda_tau", "by the forces", kPerConstraintRow, kPerSpeed}},
     "Of the rows that constrained_forward_dynamics takes, whether or not the state keeps them. Where M is singular, they may "
     "not be finite.",
     "", Needs::regular_constrained_motion},
    {"input_jacobian", Topic::derivatives, false, {ArgumentKind::q, ArgumentKind::qd}, true,
     "Derivatives of the applied forces by the inputs: the input matrix of a linearisation.",
     "B = dQ/d(inputs), where tau = M(q) qdd + c and c contains -Q",
     {{"B", "a column for each of the inputs, in their order", kPerSpeed, kPerInput}},
     "Those of forward dynamics are M^-1 B. Where a force has a kink, they are those of the branch that is taken.", ""},
    {"state_jacobian", Topic::derivatives, false, {ArgumentKind::q, ArgumentKind::qd}, true,
     "Derivatives of the applied forces by the states.",
     "Q_s = dQ/ds, where tau = M(q) qdd + c and c contains -Q",
     {{"Q_s", "a column for each of the states, in their order", kPerSpeed, kPerState}},
     "Those of forward dynamics are M^-1 Q_s.", ""},
    {"state_rates_derivatives", Topic::derivatives, false, {ArgumentKind::q, ArgumentKind::qd}, true,
     "Partial derivatives of the rates of the states: along the speeds, by the speeds and by the states.",
     "r_q[.][k] = change of r(q, qd, s) as q changes by N(q) e_k, r_qd = dr/dqd, r_s = dr/ds",
     {{"r_q", "column k is the derivative by coordinate k; of a quaternion, by a turn about an axis of its body",
       kPerState, kPerSpeed},
      {"r_qd", "column k is the derivative by speed k", kPerState, kPerSpeed},
      {"r_s", "a column for each of the states", kPerState, kPerState}},
     "", ""},
    {"state_input_jacobian", Topic::derivatives, false, {ArgumentKind::q, ArgumentKind::qd}, true,
     "Derivatives of the rates of the states by the inputs.",
     "r_inputs = dr/d(inputs)",
     {{"r_inputs", "a column for each of the inputs, in their order", kPerState, kPerInput}},
     "", ""},
};
// clang-format on

/// Arguments are arrays of coordinates, speeds, rates or forces; what else there is comes by `takes_inputs`.
constexpr bool takes_arrays(const OutputFunction& function) {
  for (const ArgumentKind kind : function.arguments) {
    if (kind == ArgumentKind::time || kind == ArgumentKind::parameter || kind == ArgumentKind::wrench)
      return false;
  }
  return true;
}
/// S is the scalar type of what is generated, kept what crosses from block to block.
constexpr bool has_fit_names(const OutputFunction& function) {
  for (const ResultArray& result : function.results)
    if (result.name == "S" || result.name == "kept") return false;
  return true;
}
static_assert([] {
  for (const OutputFunction& row : kOutputFunctions)
    if (!takes_arrays(row) || !has_fit_names(row)) return false;
  return true;
}());

/// One of the functions of the table, by its name: FunctionKind("bias"). A name that is not there does not
/// compile.
class FunctionKind {
 public:
  consteval explicit FunctionKind(std::string_view name) : index_(index_of(name)) {
    if (index_ == std::size(kOutputFunctions)) throw "no such function";
  }
  constexpr explicit FunctionKind(const OutputFunction& row)
      : index_(static_cast<std::size_t>(&row - kOutputFunctions)) {}
  constexpr const OutputFunction& row() const { return kOutputFunctions[index_]; }
  constexpr auto operator<=>(const FunctionKind&) const = default;

 private:
  static constexpr std::size_t index_of(std::string_view name) {
    std::size_t i = 0;
    while (i < std::size(kOutputFunctions) && kOutputFunctions[i].name != name) ++i;
    return i;
  }
  std::size_t index_;
};

constexpr std::string_view to_string(FunctionKind kind) {
  return kind.row().name;
}

/// Null if there is no function of this name.
constexpr const OutputFunction* find_function(std::string_view name) {
  for (const OutputFunction& row : kOutputFunctions) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

}  // namespace alembert
