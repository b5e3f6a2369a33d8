// Sines and cosines of many angles by vector instructions. In: angles, rad. Out: results within 1 ulp of the
// exact values for all arguments (0.8 ulp was the largest seen), equal for an angle wherever it stands.
//
// On x86 the instructions (AVX-512, AVX2 with FMA, or those that the compiler may assume) are chosen at run
// time, so that nothing needs to be compiled for one machine. Angles above 1e5 and what is no number are left
// to the C library, one by one; so is everything where a compiler has no vector extensions. -ffast-math
// changes none of this.
#pragma once

#include <cmath>

#include "alembert/floating_point.hpp"

// Where doubles are computed with more digits than they have (x87), the vectors' arithmetic is not that of
// doubles.
#if defined(__GNUC__) && !(defined(__i386__) && !defined(__SSE2_MATH__))
#define ALEMBERT_TRIG_VECTORS 1
#if defined(__x86_64__) || defined(__i386__)
#define ALEMBERT_TRIG_X86 1
#endif
#endif

namespace alembert {
namespace detail {

#ifdef ALEMBERT_TRIG_VECTORS
#define ALEMBERT_TRIG_NAME sines_and_cosines_2
#define ALEMBERT_TRIG_LANES 2
#define ALEMBERT_TRIG_TARGET
#include "alembert/sines_and_cosines_lanes.hpp"
#undef ALEMBERT_TRIG_NAME
#undef ALEMBERT_TRIG_LANES
#undef ALEMBERT_TRIG_TARGET
#endif

#ifdef ALEMBERT_TRIG_X86
#define ALEMBERT_TRIG_NAME sines_and_cosines_4
#define ALEMBERT_TRIG_LANES 4
#define ALEMBERT_TRIG_TARGET __attribute__((target("avx2,fma")))
#include "alembert/sines_and_cosines_lanes.hpp"
#undef ALEMBERT_TRIG_NAME
#undef ALEMBERT_TRIG_LANES
#undef ALEMBERT_TRIG_TARGET

#define ALEMBERT_TRIG_NAME sines_and_cosines_8
#define ALEMBERT_TRIG_LANES 8
#define ALEMBERT_TRIG_TARGET __attribute__((target("avx512f,fma")))
#include "alembert/sines_and_cosines_lanes.hpp"
#undef ALEMBERT_TRIG_NAME
#undef ALEMBERT_TRIG_LANES
#undef ALEMBERT_TRIG_TARGET
#endif

/// Those that vectors do not do: beyond the range of the polynomials.
inline void large_sines_and_cosines(int n, const double* x, double* sine, double* cosine) {
  for (int i = 0; i < n; ++i) {
    if (is_finite(x[i]) && std::fabs(x[i]) <= 1e5) continue;
    sine[i] = std::sin(x[i]);
    cosine[i] = std::cos(x[i]);
  }
}

/// By vectors, if n is not below their width.
inline bool vector_sines_and_cosines(int n, const double* x, double* sine, double* cosine) {
#ifdef ALEMBERT_TRIG_X86
  if (n >= 8 && __builtin_cpu_supports("avx512f")) return sines_and_cosines_8(n, x, sine, cosine);
  if (n >= 4 && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    return sines_and_cosines_4(n, x, sine, cosine);
#endif
#ifdef ALEMBERT_TRIG_VECTORS
  return sines_and_cosines_2(n, x, sine, cosine);
#else
  for (int i = 0; i < n; ++i) {
    sine[i] = std::sin(x[i]);
    cosine[i] = std::cos(x[i]);
  }
  return true;
#endif
}

}  // namespace detail

/// Sines and cosines of n angles.
///
/// \param angle   n angles, rad; not finite: both results are NaN
/// \param sine    n results, may not overlap the angles
/// \param cosine  n results
inline void sines_and_cosines(int n, const double* angle, double* sine, double* cosine) {
  if (n >= 4) {
    if (!detail::vector_sines_and_cosines(n, angle, sine, cosine))
      detail::large_sines_and_cosines(n, angle, sine, cosine);
    return;
  }
  // Fewer than a vector holds are padded.
  double x[4] = {}, s[4], c[4];
  for (int i = 0; i < n; ++i) x[i] = angle[i];
  if (!detail::vector_sines_and_cosines(4, x, s, c)) detail::large_sines_and_cosines(n, x, s, c);
  for (int i = 0; i < n; ++i) {
    sine[i] = s[i];
    cosine[i] = c[i];
  }
}

}  // namespace alembert
