// Arithmetic modulo the prime p = 2^61 - 1, and in its extension by a square root of -1, where sums over
// paths are compared and fingerprinted. In: reduced numbers. Out: reduced numbers.
#pragma once

#include <cstdint>

#include "symbolic/passes.hpp"

namespace alembert::modulo {

inline constexpr std::uint64_t kPrime = (std::uint64_t{1} << 61) - 1;
__extension__ using Wide = unsigned __int128;

constexpr std::uint64_t add(std::uint64_t x, std::uint64_t y) {
  const std::uint64_t sum = x + y;
  return sum >= kPrime ? sum - kPrime : sum;
}
constexpr std::uint64_t sub(std::uint64_t x, std::uint64_t y) {
  return add(x, kPrime - y);
}
constexpr std::uint64_t mul(std::uint64_t x, std::uint64_t y) {
  const Wide product = static_cast<Wide>(x) * y;
  const auto low = static_cast<std::uint64_t>(product & kPrime);
  return add(low, static_cast<std::uint64_t>(product >> 61));
}
/// 1/x; zero for zero.
constexpr std::uint64_t inverse(std::uint64_t x) {
  std::uint64_t result = 1;
  for (std::uint64_t exponent = kPrime - 2; exponent != 0; exponent >>= 1, x = mul(x, x))
    if ((exponent & 1) != 0) result = mul(result, x);
  return result;
}

constexpr Modular add(Modular x, Modular y) {
  return {add(x.re, y.re), add(x.im, y.im)};
}
constexpr Modular mul(Modular x, Modular y) {
  return {sub(mul(x.re, y.re), mul(x.im, y.im)), add(mul(x.re, y.im), mul(x.im, y.re))};
}

}  // namespace alembert::modulo
