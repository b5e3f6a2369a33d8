// Forward mode. In: roots and variables. Out: the Jacobian, one column a sweep: the tangent of every node
// with respect to one variable, children before parents.
#include "differentiation/forward.hpp"

#include "differentiation/derivative_graph.hpp"
#include "differentiation/jacobian.hpp"
#include "support/no_index.hpp"

namespace alembert {

Jacobian jacobian_forward(std::span<const Expr> roots, std::span<const Expr> variables) {
  const DerivativeGraph graph = derivative_graph(roots, variables);
  Jacobian result = zero_jacobian(roots, variables, DerivativeMethod::forward);
  std::vector<Expr> tangent(graph.nodes.size());  // without a graph: zero
  for (std::size_t j = 0; j < variables.size(); ++j) {
    const std::uint32_t variable = graph.variables[j];
    if (variable == kNoIndex) continue;
    tangent.assign(graph.nodes.size(), Expr());
    tangent[variable] = graph.graph->one();
    for (const DerivativeEdge& edge : graph.edges) {
      if (!tangent[edge.bottom].valid()) continue;
      const Expr product = tangent[edge.bottom] * graph.expr(edge.value);
      Expr& sum = tangent[edge.top];
      sum = sum.valid() ? sum + product : product;
    }
    for (std::size_t i = 0; i < roots.size(); ++i) {
      const std::uint32_t root = graph.roots[i];
      if (root == kNoIndex || !tangent[root].valid()) continue;
      result.entries[i * variables.size() + j] = graph.signed_as_root(i, tangent[root]);
    }
  }
  return result;
}

}  // namespace alembert
