// Rules of construction for functions other than the trigonometric ones. In: an operation and its operand.
// Out: the result, exact where the operand is a number with an exact result, otherwise a node.
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "symbolic/builder.hpp"

namespace alembert {
namespace {

[[noreturn]] void not_defined(const char* what) {
  throw std::domain_error(what);
}

// n = square^2 * rest for n > 0, as far as small primes and a square as a whole show it.
struct SquareFactor {
  std::int64_t square = 1, rest = 1;
};

std::int64_t integer_root(std::int64_t n) {
  std::int64_t root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(n)));
  while (root > 0 && root > n / root) --root;
  while ((root + 1) <= n / (root + 1)) ++root;
  return root;
}

SquareFactor square_factor(std::int64_t n) {
  constexpr std::int64_t kLargestPrime = 1000;
  SquareFactor out;
  const std::int64_t whole = integer_root(n);
  if (whole * whole == n) return {whole, 1};
  for (std::int64_t p = 2; p <= kLargestPrime && p <= n / p; ++p) {
    int exponent = 0;
    for (; n % p == 0; ++exponent) n /= p;
    for (int i = 0; i < exponent / 2; ++i) out.square *= p;
    if (exponent % 2 != 0) out.rest *= p;
  }
  const std::int64_t left = integer_root(n);
  if (left * left == n) {
    out.square *= left;
  } else {
    out.rest *= n;
  }
  return out;
}

}  // namespace

Ref Builder::function(Operation op, Ref x) {
  const Nested nested(*this);
  // Those that have rules of their own.
  struct Rule {
    Operation op;
    Ref (Builder::*make)(Ref);
  };
  static constexpr Rule kRules[] = {
      {Operation::sqrt, &Builder::square_root}, {Operation::sin, &Builder::sine},
      {Operation::cos, &Builder::cosine},       {Operation::tan, &Builder::tangent},
      {Operation::asin, &Builder::arcsine},     {Operation::acos, &Builder::arccosine},
      {Operation::atan, &Builder::arctangent},  {Operation::exp, &Builder::exponential},
      {Operation::log, &Builder::logarithm},    {Operation::abs, &Builder::absolute},
      {Operation::sign, &Builder::signum}};
  for (const Rule& rule : kRules)
    if (rule.op == op) return (this->*rule.make)(x);
  if (is_call(op) && operand_count(op) == 1) return any_function(op, x);
  throw std::logic_error("not a function of one operand");
}

// sqrt(n/d) = square/d * sqrt(rest), where rest has no square factor left.
Ref Builder::root_of_rational(Rational x) {
  const auto whole = mul(Rational(x.numerator), Rational(x.denominator));
  if (!whole) {
    const std::int64_t n = integer_root(x.numerator), d = integer_root(x.denominator);
    if (n * n == x.numerator && d * d == x.denominator) return number(Rational(n, d));
    return intern(Operation::sqrt, number(x), Ref());
  }
  const SquareFactor found = square_factor(whole->numerator);
  const auto outside = make_rational(found.square, x.denominator);
  const Ref factor = number(*outside);
  if (found.rest == 1) return factor;
  const Ref root = intern(Operation::sqrt, number(found.rest), Ref());
  return product(factor, root);
}

Ref Builder::square_root(Ref x) {
  if (x == kZero || x == kOne) return x;
  if (constant(x)) {
    if (graph.bounds(x).upper < 0) not_defined("square root of a negative constant");
    if (rational(x)) return root_of_rational(rational_of(x));
    if (op(x) == Operation::real) return real(std::sqrt(numeric_value(x)));
  }
  const Node n = node(x);
  if (x.negative() || too_deep()) return intern(Operation::sqrt, x, Ref());
  if (n.op == Operation::mul) {
    if (n.a == n.b) return absolute(n.a);
    if (constant(n.a) && graph.bounds(n.a).lower > 0) {
      const Ref outside = square_root(n.a);
      const Ref inside = square_root(n.b);
      return product(outside, inside);
    }
    for (const bool first : {true, false}) {
      const Ref square = first ? n.a : n.b, rest = first ? n.b : n.a;
      if (op(square) != Operation::mul || node(square).a != node(square).b) continue;
      const Ref outside = absolute(node(square).a);
      const Ref inside = function(Operation::sqrt, rest);
      return product(outside, inside);
    }
  }
  if (n.op == Operation::div) {
    const bool square_below = op(n.b) == Operation::mul && node(n.b).a == node(n.b).b;
    const bool number_above = rational(n.a);
    if (square_below || (number_above && n.a != kOne)) {
      const Ref above = function(Operation::sqrt, n.a);
      if (square_below) return quotient(above, absolute(node(n.b).a));
      const Ref rest = intern(Operation::sqrt, intern(Operation::div, kOne, n.b), Ref());
      return product(above, rest);
    }
  }
  return intern(Operation::sqrt, x, Ref());
}

Ref Builder::absolute(Ref x) {
  x = magnitude(x);
  const Interval range = graph.bounds(x);
  if (range.lower >= 0) return x;
  if (range.upper <= 0) return -x;
  const Node n = node(x);
  if (n.op == Operation::mul && constant(n.a) && !n.constant) {
    const Ref factor = absolute(n.a);
    const Ref rest = absolute(n.b);
    return product(factor, rest);
  }
  if (n.op == Operation::real) return x;
  return intern(Operation::abs, x, Ref());
}

