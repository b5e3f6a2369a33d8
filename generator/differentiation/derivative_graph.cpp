// Building the linearised graph: one sweep over the nodes below the roots.
#include "differentiation/derivative_graph.hpp"

#include <stdexcept>

#include "differentiation/partials.hpp"
#include "symbolic/postorder.hpp"

namespace alembert {

namespace {

/// The graph that all handles belong to, or null if there are none.
ExprGraph* common_graph(std::span<const Expr> roots, std::span<const Expr> variables) {
  ExprGraph* graph = nullptr;
  for (const std::span<const Expr> list : {roots, variables}) {
    for (const Expr& x : list) {
      if (!x.valid()) throw std::invalid_argument("jacobian: an expression without a graph");
      if (graph == nullptr) graph = &x.graph();
      if (graph != &x.graph()) throw std::invalid_argument("jacobian: expressions of different graphs");
    }
  }
  return graph;
}

}  // namespace

DerivativeGraph derivative_graph(std::span<const Expr> roots, std::span<const Expr> variables) {
  constexpr std::uint32_t kNone = DerivativeGraph::kNone;
  DerivativeGraph result;
  result.graph = common_graph(roots, variables);
  result.roots.assign(roots.size(), kNone);
  result.negative.assign(roots.size(), false);
  result.variables.assign(variables.size(), kNone);
  if (result.graph == nullptr) return result;
  ExprGraph& graph = *result.graph;

  const std::uint32_t size = graph.size();
  std::vector<std::uint32_t> vertex(size, kNone);  // of a node
  std::vector<bool> is_variable(size, false);
  for (const Expr& variable : variables) {
    const std::uint32_t id = variable.ref().node();
    if (variable.ref().negative() || graph.node(id).op != Operation::symbol)
      throw std::invalid_argument("jacobian: a variable must be a symbol");
    if (is_variable[id]) throw std::invalid_argument("jacobian: a variable is repeated");
    is_variable[id] = true;
  }

  for (const std::uint32_t id : postorder(roots)) {
    const Node node = graph.node(id);
    const auto number = static_cast<std::uint32_t>(result.nodes.size());
    bool active = is_variable[id];
    for (int slot = 0; slot < node.arity(); ++slot) {
      const std::uint32_t bottom = vertex[(slot == 0 ? node.a : node.b).node()];
      if (bottom == kNone) continue;
      const Ref value = local_partial(graph, id, slot);
      if (result.expr(value).is_zero()) continue;
      result.edges.push_back({number, bottom, value});
      active = true;
    }
    if (!active) continue;
    vertex[id] = number;
    result.nodes.push_back(id);
  }
  for (std::size_t i = 0; i < roots.size(); ++i) {
    result.roots[i] = vertex[roots[i].ref().node()];
    result.negative[i] = roots[i].ref().negative();
  }
  for (std::size_t j = 0; j < variables.size(); ++j) result.variables[j] = vertex[variables[j].ref().node()];
  return result;
}

Jacobian zero_jacobian(std::span<const Expr> roots, std::span<const Expr> variables,
                       DerivativeMethod method) {
  Jacobian result;
  result.rows = roots.size();
  result.columns = variables.size();
  result.method = method;
  if (!roots.empty() && !variables.empty())
    result.entries.assign(roots.size() * variables.size(), roots.front().graph().zero());
  return result;
}

}  // namespace alembert
