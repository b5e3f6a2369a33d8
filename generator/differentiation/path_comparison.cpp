// Exact comparison first, floating point only where that is not possible.
#include "differentiation/path_comparison.hpp"

#include <cmath>
#include <unordered_map>
#include <vector>

#include "symbolic/evaluate.hpp"
#include "symbolic/evaluate_modular.hpp"
#include "symbolic/modular.hpp"
#include "symbolic/postorder.hpp"

namespace alembert {

namespace {

std::vector<Expr> edge_values(ExprGraph& expressions, const LabelledGraph& graph) {
  std::vector<Expr> edges;
  edges.reserve(graph.edges.size());
  for (const DerivativeEdge& edge : graph.edges) edges.emplace_back(expressions, edge.value);
  return edges;
}

/// Whether all rules by which sums and products are simplified hold in the modular field too.
bool is_exact(const ExprGraph& expressions, std::span<const Expr> roots) {
  std::unordered_map<std::uint32_t, bool> has_root;  // node -> there is a square root in it
  for (const std::uint32_t id : postorder(roots)) {
    const Node& node = expressions.node(id);
    if (node.op == Operation::real || node.op == Operation::abs || node.op == Operation::sign ||
        node.op == Operation::rounding || is_choice(node.op))
      return false;
    bool below = false;
    if (node.arity() >= 1) below = has_root[node.a.node()];
    if (node.arity() >= 2) below = has_root[node.b.node()] || below;
    if (node.op == Operation::sqrt && (below || node.constant)) return false;
    has_root[id] = below || node.op == Operation::sqrt;
  }
  return true;
}

PathComparison compare_modulo(ExprGraph& expressions, const LabelledGraph& original,
                              std::span<const Expr> edges, std::span<const Expr> derivatives) {
  const std::vector<Modular> point = random_modular_point(expressions.symbol_count(), 20070802);
  const std::vector<Modular> values = evaluate_modular(edges, point);
  const std::vector<Modular> actual = evaluate_modular(derivatives, point);
  for (std::size_t p = 0; p < actual.size(); ++p)
    if (path_sum(original, p, values) != actual[p]) return PathComparison::different;
  return PathComparison::equal;
}

PathComparison compare_in_double(ExprGraph& expressions, const LabelledGraph& original,
                                 std::span<const Expr> edges, std::span<const Expr> derivatives) {
  constexpr double kTolerance = 1e-9;  // of the sum of the paths' magnitudes; rounding errors are far smaller
  std::vector<double> point(expressions.symbol_count());
  for (std::size_t s = 0; s < point.size(); ++s)
    point[s] = 0.1 + 0.8 * std::fmod(static_cast<double>(s + 1) * 0.6180339887498949, 1.0);
  const std::vector<double> values = evaluate(edges, point);
  std::vector<double> magnitudes;
  for (const double value : values) magnitudes.push_back(std::abs(value));
  const std::vector<double> actual = evaluate(derivatives, point);
  PathComparison result = PathComparison::equal;
  for (std::size_t p = 0; p < actual.size(); ++p) {
    const double error = std::abs(path_sum(original, p, values) - actual[p]);
    const double scale = path_sum(original, p, magnitudes);
    if (!std::isfinite(error) || !std::isfinite(scale)) {
      result = PathComparison::undecided;
    } else if (error > kTolerance * scale) {
      return PathComparison::different;
    }
  }
  return result;
}

}  // namespace

PathComparison compare_with_paths(ExprGraph& expressions, const LabelledGraph& original,
                                  std::span<const Expr> derivatives) {
  if (derivatives.empty()) return PathComparison::equal;
  const std::vector<Expr> edges = edge_values(expressions, original);
  if (compare_modulo(expressions, original, edges, derivatives) == PathComparison::equal)
    return PathComparison::equal;
  const PathComparison in_double = compare_in_double(expressions, original, edges, derivatives);
  if (in_double == PathComparison::equal) return PathComparison::equal;
  std::vector<Expr> all = edges;
  all.insert(all.end(), derivatives.begin(), derivatives.end());
  return is_exact(expressions, all) ? in_double : PathComparison::undecided;
}

}  // namespace alembert
