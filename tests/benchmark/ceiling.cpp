// What the machine can do at most in AVX2, where there is such: independent chains of fused multiplications
// and additions, which no program with real dependencies reaches, and sines and cosines with nothing else.
#include "benchmark/timings.hpp"

#define ALEMBERT_PACK_NAMESPACE batch_ceiling
#include "alembert/pack.hpp"

namespace alembert::benchmarks {

using batch_ceiling::Pack;

double fused_operations(int rounds) {
  // As many as two units with a latency of five cycles keep busy.
  constexpr int kChains = 10;
  const Pack m(0.999999);
  Pack a[kChains];
  for (int i = 0; i < kChains; ++i) a[i] = Pack(1.0 + i);
  for (int k = 0; k < rounds; ++k) {
#pragma GCC unroll 10
    for (Pack& x : a) x = x * m + m;
  }
  Pack sum = a[0];
  for (int i = 1; i < kChains; ++i) sum = sum + a[i];
  double lanes[Pack::kLanes];
  sum.store(lanes);
  sink = lanes[0];
  return 2.0 * kChains * Pack::kLanes * rounds;
}

double sines_of_angles(int rounds) {
  constexpr int kAngles = 12;
  Pack angle[kAngles], sine[kAngles], cosine[kAngles];
  for (int i = 0; i < kAngles; ++i) angle[i] = Pack(0.3 + i);
  for (int k = 0; k < rounds; ++k) {
    sines_and_cosines(kAngles, angle, sine, cosine);
    angle[k % kAngles] = sine[0];  // otherwise all rounds but the first might be left out
  }
  double lanes[Pack::kLanes];
  (sine[1] + cosine[2]).store(lanes);
  sink = lanes[0];
  return static_cast<double>(kAngles) * Pack::kLanes * rounds;
}

}  // namespace alembert::benchmarks
