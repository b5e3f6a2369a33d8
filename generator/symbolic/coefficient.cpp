// Coefficient of a symbol in expressions that are linear in it (Algorithm 1 of Guenter and Lee, corrected).
// In: roots and a symbol. Out: d with root = d*x + rest for each root, or NotLinear.
#include "symbolic/coefficient.hpp"

#include <stdexcept>

#include "symbolic/node_index.hpp"
#include "symbolic/postorder.hpp"
#include "symbolic/to_string.hpp"

namespace alembert {

std::vector<Expr> coefficient(std::span<const Expr> roots, Expr x) {
  ExprGraph* graph = graph_of(roots);
  std::vector<Expr> out;
  if (graph == nullptr) return out;
  const Expr symbol[] = {x};
  if (graph_of(symbol) != graph) throw std::logic_error("expressions of different graphs cannot be combined");
  if (x.ref().negative() || graph->node(x.ref().node()).op != Operation::symbol) {
    throw std::logic_error("coefficients are taken of symbols");
  }
  const Postorder order = indexed_postorder(roots);
  struct Part {
    bool inside = false;  // x occurs below, even if its coefficient is zero
    Ref coefficient;
  };
  std::vector<Part> parts(order.ids.size());
  const auto of = [&](Ref r) {
    Part part = parts[order.at(r.node())];
    if (r.negative()) part.coefficient = -part.coefficient;
    return part;
  };
  for (std::size_t i = 0; i < order.ids.size(); ++i) {
    const std::uint32_t id = order.ids[i];
    const Node node = graph->node(id);
    const auto refuse = [&](const char* why) {
      const Expr where(*graph, Ref(id, false));
      throw NotLinear(to_string(where) + " is not linear in " + to_string(x) + ": " + why, where);
    };
    Part& part = parts[i];
    const int operands = node.arity();
    if (node.op == Operation::symbol) {
      if (id == x.ref().node()) part = {true, Ref(1, false)};
    } else if (node.op == Operation::add) {
      const Part a = of(node.a), b = of(node.b);
      part.inside = a.inside || b.inside;
      if (part.inside) part.coefficient = graph->make(Operation::add, a.coefficient, b.coefficient);
    } else if (node.op == Operation::mul) {
      const Part a = of(node.a), b = of(node.b);
      if (a.inside && b.inside) refuse("both factors contain it");
      if (a.inside) part = {true, graph->make(Operation::mul, a.coefficient, node.b)};
      if (b.inside) part = {true, graph->make(Operation::mul, node.a, b.coefficient)};
    } else if (node.op == Operation::div) {
      const Part a = of(node.a);
      if (of(node.b).inside) refuse("the divisor contains it");
      if (a.inside) part = {true, graph->make(Operation::div, a.coefficient, node.b)};
    } else if ((operands == 2 && of(node.b).inside) || (operands > 0 && of(node.a).inside)) {
      refuse("it is inside a function");
    }
  }
  out.reserve(roots.size());
  for (const Expr& root : roots) out.emplace_back(*graph, of(root.ref()).coefficient);
  return out;
}

}  // namespace alembert
