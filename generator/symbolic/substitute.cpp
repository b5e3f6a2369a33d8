// Simultaneous substitution. In: roots and pairs (symbol, expression). Out: the roots with every such symbol
// replaced, rebuilt by the rules of construction.
#include "symbolic/substitute.hpp"

#include <stdexcept>

#include "support/no_index.hpp"
#include "symbolic/node_index.hpp"
#include "symbolic/postorder.hpp"
#include "symbolic/rebuilt.hpp"

namespace alembert {

std::vector<Expr> substitute(std::span<const Expr> roots,
                             std::span<const std::pair<Expr, Expr>> replacements) {
  ExprGraph* graph = graph_of(roots);
  if (graph == nullptr || replacements.empty()) return {roots.begin(), roots.end()};
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
  return rebuilt(roots, [&](std::uint32_t id, Ref a, Ref b) {
    const std::uint32_t by = replaced.find(id);
    return by == kNoIndex ? graph->remade(id, a, b) : replacements[by].second.ref();
  });
}

}  // namespace alembert
