// Second derivatives by differentiating the weighted sum of the forces twice (see the header).
#include "dynamics/choice/second_derivatives.hpp"

#include "differentiation/jacobian.hpp"
#include "dynamics/tree/symbols.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {

namespace {

/// [i][k]: D_k of value i.
std::vector<Expr> along_speeds(const Kinematics& kinematics, const std::vector<Expr>& values,
                               const std::vector<Expr>& q) {
  const std::size_t nv = static_cast<std::size_t>(kinematics.mechanism.nv);
  const Jacobian by = jacobian(values, q);
  const std::vector<Expr> N = kinematics.derivatives.coordinate_rate_matrix();
  std::vector<Expr> out(values.size() * nv, kinematics.graph.zero());
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t a = 0; a < q.size(); ++a)
      for (std::size_t k = 0; k < nv; ++k)
        if (!N[a * nv + k].is_zero()) out[i * nv + k] += by(i, a) * N[a * nv + k];
  return out;
}

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
  const std::vector<Expr> N = kinematics.derivatives.coordinate_rate_matrix();
  std::vector<Expr> first(nv, graph.zero());
  for (std::size_t a = 0; a < q.size(); ++a)
    for (std::size_t k = 0; k < nv; ++k)
      if (!N[a * nv + k].is_zero()) first[k] += gradient[a] * N[a * nv + k];
  const std::vector<Expr> along = first;
  first.insert(first.end(), gradient.begin() + static_cast<std::ptrdiff_t>(q.size()), gradient.end());
  const std::vector<Expr> by_speeds(first.begin() + static_cast<std::ptrdiff_t>(nv),
                                    first.begin() + static_cast<std::ptrdiff_t>(2 * nv));

  const std::vector<Expr> moved = along_speeds(kinematics, first, q);
  SecondForceDerivatives out;
  out.along_speeds_twice.assign(moved.begin(), moved.begin() + static_cast<std::ptrdiff_t>(nv * nv));
  complete(mechanism, along, out.along_speeds_twice);
  for (std::size_t j = 0; j < nv; ++j) {
    for (std::size_t k = 0; k < nv; ++k) {
      out.along_speeds_by_speeds.push_back(moved[(nv + k) * nv + j]);
      out.along_speeds_by_rates.push_back(moved[(2 * nv + k) * nv + j]);
    }
  }
  out.by_speeds_twice = jacobian(by_speeds, u).entries;
  for (std::size_t j = 0; j < nv; ++j)
    for (std::size_t k = 0; k < j; ++k) out.by_speeds_twice[j * nv + k] = out.by_speeds_twice[k * nv + j];
  std::vector<Expr> all;
  for (std::vector<Expr>* part : {&out.along_speeds_twice, &out.along_speeds_by_speeds, &out.by_speeds_twice,
                                  &out.along_speeds_by_rates})
    all.insert(all.end(), part->begin(), part->end());
  all = value_number(all);
  auto next = all.begin();
  for (std::vector<Expr>* part : {&out.along_speeds_twice, &out.along_speeds_by_speeds, &out.by_speeds_twice,
                                  &out.along_speeds_by_rates})
    for (Expr& value : *part) value = *next++;
  return out;
}

}  // namespace alembert