Ref Builder::signum(Ref x) {
  if (x == kZero) return kZero;
  const bool negative = x.negative();
  x = magnitude(x);
  const Interval range = graph.bounds(x);
  if (range.lower > 0) return signed_as(kOne, negative);
  if (range.upper < 0) return signed_as(kOne, !negative);
  const Node n = node(x);
  if (n.op == Operation::mul && constant(n.a)) {
    const Interval factor = graph.bounds(n.a);
    if (factor.lower > 0) return signed_as(signum(n.b), negative);
    if (factor.upper < 0) return signed_as(signum(n.b), !negative);
  }
  return signed_as(intern(Operation::sign, x, Ref()), negative);
}

// Conditions lose positive factors, choices their sign, and a choice among what is chosen already by the same
// condition is none.
Ref Builder::choice(Operation wanted, Ref condition, Ref x) {
  if (x == kZero) return kZero;
  const bool negative = x.negative();
  x = magnitude(x);
  for (Node n = node(condition); n.op == Operation::mul && graph.bounds(n.a).lower > 0 && constant(n.a);
       n = node(condition))
    condition = signed_as(n.b, condition.negative());
  const bool if_positive = wanted == Operation::if_positive;
  const Interval range = graph.bounds(condition);
  if (range.lower > 0) return if_positive ? signed_as(x, negative) : kZero;
  if (range.upper <= 0) return if_positive ? kZero : signed_as(x, negative);
  const auto chosen = [&](Ref part) { return is_choice(op(part)) && node(part).a == condition; };
  const Node n = node(x);
  for (const Ref part : {x, n.op == Operation::mul ? n.a : x, n.op == Operation::mul ? n.b : x}) {
    if (!chosen(part)) continue;
    return op(part) == wanted ? signed_as(x, negative) : kZero;
  }
  return signed_as(intern(wanted, condition, x), negative);
}

bool Builder::may_lack_value(Ref x) const {
  // Longer ones are taken to lack one: to take in what has a value changes nothing.
  int left = 64;
  const auto lacks = [&](const auto& self, Ref of) -> bool {
    const Node& n = node(of);
    if (n.constant || n.arity() == 0 || is_choice(n.op)) return false;
    if (--left < 0) return true;
    if (self(self, n.a) || (n.arity() > 1 && self(self, n.b))) return true;
    return graph.may_leave_domain(n);
  };
  return lacks(lacks, x);
}

Ref Builder::exponential(Ref x) {
  if (x == kZero) return kOne;
  if (op(x) == Operation::log && !x.negative()) return node(x).a;
  if (op(x) == Operation::real) return real(std::exp(numeric_value(x)));
  return intern(Operation::exp, x, Ref());
}

Ref Builder::logarithm(Ref x) {
  if (x == kOne) return kZero;
  if (x == kZero) not_defined("logarithm of zero");
  if (constant(x) && graph.bounds(x).upper < 0) not_defined("logarithm of a negative constant");
  if (op(x) == Operation::exp && !x.negative()) return node(x).a;
  if (op(x) == Operation::real) return real(std::log(numeric_value(x)));
  return intern(Operation::log, x, Ref());
}

// What holds for any function: its parity, numbers, and 0.
Ref Builder::any_function(Operation wanted, Ref x) {
  if (x == kZero) {
    const double value = apply(wanted, 0.0, 0.0);
    if (value == 0 || value == 1) return value == 0 ? kZero : kOne;
  }
  const bool signless = parity(wanted) != Parity::none;
  const bool negative = x.negative() && parity(wanted) == Parity::odd;
  if (signless) x = magnitude(x);
  const Ref out =
      op(x) == Operation::real ? real(apply(wanted, numeric_value(x), 0.0)) : intern(wanted, x, Ref());
  return signed_as(out, negative);
}

Ref Builder::integer_power(Ref x, std::int64_t n) {
  if (n == 0) return kOne;
  const bool below = n < 0;
  if (below && x == kZero) not_defined("division by zero");
  std::uint64_t left = below ? 0 - static_cast<std::uint64_t>(n) : static_cast<std::uint64_t>(n);
  Ref square = x, out = kOne;
  for (; left != 0; left >>= 1) {
    if ((left & 1) != 0) out = product(out, square);
    if (left > 1) square = product(square, square);
  }
  return below ? quotient(kOne, out) : out;
}

Ref Builder::power(Ref x, Ref y) {
  if (y == kZero || x == kOne) return kOne;
  if (y == kOne) return x;
  if (rational(y)) {
    const Rational exponent = rational_of(y);
    if (exponent.denominator == 1) return integer_power(x, exponent.numerator);
    if (exponent.denominator == 2) return integer_power(function(Operation::sqrt, x), exponent.numerator);
  }
  if (x == kZero) {
    const Interval range = graph.bounds(y);
    if (range.lower > 0) return kZero;
    if (range.upper < 0) not_defined("division by zero");
  }
  if (constant(x) && graph.bounds(x).upper < 0)
    not_defined("power of a negative constant with an exponent that is no integer");
  if (numeric(x) && numeric(y) && (op(x) == Operation::real || op(y) == Operation::real)) {
    return real(std::pow(numeric_value(x), numeric_value(y)));
  }
  return intern(Operation::pow, x, y);
}

}  // namespace alembert
