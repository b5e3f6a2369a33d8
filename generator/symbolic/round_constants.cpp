// Constants as numbers of double precision (see the header).
#include "symbolic/round_constants.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "support/error.hpp"
#include "support/operation.hpp"
#include "symbolic/extended.hpp"
#include "symbolic/to_string.hpp"

namespace alembert {
namespace {

// A sum of constants that cancels to less of its terms has no longer the digits of a double.
constexpr long double kLostDigits = 0x1p-11L;
// A sum with constants that were rounded to doubles is zero where it cancels to this fraction of its terms.
constexpr long double kCancelled = 0x1p-58L;

bool has_rounded(const Expr& constant) {
  const ExprGraph& graph = constant.graph();
  const std::vector<std::uint32_t> nodes = postorder({&constant, 1});
  return std::any_of(nodes.begin(), nodes.end(),
                     [&](std::uint32_t id) { return graph.node(id).op == Operation::real; });
}

// What is left of the sum where its terms, of which `term` is one, cancel to `left`. With 50 digits it is told
// whether that is zero or a small number, as it is for axes that are parallel to 1e-19.
long double remainder_of(const Expr& sum, long double term, long double left) {
  if (has_rounded(sum)) return std::abs(left) < kCancelled * std::abs(term) ? 0 : left;
  const Extended value = extended_value_of(sum);
  return abs(value) < kExtendedRounding * std::abs(term) ? 0 : value.convert_to<long double>();
}

long double quotient_of(Rational r) {
  return static_cast<long double>(r.numerator) / static_cast<long double>(r.denominator);
}

std::vector<Expr> over_rounded_constants(ExprGraph& graph, std::span<const Expr> roots) {
  const auto kept = graph.keep_brackets();
  const Postorder order = indexed_postorder(roots);
  const ConstantValues constants(graph, order);
  std::vector<Ref> image(order.ids.size());
  const auto of = [&](std::uint32_t local) {
    if (graph.node(order.ids[local >> 1]).constant) return graph.real(constants.rounded(local)).ref();
    const Ref x = image[local >> 1];
    return (local & 1) != 0 ? -x : x;
  };
  for (std::uint32_t i = 0; i < order.ids.size(); ++i) {
    const Node& node = graph.node(order.ids[i]);
    const int arity = node.constant ? 0 : node.arity();  // a part of a constant may have no finite value
    const LocalOperands operands = order.operands[i];
    const Ref a = arity > 0 ? of(operands.a) : Ref(), b = arity > 1 ? of(operands.b) : Ref();
    image[i] = arity > 0 ? graph.remade(order.ids[i], a, b) : Ref(order.ids[i], false);
  }
  std::vector<Expr> out;
  for (const Expr& root : roots) out.emplace_back(graph, of(order.local(root.ref())));
  return out;
}

}  // namespace

ConstantValues::ConstantValues(ExprGraph& graph, const Postorder& order)
    : graph_(graph), order_(order), folded_(order.ids.size(), 0) {
  for (std::size_t i = 0; i < order.ids.size(); ++i) {
    const std::uint32_t id = order.ids[i];
    const Node& n = graph.node(id);
    if (!n.constant) continue;
    const LocalOperands operands = order.operands[i];
    long double& value = folded_[i];
    if (n.op == Operation::rational) {
      value = quotient_of(graph.rational_value(id));
    } else if (n.op == Operation::pi_multiple) {
      value = std::numbers::pi_v<long double> * quotient_of(graph.rational_value(id));
    } else if (n.op == Operation::real) {
      value = graph.real_value(id);
    } else {
      const long double a = extended(operands.a), b = n.arity() == 2 ? extended(operands.b) : 0;
      value = apply(n.op, a, b);
      if (n.op == Operation::add && std::abs(value) < kLostDigits * std::abs(a))
        value = remainder_of(Expr(graph, Ref(id, false)), a, value);
    }
  }
}

double ConstantValues::rounded(std::uint32_t local) const {
  const std::uint32_t id = order_.ids[local >> 1];
  const double value = graph_.node(id).op == Operation::rational ? graph_.rational_value(id).to_double()
                                                                 : static_cast<double>(folded_[local >> 1]);
  if (!std::isfinite(value))
    throw InternalError("the constant " + to_string(Expr(graph_, Ref(id, false))) + " has no finite value");
  return (local & 1) != 0 ? -value : value;
}

std::vector<Expr> round_constants(std::span<const Expr> roots) {
  ExprGraph* graph = graph_of(roots);
  if (graph == nullptr) return {};
  try {
    return over_rounded_constants(*graph, roots);
  } catch (const std::domain_error&) {
    return {roots.begin(), roots.end()};
  }
}

}  // namespace alembert
