// Derivatives of nodes, by the rows of their operations.
#include "differentiation/partials.hpp"

#include "support/error.hpp"

namespace alembert {

Ref local_partial(ExprGraph& graph, std::uint32_t id, int slot) {
  const Node node = graph.node(id);  // a copy: making nodes may move the arena
  const int operands = node.arity();
  if (slot < 0 || slot >= operands) throw InternalError("local_partial: no such operand");
  const Expr v(graph, Ref(id, false));
  const Expr a(graph, node.a);
  const Expr b(graph, node.b);
  const Expr derivative = partial_derivative(node.op, graph.one(), a, b, v, slot);
  return (slot == 0 ? node.a : node.b).negative() ? -derivative.ref() : derivative.ref();
}

}  // namespace alembert
