// Exact rational numbers with 64-bit numerator and denominator; operations report overflow instead of
// wrapping.
#pragma once

#include <cstdint>
#include <optional>

namespace alembert {

/// numerator/denominator in lowest terms, denominator > 0. |numerator| stays below 2^63.
struct Rational {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;
  constexpr Rational() = default;
  constexpr explicit Rational(std::int64_t n) : numerator(n) {}
  constexpr Rational(std::int64_t n, std::int64_t d) : numerator(n), denominator(d) {}  // lowest terms, d > 0
  friend constexpr bool operator==(const Rational&, const Rational&) = default;
  constexpr bool negative() const { return numerator < 0; }
  double to_double() const;
};

std::optional<Rational> make_rational(std::int64_t n,
                                      std::int64_t d);  ///< reduced; nothing if d is 0 or on overflow
std::optional<Rational> add(Rational x, Rational y);
std::optional<Rational> mul(Rational x, Rational y);
std::optional<Rational> div(Rational x, Rational y);  ///< nothing if y is 0
/// The rational whose double is `value`, if its denominator is a power of two or ten small enough to be
/// exact.
std::optional<Rational> rational_from_double(double value);
/// Decimal text such as `0.4318` or `1.8e-3` exactly; nothing if it does not fit or is not a number.
std::optional<Rational> rational_from_decimal(const char* begin, const char* end);

}  // namespace alembert
