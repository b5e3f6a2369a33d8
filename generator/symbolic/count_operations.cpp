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
    const NodeKind kind = order.kinds[i];
    if (kind.arity() == 0 || is_trigonometric(kind.op)) continue;
    used_otherwise[order.operands[i].a >> 1] = true;
    if (kind.arity() == 2) used_otherwise[order.operands[i].b >> 1] = true;
  }
  for (const Expr& root : roots) used_otherwise[order.at(root.ref().node())] = true;
  OperationCount count;
  for (std::size_t i = 0; i < order.ids.size(); ++i) {
    const NodeKind kind = order.kinds[i];
    if (kind.constant) continue;
    const std::uint32_t a = order.operands[i].a >> 1, b = order.operands[i].b >> 1;
    // An offset of an angle belongs to the call.
    if (kind.op == Operation::add && !used_otherwise[i] &&
        (order.kinds[a].constant || order.kinds[b].constant))
      continue;
    const bool doubles = kind.op == Operation::mul && order.kinds[a].op == Operation::rational &&
                         graph->rational_value(order.ids[a]) == Rational(2);
    count.include(kind.op, doubles);
  }
  return count;
}

}  // namespace alembert
