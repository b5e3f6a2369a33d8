// Reverse mode. In: roots and variables. Out: the Jacobian, one row a sweep: the adjoint of every node, that
// is the derivative of one root with respect to it, parents before children.
#include "differentiation/reverse.hpp"

#include "differentiation/derivative_graph.hpp"
#include "differentiation/jacobian.hpp"
#include "support/no_index.hpp"

namespace alembert {

Jacobian jacobian_reverse(std::span<const Expr> roots, std::span<const Expr> variables) {
  const DerivativeGraph graph = derivative_graph(roots, variables);
  Jacobian result = zero_jacobian(roots, variables, DerivativeMethod::reverse);
  std::vector<Expr> adjoint(graph.nodes.size());  // without a graph: zero
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const std::uint32_t root = graph.roots[i];
    if (root == kNoIndex) continue;
    adjoint.assign(graph.nodes.size(), Expr());
    adjoint[root] = graph.graph->one();
    for (std::size_t k = graph.edges.size(); k-- > 0;) {
      const DerivativeEdge& edge = graph.edges[k];
      if (!adjoint[edge.top].valid()) continue;
      const Expr product = adjoint[edge.top] * graph.expr(edge.value);
      Expr& sum = adjoint[edge.bottom];
      sum = sum.valid() ? sum + product : product;
    }
    for (std::size_t j = 0; j < variables.size(); ++j) {
      const std::uint32_t variable = graph.variables[j];
      if (variable == kNoIndex || !adjoint[variable].valid()) continue;
      result.entries[i * variables.size() + j] = graph.signed_as_root(i, adjoint[variable]);
    }
  }
  return result;
}

}  // namespace alembert
