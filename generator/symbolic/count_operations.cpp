// Operation counts of expressions. In: roots. Out: adds, multiplies, divisions, trigonometric and other
// calls, each node once. Subtractions are adds; signs and products with 1 are free; 2x is one add; constants
// are folded; a constant offset inside the argument of sin, cos or tan belongs to that call.
#include "symbolic/count_operations.hpp"

#include "symbolic/node_index.hpp"
#include "symbolic/postorder.hpp"

namespace alembert {

ExprCount count_operations(std::span<const Expr> roots) {
  const ExprGraph* graph = graph_of(roots);
  const Postorder order = indexed_postorder(roots);
  // An offset angle is free if nothing but trigonometric calls uses it.
  std::vector<bool> used_otherwise(order.ids.size(), false);
  for (std::size_t i = 0; i < order.ids.size(); ++i) {
    const Node& node = graph->node(order.ids[i]);
    if (node.arity() == 0 || is_trigonometric(node.op)) continue;
    used_otherwise[order.operands[i].a >> 1] = true;
    if (node.arity() == 2) used_otherwise[order.operands[i].b >> 1] = true;
  }
  for (const Expr& root : roots) used_otherwise[order.at(root.ref().node())] = true;
  ExprCount count;
  for (std::size_t i = 0; i < order.ids.size(); ++i) {
    const std::uint32_t id = order.ids[i];
    const Node& node = graph->node(id);
    if (node.constant) continue;
    switch (facts(node.op).counted) {
      case Counted::free:
        break;
      case Counted::add:
        if (used_otherwise[i] ||
            !(graph->node(node.a.node()).constant || graph->node(node.b.node()).constant))
          ++count.add;
        break;
      case Counted::mul: {
        const std::uint32_t a = node.a.node();
        const bool doubled =
            graph->node(a).op == Operation::rational && graph->rational_value(a) == Rational(2);
        ++(doubled ? count.add : count.mul);
        break;
      }
      case Counted::div:
        ++count.div;
        break;
      case Counted::trig:
        ++count.trig;
        break;
      case Counted::other:
        ++count.other;
        break;
    }
  }
  return count;
}

}  // namespace alembert
