// Running error analysis over a graph; the rule of each operation is in its row. See error_bound.hpp.
#include "symbolic/error_bound.hpp"

#include "symbolic/evaluate.hpp"
#include "symbolic/node_index.hpp"
#include "symbolic/postorder.hpp"

namespace alembert {
namespace {

std::vector<Approximate> evaluate_bounded(const ExprGraph& graph, std::span<const Expr> roots,
                                          const Postorder& order, std::span<const double> symbols) {
  std::vector<Approximate> out;
  const std::vector<double> values = node_values(graph, order, symbols);
  std::vector<double> errors(values.size());
  const auto at = [&](std::uint32_t local) {
    const double value = values[local >> 1];
    return Approximate{(local & 1) != 0 ? -value : value, errors[local >> 1]};
  };
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Node& node = graph.node(order.ids[i]);
    const LocalOperands operands = order.operands[i];
    const Approximate a = node.arity() >= 1 ? at(operands.a) : Approximate{};
    const Approximate b = node.arity() == 2 ? at(operands.b) : Approximate{};
    errors[i] = error_bound(node.op, a, b, values[i]);
  }
  out.reserve(roots.size());
  for (const Expr& root : roots) out.push_back(at(order.local(root.ref())));
  return out;
}

}  // namespace

std::vector<Approximate> evaluate_bounded(std::span<const Expr> roots, std::span<const double> symbols) {
  const ExprGraph* graph = graph_of(roots);
  if (graph == nullptr) return {};
  return evaluate_bounded(*graph, roots, indexed_postorder(roots), symbols);
}

std::vector<std::vector<Approximate>> evaluate_bounded(std::span<const Expr> roots,
                                                       std::span<const std::vector<double>> points) {
  std::vector<std::vector<Approximate>> out(points.size());
  const ExprGraph* graph = graph_of(roots);
  if (graph == nullptr) return out;
  const Postorder order = indexed_postorder(roots);
  for (std::size_t k = 0; k < points.size(); ++k) out[k] = evaluate_bounded(*graph, roots, order, points[k]);
  return out;
}

}  // namespace alembert
