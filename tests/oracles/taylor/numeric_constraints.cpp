// Rows by jets along the motion and along each speed; one dense solve (see the header).
#include "oracles/taylor/numeric_constraints.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

namespace alembert::oracles {

namespace {

/// Values and rates of all rows along a motion of coordinates, speeds and time.
template <class R>
struct RowJets {
  std::vector<R> velocity, acceleration, position;
};

/// Coordinates, speeds and positions of frames, in the order of a constraint's variables.
template <class R>
std::vector<Jet<R>> variables(const Description& description, const std::vector<Jet<R>>& q,
                              const std::vector<Jet<R>>& u, const Jet<R>& t) {
  std::vector<Jet<R>> all = q;
  all.insert(all.end(), u.begin(), u.end());
  for (const RigidMotion<Jet<R>>& frame : frame_poses(description, q, t))
    all.insert(all.end(), frame.translation.begin(), frame.translation.end());
  return all;
}

/// Velocity of the child's material point at the contact, seen from the parent, along the second surface's
/// tangents, and its rate. With A the mate's transform and p the contact point in the child, that velocity is
/// A' p: p is not differentiated, and is in the rate, where another point is in contact a moment later.
template <class R>
void append_rolling(const Mate& mate, const std::vector<Jet<R>>& q, const Jet<R>& t, RowJets<R>& out) {
  const RigidMotion<Jet<R>> second = surface_frame(mate.second, q, t);
  const RigidMotion<Jet<R>> A = product_of({Factor{mate}}, q, t);
  // As jets of the first order: A' has value A.first and rate A.second.
  RigidMotion<Jet<R>> A_rate;
  for (std::size_t i = 0; i < 3; ++i) {
    A_rate.translation[i] = Jet<R>(A.translation[i].first, A.translation[i].second, R(0.0));
    for (std::size_t k = 0; k < 3; ++k)
      A_rate.column[k][i] = Jet<R>(A.column[k][i].first, A.column[k][i].second, R(0.0));
  }
  const Vector3<Jet<R>> velocity = rotated(A_rate, second.translation) + A_rate.translation;
  for (std::size_t k = 0; k < 2; ++k) {
    const Jet<R> slip = dot(rotated(A, second.column[k]), velocity);
    out.position.push_back(R(0.0));
    out.velocity.push_back(slip.value);
    out.acceleration.push_back(slip.first);
  }
}

template <class R>
RowJets<R> row_jets(const Description& description, const std::vector<Jet<R>>& q,
                    const std::vector<Jet<R>>& u, const Jet<R>& t) {
  const std::vector<Jet<R>> all = variables(description, q, u, t);
  RowJets<R> out;
  for (const Constraint& constraint : description.constraints) {
    if (constraint.kind == ConstraintKind::rolling) {
      const Body& body = description.bodies[static_cast<std::size_t>(constraint.body)];
      append_rolling(std::get<Mate>(body.transform[constraint.factor].value), q, t, out);
      continue;
    }
    for (const Expression& equation : constraint.equations) {
      const Jet<R> row = evaluate(equation, all, t);
      const bool holonomic = constraint.kind == ConstraintKind::holonomic;
      out.position.push_back(holonomic ? row.value : R(0.0));
      out.velocity.push_back(holonomic ? row.first : row.value);
      out.acceleration.push_back(holonomic ? row.second : row.first);
    }
  }
  return out;
}

template <class R>
std::vector<Jet<R>> constant_jets(const std::vector<R>& values) {
  std::vector<Jet<R>> jets;
  for (const R& value : values) jets.emplace_back(value, R(0.0), R(0.0));
  return jets;
}

/// By speed, the column of P. Rows are affine in the speeds, so that a difference of two of their values is a column
/// exactly.
template <class R>
std::vector<std::vector<R>> columns_of(const Description& description, const StateOf<R>& state) {
  const Jet<R> t(state.time, R(0.0), R(0.0));
  const std::vector<Jet<R>> rest(state.speeds.size(), Jet<R>(0.0));
  const std::vector<R> at_rest = row_jets(description, constant_jets(state.q), rest, t).velocity;
  std::vector<std::vector<R>> columns;
  for (int k = 0; k < description.nv; ++k) {
    std::vector<Jet<R>> unit = rest;
    unit[static_cast<std::size_t>(k)] = Jet<R>(1.0);
    std::vector<R>& column =
        columns.emplace_back(row_jets(description, unit_motion(description, state, k), unit, t).velocity);
    for (std::size_t r = 0; r < column.size(); ++r) column[r] = column[r] - at_rest[r];
  }
  return columns;
}

/// As the state moves, with these rates of its speeds.
template <class R>
RowJets<R> moving_rows(const Description& description, const StateOf<R>& state, const std::vector<R>& rates) {
  std::vector<Jet<R>> u;
  for (std::size_t k = 0; k < rates.size(); ++k) u.emplace_back(state.speeds[k], rates[k], R(0.0));
  return row_jets(description, trajectory(description, state, rates), u, Jet<R>(state.time, R(1.0), R(0.0)));
}

template <class R>
VectorOf<R> vector_of(const std::vector<R>& values) {
  return Eigen::Map<const VectorOf<R>>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

template <class R>
ConstraintRowsOf<R> numeric_constraints(const Description& description, const State& state) {
  const StateOf<R> given = lifted<R>(state);
  const RowJets<R> moving = moving_rows(description, given, std::vector<R>(given.speeds.size(), R(0.0)));
  ConstraintRowsOf<R> rows;
  rows.gamma = vector_of(moving.acceleration);
  rows.velocity = vector_of(moving.velocity);
  rows.position = vector_of(moving.position);
  rows.P.resize(rows.gamma.size(), description.nv);
  Eigen::Index k = 0;
  for (const std::vector<R>& column : columns_of(description, given)) rows.P.col(k++) = vector_of(column);
  return rows;
}

template <class R>
ConstraintActions<R> constraint_actions(const Description& description, const StateOf<R>& state,
                                        const std::vector<R>& multipliers) {
  ConstraintActions<R> actions;
  for (const std::vector<R>& column : columns_of(description, state)) {
    R& force = actions.forces.emplace_back(0.0);
    for (std::size_t r = 0; r < multipliers.size(); ++r) force = force + column[r] * multipliers[r];
  }
  actions.accelerations = moving_rows(description, state, state.rates).acceleration;
  return actions;
}
template ConstraintActions<Jet<double>> constraint_actions(const Description&, const StateOf<Jet<double>>&,
                                                           const std::vector<Jet<double>>&);
template ConstraintActions<Jet<long double>> constraint_actions(const Description&,
                                                                const StateOf<Jet<long double>>&,
                                                                const std::vector<Jet<long double>>&);

template ConstraintRows numeric_constraints<double>(const Description&, const State&);
template ConstraintRowsOf<long double> numeric_constraints<long double>(const Description&, const State&);

ConstrainedMotion constrained_motion(const Dynamics& dynamics, const ConstraintRows& rows) {
  const Eigen::Index n = dynamics.bias.size(), m = rows.gamma.size();
  const Eigen::VectorXd speed_scale = dynamics.mass_matrix.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd M = speed_scale.asDiagonal() * dynamics.mass_matrix * speed_scale.asDiagonal();
  const Eigen::MatrixXd half = rows.P * speed_scale.asDiagonal();
  const Eigen::VectorXd row_scale = half.rowwise().norm().cwiseMax(1e-300).cwiseInverse();
  const Eigen::MatrixXd P = row_scale.asDiagonal() * half;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n + m, n + m);
  K.topLeftCorner(n, n) = M;
  K.topRightCorner(n, m) = -P.transpose();
  K.bottomLeftCorner(m, n) = P;
  Eigen::VectorXd right(n + m);
  right.head(n) = speed_scale.cwiseProduct(dynamics.tau - dynamics.bias);
  right.tail(m) = -row_scale.cwiseProduct(rows.gamma);
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(1e-11);
  solver.compute(K);
  Eigen::VectorXd x = solver.solve(right);
  x += solver.solve(right - K * x);
  ConstrainedMotion result;
  result.rates = speed_scale.cwiseProduct(x.head(n));
  result.multipliers = row_scale.cwiseProduct(x.tail(m));
  result.inconsistency = m == 0 ? 0 : (rows.P * result.rates + rows.gamma).cwiseAbs().maxCoeff();
  if (m == 0) return result;
  const Eigen::MatrixXd schur = P * M.ldlt().solve(P.transpose());
  const Eigen::VectorXd unit = schur.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
                                     unit.asDiagonal() * schur * unit.asDiagonal(), Eigen::EigenvaluesOnly)
                                     .eigenvalues();
  result.condition =
      values.minCoeff() > 0 ? values.maxCoeff() / values.minCoeff() : std::numeric_limits<double>::infinity();
  return result;
}

State with_consistent_speeds(const Description& description, State state) {
  const ConstraintRows rows = numeric_constraints(description, state);
  if (rows.gamma.size() == 0) return state;
  const Eigen::VectorXd change =
      Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(rows.P).solve(-rows.velocity);
  for (std::size_t k = 0; k < state.speeds.size(); ++k)
    state.speeds[k] += change[static_cast<Eigen::Index>(k)];
  return state;
}

std::optional<State> consistent(const Description& description, const State& given) {
  State state = given;
  for (int iteration = 0; iteration < 30; ++iteration) {
    const ConstraintRows rows = numeric_constraints(description, state);
    if (!rows.position.allFinite()) return std::nullopt;
    if (rows.position.size() == 0 || rows.position.cwiseAbs().maxCoeff() < 1e-13)
      return with_consistent_speeds(description, state);
    Eigen::MatrixXd P = rows.P;
    Eigen::Index row = 0;
    for (const Constraint& constraint : description.constraints) {
      for (std::size_t i = 0; i < constraint.rows(); ++i, ++row)
        if (constraint.kind != ConstraintKind::holonomic) P.row(row).setZero();
    }
    const Eigen::VectorXd change =
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(P).solve(-rows.position);
    const std::vector<double> step =
        coordinate_rates(description, state.q, {change.data(), change.data() + change.size()});
    for (std::size_t i = 0; i < step.size(); ++i) state.q[i] += step[i];
    for (const Coordinate& c : description.coordinates) {
      double* x = &state.q[static_cast<std::size_t>(c.first_q)];
      const double norm = c.quaternion ? std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3]) : 1;
      for (int i = 0; c.quaternion && i < 4; ++i) x[i] /= norm;
    }
  }
  return std::nullopt;
}

}  // namespace alembert::oracles
