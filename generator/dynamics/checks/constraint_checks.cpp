// Checks of constraints that need numbers (see the header).
#include "dynamics/checks/constraint_checks.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "dynamics/checks/state_checks.hpp"
#include "dynamics/tree/state_values.hpp"
#include "mechanism/constraint_rows.hpp"
#include "symbolic/error_bound.hpp"
#include "symbolic/evaluate.hpp"

namespace alembert {

namespace {

using Eigen::VectorXd;
using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

VectorXd values_of(std::span<const Expr> expressions, const std::vector<double>& state) {
  const std::vector<double> values = evaluate(expressions, state);
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// A state that moves on: q along N u, u along ud, both as they are at the state, and time.
class MovingState {
 public:
  MovingState(const Kinematics& kinematics, std::vector<double> state)
      : kinematics_(kinematics), state_(std::move(state)), q_rate_(kinematics.mechanism.nq) {
    const Mechanism& m = kinematics.mechanism;
    const std::vector<double> N = evaluate(kinematics.derivatives.coordinate_rate_matrix(), state_);
    q_rate_ = Eigen::Map<const RowMajorMatrix>(N.data(), m.nq, m.nv) * speeds();
  }

  VectorXd rates() const {
    return gather([&](int k) { return kinematics_.derivatives.rate(k); });
  }

  /// Values of expressions a time h later. Quaternions are brought back to unit length, which changes no
  /// rate.
  VectorXd values(std::span<const Expr> expressions, double h) const {
    std::vector<double> later = state_;
    Eigen::Index i = 0;
    for (const Coordinate& coordinate : kinematics_.mechanism.coordinates) {
      double norm = 0;
      for (const Expr symbol : coordinate.symbols) {
        double& x = later[index(symbol)];
        x += h * q_rate_(i++);
        norm += x * x;
      }
      if (coordinate.type != CoordinateType::quaternion) continue;
      for (const Expr symbol : coordinate.symbols) later[index(symbol)] /= std::sqrt(norm);
    }
    for (int k = 0; k < kinematics_.mechanism.nv; ++k) {
      later[index(kinematics_.derivatives.speed(k))] += h * state_[index(kinematics_.derivatives.rate(k))];
    }
    later[index(kinematics_.mechanism.time)] += h;
    return values_of(expressions, later);
  }

  /// d/dt of expressions, by central differences of order 6 with this step.
  VectorXd rate(std::span<const Expr> expressions, double step) const {
    const auto difference = [&](double h) -> VectorXd {
      return values(expressions, h) - values(expressions, -h);
    };
    return (45 * difference(step) - 9 * difference(2 * step) + difference(3 * step)) / (60 * step);
  }

 private:
  std::uint32_t index(Expr symbol) const { return kinematics_.graph.symbol_index(symbol.ref().node()); }
  template <class Symbol>
  VectorXd gather(const Symbol& symbol) const {
    VectorXd out(kinematics_.mechanism.nv);
    for (int k = 0; k < kinematics_.mechanism.nv; ++k) out(k) = state_[index(symbol(k))];
    return out;
  }
  VectorXd speeds() const {
    return gather([&](int k) { return kinematics_.derivatives.speed(k); });
  }

  const Kinematics& kinematics_;
  std::vector<double> state_;
  VectorXd q_rate_;
};

/// Largest entry of the difference relative to the larger of 1 and the entries of `y`.
double relative_difference(const VectorXd& x, const VectorXd& y) {
  return (x - y).lpNorm<Eigen::Infinity>() / std::max(1.0, y.lpNorm<Eigen::Infinity>());
}

/// Worst difference over states, counting those that could be measured.
class Worst {
 public:
  void measure(const MovingState& motion, std::span<const Expr> of, const VectorXd& expected) {
    constexpr double kStep = 2e-3, kAccurate = 1e-8;
    const VectorXd rate = motion.rate(of, kStep);
    if (!expected.allFinite() || !rate.allFinite()) return;
    if (relative_difference(motion.rate(of, 2 * kStep), rate) > kAccurate) return;
    worst_ = std::max(worst_, relative_difference(rate, expected));
    ++states_;
  }
  std::optional<double> result(unsigned required) const {
    return states_ >= required ? std::optional(worst_) : std::nullopt;
  }

 private:
  double worst_ = 0;
  unsigned states_ = 0;
};

}  // namespace

ConstraintLaws constraint_laws(const Kinematics& kinematics, const ConstraintEquations& equations) {
  const Mechanism& mechanism = kinematics.mechanism;
  const std::vector<ConstraintRow> rows = constraint_rows(mechanism);
  std::vector<Expr> position, its_velocity;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].type != ConstraintType::holonomic) continue;
    position.push_back(equations.position[i]);
    its_velocity.push_back(equations.velocity[i]);
  }
  constexpr unsigned kLawStates = 16, kRequired = 4;
  Worst position_rate, velocity_rate;
  for (unsigned seed = 1; seed <= kLawStates; ++seed) {
    const std::vector<double> state = state_values(mechanism, kinematics.graph, seed);
    const MovingState motion(kinematics, state);
    if (!position.empty()) position_rate.measure(motion, position, values_of(its_velocity, state));
    if (rows.empty()) continue;
    const VectorXd P = values_of(equations.P, state);
    const VectorXd expected =
        Eigen::Map<const RowMajorMatrix>(P.data(), static_cast<Eigen::Index>(rows.size()), mechanism.nv) *
            motion.rates() +
        values_of(equations.gamma, state);
    velocity_rate.measure(motion, equations.velocity, expected);
  }
  return {position_rate.result(kRequired), velocity_rate.result(kRequired)};
}

