// Values of the nodes of an order, in any real arithmetic. Private to this room.
#pragma once

#include <cmath>
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
  using std::abs, std::acos, std::asin, std::atan, std::atan2, std::cos, std::cosh, std::exp, std::log,
      std::pow, std::sin, std::sinh, std::sqrt, std::tan, std::tanh;
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
    switch (node.op) {
      case Op::rational:
        value = number(graph.rational_value(id));
        break;
      case Op::pi_multiple:
        value = number(graph.rational_value(id)) * pi;
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
        value = sqrt(a);
        break;
      case Op::sin:
        value = sin(a);
        break;
      case Op::cos:
        value = cos(a);
        break;
      case Op::tan:
        value = tan(a);
        break;
      case Op::asin:
        value = asin(a);
        break;
      case Op::acos:
        value = acos(a);
        break;
      case Op::atan:
        value = atan(a);
        break;
      case Op::atan2:
        value = atan2(a, b);
        break;
      case Op::exp:
        value = exp(a);
        break;
      case Op::log:
        value = log(a);
        break;
      case Op::abs:
        value = abs(a);
        break;
      case Op::sign:
        value = (a > 0 ? 1 : 0) - (a < 0 ? 1 : 0);
        break;
      case Op::sinh:
        value = sinh(a);
        break;
      case Op::cosh:
        value = cosh(a);
        break;
      case Op::tanh:
        value = tanh(a);
        break;
      case Op::pow:
        value = pow(a, b);
        break;
    }
  }
  return values;
}

}  // namespace alembert
