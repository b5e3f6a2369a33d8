// Derivatives of the forces: of the whole by D* and its like, and by recursions (see the header).
#include "dynamics/choice/force_derivatives.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "differentiation/jacobian.hpp"
#include "dynamics/recursions/derivative_recursion.hpp"
#include "dynamics/recursions/meeting_frames.hpp"
#include "symbolic/count_operations.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {

namespace {

/// By differentiating the forces as they stand.
std::vector<Expr> derivatives_of_the_whole(const Kinematics& kinematics, const std::vector<Expr>& Q) {
  std::vector<Expr> variables;
  for (const Coordinate& coordinate : kinematics.mechanism.coordinates)
    variables.insert(variables.end(), coordinate.symbols.begin(), coordinate.symbols.end());
  const std::size_t nq = variables.size(), nv = Q.size();
  for (int k = 0; k < kinematics.mechanism.nv; ++k) variables.push_back(kinematics.derivatives.speed(k));
  const Jacobian by = jacobian(Q, variables);
  const std::vector<Expr> N = kinematics.derivatives.coordinate_rate_matrix();
  std::vector<Expr> both(2 * nv * nv, kinematics.graph.zero());
  for (std::size_t i = 0; i < nv; ++i) {
    for (std::size_t k = 0; k < nv; ++k) {
      for (std::size_t a = 0; a < nq; ++a)
        if (!N[a * nv + k].is_zero()) both[i * nv + k] += by(i, a) * N[a * nv + k];
      both[(nv + i) * nv + k] = by(i, nq + k);
    }
  }
  return both;
}

/// Beyond so many operations of a recursion, derivatives of the whole take more, and long to write.
constexpr std::size_t kWhole = 6'000;
/// Beyond so many, expressions are counted, not programs, ...
constexpr std::size_t kCounted = 10'000;
/// ... and only the estimated best meeting frames are tried, on the tree that M is of.
constexpr std::size_t kLong = 40'000;

}  // namespace

std::vector<Expr> force_derivatives(const Kinematics& kinematics, const EquationsOfMotion& equations) {
  std::vector<Expr> applied;
  if (!kinematics.applied.Q.empty())
    applied = value_number(derivatives_of_the_whole(kinematics, kinematics.applied.Q));
  std::vector<std::pair<std::size_t, std::vector<Expr>>> found;  // with their operations
  const auto add = [&](const std::vector<Expr>& values) {
    std::vector<Expr> numbered = value_number(values);
    const std::size_t operations = count_operations(numbered).total();
    found.emplace_back(operations, std::move(numbered));
  };
  const auto add_recursions = [&](const WrittenTree& tree) {
    for (const FarPairs far : {FarPairs::meet, FarPairs::meet_sooner, FarPairs::carry}) {
      std::vector<Expr> both = recursive_force_derivatives(kinematics.mechanism, tree, kinematics.derivatives,
                                                           kinematics.graph, far);
      for (std::size_t i = 0; i < applied.size(); ++i) both[i] -= applied[i];
      add(both);
      if (found.back().first > kLong) break;
    }
  };
  if (equations.articulated) add_recursions(*equations.articulated);
  if (equations.tree && (found.empty() || found.front().first <= kLong)) add_recursions(*equations.tree);
  if (found.empty() || found.front().first <= kLong) {
    add_recursions(kinematics.tree);
    if (kinematics.peeled) add_recursions(*kinematics.peeled);
  }
  std::size_t least = found.front().first;
  for (const auto& one : found) least = std::min(least, one.first);
  if (least <= kWhole) add(derivatives_of_the_whole(kinematics, equations.Q));
  least = std::min(least, found.back().first);

  // Where it is close, the optimised programs decide.
  std::size_t best = 0;
  std::optional<Length> shortest;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto& [operations, values] = found[i];
    if (2 * operations > 3 * least) continue;
    const Length length = least > kCounted ? Length{operations, 0} : kinematics.lengths.of(values);
    if (shortest && !(length < *shortest)) continue;
    shortest = length;
    best = i;
  }
  return std::move(found[best].second);
}

}  // namespace alembert
