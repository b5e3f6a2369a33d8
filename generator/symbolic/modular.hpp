// The field with p^2 elements, p = 2^61 - 1: arithmetic on re + im*i with i^2 = -1, which is a field because
// p = 3 mod 4. In and out: reduced elements.
#pragma once

#include <cstdint>
#include <optional>

#include "symbolic/rational.hpp"

namespace alembert {

/// An element re + im*i of the field with p^2 elements, p = 2^61 - 1, i^2 = -1.
struct Modular {
  std::uint64_t re = 0, im = 0;
  friend bool operator==(const Modular&, const Modular&) = default;
};

namespace modular {

__extension__ typedef unsigned __int128 Wide;

inline constexpr std::uint64_t kPrime = (std::uint64_t{1} << 61) - 1;

constexpr std::uint64_t reduce(std::uint64_t x) {
  x = (x & kPrime) + (x >> 61);
  return x >= kPrime ? x - kPrime : x;
}
constexpr std::uint64_t add(std::uint64_t x, std::uint64_t y) {
  const std::uint64_t s = x + y;
  return s >= kPrime ? s - kPrime : s;
}
constexpr std::uint64_t negate(std::uint64_t x) {
  return x == 0 ? 0 : kPrime - x;
}
constexpr std::uint64_t subtract(std::uint64_t x, std::uint64_t y) {
  return x >= y ? x - y : x + kPrime - y;
}
constexpr std::uint64_t multiply(std::uint64_t x, std::uint64_t y) {
  const Wide p = static_cast<Wide>(x) * y;
  const std::uint64_t s = (static_cast<std::uint64_t>(p) & kPrime) + static_cast<std::uint64_t>(p >> 61);
  return s >= kPrime ? s - kPrime : s;
}
constexpr std::uint64_t power(std::uint64_t x, std::uint64_t n) {
  std::uint64_t out = 1;
  for (; n != 0; n >>= 1, x = multiply(x, x)) {
    if ((n & 1) != 0) out = multiply(out, x);
  }
  return out;
}
/// 1/x; 0 for 0.
constexpr std::uint64_t inverse(std::uint64_t x) {
  // Extended Euclid: about 35 steps where Fermat's power takes 120 products.
  std::int64_t u = 0, v = 1;
  std::uint64_t a = kPrime, b = x;
  while (b != 0) {
    const std::uint64_t q = a / b;
    const std::uint64_t rest = a - q * b;
    const std::int64_t next = u - static_cast<std::int64_t>(q) * v;
    a = b;
    b = rest;
    u = v;
    v = next;
  }
  return u < 0 ? kPrime - static_cast<std::uint64_t>(-u) : static_cast<std::uint64_t>(u);
}
constexpr std::uint64_t halve(std::uint64_t x) {
  return (x & 1) == 0 ? x / 2 : (x + kPrime) / 2;
}

/// x with its bits mixed.
constexpr std::uint64_t scramble(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// The root of x or, if x is no square, of -x (then `imaginary`), the smaller of the two.
struct Root {
  std::uint64_t value;
  bool imaginary;
};
constexpr Root root(std::uint64_t x) {
  std::uint64_t r = x;  // x^((p+1)/4) = x^(2^59)
  for (int i = 0; i < 59; ++i) r = multiply(r, r);
  const bool imaginary = multiply(r, r) != x;
  return {r < kPrime - r ? r : negate(r), imaginary};
}

inline Modular add(Modular x, Modular y) {
  return {add(x.re, y.re), add(x.im, y.im)};
}
inline Modular negate(Modular x) {
  return {negate(x.re), negate(x.im)};
}
inline Modular multiply(Modular x, Modular y) {
  if (x.im == 0 && y.im == 0) return {multiply(x.re, y.re), 0};
  return {subtract(multiply(x.re, y.re), multiply(x.im, y.im)),
          add(multiply(x.re, y.im), multiply(x.im, y.re))};
}
inline bool is_zero(Modular x) {
  return x.re == 0 && x.im == 0;
}
/// 1/x; 0 for 0.
inline Modular inverse(Modular x) {
  if (x.im == 0) return {inverse(x.re), 0};
  const std::uint64_t scale = inverse(add(multiply(x.re, x.re), multiply(x.im, x.im)));
  return {multiply(x.re, scale), multiply(negate(x.im), scale)};
}
/// Exactly one of x and -x is upper, unless x is 0.
inline bool is_upper(Modular x) {
  return x.re != 0 ? x.re > kPrime / 2 : x.im > kPrime / 2;
}
/// A root of x (of x and -x the one that is not upper), if x has one.
std::optional<Modular> root(Modular x);

/// A number as an element of the field.
Modular from_rational(Rational x);

}  // namespace modular
}  // namespace alembert
