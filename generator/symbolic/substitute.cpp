// Simultaneous substitution. In: roots and pairs (symbol, expression). Out: the roots with every such symbol
// replaced, rebuilt by the rules of construction.
#include "symbolic/substitute.hpp"

#include <stdexcept>

#include "symbolic/node_index.hpp"
#include "symbolic/postorder.hpp"

namespace alembert {

std::vector<Expr> substitute(std::span<const Expr> roots,
                             std::span<const std::pair<Expr, Expr>> replacements) {
  ExprGraph* graph = graph_of(roots);
  std::vector<Expr> out(roots.begin(), roots.end());
  if (graph == nullptr || replacements.empty()) return out;
  NodeIndex replaced;
  for (std::size_t i = 0; i < replacements.size(); ++i) {
    const auto& [symbol, by] = replacements[i];
    const Expr both[] = {symbol, by};
    if (graph_of(both) != graph) throw std::logic_error("expressions of different graphs cannot be combined");
    if (symbol.ref().negative() || graph->node(symbol.ref().node()).op != Operation::symbol) {
      throw std::logic_error("only symbols can be substituted");
    }
    if (!replaced.add(symbol.ref().node(), static_cast<std::uint32_t>(i)))
      throw std::logic_error("a symbol is substituted twice");
  }
  const Postorder order = indexed_postorder(roots);
  std::vector<Ref> image(order.ids.size());
  const auto of = [&](Ref x) {
    const Ref y = image[order.at(x.node())];
    return x.negative() ? -y : y;
  };
  for (std::size_t i = 0; i < order.ids.size(); ++i) {
    const std::uint32_t id = order.ids[i];
    const Node node = graph->node(id);
    if (node.arity() == 0) {
      const std::uint32_t by = replaced.find(id);
      image[i] = by == NodeIndex::kAbsent ? Ref(id, false) : replacements[by].second.ref();
      continue;
    }
    const Ref a = of(node.a), b = node.arity() == 2 ? of(node.b) : Ref();
    image[i] = a == node.a && b == node.b ? Ref(id, false) : graph->make(node.op, a, b);
  }
  for (Expr& root : out) root = Expr(*graph, of(root.ref()));
  return out;
}

}  // namespace alembert
