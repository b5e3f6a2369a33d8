// Plain equations in 50 digits (see the header).
#include "dynamics/checks/plain_equations.hpp"

#include <Eigen/LU>

#include "dynamics/recursions/constraints.hpp"
#include "dynamics/recursions/formulations.hpp"

namespace alembert {

namespace {

/// Steps of central differences. Their error is that of a third derivative times its square.
const Extended kStep = 1e-16;

std::vector<Expr> plain_outputs(const Kinematics& k, FunctionKind kind) {
  switch (kind) {
    case FunctionKind::energy:
      return energies(k.mechanism, k.tree, k.graph);
    case FunctionKind::body_poses:
      return body_poses(k.mechanism, k.tree, k.graph);
    case FunctionKind::frame_poses:
      return frame_poses(k.mechanism, k.tree, k.graph);
    case FunctionKind::frame_jacobians:
      return frame_jacobians(k.mechanism, k.derivatives, frame_poses(k.mechanism, k.tree, k.graph), k.graph);
    case FunctionKind::body_jacobians:
      return body_jacobians(k.mechanism, k.tree, k.graph);
    case FunctionKind::body_inertias:
      return body_inertias(k.mechanism);
    case FunctionKind::coordinate_rates: {
      const std::vector<Expr> N = k.derivatives.coordinate_rate_matrix();
      std::vector<Expr> rates(static_cast<std::size_t>(k.mechanism.nq), k.graph.zero());
      for (std::size_t i = 0; i < N.size(); ++i) {
        const int speed = static_cast<int>(i) % k.mechanism.nv;
        rates[i / static_cast<std::size_t>(k.mechanism.nv)] += N[i] * k.derivatives.speed(speed);
      }
      return rates;
    }
    case FunctionKind::constraints: {
      const ConstraintEquations equations = constraint_equations(k.mechanism, k.tree, k.derivatives, k.graph);
      std::vector<Expr> all = equations.P;
      for (const std::vector<Expr>* more : {&equations.gamma, &equations.velocity, &equations.position})
        all.insert(all.end(), more->begin(), more->end());
      return all;
    }
    case FunctionKind::inverse_dynamics:
    case FunctionKind::mass_matrix:
    case FunctionKind::bias:
    case FunctionKind::mass_matrix_and_bias:
    case FunctionKind::forward_dynamics:
    case FunctionKind::inverse_dynamics_derivatives:
      break;
  }
  return {};
}

VectorXe vector(const std::vector<Extended>& values) {
  return Eigen::Map<const VectorXe>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

PlainEquations::PlainEquations(const Kinematics& kinematics)
    : kinematics_(kinematics),
      forces_(reduced_inverse_dynamics(kinematics.mechanism, kinematics.tree, kinematics.graph)),
      coordinate_rates_(kinematics.derivatives.coordinate_rate_matrix()) {}

PlainEquations::State PlainEquations::state(std::span<const double> values) const {
  State state(values.begin(), values.end());
  for (const Coordinate& coordinate : kinematics_.mechanism.coordinates) {
    if (coordinate.type != CoordinateType::quaternion) continue;
    Extended norm = 0;
    const auto at = [&](Expr symbol) -> Extended& {
      return state[kinematics_.graph.symbol_index(symbol.ref().node())];
    };
    for (const Expr symbol : coordinate.symbols) norm += at(symbol) * at(symbol);
    norm = sqrt(norm);
    for (const Expr symbol : coordinate.symbols) at(symbol) /= norm;
  }
  return state;
}

VectorXe PlainEquations::forces(const State& state) const {
  return vector(forces_(state));
}

void PlainEquations::set_rates(State& state, const VectorXe* rates) const {
  for (int k = 0; k < kinematics_.mechanism.nv; ++k) {
    const Expr rate = kinematics_.derivatives.rate(k);
    state[kinematics_.graph.symbol_index(rate.ref().node())] = rates == nullptr ? Extended(0) : (*rates)[k];
  }
}

VectorXe PlainEquations::bias(State state) const {
  set_rates(state, nullptr);
  return forces(state);
}

VectorXe PlainEquations::mass_times(State state, const VectorXe& v) const {
  const VectorXe without = bias(state);
  set_rates(state, &v);
  return forces(state) - without;
}

MatrixXe PlainEquations::mass_matrix(const State& state) const {
  if (!mass_matrix_)
    mass_matrix_.emplace(composite_mass_matrix(kinematics_.mechanism, kinematics_.tree, kinematics_.graph));
  const std::vector<Extended> values = (*mass_matrix_)(state);
  return Eigen::Map<const MatrixXe>(values.data(), kinematics_.mechanism.nv, kinematics_.mechanism.nv);
}

VectorXe PlainEquations::tau(const State& state) const {
  VectorXe out(kinematics_.mechanism.nv);
  for (int k = 0; k < kinematics_.mechanism.nv; ++k)
    out[k] = state[kinematics_.graph.symbol_index(
        tau_symbol(kinematics_.mechanism, k, kinematics_.graph).ref().node())];
  return out;
}

VectorXe PlainEquations::accelerations(const State& state) const {
  return mass_matrix(state).partialPivLu().solve(tau(state) - bias(state));
}

VectorXe PlainEquations::along_speeds(const State& state, const VectorXe& v) const {
  const Mechanism& mechanism = kinematics_.mechanism;
  const std::vector<Extended> N = coordinate_rates_(state);
  const auto moved = [&](const Extended& step) {
    State there = state;
    std::size_t row = 0;
    for (const Coordinate& coordinate : mechanism.coordinates) {
      for (const Expr symbol : coordinate.symbols) {
        Extended rate = 0;
        for (int k = 0; k < mechanism.nv; ++k)
          rate += N[row * static_cast<std::size_t>(mechanism.nv) + static_cast<std::size_t>(k)] * v[k];
        ++row;
        there[kinematics_.graph.symbol_index(symbol.ref().node())] += step * rate;
      }
    }
    return forces(there);
  };
  return (moved(kStep) - moved(-kStep)) / Extended(2 * kStep);
}

VectorXe PlainEquations::by_speeds(const State& state, const VectorXe& v) const {
  const auto moved = [&](const Extended& step) {
    State there = state;
    for (int k = 0; k < kinematics_.mechanism.nv; ++k)
      there[kinematics_.graph.symbol_index(kinematics_.derivatives.speed(k).ref().node())] += step * v[k];
    return forces(there);
  };
  return (moved(kStep) - moved(-kStep)) / Extended(2 * kStep);
}

std::vector<Extended> PlainEquations::outputs(FunctionKind kind, const State& state) const {
  auto found = others_.find(kind);
  if (found == others_.end())
    found = others_.emplace(kind, ExtendedFunction(plain_outputs(kinematics_, kind))).first;
  return found->second(state);
}

}  // namespace alembert
