// What the machine can do at most in AVX2, where there is such: independent chains of fused multiplications
// and additions, which no program with real dependencies reaches, and sines and cosines with nothing else.
#include "benchmark/timings.hpp"

#define ALEMBERT_PACK_NAMESPACE batch_ceiling
#include "alembert/pack.hpp"

namespace alembert::benchmarks {

using batch_ceiling::Pack;

double fused_operations(int rounds) {
  const Pack m(0.999999);
  Pack a(1.0), b(2.0), c(3.0), d(4.0), e(5.0);
  for (int k = 0; k < rounds; ++k) {
    a = a * m + m;
    b = b * m + m;
    c = c * m + m;
    d = d * m + m;
    e = e * m + m;
  }
  double lanes[Pack::kLanes];
  (a + b + c + d + e).store(lanes);
  sink = lanes[0];
  return 10.0 * Pack::kLanes * rounds;
}

double sines_of_angles(int rounds) {
  constexpr int kAngles = 6;
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
