// The table of derivatives, each operation and each operand by complex step, with signed operands.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "differentiation/complex_evaluation.hpp"
#include "differentiation/forward.hpp"
#include "differentiation/jacobian.hpp"
#include "differentiation/partials.hpp"
#include "differentiation/reverse.hpp"
#include "support/error.hpp"
#include "symbolic/evaluate.hpp"

namespace alembert {
namespace {

struct Case {
  std::string name;
  std::function<Expr(Expr, Expr)> function;
  double x = 0.3, y = 0.7;
};

std::vector<Case> cases() {
  return {
      {"add", [](Expr x, Expr y) { return x + y; }},
      {"subtract", [](Expr x, Expr y) { return x - y; }},
      {"subtract the other way", [](Expr x, Expr y) { return y - x; }},
      {"multiply", [](Expr x, Expr y) { return x * y; }},
      {"square", [](Expr x, Expr) { return x * x; }},
      {"divide", [](Expr x, Expr y) { return x / y; }},
      {"divide by a negative", [](Expr x, Expr y) { return x / (-y); }},
      {"reciprocal", [](Expr x, Expr y) { return x.graph().one() / (x + y); }},
      {"sqrt", [](Expr x, Expr) { return sqrt(x); }},
      {"sin", [](Expr x, Expr y) { return sin(x - y); }},
      {"cos", [](Expr x, Expr y) { return cos(y - x); }},
      {"tan", [](Expr x, Expr) { return tan(x); }},
      {"asin", [](Expr x, Expr) { return asin(x); }},
      {"acos", [](Expr x, Expr) { return acos(-x); }},
      {"atan", [](Expr x, Expr) { return atan(x); }},
      {"atan2", [](Expr x, Expr y) { return atan2(x, y); }},
      {"atan2 on the left", [](Expr x, Expr y) { return atan2(x, y); }, 0.3, -0.7},
      {"atan2 of negatives", [](Expr x, Expr y) { return atan2(-x, -y); }},
      {"exp", [](Expr x, Expr y) { return exp(x - y); }},
      {"exp of a negative", [](Expr x, Expr) { return exp(-x); }},
      {"log", [](Expr x, Expr y) { return log(y) * log(x); }},
      {"abs", [](Expr x, Expr y) { return abs(x - y); }},
      {"abs of a positive", [](Expr x, Expr y) { return abs(y - x); }},
      {"sign", [](Expr x, Expr y) { return sign(x) * y + sign(x - y); }},
      {"sinh", [](Expr x, Expr) { return sinh(x); }},
      {"cosh", [](Expr x, Expr) { return cosh(-x); }},
      {"tanh", [](Expr x, Expr) { return tanh(x); }},
      {"pow in the base", [](Expr x, Expr) { return pow(x, x.graph().rational(Rational(7, 3))); }},
      {"pow in the exponent", [](Expr, Expr y) { return pow(y.graph().rational(Rational(7, 3)), y); }},
      {"pow in both", [](Expr x, Expr y) { return pow(x, y); }},
      {"pow of itself", [](Expr x, Expr) { return pow(x, x); }},
      {"pow of a negative exponent", [](Expr x, Expr y) { return pow(x, -y); }},
      {"integer power", [](Expr x, Expr) { return pow(x, 5); }},
      {"negative integer power", [](Expr x, Expr) { return pow(x, -3); }},
  };
}

TEST(Partials, AgreeWithComplexSteps) {
  for (const Case& c : cases()) {
    ExprGraph graph;
    const Expr x = graph.symbol("x");
    const Expr y = graph.symbol("y");
    const std::vector<Expr> roots = {c.function(x, y)};
    const std::vector<Expr> variables = {x, y};
    const std::vector<double> point = {c.x, c.y};
    const std::vector<double> expected = test::complex_step(roots, variables, point);
    for (const auto method : {jacobian_forward, jacobian_reverse}) {
      const std::vector<double> actual = evaluate(method(roots, variables).entries, point);
      for (std::size_t j = 0; j < 2; ++j)
        EXPECT_NEAR(actual[j], expected[j], 1e-14 * (1 + std::abs(expected[j])))
            << c.name << ", operand " << j;
    }
  }
}

TEST(Partials, ReuseWhatIsThere) {
  ExprGraph graph;
  const Expr x = graph.symbol("x");
  const auto derivative = [&](Expr f) { return Expr(graph, local_partial(graph, f.ref().node(), 0)); };
  EXPECT_EQ(derivative(exp(x)), exp(x));
  EXPECT_EQ(derivative(sqrt(x)), graph.one() / (graph.integer(2) * sqrt(x)));
  EXPECT_EQ(derivative(tan(x)), graph.one() + tan(x) * tan(x));
  EXPECT_EQ(derivative(tanh(x)), graph.one() - tanh(x) * tanh(x));
  EXPECT_EQ(derivative(abs(x)), sign(x));
  EXPECT_TRUE(derivative(sign(x)).is_zero());
}

TEST(Partials, PowerIsRightAtZero) {
  ExprGraph graph;
  const Expr x = graph.symbol("x");
  const std::vector<Expr> roots = {pow(x, graph.rational(Rational(7, 3)))};
  const std::vector<Expr> variables = {x};
  const std::vector<double> point = {0};
  EXPECT_EQ(evaluate(jacobian_forward(roots, variables).entries, point).front(), 0);
}

TEST(Partials, AnOperandThatIsNotThere) {
  ExprGraph graph;
  const Expr x = graph.symbol("x");
  EXPECT_THROW(local_partial(graph, x.ref().node(), 0), InternalError);
  EXPECT_THROW(local_partial(graph, sin(x).ref().node(), 1), InternalError);
}

}  // namespace
}  // namespace alembert
