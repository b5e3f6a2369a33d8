// The interpreter behind the runtime's interface (see the header).
#include "simulation/interpreted_mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "alembert/forward_dynamics.hpp"
#include "mechanism/parameter_places.hpp"

namespace alembert {

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace

InterpretedMechanism::InterpretedMechanism(const CompiledMechanism& compiled, EvaluationState inputs,
                                           InputTable table)
    : mechanism_(*compiled.mechanism),
      state_count_(static_cast<Eigen::Index>(placed_parameters(mechanism_, ParameterRole::state).size())),
      rows_(constraint_rows(mechanism_)),
      table_(std::move(table)),
      state_(std::move(inputs)),
      evaluator_(compiled) {
  for (const Coordinate& coordinate : mechanism_.coordinates) {
    if (coordinate.type == CoordinateType::quaternion) quaternion_offsets_.push_back(coordinate.first_q);
  }
}

const EvaluationState& InterpretedMechanism::at(const Eigen::VectorXd& q, const Eigen::VectorXd& u) const {
  state_.q.assign(q.begin(), q.end());
  state_.qd.assign(u.begin(), u.end());
  table_.apply(state_);
  return state_;
}

EvaluationState InterpretedMechanism::state(const Eigen::VectorXd& q, const Eigen::VectorXd& u) const {
  return at(q, u);
}

void InterpretedMechanism::mass_matrix_and_bias(const Eigen::VectorXd& q, const Eigen::VectorXd& u,
                                                Eigen::MatrixXd& mass, Eigen::VectorXd& c) const {
  const Eigen::Index n = nv();
  const std::vector<double> values = evaluator_(FunctionKind("mass_matrix_and_bias"), at(q, u));
  mass = Eigen::Map<const Eigen::MatrixXd>(values.data(), n, n);
  c = Eigen::Map<const Eigen::VectorXd>(values.data() + n * n, n);
}

Status InterpretedMechanism::forward_dynamics(const Eigen::VectorXd& q, const Eigen::VectorXd& u,
                                              const Eigen::VectorXd& tau, Eigen::VectorXd& rates) const {
  if (!detail::is_finite_state(time(), q, u)) return Status::not_finite;
  Eigen::MatrixXd mass;
  Eigen::VectorXd x;
  mass_matrix_and_bias(q, u, mass, x);
  if (const Status status = detail::solve_for_rates(tau, mass, x); status != Status::ok) return status;
  rates = x;
  return Status::ok;
}

void InterpretedMechanism::constraints(const Eigen::VectorXd& q, const Eigen::VectorXd& u, Eigen::MatrixXd& P,
                                       Eigen::VectorXd& gamma, Eigen::VectorXd& velocity,
                                       Eigen::VectorXd& position) const {
  const Eigen::Index n = nv(), k = nc();
  const std::vector<double> values = evaluator_(FunctionKind("constraints"), at(q, u));
  P = Eigen::Map<const RowMajor>(values.data(), k, n);
  const double* rest = values.data() + k * n;
  gamma = Eigen::Map<const Eigen::VectorXd>(rest, k);
  velocity = Eigen::Map<const Eigen::VectorXd>(rest + k, k);
  position = Eigen::Map<const Eigen::VectorXd>(rest + 2 * k, k);
  for (Eigen::Index row = 0; row < k; ++row) {
    if (!P.row(row).allFinite())
      gamma(row) = velocity(row) = position(row) = std::numeric_limits<double>::quiet_NaN();
  }
}

void InterpretedMechanism::inverse_dynamics_derivatives(const Eigen::VectorXd& q, const Eigen::VectorXd& u,
                                                        const Eigen::VectorXd& rates, Eigen::MatrixXd& tau_q,
                                                        Eigen::MatrixXd& tau_qd) const {
  const Eigen::Index n = nv();
  EvaluationState state = at(q, u);
  state.qdd.assign(rates.begin(), rates.end());
  const std::vector<double> values = evaluator_(FunctionKind("inverse_dynamics_derivatives"), state);
  tau_q = Eigen::Map<const RowMajor>(values.data(), n, n);
  tau_qd = Eigen::Map<const RowMajor>(values.data() + n * n, n, n);
}

Eigen::VectorXd InterpretedMechanism::coordinate_rates(const Eigen::VectorXd& q,
                                                       const Eigen::VectorXd& u) const {
  const std::vector<double> values = evaluator_(FunctionKind("coordinate_rates"), at(q, u));
  return Eigen::Map<const Eigen::VectorXd>(values.data(), nq());
}

// The states stand behind all other parameters.
Eigen::VectorXd InterpretedMechanism::states() const {
  const auto size = static_cast<Eigen::Index>(state_.parameters.size());
  return Eigen::Map<const Eigen::VectorXd>(state_.parameters.data(), size).tail(state_count_);
}

void InterpretedMechanism::set_states(const Eigen::VectorXd& states) {
  std::ranges::copy(states, state_.parameters.end() - state_count_);
}

Eigen::VectorXd InterpretedMechanism::state_rates(const Eigen::VectorXd& q, const Eigen::VectorXd& u) const {
  if (state_count_ == 0) return {};
  const std::vector<double> values = evaluator_(FunctionKind("state_rates"), at(q, u));
  return Eigen::Map<const Eigen::VectorXd>(values.data(), state_count_);
}

Eigen::MatrixXd InterpretedMechanism::state_rate_derivatives(const Eigen::VectorXd& q,
                                                             const Eigen::VectorXd& u) const {
  const std::vector<double> values = evaluator_(FunctionKind("state_rates_derivatives"), at(q, u));
  const Eigen::Index n = state_count_;
  return Eigen::Map<const RowMajor>(values.data() + values.size() - n * n, n, n);
}

std::vector<FunctionKind> interpreted_functions() {
  return {FunctionKind("mass_matrix_and_bias"), FunctionKind("coordinate_rates"), FunctionKind("constraints"),
          FunctionKind("state_rates")};
}

Violation worst_violation(const InterpretedMechanism& system, const Eigen::VectorXd& q,
                          const Eigen::VectorXd& u) {
  Violation worst;
  if (system.nc() == 0) return worst;
  Eigen::MatrixXd P;
  Eigen::VectorXd gamma, velocity, position;
  system.constraints(q, u, P, gamma, velocity, position);
  for (int row = 0; row < system.nc(); ++row) {
    const double size = std::max(std::abs(velocity(row)), std::abs(position(row)));
    if (!std::isfinite(velocity(row)) || !std::isfinite(position(row)))
      return {std::numeric_limits<double>::quiet_NaN(), row};
    if (size > worst.size) worst = {size, row};
  }
  return worst;
}

}  // namespace alembert
