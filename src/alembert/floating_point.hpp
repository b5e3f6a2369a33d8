// What options such as -ffast-math must not take away. In: numbers. Out: whether they are finite, told from
// their bits, and a macro that keeps a rounded value as it is.
//
// Under -ffast-math (-Ofast, -ffinite-math-only, -fassociative-math) a compiler takes std::isfinite(x) for
// true and (a + b) - a for b. This library does not need those options to be off: what depends on rounding or
// on NaN is written with what follows.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

// ALEMBERT_AS_ROUNDED(x) tells the compiler nothing about how x, a variable of double or of a vector of them,
// came about: sums before and after are not rearranged into each other. Not an instruction. A macro, since
// what is compiled for one set of instructions must share no function with other files.
#if defined(__GNUC__) && defined(__SSE2__)
#define ALEMBERT_AS_ROUNDED(x) __asm__("" : "+v"(x))
#elif defined(__GNUC__) && defined(__aarch64__)
#define ALEMBERT_AS_ROUNDED(x) __asm__("" : "+w"(x))
#elif defined(__GNUC__)
#define ALEMBERT_AS_ROUNDED(x) __asm__("" : "+m"(x))
#elif defined(_M_FP_FAST)
#error \
    "alembert needs /fp:precise of this compiler: with /fp:fast, results that are not finite are not noticed"
#else
#define ALEMBERT_AS_ROUNDED(x) static_cast<void>(0)
#endif

// The same for an integer.
#if defined(__GNUC__)
#define ALEMBERT_AS_READ(x) __asm__("" : "+r"(x))
#else
#define ALEMBERT_AS_READ(x) static_cast<void>(0)
#endif

namespace alembert {
namespace detail {

/// The first 32 bits: sign, exponent, and some of the digits. Where they come from, the compiler is not to
/// know.
inline std::uint32_t high_bits(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  std::uint32_t high = static_cast<std::uint32_t>(bits >> 32);
  ALEMBERT_AS_READ(high);
  return high;
}
inline std::uint32_t high_bits(float x) {
  std::uint32_t high;
  std::memcpy(&high, &x, sizeof high);
  ALEMBERT_AS_READ(high);
  return high;
}

/// Neither infinite nor a NaN.
inline bool is_finite(double x) {
  return (high_bits(x) & 0x7ff00000U) != 0x7ff00000U;
}
inline bool is_finite(float x) {
  return (high_bits(x) & 0x7f800000U) != 0x7f800000U;
}

/// All of n numbers, which are read as bits: that they are numbers, the compiler is not to know.
inline bool all_finite(std::size_t n, const double* x) {
  ALEMBERT_AS_READ(x);
  constexpr std::uint64_t kExponent = 0x7ff0000000000000U, kOne = 0x0010000000000000U;
  std::uint64_t found = 0;
  for (std::size_t i = 0; i < n; ++i) {
    std::uint64_t bits;
    std::memcpy(&bits, x + i, sizeof bits);
    found |= (bits & kExponent) + kOne;
  }
  return found >> 63 == 0;
}

/// Of other scalar types, as <cmath> or their own isfinite says.
template <class S>
bool is_finite(const S& x) {
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
  static_assert(
      !std::is_same<S, long double>::value,
      "with -ffast-math nobody can tell whether a long double is finite: add -fno-finite-math-only");
#endif
  using std::isfinite;
  return isfinite(x);
}
template <class S>
bool all_finite(std::size_t n, const S* x) {
  for (std::size_t i = 0; i < n; ++i)
    if (!is_finite(x[i])) return false;
  return true;
}

/// Finite or +infinity: a bound, which nothing reaches if it is infinite.
template <class S>
bool is_bound(const S& x) {
  using std::isnan;
  return is_finite(x) || !isnan(x);
}
inline bool is_bound(double x) {
  return is_finite(x) || high_bits(x) == 0x7ff00000U;
}
inline bool is_bound(float x) {
  return is_finite(x) || high_bits(x) == 0x7f800000U;
}

}  // namespace detail
}  // namespace alembert
