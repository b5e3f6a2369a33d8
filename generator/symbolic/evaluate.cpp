// Evaluation in double precision. In: roots and the values of all symbols. Out: the values of the roots, or
// of all nodes.
#include "symbolic/evaluate.hpp"

#include "symbolic/node_values.hpp"

namespace alembert {

std::vector<double> node_values(const ExprGraph& graph, const Postorder& order,
                                std::span<const double> symbols) {
  return node_values<double>(graph, order, symbols, 3.14159265358979323846,
                             [](const Rational& x) { return x.to_double(); });
}

std::vector<double> evaluate(std::span<const Expr> roots, std::span<const double> symbols) {
  std::vector<double> out;
  const ExprGraph* graph = graph_of(roots);
  if (graph == nullptr) return out;
  const Postorder order = indexed_postorder(roots);
  const std::vector<double> values = node_values(*graph, order, symbols);
  out.reserve(roots.size());
  for (const Expr& root : roots) {
    const double value = values[order.at(root.ref().node())];
    out.push_back(root.ref().negative() ? -value : value);
  }
  return out;
}

double value_of(Expr constant) {
  return evaluate({&constant, 1}, {})[0];
}

}  // namespace alembert
