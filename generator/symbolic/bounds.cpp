// Interval bounds of expressions. In: a handle, and what is assumed of symbols. Out: an interval that
// certainly holds the value, by outward rounded interval arithmetic over the operands; used to prove signs.
#include <algorithm>
#include <cmath>

#include "symbolic/expr.hpp"

namespace alembert {
namespace {

constexpr double kInfinity = HUGE_VAL;
constexpr Interval kWhole{-kInfinity, kInfinity};
constexpr double kPi = 3.14159265358979323846;

double down(double x) {
  return std::nextafter(x, -kInfinity);
}
double up(double x) {
  return std::nextafter(x, kInfinity);
}

// Sums and products round outward only where they are not exact, so that bounds such as 0 survive.
double add_down(double x, double y) {
  const double s = x + y;
  if (std::isnan(s)) return -kInfinity;
  if (std::isinf(s)) return s < 0 || std::isinf(x) || std::isinf(y) ? s : down(s);
  const double part = s - x;
  return (x - (s - part)) + (y - part) < 0 ? down(s) : s;
}
double add_up(double x, double y) {
  return -add_down(-x, -y);
}

double mul_down(double x, double y) {
  if (x == 0 || y == 0) return 0;
  const double p = x * y;
  if (std::isinf(p)) return std::isinf(x) || std::isinf(y) || p < 0 ? p : down(p);
  constexpr double kTiny = 1e-290;  // below it the error of a product is not a double
  if (std::abs(p) < kTiny) return p > 0 && down(p) < 0 ? 0 : down(p);
  return std::fma(x, y, -p) < 0 ? down(p) : p;
}
double mul_up(double x, double y) {
  return -mul_down(-x, y);
}

Interval negated(Interval x) {
  return {-x.upper, -x.lower};
}
Interval ordered(double lower, double upper) {
  if (std::isnan(lower) || std::isnan(upper) || lower > upper) return kWhole;
  return {lower, upper};
}
// Around a library function of rounding error below two units.
Interval widened(double lower, double upper) {
  return ordered(down(down(lower)), up(up(upper)));
}

Interval sum(Interval x, Interval y) {
  return ordered(add_down(x.lower, y.lower), add_up(x.upper, y.upper));
}

Interval product(Interval x, Interval y) {
  const double lower = std::min({mul_down(x.lower, y.lower), mul_down(x.lower, y.upper),
                                 mul_down(x.upper, y.lower), mul_down(x.upper, y.upper)});
  const double upper = std::max({mul_up(x.lower, y.lower), mul_up(x.lower, y.upper), mul_up(x.upper, y.lower),
                                 mul_up(x.upper, y.upper)});
  return ordered(lower, upper);
}

Interval square(Interval x) {
  const Interval all = product(x, x);
  if (x.lower >= 0 || x.upper <= 0) return all;
  return {0, all.upper};
}

Interval reciprocal(Interval x) {
  if (x.lower < 0 && x.upper > 0) return kWhole;
  if (x.lower == 0 && x.upper == 0) return kWhole;
  if (x.lower >= 0) {
    const double lower = std::isinf(x.upper) ? 0 : std::max(0.0, down(1 / x.upper));
    return {lower, x.lower == 0 ? kInfinity : up(1 / x.lower)};
  }
  return negated(reciprocal(negated(x)));
}

Interval root(Interval x) {
  const double lower = x.lower <= 0 ? 0 : std::max(0.0, down(std::sqrt(x.lower)));
  return ordered(lower, x.upper <= 0 ? 0 : up(std::sqrt(x.upper)));
}

// sin and cos: the values at the ends, and 1 or -1 where the interval may hold a crest or a trough.
Interval wave(bool cosine, Interval x) {
  if (!(x.upper - x.lower < 6) || std::abs(x.lower) > 1e6) return {-1, 1};
  // Crests of cos are at even multiples of pi, of sin a quarter turn further; in half turns:
  const double shift = cosine ? 0 : 0.5, slack = 1e-9;
  const double from = x.lower / kPi - shift - slack, to = x.upper / kPi - shift + slack;
  const bool crest = std::floor(to / 2) >= std::ceil(from / 2);
  const bool trough = std::floor((to - 1) / 2) >= std::ceil((from - 1) / 2);
  const double a = cosine ? std::cos(x.lower) : std::sin(x.lower);
  const double b = cosine ? std::cos(x.upper) : std::sin(x.upper);
  const double margin = 1e-15;
  return {trough ? -1 : std::max(-1.0, std::min(a, b) - margin),
          crest ? 1 : std::min(1.0, std::max(a, b) + margin)};
}

Interval absolute(Interval x) {
  if (x.lower >= 0) return x;
  if (x.upper <= 0) return negated(x);
  return {0, std::max(-x.lower, x.upper)};
}

Interval power(Interval x, Interval y) {
  if (!(x.lower > 0)) return x.lower >= 0 ? Interval{0, kInfinity} : kWhole;
  if (x.lower != x.upper || y.lower != y.upper) return {0, kInfinity};
  const double value = std::pow(x.lower, y.lower);
  return {std::max(0.0, value * (1 - 1e-12)), value * (1 + 1e-12)};
}

}  // namespace

Interval ExprGraph::bounds(Ref x) const {
  const auto of_leaf = [this](std::uint32_t id) -> Interval {
    const Node& n = nodes_[id];
    if (n.op == Op::symbol) return symbols_[n.a.bits].interval;
    if (n.op == Op::real) return {real_value(id), real_value(id)};
    const Rational r = rational_value(id);
    constexpr std::int64_t kExact = std::int64_t{1} << 53;
    const double value = r.to_double();
    const bool exact = r.numerator <= kExact && (r.denominator & (r.denominator - 1)) == 0;
    const Interval plain = exact ? Interval{value, value} : Interval{down(value), up(value)};
    return n.op == Op::rational ? plain : product(plain, {kPi, up(kPi)});
  };
  const auto leaf = [this](std::uint32_t id) { return nodes_[id].arity() == 0; };
  const auto known = [&](Ref r) -> Interval {
    const Interval range = leaf(r.node()) ? of_leaf(r.node()) : bounds_.find(r.node())->second;
    return r.negative() ? negated(range) : range;
  };
  const auto of_node = [&](const Node& n) -> Interval {
    const Interval a = known(n.a);
    switch (n.op) {
      case Op::add:
        return sum(a, known(n.b));
      case Op::mul:
        return n.a == n.b ? square(a) : product(a, known(n.b));
      case Op::div:
        return product(a, reciprocal(known(n.b)));
      case Op::sqrt:
        return root(a);
      case Op::sin:
        return wave(false, a);
      case Op::cos:
        return wave(true, a);
      case Op::tan:
        // The pole of a branch lies half a period from its centre; only one branch is looked at.
        if (a.lower > -1.57 && a.upper < 1.57) return widened(std::tan(a.lower), std::tan(a.upper));
        return kWhole;
      case Op::asin:
        return widened(std::asin(std::max(-1.0, a.lower)), std::asin(std::min(1.0, a.upper)));
      case Op::acos: {
        const Interval range = widened(std::acos(std::min(1.0, a.upper)), std::acos(std::max(-1.0, a.lower)));
        return {std::max(0.0, range.lower), range.upper};
      }
      case Op::atan:
        return widened(std::atan(a.lower), std::atan(a.upper));
      case Op::atan2:
        return {a.lower >= 0 ? 0 : -up(kPi), up(kPi)};
      case Op::exp:
        return {std::max(0.0, down(down(std::exp(a.lower)))), up(up(std::exp(a.upper)))};
      case Op::log:
        return widened(a.lower > 0 ? std::log(a.lower) : -kInfinity,
                       a.upper > 0 ? std::log(a.upper) : kInfinity);
      case Op::abs:
        return absolute(a);
      case Op::sign:
        return {a.lower > 0 ? 1.0 : a.lower >= 0 ? 0.0 : -1.0, a.upper < 0 ? -1.0 : a.upper <= 0 ? 0.0 : 1.0};
      case Op::sinh:
        return widened(std::sinh(a.lower), std::sinh(a.upper));
      case Op::cosh: {
        const Interval size = absolute(a);
        return {std::max(1.0, down(down(std::cosh(size.lower)))), up(up(std::cosh(size.upper)))};
      }
      case Op::tanh:
        return {std::max(-1.0, down(down(std::tanh(a.lower)))), std::min(1.0, up(up(std::tanh(a.upper))))};
      case Op::pow:
        return power(a, known(n.b));
      case Op::rational:
      case Op::pi_multiple:
      case Op::real:
      case Op::symbol:
        return kWhole;
    }
    return kWhole;
  };

  if (!leaf(x.node()) && bounds_.find(x.node()) == bounds_.end()) {
    std::vector<std::uint32_t> open{x.node()};
    while (!open.empty()) {
      const std::uint32_t id = open.back();
      const Node& n = nodes_[id];
      const std::size_t before = open.size();
      for (const Ref operand : {n.a, n.b}) {
        if (!leaf(operand.node()) && bounds_.find(operand.node()) == bounds_.end())
          open.push_back(operand.node());
      }
      if (open.size() != before) continue;
      open.pop_back();
      bounds_.emplace(id, of_node(n));
    }
  }
  return known(x);
}

}  // namespace alembert
