// Operation counts of expressions (see the header).
#include "symbolic/count_operations.hpp"

namespace alembert {

OperationCount count_operations(std::span<const Expr> roots) {
  return roots.empty() ? OperationCount() : count_operations(roots, indexed_postorder(roots));
}

OperationCount count_operations(std::span<const Expr> roots, const Postorder& order) {
  const ExprGraph* graph = graph_of(roots);
  // An offset angle is free if nothing but trigonometric calls uses it.
  std::vector<bool> used_otherwise(order.ids.size(), false);
  for (std::size_t i = 0; i < order.ids.size(); ++i) {
    const Node& node = graph->node(order.ids[i]);
    if (node.arity() == 0 || is_trigonometric(node.op)) continue;
    used_otherwise[order.operands[i].a >> 1] = true;
    if (node.arity() == 2) used_otherwise[order.operands[i].b >> 1] = true;
  }
  for (const Expr& root : roots) used_otherwise[order.at(root.ref().node())] = true;
  OperationCount count;
  for (std::size_t i = 0; i < order.ids.size(); ++i) {
    const std::uint32_t id = order.ids[i];
    const Node& node = graph->node(id);
    if (node.constant) continue;
    // An offset of an angle belongs to the call.
    if (node.op == Operation::add && !used_otherwise[i] &&
        (graph->node(node.a.node()).constant || graph->node(node.b.node()).constant))
      continue;
    const bool doubles = node.op == Operation::mul && graph->node(node.a.node()).op == Operation::rational &&
                         graph->rational_value(node.a.node()) == Rational(2);
    count.include(node.op, doubles);
  }
  return count;
}

}  // namespace alembert
