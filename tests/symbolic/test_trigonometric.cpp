// Sines, cosines and their inverses: exact angles, quarter turns, the circle.
#include <cmath>

#include "symbolic/evaluate.hpp"
#include "symbolic/same.hpp"

namespace alembert {
namespace {

class Trigonometric : public testing::Test {
 protected:
  ExprGraph g;
  Expr x = g.symbol("x"), y = g.symbol("y"), f = g.symbol("f");
  Expr one = g.one();
};

TEST_F(Trigonometric, ParityMovesSignsOut) {
  EXPECT_TRUE(same(sin(-x), -sin(x)));
  EXPECT_TRUE(same(cos(-x), cos(x)));
  EXPECT_TRUE(same(tan(-x), -tan(x)));
  EXPECT_TRUE(same(asin(-x), -asin(x)));
  EXPECT_TRUE(same(atan(-x), -atan(x)));
  EXPECT_TRUE(same(atan2(-y, x), -atan2(y, x)));
  EXPECT_TRUE(same(sin(x - y), -sin(y - x)));
  EXPECT_TRUE(same(cos(x - y), cos(y - x)));
}

TEST_F(Trigonometric, ExactAtMultiplesOfPi) {
  for (int n = -24; n <= 24; ++n) {
    for (const int d : {1, 2, 3, 4, 5, 6, 12}) {
      const Expr angle = g.pi(*make_rational(n, d));
      const double value = M_PI * n / d;
      const std::vector<Expr> both{sin(angle), cos(angle)};
      const std::vector<double> found = evaluate(both, {});
      EXPECT_NEAR(found[0], std::sin(value), 1e-14) << n << "/" << d;
      EXPECT_NEAR(found[1], std::cos(value), 1e-14) << n << "/" << d;
      EXPECT_TRUE(same(both[0] * both[0] + both[1] * both[1], one)) << n << "/" << d;
      if (std::abs(std::cos(value)) > 1e-9) {
        EXPECT_NEAR(evaluate(std::vector<Expr>{tan(angle)}, {})[0], std::tan(value), 1e-12) << n << "/" << d;
      }
    }
  }
  EXPECT_TRUE(same(cos(g.pi({1, 2})), g.zero()));
  EXPECT_TRUE(same(sin(g.pi({1, 6})), g.rational({1, 2})));
  EXPECT_TRUE(same(cos(g.pi({1, 3})), g.rational({1, 2})));
  EXPECT_TRUE(same(tan(g.pi({3, 4})), -one));
  EXPECT_TRUE(same(sin(g.pi({1, 5})), cos(g.pi({3, 10}))));
}

TEST_F(Trigonometric, QuarterTurnsShift) {
  EXPECT_TRUE(same(sin(x + g.pi({1, 2})), cos(x)));
  EXPECT_TRUE(same(cos(x + g.pi({1, 2})), -sin(x)));
  EXPECT_TRUE(same(sin(g.pi({1, 2}) - x), cos(x)));
  EXPECT_TRUE(same(cos(x - g.pi({1, 2})), sin(x)));
  EXPECT_TRUE(same(sin(x + g.pi()), -sin(x)));
  EXPECT_TRUE(same(sin(x + g.pi(Rational(-7))), -sin(x)));
  EXPECT_TRUE(same(cos(g.pi({3, 2}) - x), -sin(x)));
  EXPECT_TRUE(same(tan(x + g.pi()), tan(x)));
  EXPECT_TRUE(same(sin(x + g.pi({1, 3})), cos(x - g.pi({1, 6}))));
  EXPECT_TRUE(same(sin((x + g.pi({1, 2})) + y), cos(x + y)));
}

TEST_F(Trigonometric, ShiftsHaveTheRightValue) {
  for (int n = -12; n <= 12; ++n) {
    for (const Expr angle : {x + g.pi(*make_rational(n, 6)), g.pi(*make_rational(n, 4)) - x}) {
      const std::vector<Expr> roots{angle, sin(angle), cos(angle), tan(angle)};
      const std::vector<double> at{0.7, 0, 0};
      const std::vector<double> value = evaluate(roots, at);
      EXPECT_NEAR(value[1], std::sin(value[0]), 1e-13) << to_string(angle);
      EXPECT_NEAR(value[2], std::cos(value[0]), 1e-13) << to_string(angle);
      EXPECT_NEAR(value[3], std::tan(value[0]), 1e-11) << to_string(angle);
    }
  }
}

TEST_F(Trigonometric, Circle) {
  const Expr s = sin(x), c = cos(x);
  EXPECT_TRUE(same(s * s + c * c, one));
  EXPECT_TRUE(same(f * s * s + c * c * f, f));
  EXPECT_TRUE(same((f * s) * (f * s) + (f * c) * (c * f), f * f));
  EXPECT_TRUE(same(-(f * s * s) - f * c * c, -f));
  EXPECT_TRUE(same(one - s * s, c * c));
  EXPECT_TRUE(same(one - c * c, s * s));
  EXPECT_TRUE(same(s * s - one, -(c * c)));
  EXPECT_TRUE(same(g.integer(3) - g.integer(3) * s * s, g.integer(3) * (c * c)));
  const Expr constant = g.rational({3, 10});
  EXPECT_TRUE(same(sin(constant) * sin(constant) + cos(constant) * cos(constant), one));
  EXPECT_NE(s * s - c * c, one);
  EXPECT_NE(f * s * s + c * c, f);
}

TEST_F(Trigonometric, Inverses) {
  EXPECT_TRUE(same(sin(asin(x)), x));
  EXPECT_TRUE(same(cos(acos(x)), x));
  EXPECT_TRUE(same(tan(atan(x)), x));
  EXPECT_TRUE(same(cos(asin(x)), sqrt(one - x * x)));
  EXPECT_TRUE(same(sin(acos(x)), sqrt(one - x * x)));
  EXPECT_TRUE(same(sin(atan2(y, x)), y / sqrt(x * x + y * y)));
  EXPECT_TRUE(same(cos(atan2(y, x)), x / sqrt(x * x + y * y)));
  EXPECT_TRUE(same(sin(atan(x)), x / sqrt(one + x * x)));
  EXPECT_TRUE(same(tan(atan2(y, x)), y / x));
}

TEST_F(Trigonometric, InversesOfConstants) {
  EXPECT_TRUE(same(asin(g.rational({1, 2})), g.pi({1, 6})));
  EXPECT_TRUE(same(acos(g.rational({-1, 2})), g.pi({2, 3})));
  EXPECT_TRUE(same(acos(g.zero()), g.pi({1, 2})));
  EXPECT_TRUE(same(acos(one), g.zero()));
  EXPECT_TRUE(same(acos(-one), g.pi()));
  EXPECT_TRUE(same(atan(-one), g.pi({-1, 4})));
  EXPECT_TRUE(same(atan(sqrt(g.integer(3))), g.pi({1, 3})));
  for (int n = -5; n <= 6; ++n) {
    const Expr angle = g.pi(*make_rational(n, 6));
    EXPECT_TRUE(same(atan2(sin(angle), cos(angle)), angle)) << n;
  }
  EXPECT_TRUE(same(atan2(-one, -one), g.pi({-3, 4})));
  EXPECT_TRUE(same(atan2(g.zero(), -one), g.pi()));
  EXPECT_TRUE(same(atan2(g.zero(), one), g.zero()));
  const std::vector<Expr> some{atan2(g.integer(1), g.integer(-2)), atan2(g.integer(-3), g.integer(-2)),
                               atan2(g.integer(3), g.integer(2))};
  const std::vector<double> value = evaluate(some, {});
  EXPECT_NEAR(value[0], std::atan2(1, -2), 1e-15);
  EXPECT_NEAR(value[1], std::atan2(-3, -2), 1e-15);
  EXPECT_NEAR(value[2], std::atan2(3, 2), 1e-15);
}

}  // namespace
}  // namespace alembert
