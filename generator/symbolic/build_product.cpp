// Rules of construction for products and quotients. In: two operands with signs. Out: the result in normal
// form: operands unsigned and ordered by content, constant factors gathered in front, the sign outside.
#include <stdexcept>
#include <utility>

#include "symbolic/builder.hpp"

namespace alembert {

Builder::Term Builder::factor(Ref x) {
  const Node n = node(x);
  if (n.op == Operation::mul && constant(n.a) && (!n.constant || numeric(n.a))) {
    return {signed_as(n.a, x.negative()), n.b};
  }
  return {signed_as(kOne, x.negative()), magnitude(x)};
}

// c sin(x) or c cos(x) with a c that is no fraction. The vectors that such a pair turns share the products,
// so c stays where it is.
bool Builder::is_scaled_sine(Ref x) const {
  const Node& n = node(x);
  return n.op == Operation::mul && op(n.a) == Operation::real &&
         (op(n.b) == Operation::sin || op(n.b) == Operation::cos);
}

Builder::Term Builder::term(Ref x) {
  const Node n = node(x);
  if (n.op == Operation::div && n.a != kOne && constant(n.a) && (!n.constant || numeric(n.a))) {
    return {signed_as(n.a, x.negative()), intern(Operation::div, kOne, n.b)};
  }
  return factor(x);
}

Ref Builder::intern_product(Ref a, Ref b) {
  if (before(b, a)) std::swap(a, b);
  return intern(Operation::mul, a, b);
}

// Product of two numbers, unless it has no exact form of its own (pi * pi), or what is left as it was written has none.
std::optional<Ref> Builder::fold_product(Ref a, Ref b) {
  if (op(a) == Operation::pi_multiple && op(b) == Operation::pi_multiple) return std::nullopt;
  if (op(a) != Operation::real && op(b) != Operation::real) {
    const auto exact = mul(rational_of(a), rational_of(b));
    if (exact) return rational(a) && rational(b) ? number(*exact) : pi(*exact);
  }
  if (!graph.simplifies_) return std::nullopt;
  return real(numeric_value(a) * numeric_value(b));
}

Ref Builder::product(Ref a, Ref b) {
  if (a == kZero || b == kZero) return kZero;
  const bool negative = a.negative() != b.negative();
  a = magnitude(a);
  b = magnitude(b);
  if (a == kOne) return signed_as(b, negative);
  if (b == kOne) return signed_as(a, negative);
  const Nested nested(*this);
  if (too_deep()) return signed_as(intern_product(a, b), negative);
  if (before(b, a)) std::swap(a, b);
  for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
    if (!is_choice(op(one)) || graph.keeps_brackets_) continue;
    const Node chosen = node(one);
    if (chosen.b == kOne || may_lack_value(other))
      return signed_as(choice(chosen.op, chosen.a, product(chosen.b, other)), negative);
  }

  if (constant(a)) {
    if (const auto found = constant_product(a, b)) return signed_as(*found, negative);
    return signed_as(intern_product(a, b), negative);
  }
  if (graph.keeps_brackets_) {
    if (a == b && op(a) == Operation::sqrt) return signed_as(node(a).a, negative);
    return signed_as(intern_product(a, b), negative);
  }
  if (op(a) == Operation::mul || op(b) == Operation::mul) {
    const Term ta = is_scaled_sine(a) ? Term{kOne, a} : factor(a);
    const Term tb = is_scaled_sine(b) ? Term{kOne, b} : factor(b);
    if (ta.coefficient != kOne || tb.coefficient != kOne) {
      const Ref coefficient = product(ta.coefficient, tb.coefficient);
      // (c*x) * (d/y): the numerator takes c for nothing.
      for (const bool first : {true, false}) {
        const Ref divided = first ? ta.rest : tb.rest, other = first ? tb.rest : ta.rest;
        if (op(divided) != Operation::div || !constant(node(divided).a)) continue;
        const Ref scaled = product(coefficient, divided);
        return signed_as(product(scaled, other), negative);
      }
      const Ref rest = product(ta.rest, tb.rest);
      return signed_as(product(coefficient, rest), negative);
    }
  }
  if (const auto found = cancel_product(a, b)) return signed_as(*found, negative);
  return signed_as(intern_product(a, b), negative);
}

