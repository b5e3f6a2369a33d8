// Expressions in descriptions: what they become in the graph. Read through a parameter's or a translation's
// value.
#include <gtest/gtest.h>

#include "mechanism/loaded.hpp"

namespace alembert {
namespace {

using test::error_of;
using test::Loaded;
using test::shift;

/// A description whose only body is shifted along x by `expression`, over q, p, parameters r = 1/4 and k
/// (runtime).
std::string shifted(const std::string& expression) {
  return test::with_parameters("[\"" + expression + "\", q, p]", "[{name: q, initial: 0.5}, p]");
}

TEST(ExpressionReader, KeepsDecimalsExactly) {
  for (const auto& [text, n, d] : {std::tuple{"0.1", 1, 10},
                                   {"1.5e-3", 3, 2000},
                                   {".5", 1, 2},
                                   {"5.", 5, 1},
                                   {"1e3", 1000, 1},
                                   {"0.4318", 2159, 5000},
                                   {"1/3", 1, 3},
                                   {"0.1 + 0.2", 3, 10},
                                   {"010", 10, 1}}) {
    Loaded loaded(shifted(text));
    EXPECT_EQ(shift(loaded), loaded.number(n, d)) << text;
  }
}
TEST(ExpressionReader, KeepsNumbersBeyondRationalsAsDoubles) {
  Loaded loaded(shifted("6.02214076e30"));
  EXPECT_EQ(shift(loaded), loaded.graph.real(6.02214076e30));
}
TEST(ExpressionReader, KeepsPiExactly) {
  Loaded loaded(shifted("-3*pi/4"));
  EXPECT_EQ(shift(loaded), -loaded.graph.pi(Rational(3, 4)));
  Loaded folded(shifted("q*cos(pi/2) + sin(pi/2)"));
  EXPECT_EQ(shift(folded), folded.graph.one());
}
TEST(ExpressionReader, FollowsPrecedence) {
  {
    Loaded loaded(shifted("-2^2"));
    EXPECT_EQ(shift(loaded), loaded.number(-4));
  }
  {
    Loaded loaded(shifted("2^3^2"));
    EXPECT_EQ(shift(loaded), loaded.number(512));
  }
  {
    Loaded loaded(shifted("2^-1*3"));
    EXPECT_EQ(shift(loaded), loaded.number(3, 2));
  }
  {
    Loaded loaded(shifted("7 - 2 - 1 + 8/2/2*3"));
    EXPECT_EQ(shift(loaded), loaded.number(10));
  }
}
TEST(ExpressionReader, FoldsParametersAndKeepsRuntimeOnes) {
  Loaded loaded(shifted("r*q + k*p"));
  EXPECT_EQ(shift(loaded),
            loaded.number(1, 4) * loaded.symbol("q") + loaded.symbol("k") * loaded.symbol("p"));
}
TEST(ExpressionReader, ReadsTime) {
  Loaded loaded(shifted("q + sin(2*t)"));
  EXPECT_EQ(shift(loaded), loaded.symbol("q") + sin(loaded.number(2) * loaded.mechanism.time));
}
TEST(ExpressionReader, BuildsEveryFunction) {
  const auto one = [](const char* text, Expr (*build)(Expr)) {
    Loaded loaded(shifted(text));
    EXPECT_EQ(shift(loaded), build(loaded.symbol("q"))) << text;
  };
  one("sin(q)", [](Expr x) { return sin(x); });
  one("cos(q)", [](Expr x) { return cos(x); });
  one("tan(q)", [](Expr x) { return tan(x); });
  one("asin(q)", [](Expr x) { return asin(x); });
  one("acos(q)", [](Expr x) { return acos(x); });
  one("atan(q)", [](Expr x) { return atan(x); });
  one("sqrt(q)", [](Expr x) { return sqrt(x); });
  one("exp(q)", [](Expr x) { return exp(x); });
  one("log(q)", [](Expr x) { return log(x); });
  one("sinh(q)", [](Expr x) { return sinh(x); });
  one("cosh(q)", [](Expr x) { return cosh(x); });
  one("tanh(q)", [](Expr x) { return tanh(x); });
  Loaded loaded(shifted("atan2(q, p + 1)"));
  EXPECT_EQ(shift(loaded), atan2(loaded.symbol("q"), loaded.symbol("p") + loaded.number(1)));
}
TEST(ExpressionReader, BuildsPowers) {
  {
    Loaded loaded(shifted("q^3"));
    EXPECT_EQ(shift(loaded), pow(loaded.symbol("q"), 3));
  }
  {
    Loaded loaded(shifted("q^-2"));
    EXPECT_EQ(shift(loaded), pow(loaded.symbol("q"), -2));
  }
  {
    Loaded loaded(shifted("q^0.5"));
    EXPECT_EQ(shift(loaded), sqrt(loaded.symbol("q")));
  }
  {
    Loaded loaded(shifted("q^(1/3)"));
    EXPECT_EQ(shift(loaded), pow(loaded.symbol("q"), loaded.number(1, 3)));
  }
  {
    Loaded loaded(shifted("2^q"));
    EXPECT_EQ(shift(loaded), pow(loaded.number(2), loaded.symbol("q")));
  }
}
TEST(ExpressionReader, AcceptsAbsWhereTheSignIsProven) {
  Loaded loaded(shifted("abs(2 + cos(q))"));
  EXPECT_EQ(shift(loaded), loaded.number(2) + cos(loaded.symbol("q")));
  Loaded constant(shifted("q*abs(r - 1)"));
  EXPECT_EQ(shift(constant), constant.number(3, 4) * constant.symbol("q"));
  EXPECT_EQ(error_of(shifted("q*abs(k)")), "");
  EXPECT_NE(error_of(shifted("abs(q)")), "");
}
TEST(ExpressionReader, ChecksValuesAtTheInitialState) {
  EXPECT_EQ(error_of(shifted("1/q")), "");
  EXPECT_NE(error_of(shifted("1/(q - 0.5)")).find("division by zero: '(q - 0.5)' is 0 at the initial state"),
            std::string::npos);
  EXPECT_NE(error_of(shifted("sqrt(q - k)")).find("sqrt of a negative number: 'q - k' is -2.5"),
            std::string::npos);
  EXPECT_NE(error_of(shifted("1/p")), "");
  EXPECT_NE(error_of(shifted("0/t")), "");
}
TEST(ExpressionReader, SurvivesHugeValues) {
  EXPECT_NE(error_of(shifted("(1e300*q)*1e300*p")), "");
  EXPECT_NE(error_of(shifted("exp(1000)")), "");
  EXPECT_NE(error_of(shifted("2^1000000")), "");
  EXPECT_NE(error_of(shifted("10^(10^10)")), "");
  EXPECT_EQ(error_of(shifted("q^1000000")), "");
}
TEST(ExpressionReader, NamesWhatIsNear) {
  EXPECT_NE(error_of(shifted("q + kk")).find("unknown name 'kk' (did you mean 'k'?)"), std::string::npos);
  EXPECT_NE(error_of(shifted("sine(q)")).find("unknown function 'sine' (did you mean 'sin'?)"),
            std::string::npos);
}
TEST(ExpressionReader, ReadsFoldedAndBlockScalars) {
  Loaded loaded(
      "alembert: 1\nname: one\ncoordinates: [q]\ndefinitions:\n  phi: >\n    1 +\n    q\nbodies:\n"
      "  - {name: arm, mass: 1, transform: [{translate: [phi, 0, 0]}]}\n");
  EXPECT_EQ(shift(loaded), loaded.symbol("q") + loaded.number(1));
}

}  // namespace
}  // namespace alembert
