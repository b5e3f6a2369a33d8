// Guarding arguments (see the header).
#include "symbolic/guarded.hpp"

#include <array>
#include <optional>
#include <vector>

#include "symbolic/postorder.hpp"

namespace alembert {
namespace {

/// What a critical operand becomes where it is not chosen, if it may be one.
std::optional<int> harmless(const ExprGraph& graph, const Node& node) {
  const Operation op = node.op;
  if (op == Operation::div) {
    const Interval divisor = graph.bounds(node.b);
    const bool never_zero = divisor.lower > 0 || divisor.upper < 0;
    if (never_zero || graph.node(node.b.node()).op == Operation::sqrt) return std::nullopt;
    return 1;
  }
  if (node.arity() == 0) return std::nullopt;
  const Interval x = graph.bounds(node.a);
  if ((op == Operation::sqrt || op == Operation::log || op == Operation::pow) && x.lower < 0) return 1;
  if ((op == Operation::asin || op == Operation::acos) && (x.lower < -1 || x.upper > 1)) return 0;
  return std::nullopt;
}

}  // namespace

Expr guarded(Operation choice, const Expr& c, const Expr& x) {
  ExprGraph& graph = x.graph();
  const std::array<Expr, 1> root{x};
  const Postorder order = indexed_postorder(root);
  const Operation other =
      choice == Operation::if_positive ? Operation::unless_positive : Operation::if_positive;
  std::vector<Expr> image;
  image.reserve(order.ids.size());
  const auto of = [&](std::uint32_t local) {
    return (local & 1u) != 0 ? -image[local >> 1] : image[local >> 1];
  };
  for (std::size_t i = 0; i < order.ids.size(); ++i) {
    const std::uint32_t id = order.ids[i];
    const Node node = graph.node(id);  // a copy: making nodes may move the arena
    const Expr same(graph, Ref(id, false));
    if (node.arity() == 0 || is_choice(node.op)) {
      image.push_back(same);
      continue;
    }
    const bool binary = node.arity() == 2;
    Expr a = of(order.operands[i].a);
    Expr b = binary ? of(order.operands[i].b) : a;
    const std::optional<int> instead = harmless(graph, node);
    if (instead) {
      Expr& critical = node.op == Operation::div ? b : a;
      critical = apply(choice, c, critical) + apply(other, c, graph.integer(*instead));
    }
    const bool changed = instead || a != Expr(graph, node.a) || (binary && b != Expr(graph, node.b));
    image.push_back(changed ? apply(node.op, a, b) : same);
  }
  return x.ref().negative() ? -image.back() : image.back();
}

}  // namespace alembert
