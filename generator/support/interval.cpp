// Interval arithmetic (see the header).
#include "support/interval.hpp"

#include <algorithm>

namespace alembert::interval {
namespace {

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

Interval ordered(double lower, double upper) {
  if (std::isnan(lower) || std::isnan(upper) || lower > upper) return kWhole;
  return {lower, upper};
}

}  // namespace

Interval negated(Interval x) {
  return {-x.upper, -x.lower};
}
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

Interval with_zero(Interval x) {
  return {x.lower < 0 ? x.lower : 0, x.upper > 0 ? x.upper : 0};
}

Interval power(Interval x, Interval y) {
  if (!(x.lower > 0)) return x.lower >= 0 ? Interval{0, kInfinity} : kWhole;
  if (x.lower != x.upper || y.lower != y.upper) return {0, kInfinity};
  const double value = std::pow(x.lower, y.lower);
  return {std::max(0.0, value * (1 - 1e-12)), value * (1 + 1e-12)};
}

}  // namespace alembert::interval
