// Values of expressions at complex points, for derivatives by complex step: f'(x) = Im f(x + ih) / h without
// cancellation. In: roots and complex symbol values. Out: complex values. Shares nothing with the evaluators
// under generator/.
#pragma once

#include <complex>
#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

#include "symbolic/expr.hpp"

namespace alembert::test {

inline std::complex<double> complex_value(const ExprGraph& graph, std::uint32_t id, std::complex<double> a,
                                          std::complex<double> b,
                                          std::span<const std::complex<double>> symbols) {
  using Complex = std::complex<double>;
  switch (graph.node(id).op) {
    case Operation::rational:
      return graph.rational_value(id).to_double();
    case Operation::pi_multiple:
      return graph.rational_value(id).to_double() * std::acos(-1.0);
    case Operation::real:
      return graph.real_value(id);
    case Operation::symbol:
      return symbols[graph.symbol_index(id)];
    case Operation::add:
      return a + b;
    case Operation::mul:
      return a * b;
    case Operation::div:
      return a / b;
    case Operation::sqrt:
      return std::sqrt(a);
    case Operation::sin:
      return std::sin(a);
    case Operation::cos:
      return std::cos(a);
    case Operation::tan:
      return std::tan(a);
    case Operation::asin:
      return std::asin(a);
    case Operation::acos:
      return std::acos(a);
    case Operation::atan:
      return std::atan(a);
    case Operation::atan2: {
      // To first order in the imaginary parts, which is all a complex step needs.
      const double square = a.real() * a.real() + b.real() * b.real();
      return Complex(std::atan2(a.real(), b.real()), (b.real() * a.imag() - a.real() * b.imag()) / square);
    }
    case Operation::exp:
      return std::exp(a);
    case Operation::log:
      return std::log(a);
    case Operation::abs:
      return a.real() < 0 ? -a : a;
    case Operation::sign:
      return a.real() < 0 ? -1.0 : a.real() > 0 ? 1.0 : 0.0;
    case Operation::rounding:
      return a * std::numeric_limits<double>::epsilon();
    case Operation::if_positive:
      return a.real() > 0 ? b : 0.0;
    case Operation::unless_positive:
      return a.real() > 0 ? 0.0 : b;
    case Operation::sinh:
      return std::sinh(a);
    case Operation::cosh:
      return std::cosh(a);
    case Operation::tanh:
      return std::tanh(a);
    case Operation::pow:
      return std::pow(a, b);
    case Operation::sub:
    case Operation::neg:
      break;
  }
  throw std::logic_error("no such operation");
}

/// Values of the roots. `symbols[i]` belongs to the symbol with index i.
inline std::vector<std::complex<double>> complex_values(std::span<const Expr> roots,
                                                        std::span<const std::complex<double>> symbols) {
  std::unordered_map<std::uint32_t, std::complex<double>> known;
  std::vector<std::complex<double>> result;
  for (const Expr& root : roots) {
    const ExprGraph& graph = root.graph();
    const auto value = [&](Ref x) { return x.negative() ? -known.at(x.node()) : known.at(x.node()); };
    std::vector<std::uint32_t> open = {root.ref().node()};
    while (!open.empty()) {
      const std::uint32_t id = open.back();
      const Node& node = graph.node(id);
      bool ready = true;
      for (int slot = 0; slot < node.arity(); ++slot) {
        const std::uint32_t operand = (slot == 0 ? node.a : node.b).node();
        if (known.count(operand) != 0) continue;
        open.push_back(operand);
        ready = false;
      }
      if (!ready) continue;
      open.pop_back();
      const std::complex<double> a = node.arity() >= 1 ? value(node.a) : 0.0;
      const std::complex<double> b = node.arity() >= 2 ? value(node.b) : 0.0;
      known[id] = complex_value(graph, id, a, b, symbols);
    }
    result.push_back(value(root.ref()));
  }
  return result;
}

/// d root_i / d variable_j by complex step at a real point, row major.
inline std::vector<double> complex_step(std::span<const Expr> roots, std::span<const Expr> variables,
                                        std::span<const double> point) {
  constexpr double kStep = 1e-60;
  std::vector<double> result(roots.size() * variables.size());
  for (std::size_t j = 0; j < variables.size(); ++j) {
    std::vector<std::complex<double>> symbols(point.begin(), point.end());
    const ExprGraph& graph = variables[j].graph();
    symbols[graph.symbol_index(variables[j].ref().node())] += std::complex<double>(0, kStep);
    const std::vector<std::complex<double>> values = complex_values(roots, symbols);
    for (std::size_t i = 0; i < roots.size(); ++i)
      result[i * variables.size() + j] = values[i].imag() / kStep;
  }
  return result;
}

}  // namespace alembert::test
