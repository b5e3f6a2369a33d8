// Vectorised sines and cosines, packs and their checks, as compiled with the flags under test. Out: nothing
// and 0, or what is wrong and 1. Argument: the largest error allowed, in units in the last place.
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

#include "alembert/sines_and_cosines.hpp"
#include "reference.hpp"
#define ALEMBERT_PACK_NAMESPACE packs_with_flags
#include "alembert/pack_window.hpp"

namespace {

int failures = 0;

void expect(bool right, const char* what) {
  if (right) return;
  std::printf("wrong: %s\n", what);
  ++failures;
}

/// Angles of all magnitudes, and next to quarter turns, where digits cancel.
std::vector<double> angles() {
  std::vector<double> out;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-30, 11.5), uniform(-4, 4);
  for (int i = 0; i < 4000; ++i) {
    out.push_back(std::exp(exponent(random)));
    out.push_back(uniform(random));
    const int k = 1 + 15 * i;
    const double turn = k * 1.5707963267948966;
    out.push_back(i % 2 == 0 ? turn : -turn);
    out.push_back(std::nextafter(turn, 1e6));
  }
  return out;
}

using Compute = bool (*)(int, const double*, double*, double*);

void check(Compute compute, double bound, const char* what) {
  const std::vector<double> x = angles();
  std::vector<double> s(x.size()), c(x.size());
  expect(compute(static_cast<int>(x.size()), x.data(), s.data(), c.data()), what);
  double worst = 0, at = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (const double error : {error_in_ulp(s[i], exact_sine(x[i])), error_in_ulp(c[i], exact_cosine(x[i]))})
      if (error > worst) {
        worst = error;
        at = x[i];
      }
  }
  std::printf("%s: %.3f ulp at %.17g\n", what, worst, at);
  expect(worst <= bound, what);
  // What is too large is reported, and the rest is right.
  for (const double bad : {1.1e5, -1e300, infinity(), -infinity(), not_a_number()}) {
    std::vector<double> y(16, 0.5), sine(16), cosine(16);
    y[11] = bad;
    expect(!compute(16, y.data(), sine.data(), cosine.data()), "angles out of range are reported");
    expect(error_in_ulp(sine[12], exact_sine(0.5)) <= bound, "sine beside an angle out of range");
  }
}

using alembert::packs_with_flags::Pack;

void check_packs() {
  namespace pack = alembert::packs_with_flags;
  for (const double bad : {infinity(), -infinity(), not_a_number()}) {
    for (int n = 1; n <= 5; ++n) {
      Pack x[5];
      for (Pack& one : x) one = Pack(1e307);
      expect(pack::is_zero(pack::zero_if_finite(n, x)), "large numbers are finite");
      double lanes[Pack::kLanes];
      for (double& lane : lanes) lane = 1;
      lanes[Pack::kLanes - 1] = bad;
      x[n - 1] = Pack::load(lanes);
      const Pack sum = pack::zero_if_finite(n, x);
      expect(!pack::is_zero(sum), "what is not finite is found");
      expect(pack::Window{0, 1}.count_not_finite(sum) == 1, "and counted once");
    }
  }
  // Singular in the first lane, regular or not finite in the others.
  for (const double last : {2.0, not_a_number()}) {
    Pack M[4], x[2];
    double lanes[Pack::kLanes];
    for (double& lane : lanes) lane = last;
    lanes[0] = 1;
    M[0] = M[1] = M[2] = Pack(1);
    M[3] = Pack::load(lanes);
    x[0] = x[1] = Pack(1);
    pack::solve_positive_definite<2>(M, x);
    double first[Pack::kLanes], second[Pack::kLanes];
    x[0].store(first);
    x[1].store(second);
    expect(Pack::kLanes < 2 || is_a_nan(first[1]) == is_a_nan(last),
           "a regular matrix is solved, another is not");
    expect(is_a_nan(first[0]) && is_a_nan(second[0]), "a singular matrix gives NaN");
  }
  Pack angle(not_a_number()), s, c;
  pack::sines_and_cosines(1, &angle, &s, &c);
  expect(!pack::is_zero(s) && !pack::is_zero(c - Pack(1)), "a NaN has no sine");
}

void check_library() {
  for (const double bad : {infinity(), not_a_number()}) {
    double x[6] = {1, bad, 3, 1e6, 5, 6}, s[6], c[6];
    for (const int n : {2, 6}) {
      alembert::sines_and_cosines(n, x, s, c);
      expect(is_a_nan(s[1]) && is_a_nan(c[1]), "sines of what is no angle are NaN");
    }
    expect(error_in_ulp(s[3], exact_sine(1e6)) <= 1, "large angles are those of the library");
  }
}

}  // namespace

int main(int argc, char** argv) {
  const double bound = argc > 1 ? std::atof(argv[1]) : 1;
#ifdef ALEMBERT_TRIG_VECTORS
  check(alembert::detail::sines_and_cosines_2, bound, "2 lanes");
#endif
#ifdef ALEMBERT_TRIG_X86
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    check(alembert::detail::sines_and_cosines_4, bound, "4 lanes");
  if (__builtin_cpu_supports("avx512f")) check(alembert::detail::sines_and_cosines_8, bound, "8 lanes");
#endif
#if defined(__GNUC__)
  check(alembert::packs_with_flags::sines_and_cosines_of_lanes, bound, "packs");
#endif
  check_packs();
  check_library();
  return failures == 0 ? 0 : 1;
}
