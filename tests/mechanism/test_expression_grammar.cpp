#include <gtest/gtest.h>

#include "mechanism/expression_grammar.hpp"

namespace alembert {
namespace {

/// Postfix text: operators as themselves, negation as `~`, calls as name/arguments.
std::string postfix(std::string_view text) {
  std::string out;
  for (const PostfixToken& token : parse_expression(text)) {
    const std::string piece(text.substr(token.begin, token.end - token.begin));
    switch (token.kind) {
      case PostfixToken::Kind::number:
      case PostfixToken::Kind::name:
        out += piece;
        break;
      case PostfixToken::Kind::reference:
        out += std::string(text.substr(token.begin, token.close - token.begin));
        break;
      case PostfixToken::Kind::call:
        out += piece + "/" + std::to_string(token.arguments);
        break;
      case PostfixToken::Kind::spline:
        out += piece + "/" + std::to_string(token.arguments) + "," + std::to_string(token.knots);
        break;
      case PostfixToken::Kind::add:
      case PostfixToken::Kind::subtract:
      case PostfixToken::Kind::multiply:
      case PostfixToken::Kind::divide:
      case PostfixToken::Kind::power:
        out += piece;
        break;
      case PostfixToken::Kind::negate:
        out += "~";
        break;
      case PostfixToken::Kind::group:
        continue;
    }
    out += ' ';
  }
  if (!out.empty()) out.pop_back();
  return out;
}

TEST(ExpressionGrammar, ReadsReferences) {
  EXPECT_EQ(postfix("2*d(q1) - d"), "2 d(q1) * d -");
  EXPECT_EQ(postfix("d ( base ) . x"), "d ( base ) . x");
  EXPECT_EQ(postfix("-position(tip).y^2"), "position(tip).y 2 ^ ~");
  EXPECT_EQ(postfix("dd(q)"), "q dd/1");
  EXPECT_EQ(postfix("positions(q)"), "q positions/1");
}
TEST(ExpressionGrammar, ReadsSplines) {
  EXPECT_EQ(postfix("spline(x; [0, 1]; [a, b])"), "x 0 1 a b spline/5,2");
  EXPECT_EQ(postfix("spline( x ; 0 , 1 , 2 ; a+b , sin(c), 3 ) * 2"),
            "x 0 1 2 a b + c sin/1 3 spline/7,3 2 *");
  EXPECT_EQ(postfix("spline (spline(x; 0; 1); [0]; 1, 2)"), "x 0 1 spline/3,1 0 1 2 spline/4,1");
  EXPECT_EQ(postfix("splines(x)"), "x splines/1");
  for (const char* text :
       {"spline(x, [0, 1], [0, 1])", "spline(x; [0, 1])", "spline(x; []; [])", "spline(x; [0; 1])",
        "spline(x; [0, 1]; [0, 1]; 2)", "spline(x; [[0, 1]]; [1])", "spline()", "[0]", "sin([x])"})
    EXPECT_THROW(parse_expression(text), SyntaxError) << text;
}
TEST(ExpressionGrammar, BindsProductsBeforeSums) {
  EXPECT_EQ(postfix("a + b*c"), "a b c * +");
  EXPECT_EQ(postfix("a*b + c"), "a b * c +");
  EXPECT_EQ(postfix("(a + b)*c"), "a b + c *");
}
TEST(ExpressionGrammar, AssociatesToTheLeft) {
  EXPECT_EQ(postfix("a - b - c"), "a b - c -");
  EXPECT_EQ(postfix("a/b/c"), "a b / c /");
  EXPECT_EQ(postfix("a/b*c"), "a b / c *");
  EXPECT_EQ(postfix("a - b + c"), "a b - c +");
}
TEST(ExpressionGrammar, AssociatesPowersToTheRight) {
  EXPECT_EQ(postfix("a^b^c"), "a b c ^ ^");
}
TEST(ExpressionGrammar, NegatesAfterPowers) {
  EXPECT_EQ(postfix("-a^2"), "a 2 ^ ~");
  EXPECT_EQ(postfix("(-a)^2"), "a ~ 2 ^");
  EXPECT_EQ(postfix("a^-b"), "a b ~ ^");
  EXPECT_EQ(postfix("a^-b^c"), "a b c ^ ~ ^");
  EXPECT_EQ(postfix("a^-b*c"), "a b ~ ^ c *");
}
TEST(ExpressionGrammar, NegatesBeforeProducts) {
  EXPECT_EQ(postfix("-a*b"), "a ~ b *");
  EXPECT_EQ(postfix("a*-b"), "a b ~ *");
  EXPECT_EQ(postfix("a - -b"), "a b ~ -");
  EXPECT_EQ(postfix("+a"), "a");
  EXPECT_EQ(postfix("--a"), "a ~ ~");
}
TEST(ExpressionGrammar, ReadsNumbers) {
  for (const char* number : {"0", "12", "1.5", ".5", "5.", "1e3", "1E-3", "1.5e+10", "007"})
    EXPECT_EQ(postfix(number), number);
}
TEST(ExpressionGrammar, ReadsCalls) {
  EXPECT_EQ(postfix("sin(a)"), "a sin/1");
  EXPECT_EQ(postfix("atan2(a + b, c)"), "a b + c atan2/2");
  EXPECT_EQ(postfix("sin ( cos(a) )"), "a cos/1 sin/1");
  EXPECT_EQ(postfix("f(a, b, c)"), "a b c f/3");
  EXPECT_EQ(postfix("sinus"), "sinus");
}
TEST(ExpressionGrammar, SkipsBlanks) {
  EXPECT_EQ(postfix(" a\t+\nb "), "a b +");
}

TEST(ExpressionGrammar, PlacesCallsAndGroups) {
  const auto tokens = parse_expression("1 + (sin( x ))");
  ASSERT_EQ(tokens.size(), 5u);
  EXPECT_EQ(tokens[2].kind, PostfixToken::Kind::call);
  EXPECT_EQ(tokens[2].begin, 5u);
  EXPECT_EQ(tokens[2].end, 8u);
  EXPECT_EQ(tokens[2].close, 13u);
  EXPECT_EQ(tokens[3].kind, PostfixToken::Kind::group);
  EXPECT_EQ(tokens[3].begin, 4u);
  EXPECT_EQ(tokens[3].end, 14u);
  EXPECT_EQ(tokens[4].begin, 2u);
}

struct Wrong {
  const char* text;
  std::size_t offset;
  const char* message;
};
class ExpressionSyntax : public testing::TestWithParam<Wrong> {};
TEST_P(ExpressionSyntax, IsRefusedAtItsPlace) {
  const Wrong& wrong = GetParam();
  try {
    parse_expression(wrong.text);
    FAIL() << wrong.text << " was accepted";
  } catch (const SyntaxError& error) {
    EXPECT_EQ(error.offset, wrong.offset) << wrong.text;
    EXPECT_EQ(error.message, wrong.message) << wrong.text;
  }
}
INSTANTIATE_TEST_SUITE_P(
    All, ExpressionSyntax,
    testing::Values(Wrong{"", 0, "expected a number, a name or '(', found the end of the expression"},
                    Wrong{"1 +", 3, "expected a number, a name or '(', found the end of the expression"},
                    Wrong{"1 + * 2", 4, "expected a number, a name or '(', found '*'"},
                    Wrong{"a b", 2, "expected an operator or the end of the expression, found 'b'"},
                    Wrong{"1,5", 1, "expected an operator or the end of the expression, found ','"},
                    Wrong{"0x10", 1, "expected an operator after the number, found 'x10'"},
                    Wrong{"2x", 1, "expected an operator after the number, found 'x'"},
                    Wrong{"1.2.3", 3, "expected an operator after the number, found '.'"},
                    Wrong{"1e", 1, "expected an operator after the number, found 'e'"},
                    Wrong{"(1 + 2", 6, "expected an operator or ')', found the end of the expression"},
                    Wrong{"1 + 2)", 5, "expected an operator or the end of the expression, found ')'"},
                    Wrong{"sin()", 4, "expected a number, a name or '(', found ')'"},
                    Wrong{"sin(1", 5, "expected an operator, ',' or ')', found the end of the expression"},
                    Wrong{"sin(1,)", 6, "expected a number, a name or '(', found ')'"},
                    Wrong{"2**3", 2, "expected a number, a name or '(', found '*'"},
                    Wrong{"a = b", 2, "expected an operator or the end of the expression, found '='"},
                    Wrong{"\xCE\xB8", 0, "expected a number, a name or '(', found '\xCE\xB8'"},
                    Wrong{"spline(q)", 8, "expected an operator or ';', found ')'"},
                    Wrong{"spline(q, 0, 1)", 8, "expected an operator or ';', found ','"},
                    Wrong{"spline(q; [0, 1], [2, 3])", 16, "expected an operator or ';', found ','"},
                    Wrong{"spline(q; [0, 1; 2, 3])", 15, "expected an operator, ',' or ']', found ';'"},
                    Wrong{"spline(q; 0, 1; 2, 3; 4)", 20, "expected an operator, ',' or ')', found ';'"},
                    Wrong{"spline(q; []; [])", 11, "expected a number, a name or '(', found ']'"},
                    Wrong{"d(q + 1)", 4, "expected ')' after the name, found '+'"},
                    Wrong{"d(2)", 2, "expected a name, found '2'"},
                    Wrong{"position(f).", 12,
                          "expected a part such as x after the point, found the end of the expression"}));

TEST(ExpressionGrammar, LimitsNestingWithoutRunningOutOfStack) {
  const auto deep = [](const std::string& open, std::size_t n, const std::string& close) {
    std::string text;
    for (std::size_t i = 0; i < n; ++i) text += open;
    text += "1";
    for (std::size_t i = 0; i < n; ++i) text += close;
    return text;
  };
  for (const auto& [open, close] :
       {std::pair{"(", ")"}, {"-", ""}, {"+", ""}, {"1^", ""}, {"sin(", ")"}, {"-(", ")"}}) {
    EXPECT_NO_THROW(parse_expression(deep(open, 40, close))) << open;
    EXPECT_THROW(parse_expression(deep(open, 101, close)), SyntaxError) << open;
    EXPECT_THROW(parse_expression(deep(open, 100000, close)), SyntaxError) << open;
  }
}
TEST(ExpressionGrammar, DoesNotLimitLength) {
  std::string text = "1";
  for (int i = 0; i < 100000; ++i) text += "+1*2";
  EXPECT_EQ(parse_expression(text).size(), 400001u);
}

TEST(ExpressionGrammar, KnowsTheFunctions) {
  for (const char* name :
       {"sin", "cos", "tan", "asin", "acos", "atan", "sqrt", "exp", "log", "abs", "sinh", "cosh", "tanh"})
    EXPECT_EQ(function_arity(name), 1) << name;
  for (const char* name : {"step", "smoothstep", "sign"}) EXPECT_EQ(function_arity(name), 1) << name;
  for (const char* name : {"atan2", "min", "max"}) EXPECT_EQ(function_arity(name), 2) << name;
  for (const char* name : {"clamp", "select"}) EXPECT_EQ(function_arity(name), 3) << name;
  for (const char* name : {"pi", "t", "spline", "linear", "position", "x"})
    EXPECT_EQ(function_arity(name), 0) << name;
}

}  // namespace
}  // namespace alembert
