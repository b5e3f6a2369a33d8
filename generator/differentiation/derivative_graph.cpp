// Building the linearised graph: one sweep over the nodes below the roots.
#include "differentiation/derivative_graph.hpp"

#include <stdexcept>

#include "differentiation/partials.hpp"
#include "support/no_index.hpp"
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
  DerivativeGraph result;
  result.graph = common_graph(roots, variables);
  result.roots.assign(roots.size(), kNoIndex);
  result.negative.assign(roots.size(), false);
  result.variables.assign(variables.size(), kNoIndex);
  if (result.graph == nullptr) return result;
  ExprGraph& graph = *result.graph;

  const Postorder order = indexed_postorder(roots);
  std::vector<std::uint32_t> vertex(order.ids.size(), kNoIndex);  // by position in the order
  const auto vertex_of = [&](Ref x) {
    const std::uint32_t position = order.at(x.node());
    return position == kNoIndex ? kNoIndex : vertex[position];
  };
  NodeIndex numbers;  // of variables
  for (std::uint32_t j = 0; j < variables.size(); ++j) {
    const Ref variable = variables[j].ref();
    if (variable.negative() || graph.node(variable.node()).op != Operation::symbol)
      throw std::invalid_argument("jacobian: a variable must be a symbol");
    if (!numbers.add(variable.node(), j)) throw std::invalid_argument("jacobian: a variable is repeated");
  }

  for (std::size_t k = 0; k < order.ids.size(); ++k) {
    const std::uint32_t id = order.ids[k];
    const Node node = graph.node(id);
    const auto number = static_cast<std::uint32_t>(result.nodes.size());
    bool active = node.op == Operation::symbol && numbers.find(id) != kNoIndex;
    for (int slot = 0; slot < node.arity(); ++slot) {
      const std::uint32_t bottom = vertex[(slot == 0 ? order.operands[k].a : order.operands[k].b) >> 1];
      if (bottom == kNoIndex) continue;
      const Ref value = local_partial(graph, id, slot);
      if (result.expr(value).is_zero()) continue;
      result.edges.push_back({number, bottom, value});
      active = true;
    }
    if (!active) continue;
    vertex[k] = number;
    result.nodes.push_back(id);
  }
  for (std::size_t i = 0; i < roots.size(); ++i) {
    result.roots[i] = vertex_of(roots[i].ref());
    result.negative[i] = roots[i].ref().negative();
  }
  for (std::size_t j = 0; j < variables.size(); ++j) result.variables[j] = vertex_of(variables[j].ref());
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
