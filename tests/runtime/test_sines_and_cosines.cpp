// Vectorised sines and cosines against 300-bit arithmetic of MPFR: within 1 ulp over all magnitudes, special
// values exact, the same result wherever an angle stands. Every set of instructions that this machine has.
#include <gtest/gtest.h>
#include <mpfr.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "alembert/sines_and_cosines.hpp"

namespace {

struct Vectors {
  std::string name;
  int lanes;
  bool (*compute)(int, const double*, double*, double*);
};

/// The loops that this machine can run.
std::vector<Vectors> all_vectors() {
  std::vector<Vectors> list;
#ifdef ALEMBERT_TRIG_VECTORS
  list.push_back({"2 lanes", 2, alembert::detail::sines_and_cosines_2});
#endif
#ifdef ALEMBERT_TRIG_X86
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    list.push_back({"4 lanes", 4, alembert::detail::sines_and_cosines_4});
  if (__builtin_cpu_supports("avx512f"))
    list.push_back({"8 lanes", 8, alembert::detail::sines_and_cosines_8});
#endif
  list.push_back({"as called", 1, [](int n, const double* x, double* s, double* c) {
                    alembert::sines_and_cosines(n, x, s, c);
                    return true;
                  }});
  return list;
}

/// Sine and cosine to 300 bits, and how far a double is from them.
class Exact {
 public:
  Exact() { mpfr_inits2(300, x_, sine_, cosine_, difference_, static_cast<mpfr_ptr>(nullptr)); }
  ~Exact() { mpfr_clears(x_, sine_, cosine_, difference_, static_cast<mpfr_ptr>(nullptr)); }
  Exact(const Exact&) = delete;
  Exact& operator=(const Exact&) = delete;

  void at(double x) {
    mpfr_set_d(x_, x, MPFR_RNDN);
    mpfr_sin_cos(sine_, cosine_, x_, MPFR_RNDN);
  }
  double sine_error(double value) { return error(value, sine_); }
  double cosine_error(double value) { return error(value, cosine_); }

 private:
  /// In units in the last place of the exact value, rounded.
  double error(double value, const mpfr_t exact) {
    int exponent = 0;
    static_cast<void>(std::frexp(mpfr_get_d(exact, MPFR_RNDN), &exponent));
    mpfr_set_d(difference_, value, MPFR_RNDN);
    mpfr_sub(difference_, difference_, exact, MPFR_RNDN);
    return std::fabs(mpfr_get_d(difference_, MPFR_RNDN)) / std::ldexp(1.0, std::max(exponent - 53, -1074));
  }
  mpfr_t x_, sine_, cosine_, difference_;
};

/// Largest error of all vectors over the angles, which are tried in groups.
void expect_within_one_ulp(const std::vector<double>& angles, const char* what) {
  Exact exact;
  for (const Vectors& vectors : all_vectors()) {
    double worst = 0, at = 0;
    std::array<double, 8> x, s, c;
    for (std::size_t first = 0; first < angles.size(); first += x.size()) {
      for (std::size_t i = 0; i < x.size(); ++i) x[i] = angles[std::min(first + i, angles.size() - 1)];
      ASSERT_TRUE(vectors.compute(8, x.data(), s.data(), c.data()));
      for (std::size_t i = 0; i < x.size(); ++i) {
        exact.at(x[i]);
        const double error = std::max(exact.sine_error(s[i]), exact.cosine_error(c[i]));
        if (error > worst) {
          worst = error;
          at = x[i];
        }
      }
    }
    EXPECT_LE(worst, 1.0) << what << ", " << vectors.name << ", at " << at;
    EXPECT_GE(worst, 0.25) << what << ", " << vectors.name << ": no test at all";
    testing::Test::RecordProperty(vectors.name, std::to_string(worst));
  }
}

TEST(SinesAndCosines, AreWithinOneUlpInAllRanges) {
  std::mt19937_64 random(1);
  for (const double width : {1e-3, 1.0, 3.2, 100.0, 1e4, 1e5}) {
    std::vector<double> angles(20000);
    std::uniform_real_distribution<double> uniform(-width, width);
    for (double& x : angles) x = uniform(random);
    expect_within_one_ulp(angles, "uniform");
  }
  std::vector<double> angles(20000);
  std::uniform_real_distribution<double> exponent(-30, std::log(1e5));
  for (double& x : angles) x = std::exp(exponent(random));
  expect_within_one_ulp(angles, "by magnitude");
}

/// All multiples of pi/2 below 1e5 and their neighbours: there digits cancel.
TEST(SinesAndCosines, AreWithinOneUlpNextToQuarterTurns) {
  std::vector<double> angles;
  for (int k = 1; k < 63600; k += 1) {
    const double x = k * 1.5707963267948966;
    for (const double y : {x, std::nextafter(x, 0.0), std::nextafter(x, 1e6)})
      angles.push_back(k % 2 ? -y : y);
  }
  expect_within_one_ulp(angles, "quarter turns");
}

TEST(SinesAndCosines, OfLargeAnglesAreThoseOfTheLibrary) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::array<double, 12> x{1.0,   100001.0,   -1e6, 0.5,        1e22, 1.7e308,
                                 -1e15, -kInfinity, 2.0,  1048575.25, 1e5,  std::nextafter(1e5, 1e6)};
  for (int n = 1; n <= 12; ++n) {
    std::array<double, 12> s{}, c{};
    alembert::sines_and_cosines(n, x.data(), s.data(), c.data());
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
      if (std::isinf(x[i])) {
        EXPECT_TRUE(std::isnan(s[i]) && std::isnan(c[i]));
      } else if (std::fabs(x[i]) > 1e5) {
        EXPECT_EQ(s[i], std::sin(x[i]));
        EXPECT_EQ(c[i], std::cos(x[i]));
      } else {
        EXPECT_NEAR(s[i], std::sin(x[i]), 3e-16);
        EXPECT_NEAR(c[i], std::cos(x[i]), 3e-16);
      }
    }
  }
}

