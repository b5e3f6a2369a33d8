// Solves with M: by articulated bodies, and by factors of M written out (see the header).
#include "dynamics/choice/forward_dynamics.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "dynamics/choice/force_derivatives.hpp"
#include "dynamics/recursions/articulated_bodies.hpp"
#include "dynamics/recursions/mass_matrix.hpp"
#include "dynamics/tree/symbols.hpp"
#include "symbolic/count_operations.hpp"
#include "symbolic/substitute.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {
namespace {

/// By articulated bodies, over the tree that the equations' search found or the given one; nothing where that is
/// impossible.
std::optional<std::vector<Expr>> articulated(const Kinematics& kinematics, const EquationsOfMotion& equations,
                                             const std::vector<Expr>& right_side) {
  std::optional<std::vector<Expr>> found;
  if (!equations.articulated) return found;
  const auto solve = [&](const MotionTree& tree) -> std::optional<std::vector<Expr>> {
    try {
      return articulated_solve(kinematics.mechanism, tree, right_side, kinematics.graph);
    } catch (const std::domain_error&) {
      // An articulated inertia is the small difference of large ones; M need not be.
      return std::nullopt;
    }
  };
  found = solve(*equations.articulated);
  // Regrouping may have left mass between two motions of one speed.
  if (!found) found = solve(kinematics.tree);
  return found;
}

/// M^-1 of the right side, by the way that takes fewer operations.
std::vector<Expr> solved_for_rates(const Kinematics& kinematics, const EquationsOfMotion& equations,
                                   std::vector<Expr> right_side) {
  std::optional<std::vector<Expr>> by_bodies = articulated(kinematics, equations, right_side);
  if (!by_bodies) return straight_line_solve(equations.M, std::move(right_side));
  *by_bodies = value_number(*by_bodies);
  const std::size_t length = count_operations(*by_bodies).total();
  // M and c alone are a part of the other way, which is O(n^3): it is not made in vain.
  std::vector<Expr> part = equations.M;
  part.insert(part.end(), right_side.begin(), right_side.end());
  if (5 * count_operations(part).total() > 6 * length) return *by_bodies;
  const std::vector<Expr> other = straight_line_solve(equations.M, std::move(right_side));
  // Where it is close, the optimised programs decide.
  const std::size_t other_length = count_operations(value_number(other)).total();
  const bool close = 5 * std::max(length, other_length) < 6 * std::min(length, other_length);
  const auto weigh = [&](std::size_t operations, const std::vector<Expr>& values) {
    return close ? kinematics.lengths.of(values).first : operations;
  };
  return weigh(other_length, other) > weigh(length, *by_bodies) ? *by_bodies : other;
}

}  // namespace

std::vector<Expr> driving_forces(const Kinematics& kinematics, const EquationsOfMotion& equations) {
  std::vector<Expr> forces;
  for (int k = 0; k < kinematics.mechanism.nv; ++k)
    forces.push_back(tau_symbol(kinematics.mechanism, k, kinematics.graph) -
                     equations.c[static_cast<std::size_t>(k)]);
  return forces;
}

std::vector<Expr> by_rows(const std::vector<std::vector<Expr>>& columns, std::size_t first,
                          std::size_t count) {
  std::vector<Expr> all;
  for (std::size_t i = 0; i < columns[first].size(); ++i)
    for (std::size_t k = 0; k < count; ++k) all.push_back(columns[first + k][i]);
  return all;
}

