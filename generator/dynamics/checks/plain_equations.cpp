// Plain equations in 50 digits (see the header).
#include "dynamics/checks/plain_equations.hpp"

#include <Eigen/LU>
#include <limits>

#include "dynamics/choice/second_derivatives.hpp"
#include "dynamics/function_builders.hpp"
#include "dynamics/recursions/constraints.hpp"
#include "dynamics/recursions/mass_matrix.hpp"
#include "dynamics/recursions/reduced.hpp"
#include "dynamics/tree/symbols.hpp"
#include "symbolic/simplify.hpp"

namespace alembert {

namespace {

/// One decomposition for all, and products without blocks: with others this room takes a fifth longer to
/// compile.
using Factors = Eigen::FullPivLU<MatrixXe>;

Factors factors(const MatrixXe& A) {
  Factors out(A);
  out.setThreshold(0);  // small pivots are pivots
  return out;
}
/// A^-1 b; not numbers where A has no inverse.
VectorXe solved(const Factors& A, const VectorXe& b) {
  if (A.isInvertible()) return A.solve(b);
  return VectorXe::Constant(b.size(), std::numeric_limits<Extended>::quiet_NaN());
}

/// Steps of central differences. Their error is that of a third derivative times its square.
const Extended kStep = 1e-16;
/// Of the largest entry of M's diagonal: less is out of the range of double, in M or in its inverse.
const Extended kLeastInertia = 1e-300;
/// Of rows in the units of M's diagonal.
const Extended kDependentRows = 1e-20;

Kinematics as_written(const Kinematics& kinematics) {
  const auto left = kinematics.graph.leave_as_written();
  return plain_kinematics(kinematics.mechanism, kinematics.graph);
}

std::vector<Expr> forces_of(const Kinematics& kinematics) {
  const auto left = kinematics.graph.leave_as_written();
  return less_applied(reduced_inverse_dynamics(kinematics.mechanism, kinematics.tree, kinematics.graph),
                      kinematics.applied);
}

VectorXe vector(const std::vector<Extended>& values) {
  return Eigen::Map<const VectorXe>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

PlainEquations::PlainEquations(const Kinematics& kinematics)
    : kinematics_(as_written(kinematics)),
      forces_(forces_of(kinematics_)),
      coordinate_rates_(kinematics_.derivatives.coordinate_rate_matrix()) {}

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
  const auto left = kinematics_.graph.leave_as_written();
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
  return solved(factors(mass_matrix(state)), tau(state) - bias(state));
}

VectorXe PlainEquations::inertia(const State& state) const {
  VectorXe diagonal = mass_matrix(state).diagonal();
  Extended largest = 0;
  for (const Extended& x : diagonal)
    if (isfinite(x)) largest = std::max(largest, x);
  for (Extended& x : diagonal)
    x = isfinite(x) && x > kLeastInertia * largest ? Extended(sqrt(x / largest)) : Extended(1);
  return diagonal;
}

VectorXe PlainEquations::constrained_inertia(const State& state) const {
  const Eigen::Index nv = kinematics_.mechanism.nv;
  const MatrixXe M = mass_matrix(state);
  if (!rows_) {
    const auto left = kinematics_.graph.leave_as_written();
    rows_.emplace(constraint_equations(kinematics_.mechanism, kinematics_.tree, kinematics_.derivatives,
                                       kinematics_.graph)
                      .P);
  }
  const std::vector<Extended> entries = (*rows_)(state);
  const MatrixXe P =
      Eigen::Map<const Eigen::Matrix<Extended, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
          entries.data(), static_cast<Eigen::Index>(entries.size()) / nv, nv);
  // In N z, with P N = 0, what moves has the inertia N^T M N: the rates are N (N^T M N)^-1 N^T times the forces.
  const VectorXe units = inertia(state).cwiseInverse();
  Factors rows(P * units.asDiagonal());
  rows.setThreshold(kDependentRows);
  VectorXe out = inertia(state);
  if (P.rows() == 0 || rows.dimensionOfKernel() == 0) return out;
  const MatrixXe N = units.asDiagonal() * rows.kernel();
  const Factors moving = factors(N.transpose().lazyProduct(MatrixXe(M.lazyProduct(N))));
  const MatrixXe response = N.lazyProduct(MatrixXe(moving.solve(N.transpose())));
  Extended largest = 0;
  for (Eigen::Index k = 0; k < nv; ++k)
    if (isfinite(response(k, k))) largest = std::max(largest, response(k, k));
  // What the constraints hold keeps its own.
  for (Eigen::Index k = 0; k < nv; ++k)
    if (isfinite(response(k, k)) && response(k, k) > kLeastInertia * largest)
      out[k] = 1 / sqrt(Extended(response(k, k)));
  return out / Extended(out.maxCoeff());
}

VectorXe PlainEquations::weighted_gradient(const State& state) const {
  const auto left = kinematics_.graph.leave_as_written();
  if (!weighted_gradient_)
    weighted_gradient_.emplace(alembert::weighted_gradient(kinematics_, forces_.roots()).all());
  return vector((*weighted_gradient_)(state));
}

VectorXe PlainEquations::along_speeds(Function of, const State& state, const VectorXe& v) const {
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
    return (this->*of)(there);
  };
  return (moved(kStep) - moved(-kStep)) / Extended(2 * kStep);
}

VectorXe PlainEquations::by_speeds(Function of, const State& state, const VectorXe& v) const {
  const auto moved = [&](const Extended& step) {
    State there = state;
    for (int k = 0; k < kinematics_.mechanism.nv; ++k)
      there[kinematics_.graph.symbol_index(kinematics_.derivatives.speed(k).ref().node())] += step * v[k];
    return (this->*of)(there);
  };
  return (moved(kStep) - moved(-kStep)) / Extended(2 * kStep);
}

PlainEquations::Accelerations PlainEquations::accelerations_along(const State& state, const VectorXe& v,
                                                                  const VectorXe& forces) const {
  const Factors M = factors(mass_matrix(state));
  Accelerations out;
  out.values = solved(M, tau(state) - bias(state));
  State moving = state;
  set_rates(moving, &out.values);
  out.along_speeds = solved(M, -along_speeds(&PlainEquations::forces, moving, v));
  out.by_speeds = solved(M, -by_speeds(&PlainEquations::forces, moving, v));
  out.by_forces = solved(M, forces);
  return out;
}

const std::vector<OutputExpressions>& PlainEquations::expressions(FunctionKind kind) const {
  const auto left = kinematics_.graph.leave_as_written();
  auto found = expressions_.find(kind);
  if (found == expressions_.end())
    found = expressions_.emplace(kind, plain_function_outputs(kinematics_, kind)).first;
  return found->second;
}

std::vector<Extended> PlainEquations::outputs(FunctionKind kind, const State& state) const {
  auto found = others_.find(kind);
  if (found == others_.end()) {
    std::vector<Expr> all;
    for (const OutputExpressions& output : expressions(kind))
      all.insert(all.end(), output.values.begin(), output.values.end());
    found = others_.emplace(kind, ExtendedFunction(all)).first;
  }
  return found->second(state);
}

}  // namespace alembert
