// Second derivatives by differentiating the weighted sum of the forces twice (see the header).
#include "dynamics/choice/second_derivatives.hpp"

#include "differentiation/jacobian.hpp"
#include "dynamics/tree/symbols.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {

namespace {

/// Makes the entries below the diagonal from those above: D_k D_j f = D_j D_k f, but for the speeds 1, 2, 3 of a
/// quaternion, turns about axes of the body, D_1 D_2 f - D_2 D_1 f = D_3 f and so on around.
void complete(const Mechanism& mechanism, const std::vector<Expr>& along, std::vector<Expr>& twice) {
  const std::size_t nv = along.size();
  for (std::size_t j = 0; j < nv; ++j)
    for (std::size_t k = 0; k < j; ++k) twice[j * nv + k] = twice[k * nv + j];
  for (const Coordinate& coordinate : mechanism.coordinates) {
    if (coordinate.type != CoordinateType::quaternion) continue;
    const std::size_t first = static_cast<std::size_t>(coordinate.first_speed);
    const auto entry = [&](std::size_t j, std::size_t k) -> Expr& {
      return twice[(first + j) * nv + first + k];
    };
    // Above the diagonal stand D_1 D_0, D_2 D_0 and D_2 D_1.
    entry(1, 0) += along[first + 2];
    entry(2, 0) -= along[first + 1];
    entry(2, 1) += along[first];
  }
}

std::vector<Expr> coordinate_symbols(const Mechanism& mechanism) {
  std::vector<Expr> q;
  for (const Coordinate& coordinate : mechanism.coordinates)
    q.insert(q.end(), coordinate.symbols.begin(), coordinate.symbols.end());
  return q;
}

}  // namespace

std::vector<Expr> WeightedGradient::all() const {
  std::vector<Expr> out = along_speeds;
  out.insert(out.end(), by_speeds.begin(), by_speeds.end());
  out.insert(out.end(), by_rates.begin(), by_rates.end());
  return out;
}

WeightedGradient weighted_gradient(const Kinematics& kinematics, const std::vector<Expr>& Q) {
  const Mechanism& mechanism = kinematics.mechanism;
  ExprGraph& graph = kinematics.graph;
  Expr f = graph.zero();
  for (std::size_t k = 0; k < Q.size(); ++k) f += mu_symbol(mechanism, static_cast<int>(k), graph) * Q[k];
  std::vector<Expr> variables = coordinate_symbols(mechanism);
  const std::ptrdiff_t nq = std::ssize(variables), nv = mechanism.nv;
  for (int k = 0; k < mechanism.nv; ++k) variables.push_back(kinematics.derivatives.speed(k));
  for (int k = 0; k < mechanism.nv; ++k) variables.push_back(kinematics.derivatives.rate(k));
  std::vector<Expr> gradient = jacobian(std::vector<Expr>{f}, variables).entries;
  if (graph.simplifies()) gradient = value_number(gradient);
  const auto speeds = gradient.begin() + nq;
  return {kinematics.derivatives.along_speeds({gradient.begin(), speeds}),
          {speeds, speeds + nv},
          {speeds + nv, gradient.end()}};
}

SecondForceDerivatives second_force_derivatives(const Kinematics& kinematics,
                                                const EquationsOfMotion& equations) {
  const Mechanism& mechanism = kinematics.mechanism;
  const std::size_t nv = equations.Q.size();
  const WeightedGradient gradient = weighted_gradient(kinematics, equations.Q);
  const std::vector<Expr> moved =
      kinematics.derivatives.along_speeds(jacobian(gradient.all(), coordinate_symbols(mechanism)).entries);
  SecondForceDerivatives out;
  out.along_speeds_twice.assign(moved.begin(), moved.begin() + static_cast<std::ptrdiff_t>(nv * nv));
  complete(mechanism, gradient.along_speeds, out.along_speeds_twice);
  for (std::size_t j = 0; j < nv; ++j) {
    for (std::size_t k = 0; k < nv; ++k) {
      out.along_speeds_by_speeds.push_back(moved[(nv + k) * nv + j]);
      out.along_speeds_by_rates.push_back(moved[(2 * nv + k) * nv + j]);
    }
  }
  std::vector<Expr> u;
  for (int k = 0; k < mechanism.nv; ++k) u.push_back(kinematics.derivatives.speed(k));
  out.by_speeds_twice = jacobian(gradient.by_speeds, u).entries;
  for (std::size_t j = 0; j < nv; ++j)
    for (std::size_t k = 0; k < j; ++k) out.by_speeds_twice[j * nv + k] = out.by_speeds_twice[k * nv + j];
  value_number_all({&out.along_speeds_twice, &out.along_speeds_by_speeds, &out.by_speeds_twice,
                    &out.along_speeds_by_rates});
  return out;
}

}  // namespace alembert