// a is constant; both are unsigned and neither is 0 or 1.
std::optional<Ref> Builder::constant_product(Ref a, Ref b) {
  const Node nb = node(b);
  if (!nb.constant) {
    if (nb.op == Operation::mul && constant(nb.a)) {
      const Ref gathered = product(a, nb.a);
      return product(gathered, nb.b);
    }
    if (nb.op == Operation::div && constant(nb.a) && !graph.keeps_brackets_) {
      const Ref gathered = product(a, nb.a);
      return gathered == kZero
                 ? kZero
                 : signed_as(intern(Operation::div, magnitude(gathered), nb.b), gathered.negative());
    }
    return std::nullopt;
  }
  if (numeric(a) && numeric(b)) return fold_product(a, b);
  if (!graph.simplifies_) return std::nullopt;
  const Term tb = term(b);
  if (numeric(a)) {
    if (tb.coefficient != kOne) {
      const auto gathered = fold_product(a, tb.coefficient);
      if (gathered) return product(*gathered, tb.rest);
    }
    if (nb.op == Operation::div && nb.a == kOne) return intern(Operation::div, a, nb.b);
    return std::nullopt;
  }
  const Term ta = term(a);
  if (ta.coefficient != kOne || tb.coefficient != kOne) {
    const Ref coefficient = product(ta.coefficient, tb.coefficient);
    const Ref rest = product(ta.rest, tb.rest);
    return product(coefficient, rest);
  }
  const Node na = node(a);
  if (na.op == Operation::sqrt && nb.op == Operation::sqrt && a != b && rational(na.a) && rational(nb.a)) {
    if (const auto exact = mul(rational_of(na.a), rational_of(nb.a)))
      return function(Operation::sqrt, number(*exact));
  }
  return cancel_product(a, b);
}

// Products that undo a root, a quotient or an absolute value. Operands unsigned.
std::optional<Ref> Builder::cancel_product(Ref a, Ref b) {
  if (a == b) {
    const Node n = node(a);
    if (n.op == Operation::sqrt) return n.a;
    if (n.op == Operation::abs) return product(n.a, n.a);
    return std::nullopt;
  }
  for (int turn = 0; turn < 2; ++turn, std::swap(a, b)) {
    const Node na = node(a), nb = node(b);
    if (na.op == Operation::sign) {
      if (na.a == b) return function(Operation::abs, b);
      if (nb.op == Operation::abs && nb.a == na.a) return na.a;
    }
    if (na.op == Operation::sqrt && nb.op == Operation::mul && (nb.a == a || nb.b == a)) {
      return product(na.a, nb.a == a ? nb.b : nb.a);
    }
    if (na.op != Operation::div) continue;
    if (na.b == b) return na.a;
    const Node nd = node(na.b);
    if (nd.op == Operation::mul && (nd.a == b || nd.b == b)) return quotient(na.a, nd.a == b ? nd.b : nd.a);
    if (nb.op == Operation::mul && (nb.a == na.b || nb.b == na.b)) {
      return product(na.a, nb.a == na.b ? nb.b : nb.a);
    }
    if (nb.op == Operation::div && nb.a == na.b) return quotient(na.a, nb.b);
  }
  return std::nullopt;
}

// 1/c of a constant that is not 0.
Ref Builder::reciprocal(Ref c) {
  const bool negative = c.negative();
  c = magnitude(c);
  const Node n = node(c);
  if (n.op == Operation::rational) {
    if (const auto exact = div(Rational(1), rational_of(c))) return signed_as(number(*exact), negative);
  }
  if (n.op == Operation::rational || n.op == Operation::real)
    return signed_as(real(1 / numeric_value(c)), negative);
  Ref out;
  if (n.op == Operation::sqrt && rational(n.a)) {
    out = product(reciprocal(n.a), c);
  } else if (n.op == Operation::mul && numeric(n.a)) {
    const Ref number_part = quotient(kOne, n.a);
    const Ref rest = quotient(kOne, n.b);
    out = product(number_part, rest);
  } else if (n.op == Operation::div) {
    out = quotient(n.b, n.a);
  } else if (n.op == Operation::pi_multiple && rational_of(c) != Rational(1)) {
    const Ref number_part = reciprocal(number(rational_of(c)));
    const Ref rest = intern(Operation::div, kOne, pi(Rational(1)));
    out = product(number_part, rest);
  } else {
    out = intern(Operation::div, kOne, c);
  }
  return signed_as(out, negative);
}

