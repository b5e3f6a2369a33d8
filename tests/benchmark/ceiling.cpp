// What the machine can do at most: independent chains of fused multiplications and additions in AVX2, which
// no program with real dependencies reaches. Compiled with those instructions where there are such.
#include "benchmark/timings.hpp"

namespace alembert::benchmarks {

double fused_operations(int rounds) {
#if defined(__AVX2__) && defined(__FMA__)
  typedef double Vector __attribute__((vector_size(32)));
  constexpr int kLanes = 4;
#else
  typedef double Vector;
  constexpr int kLanes = 1;
#endif
  const Vector m = Vector{} + 0.999999;
  Vector a = m, b = m + 1.0, c = m + 2.0, d = m + 3.0, e = m + 4.0;
  Vector f = m + 5.0, g = m + 6.0, h = m + 7.0, i = m + 8.0, j = m + 9.0;
  for (int k = 0; k < rounds; ++k) {
    a = a * m + m;
    b = b * m + m;
    c = c * m + m;
    d = d * m + m;
    e = e * m + m;
    f = f * m + m;
    g = g * m + m;
    h = h * m + m;
    i = i * m + m;
    j = j * m + m;
  }
  a += b + c + d + e + f + g + h + i + j;
  double used = 0;
  __builtin_memcpy(&used, &a, sizeof used);
  sink = used;
  return 20.0 * kLanes * rounds;
}

}  // namespace alembert::benchmarks
