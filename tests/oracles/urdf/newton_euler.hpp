// Newton and Euler, body by body in world axes, on a tree that was read from a URDF: forces of any motion, M
// by columns, c, and derivatives by jets. Shares nothing with the Taylor oracle but the arithmetic of jets
// and vectors.
#pragma once

#include "oracles/state.hpp"
#include "oracles/taylor/poses.hpp"
#include "oracles/urdf/urdf_robot.hpp"

namespace alembert::oracles {

/// Speeds of a state in the order of `alembert import`: a floating root's first, then those of joints in the
/// order of the file.
int speeds_of(const UrdfTree& tree);

/// Forces that the state's motion takes, under gravity along -z.
template <class S>
std::vector<S> newton_euler(const UrdfTree& tree, const StateOf<S>& state, double gravity);

/// R is double or long double.
template <class R>
DynamicsOf<R> newton_euler_dynamics(const UrdfTree& tree, const State& state);

/// Derivatives of the forces: along speeds (tau_q), by speeds (tau_qd).
/// \param description  of the same robot, for the rates of its coordinates
template <class R>
std::pair<Eigen::MatrixXd, Eigen::MatrixXd> newton_euler_derivatives(const UrdfTree& tree,
                                                                     const Description& description,
                                                                     const State& state);

}  // namespace alembert::oracles
