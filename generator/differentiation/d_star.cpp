// D* (Guenter, "Efficient symbolic differentiation for graphics applications", 2007). In: roots and
// variables. Out: the Jacobian, from the derivative graph factored until every entry is one product.
#include "differentiation/d_star.hpp"

#include "differentiation/derivative_graph.hpp"
#include "differentiation/factoring.hpp"
#include "differentiation/jacobian.hpp"
#include "differentiation/labelled_graph.hpp"
#include "differentiation/path_comparison.hpp"
#include "differentiation/products.hpp"
#include "differentiation/reverse.hpp"
#include "support/error.hpp"
#include "support/no_index.hpp"

namespace alembert {

namespace {

constexpr std::uint64_t kMaxLabels = 4'000'000;  // pairs of all edges together; about 100 MB

Jacobian give_up(std::span<const Expr> roots, std::span<const Expr> variables) {
  Jacobian result = jacobian_reverse(roots, variables);
  result.d_star_gave_up = true;
  return result;
}

}  // namespace

Jacobian jacobian_d_star(std::span<const Expr> roots, std::span<const Expr> variables, DStarOptions options) {
  const DerivativeGraph graph = derivative_graph(roots, variables);
  Jacobian result = zero_jacobian(roots, variables, DerivativeMethod::d_star);
  if (result.entries.empty()) return result;
  std::optional<LabelledGraph> labelled = label_edges(graph, kMaxLabels);
  if (!labelled) return give_up(roots, variables);
  const LabelledGraph original = *labelled;

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

  switch (compare_with_paths(*graph.graph, original, products)) {
    case PathComparison::equal:
      break;
    case PathComparison::undecided:
      return give_up(roots, variables);
    case PathComparison::different:
      throw InternalError("D*: a product is not the sum over the paths it stands for");
  }

  for (std::size_t i = 0; i < roots.size(); ++i) {
    for (std::size_t j = 0; j < variables.size(); ++j) {
      const std::size_t k = i * variables.size() + j;
      Expr entry = graph.graph->zero();
      if (labelled->pair_of[k] != kNoIndex) {
        entry = products[labelled->pair_of[k]];
      } else if (graph.roots[i] != kNoIndex && graph.roots[i] == graph.variables[j]) {
        entry = graph.graph->one();
      }
      result.entries[k] = graph.signed_as_root(i, entry);
    }
  }
  return result;
}

}  // namespace alembert
