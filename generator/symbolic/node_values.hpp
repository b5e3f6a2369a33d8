// Values of the nodes of an order, in any real arithmetic. Private to this room.
#pragma once

#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include "symbolic/evaluate.hpp"
#include "symbolic/node_index.hpp"
#include "symbolic/postorder.hpp"

namespace alembert {

/// Values of all nodes of an order; symbols[i] belongs to the symbol with index i. `Real` has the functions
/// of <cmath>; `number` makes one of a rational.
template <class Real, class Number>
std::vector<Real> node_values(const ExprGraph& graph, const Postorder& order, std::span<const Real> symbols,
                              const Real& pi, Number number) {
  using std::abs;
  std::vector<Real> values(order.ids.size());
  const auto of = [&](std::uint32_t local) {
    const Real& value = values[local >> 1];
    return (local & 1) != 0 ? Real(-value) : value;
  };
  for (std::size_t i = 0; i < order.ids.size(); ++i) {
    const std::uint32_t id = order.ids[i];
    const Node& node = graph.node(id);
    const int arity = node.arity();
    const LocalOperands operands = order.operands[i];
    const Real a = arity >= 1 ? of(operands.a) : Real(0), b = arity == 2 ? of(operands.b) : Real(0);
    Real& value = values[i];
    if (node.op == Operation::rational) {
      value = number(graph.rational_value(id));
    } else if (node.op == Operation::pi_multiple) {
      value = number(graph.rational_value(id)) * pi;
    } else if (node.op == Operation::real) {
      value = graph.real_value(id);
    } else if (node.op == Operation::symbol) {
      const std::uint32_t index = graph.symbol_index(id);
      if (index >= symbols.size()) throw std::out_of_range("no value for symbol " + graph.symbol_name(index));
      value = symbols[index];
    } else if (is_trigonometric(node.op) && abs(a) > std::numeric_limits<double>::max()) {
      // As of infinity: to reduce it would take as many digits of pi as it has.
      value = std::numeric_limits<double>::quiet_NaN();
    } else {
      value = apply(node.op, a, b);
    }
  }
  return values;
}

}  // namespace alembert