std::vector<std::vector<Expr>> solved_for_columns(const Kinematics& kinematics,
                                                  const EquationsOfMotion& equations,
                                                  const std::vector<std::vector<Expr>>& columns) {
  std::vector<std::vector<Expr>> by_factors;
  for (const std::vector<Expr>& column : columns)
    by_factors.push_back(straight_line_solve(equations.M, column));
  const auto flat = [](const std::vector<std::vector<Expr>>& of) {
    std::vector<Expr> all;
    for (const std::vector<Expr>& one : of) all.insert(all.end(), one.begin(), one.end());
    return all;
  };
  const auto operations = [&](const std::vector<std::vector<Expr>>& of) {
    return count_operations(value_number(flat(of))).total();
  };
  std::vector<std::vector<Expr>> by_bodies;
  const std::size_t most = operations(by_factors);
  std::size_t first = 0;
  for (const std::vector<Expr>& column : columns) {
    std::optional<std::vector<Expr>> one = articulated(kinematics, equations, column);
    if (!one) return by_factors;
    by_bodies.push_back(std::move(*one));
    if (by_bodies.size() == 1) first = operations(by_bodies);
    // The others take about as much as the second does beyond the first.
    if (by_bodies.size() == 2 && first + (columns.size() - 1) * (operations(by_bodies) - first) > 2 * most)
      return by_factors;
  }
  return operations(by_bodies) < most ? by_bodies : by_factors;
}

namespace {

/// M^-1 (tau - c) beside the inverse of M: factors of M, if that has them, are there already.
std::vector<Expr> rates_beside(const std::vector<Expr>& inverse, const Kinematics& kinematics,
                               const EquationsOfMotion& equations) {
  std::vector<Expr> alone = forward_dynamics(kinematics, equations);
  std::vector<Expr> by_factors = straight_line_solve(equations.M, driving_forces(kinematics, equations));
  const auto operations = [&](std::vector<Expr> values) {
    values.insert(values.end(), inverse.begin(), inverse.end());
    return count_operations(value_number(values)).total();
  };
  return operations(by_factors) < operations(alone) ? by_factors : alone;
}

}  // namespace

std::vector<Expr> forward_dynamics(const Kinematics& kinematics, const EquationsOfMotion& equations) {
  return solved_for_rates(kinematics, equations, driving_forces(kinematics, equations));
}

std::vector<Expr> inverse_mass_matrix(const Kinematics& kinematics, const EquationsOfMotion& equations) {
  const std::size_t nv = static_cast<std::size_t>(kinematics.mechanism.nv);
  std::vector<std::vector<Expr>> columns(nv, std::vector<Expr>(nv, kinematics.graph.zero()));
  for (std::size_t k = 0; k < nv; ++k) columns[k][k] = kinematics.graph.one();
  columns = solved_for_columns(kinematics, equations, columns);
  // Of the two triangles, which are equal, the shorter.
  const auto matrix = [&](bool upper) {
    std::vector<Expr> all(nv * nv, kinematics.graph.zero());
    for (std::size_t k = 0; k < nv; ++k)
      for (std::size_t i = 0; i <= k; ++i)
        all[i * nv + k] = all[k * nv + i] = upper ? columns[k][i] : columns[i][k];
    return value_number(all);
  };
  std::vector<Expr> upper = matrix(true), lower = matrix(false);
  return count_operations(lower).total() < count_operations(upper).total() ? lower : upper;
}

ForwardDerivatives forward_dynamics_derivatives(const Kinematics& kinematics,
                                                const EquationsOfMotion& equations) {
  const std::size_t nv = static_cast<std::size_t>(kinematics.mechanism.nv);
  std::vector<Expr> inverse = inverse_mass_matrix(kinematics, equations);
  const std::vector<Expr> qdd = rates_beside(inverse, kinematics, equations);
  std::vector<std::pair<Expr, Expr>> rates;
  for (std::size_t k = 0; k < nv; ++k)
    rates.emplace_back(kinematics.derivatives.rate(static_cast<int>(k)), qdd[k]);
  // d qdd = -M^-1 (tau_q dq + tau_qd dqd), tau_q and tau_qd at these rates.
  const std::vector<Expr> tau = substitute(force_derivatives(kinematics, equations), rates);
  std::vector<std::vector<Expr>> columns;
  for (std::size_t half = 0; half < 2; ++half)
    for (std::size_t k = 0; k < nv; ++k) {
      std::vector<Expr>& column = columns.emplace_back();
      for (std::size_t i = 0; i < nv; ++i) column.push_back(-tau[(half * nv + i) * nv + k]);
    }
  columns = solved_for_columns(kinematics, equations, columns);
  return {by_rows(columns, 0, nv), by_rows(columns, nv, nv), std::move(inverse)};
}

}  // namespace alembert