std::vector<std::size_t> redundant_rows(const Kinematics& kinematics, const ConstraintEquations& equations,
                                        std::span<const Expr> M) {
  constexpr double kDependent = 1e-9;  // what is left of a row of length 1
  const std::vector<double> state = state_values(kinematics.mechanism, kinematics.graph, 0);
  const Eigen::Index nv = kinematics.mechanism.nv;
  const Eigen::Index count = static_cast<Eigen::Index>(equations.position.size());
  const std::vector<Approximate> entries = evaluate_bounded(equations.P, state);
  RowMajorMatrix P(count, nv), terms(count, nv);
  for (Eigen::Index k = 0; k < count * nv; ++k) {
    const Approximate& entry = entries[static_cast<std::size_t>(k)];
    P.data()[k] = entry.value;
    terms.data()[k] = terms_of(entry);
  }
  // Where all speeds have the same unit.
  const VectorXd mass = values_of(M, state);
  const Eigen::RowVectorXd units =
      Eigen::Map<const RowMajorMatrix>(mass.data(), nv, nv).diagonal().cwiseSqrt().cwiseInverse().transpose();
  if (units.allFinite()) {
    P = P * units.asDiagonal();
    terms = terms * units.asDiagonal();
  }
  std::vector<std::size_t> redundant;
  std::vector<Eigen::RowVectorXd> basis;
  for (Eigen::Index i = 0; i < count; ++i) {
    Eigen::RowVectorXd rest = P.row(i);
    const double length = rest.norm();
    // Twice is enough: the second pass takes away what rounding left.
    for (int pass = 0; pass < 2; ++pass) {
      for (const Eigen::RowVectorXd& direction : basis) rest -= rest.dot(direction) * direction;
    }
    if (length <= 1e-15 * terms.row(i).norm() || rest.norm() <= kDependent * length) {
      redundant.push_back(static_cast<std::size_t>(i));
    } else {
      basis.push_back(rest.normalized());
    }
  }
  return redundant;
}

std::vector<InitialResidual> initial_residuals(const Kinematics& kinematics,
                                               const ConstraintEquations& equations, double tolerance) {
  const std::vector<double> state = state_values(kinematics.mechanism, kinematics.graph, 0);
  const std::vector<Approximate> position = evaluate_bounded(equations.position, state);
  const std::vector<Approximate> velocity = evaluate_bounded(equations.velocity, state);
  const auto is_off = [&](const Approximate& residual) {
    return std::abs(residual.value) > tolerance * terms_of(residual);
  };
  std::vector<InitialResidual> residuals;
  for (std::size_t i = 0; i < position.size(); ++i) {
    if (is_off(position[i]) || is_off(velocity[i]))
      residuals.push_back({i, position[i].value, velocity[i].value});
  }
  return residuals;
}

}  // namespace alembert
