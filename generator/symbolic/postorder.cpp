// Order of evaluation. In: roots. Out: the ids of all nodes they need, operands first, depth first from the
// roots in their order and from operand a before b.
#include "symbolic/postorder.hpp"

#include <stdexcept>

#include "support/no_index.hpp"
#include "symbolic/node_index.hpp"

namespace alembert {

ExprGraph* graph_of(std::span<const Expr> roots) {
  ExprGraph* graph = nullptr;
  for (const Expr& root : roots) {
    if (!root.valid()) throw std::logic_error("an expression that belongs to no graph was used");
    if (graph != nullptr && graph != &root.graph()) {
      throw std::logic_error("expressions of different graphs cannot be combined");
    }
    graph = &root.graph();
  }
  return graph;
}

Postorder indexed_postorder(std::span<const Expr> roots, const NodeIndex* ranks) {
  const ExprGraph* graph = graph_of(roots);
  Postorder out;
  if (graph != nullptr) out.index = NodeIndex(graph->size());
  std::vector<std::uint32_t> open;
  for (const Expr& root : roots) {
    open.push_back(root.ref().node());
    while (!open.empty()) {
      const std::uint32_t id = open.back();
      const Node& node = graph->node(id);
      const int arity = node.arity();
      const std::uint32_t a = arity >= 1 ? out.at(node.a.node()) : 0;
      const std::uint32_t b = arity == 2 ? out.at(node.b.node()) : 0;
      // What is visited first is pushed last.
      const bool b_first = ranks != nullptr && arity == 2 && !graph->node(node.a.node()).constant &&
                           ranks->find(node.b.node()) < ranks->find(node.a.node());
      if (b_first && a == kNoIndex) open.push_back(node.a.node());
      if (b == kNoIndex) open.push_back(node.b.node());
      if (!b_first && a == kNoIndex) open.push_back(node.a.node());
      if (a == kNoIndex || b == kNoIndex) continue;
      open.pop_back();
      if (!out.index.add(id, static_cast<std::uint32_t>(out.ids.size()))) continue;
      out.ids.push_back(id);
      out.kinds.push_back({node.op, node.constant});
      out.operands.push_back(
          {arity >= 1 ? Postorder::local(a, node.a) : 0, arity == 2 ? Postorder::local(b, node.b) : 0});
    }
  }
  return out;
}

std::vector<std::uint32_t> postorder(std::span<const Expr> roots) {
  return indexed_postorder(roots).ids;
}

}  // namespace alembert
