// Running error analysis, one rule an operation. See error_bound.hpp.
#include "symbolic/error_bound.hpp"

#include <cmath>
#include <limits>

#include "symbolic/evaluate.hpp"
#include "symbolic/node_index.hpp"
#include "symbolic/postorder.hpp"

namespace alembert {
namespace {

// Functions of the C library are within a few units in the last place.
constexpr double kFunctionRoundings = 4;

double carried(Op op, Approximate a, Approximate b, double v) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  switch (op) {
    case Op::rational:
    case Op::pi_multiple:
    case Op::real:
    case Op::symbol:
      return 0;
    case Op::add:
      return a.error + b.error;
    case Op::mul:
      return std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error;
    case Op::div: {
      const double divisor = std::abs(b.value) - b.error;
      return divisor > 0 ? (a.error + std::abs(v) * b.error) / divisor : kInfinite;
    }
    case Op::abs:
    case Op::sin:
    case Op::cos:
    case Op::tanh:
      return a.error;
    case Op::sqrt:
      return a.error == 0 ? 0 : a.value > a.error ? a.error / v : kInfinite;
    case Op::tan:
      return std::abs(v) * a.error < 0.5 ? 2 * a.error * (1 + v * v) : kInfinite;
    case Op::asin:
    case Op::acos: {
      const double x = std::abs(a.value) + a.error;
      return a.error == 0 ? 0 : x < 1 ? a.error / std::sqrt(1 - x * x) : kInfinite;
    }
    case Op::atan: {
      const double x = std::abs(a.value) - a.error;
      return x > 0 ? a.error / (1 + x * x) : a.error;
    }
    case Op::atan2: {  // the half line b < 0, a = 0 is a cut; -0 is 0 here
      if (b.value <= b.error && std::abs(a.value) <= a.error) return kInfinite;
      const double radius = std::hypot(a.value, b.value) - std::hypot(a.error, b.error);
      return radius > 0 ? std::hypot(a.error, b.error) / radius : kInfinite;
    }
    case Op::exp:
      return a.error < 0.5 ? 2 * std::abs(v) * a.error : kInfinite;
    case Op::log:
      return a.error == 0 ? 0 : a.value > a.error ? a.error / (a.value - a.error) : kInfinite;
    case Op::sign:
      return a.error == 0 || std::abs(a.value) > a.error ? 0 : kInfinite;
    case Op::sinh:
    case Op::cosh:
      return a.error < 0.5 ? 2 * a.error * std::cosh(a.value) : kInfinite;
    case Op::pow: {  // relative error: |b| da/a + |log a| db
      if (a.error == 0 && b.error == 0) return 0;
      const double base = a.value - a.error;
      if (!(base > 0)) return kInfinite;
      const double relative = std::abs(b.value) * a.error / base + std::abs(std::log(a.value)) * b.error;
      return relative < 0.5 ? 2 * relative * std::abs(v) : kInfinite;
    }
  }
  return kInfinite;
}

double roundings(Op op) {
  switch (op) {
    case Op::symbol:
    case Op::abs:
    case Op::sign:
      return 0;
    case Op::rational:
    case Op::pi_multiple:
    case Op::real:
    case Op::add:
    case Op::mul:
    case Op::div:
    case Op::sqrt:
      return 1;
    case Op::sin:
    case Op::cos:
    case Op::tan:
    case Op::asin:
    case Op::acos:
    case Op::atan:
    case Op::atan2:
    case Op::exp:
    case Op::log:
    case Op::sinh:
    case Op::cosh:
    case Op::tanh:
    case Op::pow:
      return kFunctionRoundings;
  }
  return kFunctionRoundings;
}

}  // namespace

double error_bound(Op op, Approximate a, Approximate b, double result) {
  if (!std::isfinite(a.value) || !std::isfinite(b.value) || !std::isfinite(result))
    return std::numeric_limits<double>::infinity();
  return carried(op, a, b, result) + roundings(op) * kUnitRoundoff * std::abs(result);
}

std::vector<Approximate> evaluate_bounded(std::span<const Expr> roots, std::span<const double> symbols) {
  std::vector<Approximate> out;
  const ExprGraph* graph = graph_of(roots);
  if (graph == nullptr) return out;
  const Postorder order = indexed_postorder(roots);
  const std::vector<double> values = node_values(*graph, order, symbols);
  std::vector<double> errors(values.size());
  const auto at = [&](std::uint32_t local) {
    const double value = values[local >> 1];
    return Approximate{(local & 1) != 0 ? -value : value, errors[local >> 1]};
  };
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Node& node = graph->node(order.ids[i]);
    const LocalOperands operands = order.operands[i];
    const Approximate a = node.arity() >= 1 ? at(operands.a) : Approximate{};
    const Approximate b = node.arity() == 2 ? at(operands.b) : Approximate{};
    errors[i] = error_bound(node.op, a, b, values[i]);
  }
  out.reserve(roots.size());
  for (const Expr& root : roots) out.push_back(at(order.local(root.ref())));
  return out;
}

}  // namespace alembert
