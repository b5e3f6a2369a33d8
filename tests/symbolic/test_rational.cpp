// Exact fractions: lowest terms, overflow, doubles and decimal text.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "symbolic/random_dag.hpp"
#include "symbolic/rational.hpp"

namespace alembert {
namespace {

constexpr std::int64_t kLargest = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t kSmallest = std::numeric_limits<std::int64_t>::min();

std::optional<Rational> decimal(const std::string& text) {
  return rational_from_decimal(text.data(), text.data() + text.size());
}

TEST(Rational, LowestTermsWithPositiveDenominator) {
  EXPECT_EQ(make_rational(6, -4), Rational(-3, 2));
  EXPECT_EQ(make_rational(0, -7), Rational(0, 1));
  EXPECT_EQ(make_rational(kLargest, kLargest), Rational(1));
  EXPECT_EQ(make_rational(1, 0), std::nullopt);
}

TEST(Rational, OverflowIsReported) {
  EXPECT_EQ(make_rational(kSmallest, 1), std::nullopt);
  EXPECT_EQ(make_rational(kSmallest, 2), Rational(kSmallest / 2));
  EXPECT_EQ(add(Rational(kLargest), Rational(1)), std::nullopt);
  EXPECT_EQ(add(Rational(kLargest), Rational(-1)), Rational(kLargest - 1));
  EXPECT_EQ(add(Rational(-kLargest), Rational(-kLargest)), std::nullopt);
  EXPECT_EQ(mul(Rational(kLargest), Rational(2)), std::nullopt);
  EXPECT_EQ(mul(Rational(kLargest, 3), Rational(3, kLargest)), Rational(1));
  EXPECT_EQ(mul(Rational(1, kLargest), Rational(1, 2)), std::nullopt);
  EXPECT_EQ(add(Rational(1, kLargest), Rational(1, kLargest - 1)), std::nullopt);
  EXPECT_EQ(div(Rational(1), Rational(0)), std::nullopt);
  EXPECT_EQ(div(Rational(3), Rational(-6)), Rational(-1, 2));
}

TEST(Rational, ToDoubleRoundsOnce) {
  EXPECT_EQ(Rational(1, 3).to_double(), 1.0 / 3.0);
  EXPECT_EQ(Rational(-1, 10).to_double(), -0.1);
  EXPECT_EQ(Rational(0).to_double(), 0.0);
  EXPECT_EQ(Rational(kLargest, kLargest - 1).to_double(), 1.0);
  // Just above the middle between 2^53 and 2^53 + 2: dividing rounded parts would lose it.
  const std::int64_t middle = (std::int64_t{1} << 53) + 1;
  EXPECT_EQ(Rational(middle).to_double(), 9007199254740992.0);
  EXPECT_EQ(Rational(3 * middle + 1, 3).to_double(), 9007199254740994.0);
  EXPECT_EQ(Rational(3 * middle - 1, 3).to_double(), 9007199254740992.0);
}

TEST(Rational, ToDoubleAgreesWithDecimalConversion) {
  TestRandom random(1);
  for (int i = 0; i < 2000; ++i) {
    const std::string text = "0." + std::to_string(random.next() % 1000000000000000u);
    const auto exact = decimal(text);
    ASSERT_TRUE(exact) << text;
    EXPECT_EQ(exact->to_double(), std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(Rational, FromDecimal) {
  EXPECT_EQ(decimal("0.4318"), Rational(2159, 5000));
  EXPECT_EQ(decimal("1.8e-3"), Rational(9, 5000));
  EXPECT_EQ(decimal("-12E2"), Rational(-1200));
  EXPECT_EQ(decimal("+.5"), Rational(1, 2));
  EXPECT_EQ(decimal("7."), Rational(7));
  EXPECT_EQ(decimal("1.000000000000000000000000"), Rational(1));
  EXPECT_EQ(decimal("0e999999999999"), Rational(0));
  EXPECT_EQ(decimal("1000000000000000000"), Rational(1000000000000000000));
  EXPECT_EQ(decimal("9223372036854775807"), Rational(kLargest));
}

TEST(Rational, FromDecimalRefuses) {
  for (const char* text : {"", "-", ".", "1,5", "1e", "1e+", "nan", "inf", "0x1", "1 ", " 1", "1.2.3", "--1",
                           "e5", "9223372036854775808", "1e19", "1e999", "1e-19", "1e-999999999999999999"}) {
    EXPECT_EQ(decimal(text), std::nullopt) << text;
  }
}

TEST(Rational, FromDouble) {
  EXPECT_EQ(rational_from_double(0.1), Rational(1, 10));
  EXPECT_EQ(rational_from_double(-0.375), Rational(-3, 8));
  EXPECT_EQ(rational_from_double(0.0), Rational(0));
  EXPECT_EQ(rational_from_double(-0.0), Rational(0));
  EXPECT_EQ(rational_from_double(1e15), Rational(1000000000000000));
  EXPECT_EQ(rational_from_double(M_PI), std::nullopt);
  EXPECT_EQ(rational_from_double(1.0 / 3.0), std::nullopt);
  EXPECT_EQ(rational_from_double(1e300), std::nullopt);
  EXPECT_EQ(rational_from_double(5e-324), std::nullopt);
  EXPECT_EQ(rational_from_double(std::numeric_limits<double>::infinity()), std::nullopt);
  EXPECT_EQ(rational_from_double(std::numeric_limits<double>::quiet_NaN()), std::nullopt);
}

TEST(Rational, FromDoubleGivesBackTheDouble) {
  TestRandom random(2);
  int exact = 0;
  for (int i = 0; i < 5000; ++i) {
    const double value = std::round(random.uniform(-1000, 1000) * 1e6) / 1e6;
    if (const auto found = rational_from_double(value)) {
      EXPECT_EQ(found->to_double(), value);
      ++exact;
    }
  }
  EXPECT_EQ(exact, 5000);
}

}  // namespace
}  // namespace alembert
