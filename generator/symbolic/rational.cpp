// Exact rational arithmetic. In: 64-bit fractions, doubles, decimal text. Out: fractions in lowest terms, or
// nothing where the result does not fit.
#include "symbolic/rational.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>

namespace alembert {
namespace {

__extension__ typedef __int128 Wide;
__extension__ typedef unsigned __int128 UnsignedWide;

UnsignedWide magnitude(Wide x) {
  return x < 0 ? -static_cast<UnsignedWide>(x) : static_cast<UnsignedWide>(x);
}

UnsignedWide greatest_common_divisor(UnsignedWide x, UnsignedWide y) {
  constexpr UnsignedWide kSmall = std::numeric_limits<std::uint64_t>::max();
  while (y != 0) {
    if (x <= kSmall && y <= kSmall) {
      return std::gcd(static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(y));
    }
    const UnsignedWide rest = x % y;
    x = y;
    y = rest;
  }
  return x;
}

std::optional<Rational> reduced(Wide n, Wide d) {
  if (d == 0) return std::nullopt;
  const bool negative = (n < 0) != (d < 0);
  UnsignedWide un = magnitude(n), ud = magnitude(d);
  const UnsignedWide divisor = greatest_common_divisor(un, ud);
  un /= divisor;
  ud /= divisor;
  constexpr UnsignedWide kLargest = std::numeric_limits<std::int64_t>::max();
  if (un > kLargest || ud > kLargest) return std::nullopt;
  const std::int64_t value = static_cast<std::int64_t>(un);
  return Rational(negative ? -value : value, static_cast<std::int64_t>(ud));
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// digits * 10^exponent
std::optional<Rational> scaled(std::int64_t digits, long exponent) {
  if (digits == 0) return Rational(0);
  if (exponent > 18 || exponent < -36) return std::nullopt;
  Wide n = digits, d = 1;
  for (; exponent > 0; --exponent) n *= 10;
  for (; exponent < 0; ++exponent) d *= 10;
  return reduced(n, d);
}

}  // namespace

double Rational::to_double() const {
  if (numerator == 0) return 0;
  // Quotient of 63 or 64 bits whose last bit tells whether anything was cut off: its one rounding is the
  // right one.
  const std::uint64_t n = static_cast<std::uint64_t>(numerator < 0 ? -numerator : numerator);
  const std::uint64_t d = static_cast<std::uint64_t>(denominator);
  const int shift = 63 - static_cast<int>(std::bit_width(n)) + static_cast<int>(std::bit_width(d));
  const UnsignedWide dividend = static_cast<UnsignedWide>(n) << shift;
  std::uint64_t quotient = static_cast<std::uint64_t>(dividend / d);
  if (dividend % d != 0) quotient |= 1;
  const double value = std::ldexp(static_cast<double>(quotient), -shift);
  return numerator < 0 ? -value : value;
}

std::optional<Rational> make_rational(std::int64_t n, std::int64_t d) {
  return reduced(n, d);
}

std::optional<Rational> add(Rational x, Rational y) {
  const Wide left = static_cast<Wide>(x.numerator) * y.denominator;
  const Wide right = static_cast<Wide>(y.numerator) * x.denominator;
  return reduced(left + right, static_cast<Wide>(x.denominator) * y.denominator);
}

std::optional<Rational> mul(Rational x, Rational y) {
  return reduced(static_cast<Wide>(x.numerator) * y.numerator,
                 static_cast<Wide>(x.denominator) * y.denominator);
}

std::optional<Rational> div(Rational x, Rational y) {
  return reduced(static_cast<Wide>(x.numerator) * y.denominator,
                 static_cast<Wide>(x.denominator) * y.numerator);
}

std::optional<Rational> rational_from_double(double value) {
  if (!std::isfinite(value)) return std::nullopt;
  constexpr double kExactIntegers = 9007199254740992.0;  // 2^53
  for (std::int64_t d = 1; d <= 1024; d *= 2) {
    const double n = value * static_cast<double>(d);
    if (n == std::floor(n) && std::abs(n) <= kExactIntegers) return reduced(static_cast<Wide>(n), d);
  }
  // Otherwise the shortest decimal that reads back as this double, if it is short enough to have been meant.
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific);
  if (error != std::errc()) return std::nullopt;
  int digits = 0;
  for (const char* c = text; c != end && *c != 'e'; ++c) digits += is_digit(*c) ? 1 : 0;
  if (digits > 15) return std::nullopt;
  const std::optional<Rational> exact = rational_from_decimal(text, end);
  return exact && exact->to_double() == value ? exact : std::nullopt;
}

std::optional<Rational> rational_from_decimal(const char* begin, const char* end) {
  const char* c = begin;
  bool negative = false;
  if (c != end && (*c == '+' || *c == '-')) negative = *c++ == '-';
  std::int64_t digits = 0;
  long exponent = 0,
       held_zeros = 0;  // zeros are only multiplied in when a digit follows: 1.5000 has two digits
  bool any = false, point = false, fits = true;
  for (; c != end && (is_digit(*c) || (*c == '.' && !point)); ++c) {
    if (*c == '.') {
      point = true;
      continue;
    }
    any = true;
    if (point) --exponent;
    if (*c == '0') {
      if (digits != 0) ++held_zeros;
      continue;
    }
    for (long i = 0; i <= held_zeros && fits; ++i) {
      fits = !__builtin_mul_overflow(digits, std::int64_t{10}, &digits);
    }
    held_zeros = 0;
    fits = fits && !__builtin_add_overflow(digits, std::int64_t{*c - '0'}, &digits);
  }
  if (!any) return std::nullopt;
  if (c != end && (*c == 'e' || *c == 'E')) {
    ++c;
    bool down = false;
    if (c != end && (*c == '+' || *c == '-')) down = *c++ == '-';
    if (c == end) return std::nullopt;
    long given = 0;
    for (; c != end && is_digit(*c); ++c) given = std::min(given * 10 + (*c - '0'), 1000000L);
    exponent += down ? -given : given;
  }
  if (c != end || !fits) return std::nullopt;
  return scaled(negative ? -digits : digits, exponent + held_zeros);
}

}  // namespace alembert
