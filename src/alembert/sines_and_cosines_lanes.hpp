// One vectorised loop for sines and cosines, written once for all instruction sets. In, as macros:
//
//   ALEMBERT_TRIG_NAME    name of the function to be defined
//   ALEMBERT_TRIG_LANES   doubles in a vector
//   ALEMBERT_TRIG_TARGET  attribute that allows the instructions, or nothing
//   ALEMBERT_TRIG_MULTIPLY_ADD(a, b, c)  a b + c, fused or not; without it the compiler chooses
//
// Out: bool NAME(int n, const double* x, double* sine, double* cosine) for n >= LANES, which is false if some
// |x| is above 1e5 or no number: those results are then wrong and the others right. No `#pragma once`: it is
// included several times. Needs vector extensions of gcc or clang.
//
// x = n pi/2 + (hi + lo), |hi| <= pi/4, with pi/2 in four parts, of which the first three have 34 bits so
// that n times them is exact; then polynomials with minimax coefficients for (sin r - r) / r^3 and (cos r - 1
// + r^2/2) / r^4, relative error of the results below 2^-57 before rounding. All products whose rounding
// matters are exact, so that contraction to fused operations changes last digits only. After W. Cody and W.
// Waite, Software Manual for the Elementary Functions, 1980.

#ifdef ALEMBERT_TRIG_MULTIPLY_ADD
#define ALEMBERT_TRIG_AXPY ALEMBERT_TRIG_MULTIPLY_ADD
#else
#define ALEMBERT_TRIG_AXPY(a, b, c) ((a) * (b) + (c))
#endif

ALEMBERT_TRIG_TARGET inline bool ALEMBERT_TRIG_NAME(int n, const double* x, double* sine, double* cosine) {
  constexpr int kLanes = ALEMBERT_TRIG_LANES;
  typedef double Vector __attribute__((vector_size(8 * kLanes)));
  typedef long long Integers __attribute__((vector_size(8 * kLanes)));
  const Vector zero = {};
  const Integers no_bits = {};
  const Integers magnitude = no_bits + 0x7fffffffffffffffLL;
  Integers small = ~no_bits;
  for (int first = 0;;) {
    Vector v;
    __builtin_memcpy(&v, x + first, sizeof v);
    // Adding 1.5 * 2^52 leaves the nearest integer in the last bits.
    const Vector shifted = ALEMBERT_TRIG_AXPY(v, zero + 0.63661977236758134308, zero + 6755399441055744.0);
    const Vector k = shifted - 6755399441055744.0;
    const Vector r0 = ALEMBERT_TRIG_AXPY(k, zero - 0x1.921fb54440000p+0, v);
    const Vector t1 = k * 0x1.68c234c4c0000p-39;
    const Vector r1 = r0 - t1;
    const Vector t2 = k * 0x1.98a2e03700000p-77;
    const Vector hi = r1 - t2;
    const Vector lo = ((r0 - r1) - t1) + ALEMBERT_TRIG_AXPY(k, zero - 0x1.cd129024e088ap-115, (r1 - hi) - t2);

    const Vector z = hi * hi;
    const Vector z2 = z * z;
    const Vector ps0 = ALEMBERT_TRIG_AXPY(z, zero + 0x1.111111110f7cap-7, zero - 0x1.5555555555548p-3);
    const Vector ps1 = ALEMBERT_TRIG_AXPY(z, zero + 0x1.71de356714d58p-19, zero - 0x1.a01a019bfd1bdp-13);
    const Vector ps2 = ALEMBERT_TRIG_AXPY(z, zero + 0x1.5d8fa3765db81p-33, zero - 0x1.ae5e59f7155fap-26);
    const Vector ps = ALEMBERT_TRIG_AXPY(ALEMBERT_TRIG_AXPY(ps2, z2, ps1), z2, ps0);
    const Vector pc0 = ALEMBERT_TRIG_AXPY(z, zero - 0.001388888888887304, zero + 0.041666666666666595);
    const Vector pc1 = ALEMBERT_TRIG_AXPY(z, zero - 2.755731417623388e-07, zero + 2.4801587288841367e-05);
    const Vector pc2 = ALEMBERT_TRIG_AXPY(z, zero - 1.135851393858682e-11, zero + 2.087570041558362e-09);
    const Vector pc = ALEMBERT_TRIG_AXPY(ALEMBERT_TRIG_AXPY(pc2, z2, pc1), z2, pc0);
    const Vector half = z * 0.5;
    const Vector rest = 1.0 - half;
    const Vector unsigned_s = hi + ALEMBERT_TRIG_AXPY(hi * z, ps, ALEMBERT_TRIG_AXPY(-lo, half, lo));
    // Only a zero has lost its sign.
    const Vector s = reinterpret_cast<Vector>(reinterpret_cast<Integers>(unsigned_s) |
                                              (reinterpret_cast<Integers>(hi) & ~magnitude));
    const Vector c = rest + (((1.0 - rest) - half) + ALEMBERT_TRIG_AXPY(z2, pc, -(hi * lo)));

    // Quarter turns: odd ones exchange the two, and two of four change the sign.
    const Integers turns = reinterpret_cast<Integers>(shifted);
    const Integers s0 = reinterpret_cast<Integers>(s), c0 = reinterpret_cast<Integers>(c);
    const Integers odd = no_bits - (turns & 1);
    const Integers s_bits = ((c0 & odd) | (s0 & ~odd)) ^ ((turns & 2) << 62);
    const Integers c_bits = ((s0 & odd) | (c0 & ~odd)) ^ (((turns + 1) & 2) << 62);
    __builtin_memcpy(sine + first, &s_bits, sizeof s_bits);
    __builtin_memcpy(cosine + first, &c_bits, sizeof c_bits);
    small &= reinterpret_cast<Vector>(reinterpret_cast<Integers>(v) & magnitude) <= 1e5;
    if (first == n - kLanes) break;
    first =
        first + 2 * kLanes <= n ? first + kLanes : n - kLanes;  // the last vector may overlap the one before
  }
  long long all = -1;
  for (int i = 0; i < kLanes; ++i) all &= small[i];
  return all != 0;
}

#undef ALEMBERT_TRIG_AXPY
