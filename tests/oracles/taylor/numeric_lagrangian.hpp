// A mechanism and a state in; tau, M and c out, by d'Alembert's principle on numbers. Transforms are
// evaluated as they are written, on jets along the motion; no joint, twist, recursion or formula of the
// generator is shared.
#pragma once

#include "oracles/state.hpp"
#include "oracles/taylor/poses.hpp"

namespace alembert::oracles {

/// tau_k = sum over bodies of  (m (a - g) - f) . dv/du_k + (I al + om x I om - R^T tau_ext) . dom/du_k;
/// M_kl = sum of  m dv/du_k . dv/du_l + dom/du_k . I dom/du_l;  c = tau at zero rates. An armature a adds a
/// du_k/dt to tau_k and a to M_kk, and a u_k^2/2 to the kinetic energy; applied forces are taken off tau and c.
/// R is double, or long double for a reference that has digits to spare.
template <class R = double>
DynamicsOf<R> numeric_lagrangian(const Description& description, const State& state);

/// tau alone, of a state on any scalars: on jets its derivatives along whatever the state moves along.
template <class R>
std::vector<R> numeric_forces(const Description& description, const StateOf<R>& state,
                              const std::map<std::string, Wrench>& wrenches);

/// Kinetic and potential energy: of gravity, zero at the world's origin, and of applied forces.
template <class R = double>
std::pair<R, R> energy(const Description& description, const State& state);

/// Where a body is and how it moves, in world axes: its axes and origin.
struct BodyState {
  Eigen::Matrix3d R;
  Eigen::Vector3d origin, velocity, omega;
};
std::vector<BodyState> body_states(const Description& description, const State& state);

/// By body, in world axes: acceleration of the centre of mass, angular acceleration.
using BodyAccelerations = Eigen::Matrix<double, 6, Eigen::Dynamic>;
BodyAccelerations body_accelerations(const Description& description, const State& state,
                                     const Eigen::VectorXd& rates);

}  // namespace alembert::oracles
