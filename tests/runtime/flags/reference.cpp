// Sines, cosines and comparisons for flags_test.cpp, compiled without the flags under test.
#include "reference.hpp"

#include <cmath>
#include <cstring>

long double exact_sine(double x) {
  return std::sin(static_cast<long double>(x));
}
long double exact_cosine(double x) {
  return std::cos(static_cast<long double>(x));
}
bool is_a_nan(double x) {
  return std::isnan(x);
}
double error_in_ulp(double found, long double exact) {
  if (std::isnan(found)) return HUGE_VAL;
  int exponent = 0;
  static_cast<void>(std::frexp(exact, &exponent));
  return static_cast<double>(std::fabs(static_cast<long double>(found) - exact) /
                             std::ldexp(1.0L, exponent < -1021 ? -1074 : exponent - 53));
}
double not_a_number() {
  return std::nan("");
}
double infinity() {
  return HUGE_VAL;
}
