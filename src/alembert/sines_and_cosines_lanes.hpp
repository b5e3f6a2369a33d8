// One vectorised loop for sines and cosines, written once for all instruction sets. In, as macros:
//
//   ALEMBERT_TRIG_NAME    name of the function to be defined
//   ALEMBERT_TRIG_LANES   doubles in a vector
//   ALEMBERT_TRIG_TARGET  attribute that allows the instructions, or nothing
//   ALEMBERT_TRIG_MULTIPLY_ADD(a, b, c)  a b + c, fused or not; without it the compiler chooses
//
// Out: bool NAME(int n, const double* x, double* sine, double* cosine) for n >= LANES, which is false if some
// |x| is above 1e5 or no number: those results are then wrong and the others right. No `#pragma once`: it is
// included several times. Needs vector extensions of gcc or clang, and floating_point.hpp.
//
// x = n pi/2 + (hi + lo), |hi| <= pi/4, with pi/2 in four parts, of which the first three have 34 bits so
// that n times them is exact; then polynomials with minimax coefficients for (sin r - r) / r^3 and (cos r - 1
// + r^2/2) / r^4, relative error of the results below 2^-57 before rounding. All products whose rounding
// matters are exact, so that contraction to fused operations changes last digits only; sums whose rounding
// matters are kept as they are under -ffast-math too. After W. Cody and W. Waite, Software Manual for the
// Elementary Functions, 1980.

#ifdef ALEMBERT_TRIG_MULTIPLY_ADD
#define ALEMBERT_TRIG_AXPY ALEMBERT_TRIG_MULTIPLY_ADD
#else
#define ALEMBERT_TRIG_AXPY(a, b, c) ((a) * (b) + (c))
#endif

