// Normal form and the rules of construction.
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "symbolic/count_operations.hpp"
#include "symbolic/evaluate.hpp"
#include "symbolic/expr.hpp"
#include "symbolic/guarded.hpp"
#include "symbolic/postorder.hpp"
#include "symbolic/same.hpp"
#include "symbolic/to_string.hpp"
#include "symbolic/transferred.hpp"

namespace alembert {
namespace {

class Construction : public testing::Test {
 protected:
  ExprGraph g;
  Expr x = g.symbol("x"), y = g.symbol("y"), z = g.symbol("z");
  Expr zero = g.zero(), one = g.one(), two = g.integer(2), three = g.integer(3), half = g.rational({1, 2});
};

TEST_F(Construction, EqualTextsAreEqualNodes) {
  EXPECT_TRUE(same(x + y, y + x));
  EXPECT_TRUE(same(x * y, y * x));
  EXPECT_TRUE(same(x - y, -(y - x)));
  EXPECT_TRUE(same((-x) * y, -(x * y)));
  EXPECT_TRUE(same((-x) / (-y), x / y));
  EXPECT_EQ(g.symbol("x"), x);
  EXPECT_NE(x, y);
  EXPECT_NE(x, -x);
  EXPECT_EQ((x - y).ref().node(), (y - x).ref().node());
}

TEST_F(Construction, ThereIsOneZero) {
  EXPECT_EQ(-zero, zero);
  EXPECT_TRUE(same(x - x, zero));
  EXPECT_TRUE(same(zero * x, zero));
  EXPECT_TRUE(same(-(x * zero), zero));
  EXPECT_TRUE(same(g.real(-0.0), zero));
  EXPECT_TRUE(same(zero / x, zero));
  EXPECT_TRUE((half - half).is_zero());
}

TEST_F(Construction, Units) {
  EXPECT_TRUE(same(x + zero, x));
  EXPECT_TRUE(same(one * x, x));
  EXPECT_TRUE(same(x / one, x));
  EXPECT_TRUE(same(x / x, one));
  EXPECT_TRUE(same(x / -x, -one));
  EXPECT_TRUE((half * two).is_one());
}

TEST_F(Construction, NumbersFoldExactly) {
  EXPECT_TRUE(same(g.rational({1, 3}) + g.rational({1, 6}), half));
  EXPECT_TRUE(same(g.real(0.1) + g.real(0.2), g.rational({3, 10})));
  EXPECT_TRUE(same(g.pi({1, 3}) + g.pi({1, 6}), g.pi({1, 2})));
  EXPECT_TRUE(same(two * g.pi({1, 2}), g.pi()));
  EXPECT_TRUE(same(g.pi() / g.pi({1, 2}), two));
  EXPECT_TRUE(same(g.pi() - g.pi(), zero));
  EXPECT_TRUE(same((one + g.pi()) - g.pi(), one));
}

TEST_F(Construction, OverflowFallsBackToDouble) {
  const std::int64_t large = std::int64_t{1} << 62;
  const Expr square = g.integer(large) * g.integer(large);
  EXPECT_TRUE(square.is_constant());
  EXPECT_EQ(evaluate(std::vector<Expr>{square}, {})[0], 0x1p124);
  EXPECT_TRUE(same(square / square, one));
  const Expr sum = g.rational({1, large - 1}) + g.rational({1, large - 3});
  EXPECT_NEAR(evaluate(std::vector<Expr>{sum}, {})[0], 2.0 / 0x1p62, 1e-30);
  EXPECT_THROW(g.real(1e308) * g.integer(1000), std::domain_error);
}

TEST_F(Construction, LikeTermsAndConstantFactors) {
  EXPECT_TRUE(same(x + x, two * x));
  EXPECT_TRUE(same(two * x + three * x, g.integer(5) * x));
  EXPECT_TRUE(same(half * x + half * x, x));
  EXPECT_TRUE(same(two * x - x, x));
  EXPECT_TRUE(same(two * (three * x), g.integer(6) * x));
  EXPECT_TRUE(same((two * x) * (three * y), g.integer(6) * (x * y)));
  EXPECT_TRUE(same(x / two, half * x));
  EXPECT_TRUE(same((two * x) / (three * y), g.rational({2, 3}) * (x / y)));
  EXPECT_TRUE(same(two / y + three / y, g.integer(5) / y));
  EXPECT_TRUE(same((two + x) + three, g.integer(5) + x));
  EXPECT_TRUE(same(two * x + (three * x + y), g.integer(5) * x + y));
  const Expr c = sin(g.rational({3, 10}));
  EXPECT_TRUE(same(c * (two * x), (two * c) * x));
  EXPECT_TRUE(same(c * x - c * x, zero));
}

TEST_F(Construction, SumsCancel) {
  EXPECT_TRUE(same((x + y) - x, y));
  EXPECT_TRUE(same(x - (x + y), -y));
  EXPECT_TRUE(same(x + (y - x), y));
  EXPECT_TRUE(same((x + y) - (x + z), y - z));
  EXPECT_TRUE(same((x - y) + (y + z), x + z));
}

TEST_F(Construction, QuotientsCancel) {
  EXPECT_TRUE(same((x * y) / y, x));
  EXPECT_TRUE(same((x / y) * y, x));
  EXPECT_TRUE(same(x / (x * y), one / y));
  EXPECT_TRUE(same((x * y) / (x * z), y / z));
  EXPECT_TRUE(same(x / (y / z), (x * z) / y));
  EXPECT_TRUE(same((x / y) / z, x / (y * z)));
  EXPECT_TRUE(same((x / y) * (y / z), x / z));
}

TEST_F(Construction, ReciprocalsStayShared) {
  // Three components times one reciprocal are one division, not three.
  const Expr inverse = two / sqrt(x);
  const std::vector<Expr> components{inverse * x, inverse * y, inverse * z};
  EXPECT_LE(count_operations(components).div, 1u);
}

/// Where a condition does not choose them, expressions have a value.
TEST_F(Construction, WhatIsNotChosenIsGuarded) {
  for (const Expr& e :
       {sqrt(x) * sin(y), log(x) / x, pow(x, y), acos(one / x + y), y / (x - sqrt(x)) + z, log(abs(x))}) {
    const Expr safe = guarded(Operation::if_positive, x, e);
    for (const double at : {-2.0, 0.0})
      EXPECT_TRUE(std::isfinite(evaluate(std::vector<Expr>{safe}, std::vector<double>{at, 0.3, 0.7})[0]));
  }
  const Expr chosen = guarded(Operation::if_positive, x, sqrt(x) / y);
  EXPECT_DOUBLE_EQ(evaluate(std::vector<Expr>{chosen}, std::vector<double>{4, 2, 0})[0], 1);
  EXPECT_TRUE(same(guarded(Operation::if_positive, x, y * z + sin(x)), y * z + sin(x)));
}

TEST_F(Construction, Roots) {
  EXPECT_TRUE(same(sqrt(x) * sqrt(x), x));
  EXPECT_TRUE(same(x / sqrt(x), sqrt(x)));
  EXPECT_TRUE(same(sqrt(x) / x, one / sqrt(x)));
  EXPECT_TRUE(same(sqrt(x * x), abs(x)));
  EXPECT_TRUE(same(sqrt((x * x) * y), abs(x) * sqrt(y)));
  EXPECT_TRUE(same(sqrt(x / (y * y)), sqrt(x) / abs(y)));
  EXPECT_TRUE(same(abs(x) * abs(x), x * x));
  EXPECT_TRUE(same(sqrt(g.rational({9, 4})), g.rational({3, 2})));
  EXPECT_TRUE(same(sqrt(g.integer(12)), two * sqrt(three)));
  EXPECT_TRUE(same(sqrt(half) * sqrt(two), one));
  EXPECT_TRUE(same(sqrt(two) * sqrt(three), sqrt(g.integer(6))));
  EXPECT_TRUE(same(one / sqrt(two), half * sqrt(two)));
  EXPECT_TRUE(same(sqrt(g.integer(4) * x), two * sqrt(x)));
}

TEST_F(Construction, RootsOfSquaresUnderProvenSign) {
  g.assume(x, {0.5, 2});
  EXPECT_TRUE(same(sqrt(x * x), x));
  EXPECT_TRUE(same(abs(x), x));
  EXPECT_TRUE(same(sign(x), one));
  EXPECT_TRUE(same(abs(-x), x));
  const Expr tube = x - half * cos(y);  // 1/2 - 1/2 is not below zero
  EXPECT_TRUE(same(sqrt(tube * tube), tube));
  g.assume(z, {-3, -1});
  EXPECT_TRUE(same(abs(z), -z));
  EXPECT_TRUE(same(sqrt(z * z), -z));
  EXPECT_TRUE(same(sign(z * z), one));
}

TEST_F(Construction, Powers) {
  EXPECT_TRUE(same(pow(x, 3), x * (x * x)));
  EXPECT_TRUE(same(pow(x, 0), one));
  EXPECT_TRUE(same(pow(x, -1), one / x));
  EXPECT_TRUE(same(pow(x, half), sqrt(x)));
  EXPECT_TRUE(same(pow(x, g.rational({3, 2})), x * sqrt(x)));
  EXPECT_TRUE(same(pow(two, g.integer(10)), g.integer(1024)));
  EXPECT_TRUE(same(pow(x, y), pow(x, y)));
  EXPECT_TRUE(same(pow(one, y), one));
  EXPECT_LE(count_operations(std::vector<Expr>{pow(x, 1000)}).mul, 20u);
}

TEST_F(Construction, Functions) {
  EXPECT_TRUE(same(exp(zero), one));
  EXPECT_TRUE(same(log(one), zero));
  EXPECT_TRUE(same(exp(log(x)), x));
  EXPECT_TRUE(same(log(exp(x)), x));
  EXPECT_TRUE(same(cosh(-x), cosh(x)));
  EXPECT_TRUE(same(sinh(-x), -sinh(x)));
  EXPECT_TRUE(same(tanh(-x), -tanh(x)));
  EXPECT_TRUE(same(sign(-x), -sign(x)));
  EXPECT_TRUE(same(abs(-x), abs(x)));
  EXPECT_TRUE(same(sign(x) * abs(x), x));
  EXPECT_TRUE(same(sign(x) * x, abs(x)));
  EXPECT_TRUE(same(cosh(x) * cosh(x) - sinh(x) * sinh(x), one));
}

TEST_F(Construction, WhatIsNotDefinedThrows) {
  EXPECT_THROW(x / zero, std::domain_error);
  EXPECT_THROW(pow(zero, -1), std::domain_error);
  EXPECT_THROW(sqrt(g.integer(-1)), std::domain_error);
  EXPECT_THROW(sqrt(one - sqrt(two)), std::domain_error);
  EXPECT_THROW(log(zero), std::domain_error);
  EXPECT_THROW(log(g.integer(-2)), std::domain_error);
  EXPECT_THROW(asin(two), std::domain_error);
  EXPECT_THROW(acos(g.integer(-2)), std::domain_error);
  EXPECT_THROW(tan(g.pi({1, 2})), std::domain_error);
  EXPECT_THROW(g.real(std::numeric_limits<double>::quiet_NaN()), std::domain_error);
  EXPECT_THROW(g.real(std::numeric_limits<double>::infinity()), std::domain_error);
}

TEST_F(Construction, GraphsDoNotMix) {
  ExprGraph other;
  EXPECT_THROW(x + other.symbol("x"), std::logic_error);
  EXPECT_THROW(atan2(other.one(), x), std::logic_error);
  EXPECT_THROW(x + Expr(), std::logic_error);
  EXPECT_THROW(sin(Expr()), std::logic_error);
  EXPECT_THROW(g.make(Operation::symbol, x.ref()), std::logic_error);
}

TEST_F(Construction, SymbolsHaveAnyName) {
  const std::string odd("a \"quoted\"\n*/\0name", 18);
  EXPECT_EQ(g.symbol(odd), g.symbol(odd));
  EXPECT_EQ(g.symbol_name(g.symbol_index(g.symbol(odd).ref().node())), odd);
  EXPECT_NE(g.symbol(""), g.symbol(odd));
}

TEST_F(Construction, DoublesThatCancelToRoundingAreZero) {
  const double c = std::sqrt(3.0) / 7;
  const Expr computed = g.real(c);
  EXPECT_TRUE(same(g.real(std::nextafter(std::nextafter(c, 1), 1)) - computed, zero));
  EXPECT_TRUE(same(g.real(std::nextafter(c, 1)) - computed + half, half));
  EXPECT_FALSE((g.real(c * (1 + 1e-13)) - computed).is_zero());
  // What is written is exact.
  EXPECT_FALSE((g.rational({1000000000000000001, 1000000000000000000}) - one).is_zero());
}

TEST_F(Construction, KeepsBracketsWhereTold) {
  const Expr tenth = g.real(0.1), scaled = tenth * x;
  EXPECT_TRUE(same(scaled * y, tenth * (x * y)));
  const auto kept = g.keep_brackets();
  const Expr product = scaled * y, quotient = z / scaled;
  const auto operands = [&](Expr e) {
    const Node& n = g.node(e.ref().node());
    return std::pair(Expr(g, n.a), Expr(g, n.b));
  };
  EXPECT_TRUE(operands(product) == std::pair(scaled, y) || operands(product) == std::pair(y, scaled));
  EXPECT_EQ(operands(quotient), std::pair(z, scaled));
  // What operands alone decide still folds.
  EXPECT_TRUE(same(tenth * scaled, g.real(0.01) * x));
  EXPECT_TRUE(same(scaled - scaled, zero));
  EXPECT_TRUE(same(one / scaled, g.real(10) / x));
}

TEST_F(Construction, IsTransferredNodeForNode) {
  g.assume(x, {0, 2});
  const Expr scaled = g.real(0.1) * x;
  std::vector<Expr> roots{-sin(scaled) / sqrt(x), atan2(y, g.pi(Rational(1, 3)) + z), g.integer(-3), y};
  {
    const auto kept = g.keep_brackets();
    roots.push_back(scaled * y);  // bracketed: rules of construction would take it apart
  }
  ExprGraph other;
  const std::vector<Expr> there = transferred(roots, other);
  ASSERT_EQ(there.size(), roots.size());
  for (std::size_t i = 0; i < roots.size(); ++i) {
    EXPECT_EQ(&there[i].graph(), &other);
    EXPECT_EQ(to_string(there[i]), to_string(roots[i]));
  }
  EXPECT_EQ(postorder(there).size(), postorder(roots).size());
  const Interval there_x = other.bounds(other.symbol("x").ref());
  EXPECT_EQ(there_x.lower, 0);
  EXPECT_EQ(there_x.upper, 2);
  // And back: the very same nodes.
  EXPECT_EQ(transferred(there, g), roots);
  EXPECT_TRUE(transferred({}, other).empty());
}

TEST_F(Construction, FlagsConstants) {
  EXPECT_TRUE((sin(g.rational({3, 10})) * sqrt(two) + g.pi()).is_constant());
  EXPECT_FALSE((x + one).is_constant());
}

}  // namespace
}  // namespace alembert
