// Exact evaluation in the field with p^2 elements. In: roots and the values of all symbols. Out: values of
// the roots.
//
// sin and cos of an angle are (2t/(1+t^2), (1-t^2)/(1+t^2)) for a t that is a hash of the angle, the same for
// an angle and its negative up to the sign of t; sinh and cosh likewise on the hyperbola. pi is a fixed
// element. Roots are exact: every element of the prime field has one in the larger field; where an element of
// that has none, and for quotients by zero, the value is a hash of the operands, so that equal operands still
// give equal values. Which of the two roots is taken says nothing about the sign of a real root: whoever
// compares roots must check signs otherwise.
#include "symbolic/evaluate_modular.hpp"

#include <bit>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "symbolic/modular.hpp"

namespace alembert {
namespace modular {
namespace {

// An element of the prime field that stands for an opaque value.
std::uint64_t hash(Operation op, Modular a, Modular b = {}) {
  std::uint64_t h = scramble(static_cast<std::uint64_t>(op) + 1);
  for (const std::uint64_t part : {a.re, a.im, b.re, b.im}) h = scramble(h ^ part);
  return reduce(h);
}

constexpr std::uint64_t kPi = reduce(scramble(0x3141592653589793u));

// A double stands for itself only: as mantissa * 2^exponent it would not do, since 2^61 = 1 here, and a
// residue of rounding such as 2^-62 would be the same element as 1/2.
Modular from_double(double x) {
  const std::uint64_t value = reduce(scramble(std::bit_cast<std::uint64_t>(std::abs(x))));
  return {x < 0 ? negate(value) : value, 0};
}

// The parameter of the circle or hyperbola for an angle: odd in the angle, 0 at 0.
std::uint64_t half_parameter(Operation family, Modular angle) {
  if (is_zero(angle)) return 0;
  const bool upper = is_upper(angle);
  const std::uint64_t t = hash(family, upper ? negate(angle) : angle);
  return upper ? negate(t) : t;
}

// Values on the circle and on the hyperbola. 1 + t^2 is never 0, since -1 is no square; where 1 - t^2 is, the
// value is opaque.
Modular on_curve(Operation op, Modular x) {
  const FieldValue value = facts(op).field;
  const bool circle =
      value == FieldValue::sine || value == FieldValue::cosine || value == FieldValue::tangent;
  const std::uint64_t t = half_parameter(circle ? Operation::sin : Operation::sinh, x);
  const std::uint64_t square = multiply(t, t), twice = add(t, t), plus = add(1, square);
  const std::uint64_t minus = subtract(1, square);
  const auto over = [&](std::uint64_t numerator, std::uint64_t denominator) {
    return denominator == 0 ? Modular{hash(op, x), 0} : Modular{multiply(numerator, inverse(denominator)), 0};
  };
  if (value == FieldValue::sine || value == FieldValue::hyperbolic_tangent) return over(twice, plus);
  if (value == FieldValue::cosine) return over(minus, plus);
  return over(value == FieldValue::hyperbolic_cosine ? plus : twice, minus);
}

Modular odd(Operation op, Modular x, Modular with = {}) {
  if (is_zero(x)) return {};
  const bool upper = is_upper(x);
  const std::uint64_t value = hash(op, upper ? negate(x) : x, with);
  return {upper ? negate(value) : value, 0};
}

}  // namespace

Modular apply(Operation op, Modular a, Modular b) {
  if (op == Operation::add) return add(a, b);
  if (op == Operation::sub) return add(a, negate(b));
  if (op == Operation::neg) return negate(a);
  if (op == Operation::mul) return multiply(a, b);
  if (op == Operation::div) return is_zero(b) ? odd(op, a) : multiply(a, inverse(b));
  if (op == Operation::sqrt) {
    const std::optional<Modular> found = root(a);
    return found ? *found : Modular{hash(op, a), 0};
  }
  if (is_choice(op)) {
    const Modular taken{hash(Operation::if_positive, a), 0};
    return multiply(b, op == Operation::if_positive ? taken : add({1, 0}, negate(taken)));
  }
  if (facts(op).field != FieldValue::opaque) return on_curve(op, a);
  if (parity(op) == Parity::odd) return odd(op, a);
  if (parity(op) == Parity::even)
    return op == Operation::abs && is_zero(a) ? a : Modular{hash(op, is_upper(a) ? negate(a) : a), 0};
  if (op == Operation::atan2 && !is_zero(a)) return odd(op, a, b);  // in the first operand
  return {hash(op, a, b), 0};
}

std::vector<std::vector<Modular>> values(const ExprGraph& graph, const Postorder& order,
                                         std::span<const std::vector<Modular>> points) {
  std::vector<std::vector<Modular>> out(points.size(), std::vector<Modular>(order.ids.size()));
  const auto leaf = [&](std::uint32_t id, Operation op, const std::vector<Modular>& symbols) -> Modular {
    if (op == Operation::rational) return from_rational(graph.rational_value(id));
    if (op == Operation::pi_multiple) return multiply(from_rational(graph.rational_value(id)), {kPi, 0});
    if (op == Operation::real) return from_double(graph.real_value(id));
    const std::uint32_t index = graph.symbol_index(id);
    if (index >= symbols.size()) throw std::out_of_range("no value for symbol " + graph.symbol_name(index));
    return symbols[index];
  };
  for (std::size_t i = 0; i < order.ids.size(); ++i) {
    const NodeKind kind = order.kinds[i];
    const int arity = kind.arity();
    const LocalOperands operands = order.operands[i];
    for (std::size_t k = 0; k < points.size(); ++k) {
      std::vector<Modular>& at = out[k];
      if (arity == 0) {
        at[i] = leaf(order.ids[i], kind.op, points[k]);
        continue;
      }
      const auto of = [&](std::uint32_t local) {
        const Modular value = at[local >> 1];
        return (local & 1) != 0 ? negate(value) : value;
      };
      const Modular a = of(operands.a), b = arity == 2 ? of(operands.b) : Modular{};
      // Most nodes are sums and products.
      if (kind.op == Operation::mul) {
        at[i] = multiply(a, b);
      } else if (kind.op == Operation::add) {
        at[i] = add(a, b);
      } else {
        at[i] = apply(kind.op, a, b);
      }
    }
  }
  return out;
}

}  // namespace modular

std::vector<Modular> evaluate_modular(std::span<const Expr> roots, std::span<const Modular> symbols) {
  std::vector<Modular> out;
  const ExprGraph* graph = graph_of(roots);
  if (graph == nullptr) return out;
  const Postorder order = indexed_postorder(roots);
  const std::vector<Modular> point(symbols.begin(), symbols.end());
  const std::vector<Modular> all = std::move(modular::values(*graph, order, {&point, 1}).front());
  out.reserve(roots.size());
  for (const Expr& root : roots) {
    const Modular value = all[order.at(root.ref().node())];
    out.push_back(root.ref().negative() ? modular::negate(value) : value);
  }
  return out;
}

std::vector<Modular> random_modular_point(std::uint32_t symbol_count, std::uint64_t seed) {
  std::vector<Modular> out(symbol_count);
  for (std::uint32_t i = 0; i < symbol_count; ++i) {
    out[i].re = modular::reduce(modular::scramble(modular::scramble(seed) ^ (i + 1)));
  }
  return out;
}

}  // namespace alembert
