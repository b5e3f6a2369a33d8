// Evaluation in double precision. In: roots and the values of all symbols. Out: the values of the roots, or
// of all nodes.
#include <cmath>
#include <stdexcept>

#include "symbolic/node_index.hpp"
#include "symbolic/passes.hpp"

namespace alembert {

std::vector<double> node_values(const ExprGraph& graph, const Postorder& order,
                                std::span<const double> symbols) {
  constexpr double kPi = 3.14159265358979323846;
  std::vector<double> values(order.ids.size());
  const auto of = [&](std::uint32_t local) {
    const double value = values[local >> 1];
    return (local & 1) != 0 ? -value : value;
  };
  for (std::size_t i = 0; i < order.ids.size(); ++i) {
    const std::uint32_t id = order.ids[i];
    const Node& node = graph.node(id);
    const int arity = node.arity();
    const LocalOperands operands = order.operands[i];
    const double a = arity >= 1 ? of(operands.a) : 0, b = arity == 2 ? of(operands.b) : 0;
    double value = 0;
    switch (node.op) {
      case Op::rational:
        value = graph.rational_value(id).to_double();
        break;
      case Op::pi_multiple:
        value = graph.rational_value(id).to_double() * kPi;
        break;
      case Op::real:
        value = graph.real_value(id);
        break;
      case Op::symbol: {
        const std::uint32_t index = graph.symbol_index(id);
        if (index >= symbols.size())
          throw std::out_of_range("no value for symbol " + graph.symbol_name(index));
        value = symbols[index];
        break;
      }
      case Op::add:
        value = a + b;
        break;
      case Op::mul:
        value = a * b;
        break;
      case Op::div:
        value = a / b;
        break;
      case Op::sqrt:
        value = std::sqrt(a);
        break;
      case Op::sin:
        value = std::sin(a);
        break;
      case Op::cos:
        value = std::cos(a);
        break;
      case Op::tan:
        value = std::tan(a);
        break;
      case Op::asin:
        value = std::asin(a);
        break;
      case Op::acos:
        value = std::acos(a);
        break;
      case Op::atan:
        value = std::atan(a);
        break;
      case Op::atan2:
        value = std::atan2(a, b);
        break;
      case Op::exp:
        value = std::exp(a);
        break;
      case Op::log:
        value = std::log(a);
        break;
      case Op::abs:
        value = std::abs(a);
        break;
      case Op::sign:
        value = (a > 0 ? 1.0 : 0.0) - (a < 0 ? 1.0 : 0.0);
        break;
      case Op::sinh:
        value = std::sinh(a);
        break;
      case Op::cosh:
        value = std::cosh(a);
        break;
      case Op::tanh:
        value = std::tanh(a);
        break;
      case Op::pow:
        value = std::pow(a, b);
        break;
    }
    values[i] = value;
  }
  return values;
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
