// Several doubles as one scalar, for generated functions over many states. In, as a macro before this file is
// included: ALEMBERT_PACK_NAMESPACE, a namespace of its own for each file that is compiled for its own set of
// instructions, so that no inline function compiled for one machine is linked into code for another. Out: in
// alembert::ALEMBERT_PACK_NAMESPACE the type Pack with arithmetic and functions, and a solver for M x = b.
//
// No lane depends on another, and all are computed alike: a product is fused with the sum that it stands in
// where the machine can, by what is written here and never by the compiler, which might fuse one vector of a
// pack and not the other. So -ffp-contract must be off. ALEMBERT_PACK_NO_FMA fuses nothing. The width is that
// of the widest vectors the compiler may use; where it has no vector extensions, one.
#pragma once

#ifndef ALEMBERT_PACK_NAMESPACE
#error "define ALEMBERT_PACK_NAMESPACE before including <alembert/pack.hpp>"
#endif

#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

#include "alembert/floating_point.hpp"

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#define ALEMBERT_PACK_LANES 8
#elif defined(__AVX2__)
#define ALEMBERT_PACK_LANES 4
#elif defined(__GNUC__)
#define ALEMBERT_PACK_LANES 2
#else
#define ALEMBERT_PACK_LANES 1
#endif

#if !defined(ALEMBERT_PACK_NO_FMA) && defined(__FMA__) && ALEMBERT_PACK_LANES >= 4
#include <immintrin.h>
#if ALEMBERT_PACK_LANES == 8
#define ALEMBERT_PACK_MULTIPLY_ADD(a, b, c) _mm512_fmadd_pd(a, b, c)
#else
#define ALEMBERT_PACK_MULTIPLY_ADD(a, b, c) _mm256_fmadd_pd(a, b, c)
#endif
#elif !defined(ALEMBERT_PACK_NO_FMA) && defined(__GNUC__) && defined(__aarch64__)
#include <arm_neon.h>
#define ALEMBERT_PACK_MULTIPLY_ADD(a, b, c) vfmaq_f64(c, a, b)
#else
#define ALEMBERT_PACK_MULTIPLY_ADD(a, b, c) ((a) * (b) + (c))
#endif

namespace alembert::ALEMBERT_PACK_NAMESPACE {

#if defined(__GNUC__)
#define ALEMBERT_TRIG_MULTIPLY_ADD ALEMBERT_PACK_MULTIPLY_ADD
#define ALEMBERT_TRIG_NAME sines_and_cosines_of_lanes
#define ALEMBERT_TRIG_LANES ALEMBERT_PACK_LANES
#define ALEMBERT_TRIG_TARGET
#include "alembert/sines_and_cosines_lanes.hpp"
#undef ALEMBERT_TRIG_NAME
#undef ALEMBERT_TRIG_LANES
#undef ALEMBERT_TRIG_TARGET
#undef ALEMBERT_TRIG_MULTIPLY_ADD
#endif

/// One vector: code that reads and writes memory where registers are full (ALEMBERT_FROM_MEMORY in the files
/// of batches) needs all of them for it.
struct Pack {
  static constexpr int kLanes = ALEMBERT_PACK_LANES;
#if defined(__GNUC__)
  typedef double Vector __attribute__((vector_size(8 * ALEMBERT_PACK_LANES)));
  /// A vector in an array of doubles.
  typedef double Stored __attribute__((vector_size(8 * ALEMBERT_PACK_LANES), aligned(8), may_alias));
#else
  typedef double Vector;
  typedef double Stored;
#endif

  Pack() = default;
  explicit Pack(double x) : v(x - Vector{}) {}
  static Pack of(Vector v) {
    Pack out;
    out.v = v;
    return out;
  }

  static Pack load(const double* x) {
    return of(*reinterpret_cast<const Stored*>(x));
  }
  void store(double* x) const {
    *reinterpret_cast<Stored*>(x) = v;
  }

  friend Pack operator+(const Pack& a, const Pack& b) {
    return of(a.v + b.v);
  }
  friend Pack operator-(const Pack& a, const Pack& b) {
    return of(a.v - b.v);
  }
  friend Pack operator-(const Pack& a) {
    return of(-a.v);
  }