ALEMBERT_TRIG_TARGET inline bool ALEMBERT_TRIG_NAME(int n, const double* x, double* sine, double* cosine) {
  constexpr int kLanes = ALEMBERT_TRIG_LANES;
  constexpr int kTogether = 16;  // vectors
  typedef double Vector __attribute__((vector_size(8 * kLanes)));
  typedef long long Integers __attribute__((vector_size(8 * kLanes)));
  const Vector zero = {};
  const Integers no_bits = {};
  const Integers sign_bit = no_bits + static_cast<long long>(1ULL << 63);
  const Integers largest = no_bits + 0x40f86a0000000000LL;  // 1e5
  Integers too_large = no_bits;                             // the sign bit, where a result is wrong
  const int last = n - kLanes;                              // the last vector may overlap the one before
  for (int first = 0; first < n; first += kTogether * kLanes) {
    // Two loops, so that each is a short chain of operations and a processor has many vectors in flight.
    Vector his[kTogether], los[kTogether], shifts[kTogether];
    int count = 0;
    for (int at = first; count < kTogether && at < n; at += kLanes, ++count) {
      Vector v;
      __builtin_memcpy(&v, x + (at < last ? at : last), sizeof v);
      // Adding 1.5 * 2^52 leaves the nearest integer in the last bits.
      Vector shifted = ALEMBERT_TRIG_AXPY(v, zero + 0.63661977236758134308, zero + 6755399441055744.0);
      ALEMBERT_AS_ROUNDED(shifted);
      Vector k = shifted - 6755399441055744.0;
      ALEMBERT_AS_ROUNDED(k);
      Vector r0 = ALEMBERT_TRIG_AXPY(k, zero - 0x1.921fb54440000p+0, v);
      ALEMBERT_AS_ROUNDED(r0);
      const Vector t1 = k * 0x1.68c234c4c0000p-39;
      Vector r1 = r0 - t1;
      ALEMBERT_AS_ROUNDED(r1);
      const Vector t2 = k * 0x1.98a2e03700000p-77;
      Vector hi = r1 - t2;
      ALEMBERT_AS_ROUNDED(hi);
      Vector lost1 = r0 - r1, lost2 = r1 - hi;
      ALEMBERT_AS_ROUNDED(lost1);
      ALEMBERT_AS_ROUNDED(lost2);
      lost1 = lost1 - t1;
      lost2 = lost2 - t2;
      ALEMBERT_AS_ROUNDED(lost1);
      ALEMBERT_AS_ROUNDED(lost2);
      his[count] = hi;
      los[count] = lost1 + ALEMBERT_TRIG_AXPY(k, zero - 0x1.cd129024e088ap-115, lost2);
      shifts[count] = shifted;
      too_large |= largest - (reinterpret_cast<Integers>(v) & ~sign_bit);
    }
    for (int i = 0; i < count; ++i) {
      const Vector hi = his[i], lo = los[i];
      const Vector z = hi * hi;
      const Vector z2 = z * z;
      const Vector ps0 = ALEMBERT_TRIG_AXPY(z, zero - 0x1.111111110f7cap-7, zero + 0x1.5555555555548p-3);
      const Vector ps1 = ALEMBERT_TRIG_AXPY(z, zero - 0x1.71de356714d58p-19, zero + 0x1.a01a019bfd1bdp-13);
      const Vector ps2 = ALEMBERT_TRIG_AXPY(z, zero - 0x1.5d8fa3765db81p-33, zero + 0x1.ae5e59f7155fap-26);
      const Vector ps = ALEMBERT_TRIG_AXPY(ALEMBERT_TRIG_AXPY(ps2, z2, ps1), z2, ps0);
      const Vector pc0 = ALEMBERT_TRIG_AXPY(z, zero - 0.001388888888887304, zero + 0.041666666666666595);
      const Vector pc1 = ALEMBERT_TRIG_AXPY(z, zero - 2.755731417623388e-07, zero + 2.4801587288841367e-05);
      const Vector pc2 = ALEMBERT_TRIG_AXPY(z, zero - 1.135851393858682e-11, zero + 2.087570041558362e-09);
      const Vector pc = ALEMBERT_TRIG_AXPY(ALEMBERT_TRIG_AXPY(pc2, z2, pc1), z2, pc0);
      const Vector half = z * 0.5;
      Vector rest = 1.0 - half;
      ALEMBERT_AS_ROUNDED(rest);
      Vector lost = 1.0 - rest;
      ALEMBERT_AS_ROUNDED(lost);
      lost = lost - half;
      ALEMBERT_AS_ROUNDED(lost);
      Vector less = ALEMBERT_TRIG_AXPY(hi * z, ps, ALEMBERT_TRIG_AXPY(lo, half, -lo));
      ALEMBERT_AS_ROUNDED(less);
      Vector more = lost + ALEMBERT_TRIG_AXPY(z2, pc, -(hi * lo));
      ALEMBERT_AS_ROUNDED(more);
      const Vector s = hi - less;  // a difference: -0 keeps its sign
      const Vector c = rest + more;

      // Quarter turns: odd ones exchange the two, and two of four change the sign.
      const Integers turns = reinterpret_cast<Integers>(shifts[i]);
      const Integers s0 = reinterpret_cast<Integers>(s), c0 = reinterpret_cast<Integers>(c);
      const Integers exchanged = (s0 ^ c0) & (no_bits - (turns & 1));
      const Integers s_sign = (turns << 62) & sign_bit;
      const Integers c_sign = s_sign ^ (turns << 63);
      const Integers s_bits = s0 ^ exchanged ^ s_sign, c_bits = c0 ^ exchanged ^ c_sign;
      const int at = first + i * kLanes < last ? first + i * kLanes : last;
      __builtin_memcpy(sine + at, &s_bits, sizeof s_bits);
      __builtin_memcpy(cosine + at, &c_bits, sizeof c_bits);
    }
  }
  long long any = 0;
  for (int i = 0; i < kLanes; ++i) any |= too_large[i];
  return any >= 0;
}

#undef ALEMBERT_TRIG_AXPY
