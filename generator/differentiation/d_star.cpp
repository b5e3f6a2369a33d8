// D* (Guenter, "Efficient symbolic differentiation for graphics applications", 2007). In: roots and
// variables. Out: the Jacobian, from the derivative graph factored until every entry is one product.
#include "differentiation/derivative_graph.hpp"
#include "differentiation/factoring.hpp"
#include "differentiation/jacobian.hpp"
#include "differentiation/labelled_graph.hpp"
#include "differentiation/products.hpp"
#include "support/error.hpp"
#include "symbolic/passes.hpp"

namespace alembert {

namespace {

constexpr std::uint64_t kMaxLabels = 8'000'000;

Jacobian give_up(std::span<const Expr> roots, std::span<const Expr> variables) {
  Jacobian result = jacobian_reverse(roots, variables);
  result.d_star_gave_up = true;
  return result;
}

/// Every derivative as a sum over paths, at a random point modulo a prime.
std::vector<Modular> path_sums(const DerivativeGraph& graph, const LabelledGraph& labelled,
                               std::span<const Modular> point) {
  std::vector<Expr> edges;
  edges.reserve(labelled.edges.size());
  for (const DerivativeEdge& edge : labelled.edges) edges.push_back(graph.expr(edge.value));
  const std::vector<Modular> values = evaluate_modular(edges, point);
  std::vector<Modular> sums;
  for (std::size_t p = 0; p < labelled.pairs.size(); ++p) sums.push_back(path_sum(labelled, p, values));
  return sums;
}

/// False where constants had to be rounded to double: sums of such constants depend on their order.
bool is_exact(const DerivativeGraph& graph, const LabelledGraph& labelled, std::span<const Expr> products) {
  std::vector<Expr> all(products.begin(), products.end());
  for (const DerivativeEdge& edge : labelled.edges) all.push_back(graph.expr(edge.value));
  for (const std::uint32_t node : postorder(all))
    if (graph.graph->node(node).op == Op::real) return false;
  return true;
}

}  // namespace

Jacobian jacobian_d_star(std::span<const Expr> roots, std::span<const Expr> variables, DStarOptions options) {
  const DerivativeGraph graph = derivative_graph(roots, variables);
  Jacobian result = zero_jacobian(roots, variables, DerivativeMethod::d_star);
  if (result.entries.empty()) return result;
  std::optional<LabelledGraph> labelled = label_edges(graph, kMaxLabels);
  if (!labelled) return give_up(roots, variables);
  const std::vector<Modular> point = random_modular_point(graph.graph->symbol_count(), 20070802);
  const std::vector<Modular> expected = path_sums(graph, *labelled, point);

  Factoring factoring(*graph.graph, *labelled, graph.nodes.size(), {options.max_steps, options.max_work},
                      options.check);
  if (!factoring.run()) return give_up(roots, variables);

  std::vector<std::vector<Ref>> paths;
  for (const LabelledGraph::Pair& pair : labelled->pairs) {
    std::vector<Ref>& path = paths.emplace_back();
    for (const Arc& arc : pair.arcs) path.push_back(labelled->edges[arc.edge].value);
  }
  std::vector<Expr> products = shared_products(*graph.graph, paths, options.max_work);
  for (std::size_t p = 0; p < products.size(); ++p)
    if (paths[p].empty()) products[p] = graph.graph->zero();  // all its paths cancelled

  const std::vector<Modular> values = evaluate_modular(products, point);
  if (values != expected && is_exact(graph, *labelled, products))
    throw InternalError("D*: a product is not the sum over the paths it stands for");

  for (std::size_t i = 0; i < roots.size(); ++i) {
    for (std::size_t j = 0; j < variables.size(); ++j) {
      const std::size_t k = i * variables.size() + j;
      Expr entry = graph.graph->zero();
      if (labelled->pair_of[k] != DerivativeGraph::kNone) {
        entry = products[labelled->pair_of[k]];
      } else if (graph.roots[i] != DerivativeGraph::kNone && graph.roots[i] == graph.variables[j]) {
        entry = graph.graph->one();
      }
      result.entries[k] = graph.signed_as_root(i, entry);
    }
  }
  return result;
}

}  // namespace alembert
