// Guarding arguments (see the header).
#include "symbolic/guarded.hpp"

#include <array>

#include "symbolic/rebuilt.hpp"

namespace alembert {
namespace {

/// Whether its divisor or argument is to be guarded.
bool is_critical(const ExprGraph& graph, const Node& node) {
  const bool by_length = node.op == Operation::div && graph.node(node.b.node()).op == Operation::sqrt;
  return !by_length && graph.may_leave_domain(node);
}
/// What that becomes where it is not chosen.
int harmless(Operation op) {
  return op == Operation::asin || op == Operation::acos ? 0 : 1;
}

}  // namespace

Expr guarded(Operation choice, const Expr& c, const Expr& x) {
  ExprGraph& graph = x.graph();
  const Operation other =
      choice == Operation::if_positive ? Operation::unless_positive : Operation::if_positive;
  const auto safe = [&](Ref part, Operation op) {
    const Expr inside(graph, part);
    return (apply(choice, c, inside) + apply(other, c, graph.integer(harmless(op)))).ref();
  };
  const std::array<Expr, 1> root{x};
  return rebuilt(root,
                 [&](std::uint32_t id, Ref a, Ref b) {
                   const Node node = graph.node(id);  // a copy: making nodes may move the arena
                   if (node.arity() == 0 || is_choice(node.op)) return Ref(id, false);
                   if (is_critical(graph, node)) {
                     Ref& critical = node.op == Operation::div ? b : a;
                     critical = safe(critical, node.op);
                   }
                   return graph.remade(id, a, b);
                 })
      .front();
}

}  // namespace alembert