Ref Builder::quotient(Ref a, Ref b) {
  if (b == kZero) throw std::domain_error("division by zero");
  if (a == kZero) return kZero;
  const bool negative = a.negative() != b.negative();
  a = magnitude(a);
  b = magnitude(b);
  if (b == kOne) return signed_as(a, negative);
  if (a == b) return signed_as(kOne, negative);
  const Nested nested(*this);
  if (too_deep()) return signed_as(intern(Operation::div, a, b), negative);

  if (constant(b)) {
    if (op(a) == Operation::pi_multiple && op(b) == Operation::pi_multiple) {
      if (const auto exact = div(rational_of(a), rational_of(b))) return signed_as(number(*exact), negative);
    }
    const Ref factor = reciprocal(b);
    return signed_as(product(factor, a), negative);
  }
  const Node na = node(a), nb = node(b);
  if (graph.keeps_brackets_) {
    // (c/(d*x)) is (c/d)/x: one operation less.
    if (na.constant && nb.op == Operation::mul && constant(nb.a))
      return signed_as(quotient(quotient(a, nb.a), nb.b), negative);
    return signed_as(intern(Operation::div, a, b), negative);
  }
  if (is_choice(na.op) && may_lack_value(b))
    return signed_as(choice(na.op, na.a, quotient(na.b, b)), negative);
  if (nb.op == Operation::mul && constant(nb.a)) {
    const Ref factor = reciprocal(nb.a);
    const Ref rest = quotient(a, nb.b);
    return signed_as(product(factor, rest), negative);
  }
  if (nb.op == Operation::div) {
    const Ref dividend = product(a, nb.b);
    return signed_as(quotient(dividend, nb.a), negative);
  }
  if (!na.constant) {
    const Term ta = factor(a);
    if (ta.coefficient != kOne) {
      const Ref rest = quotient(ta.rest, b);
      return signed_as(product(ta.coefficient, rest), negative);
    }
  }
  if (na.op == Operation::div) {
    const Ref divisor = product(na.b, b);
    return signed_as(quotient(na.a, divisor), negative);
  }
  if (const auto found = cancel_quotient(a, b)) return signed_as(*found, negative);
  return signed_as(intern(Operation::div, a, b), negative);
}

// Quotients with a common factor, or of a value and its root. Operands unsigned, the divisor not constant.
std::optional<Ref> Builder::cancel_quotient(Ref a, Ref b) {
  const Node na = node(a), nb = node(b);
  if (na.op == Operation::mul) {
    if (na.a == b) return na.b;
    if (na.b == b) return na.a;
  }
  if (nb.op == Operation::mul) {
    if (nb.a == a) return quotient(kOne, nb.b);
    if (nb.b == a) return quotient(kOne, nb.a);
    if (na.op == Operation::mul) {
      if (na.a == nb.a) return quotient(na.b, nb.b);
      if (na.a == nb.b) return quotient(na.b, nb.a);
      if (na.b == nb.a) return quotient(na.a, nb.b);
      if (na.b == nb.b) return quotient(na.a, nb.a);
    }
  }
  if (nb.op == Operation::sqrt) {
    if (nb.a == a) return b;
    if (na.op == Operation::mul && (na.a == nb.a || na.b == nb.a))
      return product(b, na.a == nb.a ? na.b : na.a);
  }
  if (na.op == Operation::sqrt && na.a == b) return quotient(kOne, a);
  return std::nullopt;
}

}  // namespace alembert