  /// 0 in lanes where a > b, NaN in the others.
  static Pack nan_unless_greater(const Pack& a, const Pack& b) {
#if defined(__GNUC__)
    Vector out = reinterpret_cast<Vector>(~(a.v > b.v));
    ALEMBERT_AS_ROUNDED(out);
    return of(out);
#else
    constexpr double kNan = ::std::numeric_limits<double>::quiet_NaN();
    return of(a.v > b.v ? 0.0 : kNan);
#endif
  }

  /// What -ffast-math must not combine with other sums.
  static Pack as_rounded(Pack a) {
    ALEMBERT_AS_ROUNDED(a.v);
    return a;
  }

  /// Lanes i with i >= first and i < last that are neither 0 nor -0; a NaN is not either, whatever the
  /// compiler takes for granted of comparisons.
  int count_not_zero(int first, int last) const {
    double x[kLanes];
    store(x);
    int n = 0;
    for (int i = first; i < last; ++i) {
      unsigned long long bits;
      ::std::memcpy(&bits, x + i, sizeof bits);
      n += bits << 1 == 0 ? 0 : 1;
    }
    return n;
  }

  Vector v;
};

// No friend: both operands may be products.
inline Pack operator/(const Pack& a, const Pack& b) {
  return Pack::of(a.v / b.v);
}

/// a b, not yet rounded: the sum or difference that it stands in takes it up by a fused operation.
struct Product {
  operator Pack() const { return Pack::of(a.v * b.v); }
  Pack a, b;
};
inline Product operator*(const Pack& a, const Pack& b) {
  return {a, b};
}
inline Product operator-(const Product& p) {
  return {-p.a, p.b};
}
inline Pack operator+(const Product& p, const Pack& c) {
  return Pack::of(ALEMBERT_PACK_MULTIPLY_ADD(p.a.v, p.b.v, c.v));
}
inline Pack operator+(const Pack& c, const Product& p) {
  return p + c;
}
inline Pack operator-(const Product& p, const Pack& c) {
  return p + -c;
}
inline Pack operator-(const Pack& c, const Product& p) {
  return -p + c;
}
inline Pack operator+(const Product& p, const Product& q) {
  return p + Pack(q);
}
inline Pack operator-(const Product& p, const Product& q) {
  return p - Pack(q);
}

/// A function of the C library, lane by lane.
#define ALEMBERT_PACK_FUNCTION(name)                            \
  inline Pack name(const Pack& a) {                             \
    double x[Pack::kLanes];                                     \
    a.store(x);                                                 \
    for (int i = 0; i < Pack::kLanes; ++i) x[i] = ::name(x[i]); \
    return Pack::load(x);                                       \
  }
#define ALEMBERT_PACK_FUNCTION_2(name)                                \
  inline Pack name(const Pack& a, const Pack& b) {                    \
    double x[Pack::kLanes], y[Pack::kLanes];                          \
    a.store(x);                                                       \
    b.store(y);                                                       \
    for (int i = 0; i < Pack::kLanes; ++i) x[i] = ::name(x[i], y[i]); \
    return Pack::load(x);                                             \
  }
ALEMBERT_PACK_FUNCTION(sqrt)
ALEMBERT_PACK_FUNCTION(tan)
ALEMBERT_PACK_FUNCTION(asin)
ALEMBERT_PACK_FUNCTION(acos)
ALEMBERT_PACK_FUNCTION(atan)
ALEMBERT_PACK_FUNCTION(exp)
ALEMBERT_PACK_FUNCTION(log)
ALEMBERT_PACK_FUNCTION(sinh)
ALEMBERT_PACK_FUNCTION(cosh)
ALEMBERT_PACK_FUNCTION(tanh)
ALEMBERT_PACK_FUNCTION_2(atan2)
ALEMBERT_PACK_FUNCTION_2(pow)
#undef ALEMBERT_PACK_FUNCTION
#undef ALEMBERT_PACK_FUNCTION_2

inline Pack abs(const Pack& a) {
  double x[Pack::kLanes];
  a.store(x);
  for (int i = 0; i < Pack::kLanes; ++i) x[i] = ::fabs(x[i]);
  return Pack::load(x);
}

/// -1, 0 or 1.
inline Pack sign(const Pack& a) {
  double x[Pack::kLanes];
  a.store(x);
  for (int i = 0; i < Pack::kLanes; ++i) x[i] = (x[i] > 0 ? 1.0 : 0.0) - (x[i] < 0 ? 1.0 : 0.0);
  return Pack::load(x);
}

/// x where c > 0, else 0.
inline Pack if_positive(const Pack& c, const Pack& x) {
  double condition[Pack::kLanes], value[Pack::kLanes];
  c.store(condition);
  x.store(value);
  for (int i = 0; i < Pack::kLanes; ++i) value[i] = condition[i] > 0 ? value[i] : 0;
  return Pack::load(value);
}
/// 0 where c > 0, else x.
inline Pack unless_positive(const Pack& c, const Pack& x) {
  double condition[Pack::kLanes], value[Pack::kLanes];
  c.store(condition);
  x.store(value);
  for (int i = 0; i < Pack::kLanes; ++i) value[i] = condition[i] > 0 ? 0 : value[i];
  return Pack::load(value);
}

/// Sines and cosines of n packs of angles, within 1 ulp.
inline void sines_and_cosines(int n, const Pack* angle, Pack* sine, Pack* cosine) {
  const int count = n * Pack::kLanes;
  const double* x = reinterpret_cast<const double*>(angle);
  double* s = reinterpret_cast<double*>(sine);
  double* c = reinterpret_cast<double*>(cosine);
#if defined(__GNUC__)
  if (sines_and_cosines_of_lanes(count, x, s, c)) return;
  // What is too large for polynomials, or no number.
  for (int i = 0; i < count; ++i) {
    if (::fabs(x[i]) <= 1e5) continue;
    s[i] = ::sin(x[i]);
    c[i] = ::cos(x[i]);
  }
#else
  for (int i = 0; i < count; ++i) {
    s[i] = ::sin(x[i]);
    c[i] = ::cos(x[i]);
  }
#endif
}
inline Pack sin(const Pack& a) {
  Pack s, c;
  sines_and_cosines(1, &a, &s, &c);
  return s;
}
inline Pack cos(const Pack& a) {
  Pack s, c;
  sines_and_cosines(1, &a, &s, &c);
  return c;
}

/// 0 in lanes where all n numbers are finite, NaN in the others. Under -ffast-math, numbers whose sum
/// overflows may count as not finite too.
inline Pack zero_if_finite(int n, const Pack* x) {
  const Pack zero = Pack::as_rounded(Pack(0.0));
  Pack even = zero, odd = zero;
  for (int i = 0; i + 1 < n; i += 2) {
    even = even + x[i] * zero;
    odd = odd + x[i + 1] * zero;
  }
  return n % 2 == 0 ? even + odd : even + odd + x[n - 1] * zero;
}

/// Whether all lanes are 0.
inline bool is_zero(const Pack& a) {
  return a.count_not_zero(0, Pack::kLanes) == 0;
}

/// x = M^-1 b by L D L^T without a branch; M and b are spoilt. In lanes where M has a pivot that is not
/// positive beyond rounding, or something is not finite, x is NaN.
template <::std::size_t N>
void solve_positive_definite(Pack* M, Pack* x) {
  constexpr double kRounding = static_cast<double>(N) * ::std::numeric_limits<double>::epsilon();
  const Pack zero = Pack::as_rounded(Pack(0.0));
  Pack diagonal[N], bad = zero;
  for (::std::size_t k = 0; k < N; ++k) diagonal[k] = M[k * N + k];
  for (::std::size_t k = 0; k < N; ++k) {
    const Pack pivot = M[k * N + k];
    // The product says whether the pivot is finite, which comparisons need not under -ffast-math.
    bad = Pack::as_rounded(bad + pivot * zero) + Pack::nan_unless_greater(pivot, zero) +
          Pack::nan_unless_greater(pivot, diagonal[k] * Pack(kRounding));
    const Pack inverse = Pack(1.0) / pivot;
    for (::std::size_t i = k + 1; i < N; ++i) {
      const Pack l = M[i * N + k] * inverse;
      for (::std::size_t j = k + 1; j <= i; ++j) M[i * N + j] = M[i * N + j] - l * M[j * N + k];
      x[i] = x[i] - l * x[k];
    }
    // Column k keeps D L; the inverse of D is kept for the way back.
    M[k * N + k] = inverse;
  }
  for (::std::size_t i = N; i-- > 0;) {
    Pack sum = x[i];
    for (::std::size_t k = i + 1; k < N; ++k) sum = sum - M[k * N + i] * x[k];
    x[i] = sum * M[i * N + i];
  }
  for (::std::size_t i = 0; i < N; ++i) x[i] = x[i] + bad;
}

}  // namespace alembert::ALEMBERT_PACK_NAMESPACE

#undef ALEMBERT_PACK_MULTIPLY_ADD
