// Text of expressions.
#include <gmock/gmock.h>

#include "symbolic/same.hpp"

namespace alembert {
namespace {

TEST(ToString, NeedsFewParentheses) {
  ExprGraph g;
  const Expr a = g.symbol("a"), b = g.symbol("b"), c = g.symbol("c");
  EXPECT_THAT(to_string(a + b), testing::AnyOf("a + b", "b + a"));
  EXPECT_EQ(to_string(a - b), "a - b");
  EXPECT_EQ(to_string(b - a), "b - a");
  EXPECT_EQ(to_string(-sin(a)), "-sin(a)");
  EXPECT_EQ(to_string(g.integer(2) * a), "2*a");
  EXPECT_EQ(to_string(-g.rational({1, 2}) * a), "-1/2*a");
  EXPECT_EQ(to_string(a / b), "a/b");
  EXPECT_THAT(to_string(a / (b * c)), testing::AnyOf("a/(b*c)", "a/(c*b)"));
  EXPECT_EQ(to_string((a - b) / c), "(a - b)/c");
  EXPECT_EQ(to_string(c / (a - b)), "c/(a - b)");
  EXPECT_EQ(to_string(atan2(a - b, c)), "atan2(a - b, c)");
  EXPECT_EQ(to_string(g.pi({2, 3})), "2*pi/3");
  EXPECT_EQ(to_string(g.pi()), "pi");
  EXPECT_EQ(to_string(a / g.pi()), "1/pi*a");
  EXPECT_EQ(to_string(g.zero()), "0");
  EXPECT_EQ(to_string(-g.one()), "-1");
  EXPECT_EQ(to_string(a - g.one()), "a - 1");
  EXPECT_EQ(to_string(Expr()), "<none>");
}

TEST(ToString, SignsOfSumsReadRight) {
  ExprGraph g;
  const Expr a = g.symbol("a"), b = g.symbol("b"), c = g.symbol("c");
  for (const Expr x :
       {-(a + b), a - (b + c), (a - b) - c, -(a - b) * c, a - (b - c), -a - b - c, g.one() - (a + b)}) {
    // Read back by hand: + and - at depth 0, products of single letters elsewhere.
    const std::string text = to_string(x);
    EXPECT_EQ(text.find("--"), std::string::npos) << text;
    EXPECT_EQ(text.find("+ -"), std::string::npos) << text;
    EXPECT_EQ(text.find("- -"), std::string::npos) << text;
  }
}

TEST(ToString, IsBoundedOnSharing) {
  ExprGraph g;
  Expr x = g.symbol("x");
  for (int i = 0; i < 200; ++i) x = x * x + sin(x);
  const std::string text = to_string(x, 50);
  EXPECT_EQ(text.size(), 53u);
  EXPECT_EQ(text.substr(50), "...");
}

}  // namespace
}  // namespace alembert
