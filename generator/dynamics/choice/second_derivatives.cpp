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

}  // namespace

SecondForceDerivatives second_force_derivatives(const Kinematics& kinematics,
                                                const EquationsOfMotion& equations) {
  const Mechanism& mechanism = kinematics.mechanism;
  ExprGraph& graph = kinematics.graph;
  const std::size_t nv = equations.Q.size();
  Expr f = graph.zero();
  for (std::size_t k = 0; k < nv; ++k) f += mu_symbol(mechanism, static_cast<int>(k), graph) * equations.Q[k];
  std::vector<Expr> q, u, ud;
  for (const Coordinate& coordinate : mechanism.coordinates)
    q.insert(q.end(), coordinate.symbols.begin(), coordinate.symbols.end());
  for (int k = 0; k < mechanism.nv; ++k) {
    u.push_back(kinematics.derivatives.speed(k));
    ud.push_back(kinematics.derivatives.rate(k));
  }
  std::vector<Expr> variables = q;
  variables.insert(variables.end(), u.begin(), u.end());
  variables.insert(variables.end(), ud.begin(), ud.end());
  const std::vector<Expr> gradient = value_number(jacobian(std::vector<Expr>{f}, variables).entries);

  // D f, then df/du and df/dud.
  const auto behind = gradient.begin() + static_cast<std::ptrdiff_t>(q.size());
  const std::vector<Expr> along = kinematics.derivatives.along_speeds({gradient.begin(), behind});
  std::vector<Expr> first = along;
  first.insert(first.end(), behind, gradient.end());
  const std::vector<Expr> moved = kinematics.derivatives.along_speeds(jacobian(first, q).entries);
  SecondForceDerivatives out;
  out.along_speeds_twice.assign(moved.begin(), moved.begin() + static_cast<std::ptrdiff_t>(nv * nv));
  complete(mechanism, along, out.along_speeds_twice);
  for (std::size_t j = 0; j < nv; ++j) {
    for (std::size_t k = 0; k < nv; ++k) {
      out.along_speeds_by_speeds.push_back(moved[(nv + k) * nv + j]);
      out.along_speeds_by_rates.push_back(moved[(2 * nv + k) * nv + j]);
    }
  }
  out.by_speeds_twice =
      jacobian(std::vector<Expr>(behind, behind + static_cast<std::ptrdiff_t>(nv)), u).entries;
  for (std::size_t j = 0; j < nv; ++j)
    for (std::size_t k = 0; k < j; ++k) out.by_speeds_twice[j * nv + k] = out.by_speeds_twice[k * nv + j];
  value_number_all({&out.along_speeds_twice, &out.along_speeds_by_speeds, &out.by_speeds_twice,
                    &out.along_speeds_by_rates});
  return out;
}

}  // namespace alembert
