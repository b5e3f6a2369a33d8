// Roots and numbers in the field (see the header).
#include "symbolic/modular.hpp"

namespace alembert::modular {

namespace {

/// Of a number that the field has no element of its own for, as 2^61, which would be 1, any other element.
std::uint64_t element(std::uint64_t n) {
  return n < kPrime ? n : 2 + scramble(n) % (kPrime - 2);
}

}  // namespace

Modular from_rational(Rational x) {
  const std::uint64_t n = element(static_cast<std::uint64_t>(x.numerator < 0 ? -x.numerator : x.numerator));
  const std::uint64_t d = element(static_cast<std::uint64_t>(x.denominator));
  const std::uint64_t value = d == 1 ? n : multiply(n, inverse(d));
  return {x.numerator < 0 ? negate(value) : value, 0};
}

std::optional<Modular> root(Modular x) {
  if (x.im == 0) {
    const Root r = root(x.re);
    return r.imaginary ? Modular{0, r.value} : Modular{r.value, 0};
  }
  const Root norm = root(add(multiply(x.re, x.re), multiply(x.im, x.im)));
  if (norm.imaginary) return std::nullopt;
  // (u + v i)^2 = x with u^2 = (re +- norm)/2, v = im/(2u); exactly one of the two signs gives a square.
  Root u = root(halve(add(x.re, norm.value)));
  if (u.imaginary) u = root(halve(subtract(x.re, norm.value)));
  const Modular out{u.value, multiply(x.im, inverse(add(u.value, u.value)))};
  return is_upper(out) ? negate(out) : out;
}

}  // namespace alembert::modular
