// Rules of construction for trigonometric functions and their inverses. In: an angle or a ratio. Out: the
// result, with multiples of pi/2 taken out of angles, exact values at multiples of pi, and functions of
// inverse functions undone.
//
// An angle is brought to the form x + f pi, 0 <= f < 1/2, x unsigned, so that the sine and the cosine of
// angles that differ by quarter turns or a sign are the same two nodes.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "symbolic/builder.hpp"

namespace alembert {
namespace {

__extension__ typedef __int128 Wide;

constexpr Rational kHalf{1, 2}, kThird{1, 3}, kQuarter{1, 4}, kSixth{1, 6};

// x = whole * unit + rest, 0 <= rest < unit, for unit = 1 / parts.
struct Division {
  std::int64_t whole;
  Rational rest;
};

std::optional<Division> divide(Rational x, std::int64_t parts) {
  const Wide scaled = static_cast<Wide>(x.numerator) * parts;
  Wide whole = scaled / x.denominator;
  if (scaled % x.denominator < 0) --whole;
  // Only whole modulo 4 matters, but it must fit.
  if (whole > INT64_MAX / 2 || whole < INT64_MIN / 2) return std::nullopt;
  const std::int64_t count = static_cast<std::int64_t>(whole);
  const auto subtrahend = make_rational(-count, parts);
  if (!subtrahend) return std::nullopt;
  const auto rest = add(x, *subtrahend);
  if (!rest) return std::nullopt;
  return Division{count, *rest};
}

bool less(Rational x, Rational y) {
  return static_cast<Wide>(x.numerator) * y.denominator < static_cast<Wide>(y.numerator) * x.denominator;
}

Rational negated(Rational x) {
  return {-x.numerator, x.denominator};
}

}  // namespace

Builder::Angle Builder::angle(Ref x) {
  const Node n = node(x);
  if (n.op == Operation::pi_multiple) return {kZero, rational_of(magnitude(x)), x.negative()};
  if (n.op == Operation::add && op(n.a) == Operation::pi_multiple) {
    const Rational offset = rational_of(n.a);
    if (n.b.negative()) return {magnitude(n.b), negated(offset), !x.negative()};
    return {n.b, offset, x.negative()};
  }
  return {magnitude(x), Rational(0), x.negative()};
}

// sin(m pi), 0 <= m < 1/2.
Ref Builder::exact_sine(Rational m) {
  if (m.numerator == 0) return kZero;
  if (m == kSixth) return number(kHalf);
  if (m == kQuarter) return product(number(kHalf), function(Operation::sqrt, number(2)));
  if (m == kThird) return product(number(kHalf), function(Operation::sqrt, number(3)));
  if (less(kQuarter, m)) return intern(Operation::cos, pi(*add(kHalf, negated(m))), Ref());
  return intern(Operation::sin, pi(m), Ref());
}

Ref Builder::sine(Ref x) {
  return sine_or_cosine(false, x);
}
Ref Builder::cosine(Ref x) {
  return sine_or_cosine(true, x);
}

Ref Builder::sine_or_cosine(bool cosine, Ref x) {
  if (x == kZero) return cosine ? kOne : kZero;
  Angle turned = angle(x);
  bool negative = turned.negative && !cosine;
  if (turned.multiple.numerator != 0) {
    const auto parts = divide(turned.multiple, 2);
    if (!parts) {
      negative = x.negative() && !cosine;
      return signed_as(intern(cosine ? Operation::cos : Operation::sin, magnitude(x), Ref()), negative);
    }
    turned.multiple = parts->rest;
    // sin -> cos -> -sin -> -cos -> sin
    for (std::int64_t turns = parts->whole & 3; turns > 0; --turns) {
      if (cosine) negative = !negative;
      cosine = !cosine;
    }
    if (turned.rest == kZero) {
      if (!cosine) return signed_as(exact_sine(turned.multiple), negative);
      if (turned.multiple.numerator == 0) return signed_as(kOne, negative);
      if (less(turned.multiple, kQuarter) && turned.multiple != kSixth) {
        return signed_as(intern(Operation::cos, pi(turned.multiple), Ref()), negative);
      }
      return signed_as(exact_sine(*add(kHalf, negated(turned.multiple))), negative);
    }
  }
  const Ref argument = unsigned_angle(turned);
  const Node n = node(argument);
  if (!too_deep()) {
    Ref out;
    bool found = true;
    if (n.op == Operation::asin) {
      out = cosine ? complement_root(n.a, false) : n.a;
    } else if (n.op == Operation::acos) {
      out = cosine ? n.a : complement_root(n.a, false);
    } else if (n.op == Operation::atan) {
      out = quotient(cosine ? kOne : n.a, complement_root(n.a, true));
    } else if (n.op == Operation::atan2) {
      const Ref xx = product(n.b, n.b);
      const Ref yy = product(n.a, n.a);
      const Ref squares = sum(xx, yy);
      const Ref length = square_root(squares);
      out = quotient(cosine ? n.b : n.a, length);
    } else {
      found = false;
    }
    if (found) return signed_as(out, negative);
  }
  if (n.op == Operation::real) {
    const double value = numeric_value(argument);
    return signed_as(real(cosine ? std::cos(value) : std::sin(value)), negative);
  }
  return signed_as(intern(cosine ? Operation::cos : Operation::sin, argument, Ref()), negative);
}

Ref Builder::unsigned_angle(const Angle& angle) {
  return angle.multiple.numerator == 0 ? angle.rest : sum(pi(angle.multiple), angle.rest);
}

Ref Builder::complement_root(Ref x, bool plus) {
  const Ref square = product(x, x);
  return square_root(sum(kOne, plus ? square : -square));
}

Ref Builder::tangent(Ref x) {
  if (x == kZero) return kZero;
  Angle turned = angle(x);
  const bool negative = turned.negative;
  if (turned.multiple.numerator != 0) {
    const auto parts = divide(turned.multiple, 1);
    if (!parts) return signed_as(intern(Operation::tan, magnitude(x), Ref()), x.negative());
    turned.multiple = parts->rest;
    if (turned.rest == kZero) {
      Rational m = turned.multiple;
      if (m == kHalf) throw std::domain_error("tangent of a right angle");
      if (m.numerator == 0) return kZero;
      const bool mirrored = less(kHalf, m);
      if (mirrored) m = *add(Rational(1), negated(m));
      Ref out;
      if (m == kQuarter) {
        out = kOne;
      } else if (m == kThird || m == kSixth) {
        out = function(Operation::sqrt, number(3));
        if (m == kSixth) out = product(number(kThird), out);
      } else {
        out = intern(Operation::tan, pi(m), Ref());
      }
      return signed_as(out, negative != mirrored);
    }
  }
  const Ref argument = unsigned_angle(turned);
  const Node n = node(argument);
  if (!too_deep()) {
    if (n.op == Operation::atan) return signed_as(n.a, negative);
    if (n.op == Operation::atan2) return signed_as(quotient(n.a, n.b), negative);
    if (n.op == Operation::asin) return signed_as(quotient(n.a, complement_root(n.a, false)), negative);
    if (n.op == Operation::acos) return signed_as(quotient(complement_root(n.a, false), n.a), negative);
  }
  if (n.op == Operation::real) return signed_as(real(std::tan(numeric_value(argument))), negative);
  return signed_as(intern(Operation::tan, argument, Ref()), negative);
}

Ref Builder::arcsine(Ref x) {
  if (x == kZero) return kZero;
  const bool negative = x.negative();
  x = magnitude(x);
  if (constant(x)) {
    const Interval range = graph.bounds(x);
    if (range.lower > 1 || range.upper < -1) throw std::domain_error("asin of a constant outside [-1, 1]");
    if (x == kOne) return signed_as(pi(kHalf), negative);
    if (rational(x) && rational_of(x) == kHalf) return signed_as(pi(kSixth), negative);
    if (op(x) == Operation::real) return signed_as(real(std::asin(numeric_value(x))), negative);
    if (x == exact_sine(kQuarter)) return signed_as(pi(kQuarter), negative);
    if (x == exact_sine(kThird)) return signed_as(pi(kThird), negative);
  }
  return signed_as(intern(Operation::asin, x, Ref()), negative);
}

Ref Builder::arccosine(Ref x) {
  if (constant(x)) {
    // acos(x) = pi/2 - asin(x) where that is exact.
    const Ref inverse = arcsine(x);
    if (inverse == kZero || op(inverse) == Operation::pi_multiple) return sum(pi(kHalf), -inverse);
    if (op(x) == Operation::real) return real(std::acos(numeric_value(x)));
  }
  return intern(Operation::acos, x, Ref());
}

Ref Builder::arctangent(Ref x) {
  if (x == kZero) return kZero;
  const bool negative = x.negative();
  x = magnitude(x);
  if (x == kOne) return signed_as(pi(kQuarter), negative);
  if (constant(x)) {
    if (op(x) == Operation::real) return signed_as(real(std::atan(numeric_value(x))), negative);
    const Ref root = function(Operation::sqrt, number(3));
    if (x == root) return signed_as(pi(kThird), negative);
    if (x == product(number(kThird), root)) return signed_as(pi(kSixth), negative);
  }
  return signed_as(intern(Operation::atan, x, Ref()), negative);
}

Ref Builder::arctangent2(Ref y, Ref x) {
  const Nested nested(*this);
  const Interval across = graph.bounds(x);
  if (y == kZero) {
    if (across.lower >= 0) return kZero;
    if (across.upper < 0) return pi(Rational(1));
    return intern(Operation::atan2, y, x);
  }
  const bool negative = y.negative();
  y = magnitude(y);
  if (constant(x) && constant(y)) {
    const Interval up = graph.bounds(y);
    const bool sure_up = up.lower > 0 || up.upper < 0;
    if (x == kZero && sure_up) return signed_as(pi(kHalf), negative != (up.upper < 0));
    if (op(x) == Operation::real || op(y) == Operation::real) {
      if (numeric(x) && numeric(y)) {
        return signed_as(real(std::atan2(numeric_value(y), numeric_value(x))), negative);
      }
    }
    // Through atan(y/x) where that is a multiple of pi.
    if (x != kZero && (across.lower > 0 || (across.upper < 0 && sure_up))) {
      const Ref inverse = arctangent(quotient(y, x));
      if (op(inverse) == Operation::pi_multiple) {
        Ref out = inverse;
        if (across.upper < 0) out = sum(inverse, up.lower > 0 ? pi(Rational(1)) : pi(Rational(-1)));
        return signed_as(out, negative);
      }
    }
  }
  return signed_as(intern(Operation::atan2, y, x), negative);
}

}  // namespace alembert