TEST(SinesAndCosines, OfSpecialValuesAreExact) {
  constexpr double kTiny = std::numeric_limits<double>::denorm_min();
  const std::array<double, 8> x{0.0, -0.0, kTiny, -kTiny, 1e-300, -1e-300, 1e-160, std::nan("")};
  for (const Vectors& vectors : all_vectors()) {
    std::array<double, 8> s{}, c{};
    const bool all = vectors.compute(8, x.data(), s.data(), c.data());
    EXPECT_EQ(all, vectors.name == "as called") << "the NaN is not reported: " << vectors.name;
    for (std::size_t i = 0; i < 7; ++i) {
      EXPECT_EQ(s[i], x[i]) << vectors.name;
      EXPECT_EQ(std::signbit(s[i]), std::signbit(x[i])) << vectors.name << " " << x[i];
      EXPECT_EQ(c[i], 1.0) << vectors.name;
    }
    EXPECT_TRUE(std::isnan(s[7]) && std::isnan(c[7])) << vectors.name;
  }
}

/// For all numbers of angles and all places: what stands beside an angle does not matter.
TEST(SinesAndCosines, DoNotDependOnPlace) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(-10, 10);
  for (const Vectors& vectors : all_vectors()) {
    for (int n = std::max(vectors.lanes, 1); n <= 20; ++n) {
      std::array<double, 20> x, s{}, c{};
      const double angle = uniform(random);
      double expected_s = 0, expected_c = 0;
      for (int place = 0; place < n; ++place) {
        for (double& y : x) y = uniform(random);
        x[static_cast<std::size_t>(place)] = angle;
        x[static_cast<std::size_t>((place + 1) % n)] = n > 1 ? 1e7 : angle;
        vectors.compute(n, x.data(), s.data(), c.data());
        if (place == 0) {
          expected_s = s[0];
          expected_c = c[0];
        }
        EXPECT_EQ(s[static_cast<std::size_t>(place)], expected_s) << vectors.name << n << place;
        EXPECT_EQ(c[static_cast<std::size_t>(place)], expected_c) << vectors.name << n << place;
      }
    }
  }
}

}  // namespace
