// Interval arithmetic, rounded outward. In: intervals that hold the operands. Out: one that certainly holds the
// result.
#pragma once

#include <cmath>

namespace alembert {

/// A closed interval known to contain a value; used to prove signs.
struct Interval {
  double lower, upper;
};

namespace interval {

inline constexpr double kInfinity = HUGE_VAL;
inline constexpr double kPi = 3.14159265358979323846;
inline constexpr Interval kWhole{-kInfinity, kInfinity};

/// The next double below, and above.
inline double down(double x) {
  return std::nextafter(x, -kInfinity);
}
inline double up(double x) {
  return std::nextafter(x, kInfinity);
}
/// From the values of a function that grows, of the C library, whose rounding error is below two units.
Interval widened(double lower, double upper);

Interval negated(Interval x);
Interval sum(Interval x, Interval y);
Interval product(Interval x, Interval y);
Interval square(Interval x);
Interval reciprocal(Interval x);
Interval root(Interval x);
Interval absolute(Interval x);
/// The smallest interval that holds x and 0.
Interval with_zero(Interval x);
Interval power(Interval x, Interval y);
/// The cosine, or the sine.
Interval wave(bool cosine, Interval x);

}  // namespace interval
}  // namespace alembert
