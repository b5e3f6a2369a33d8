// Values and derivatives of every function of the language, on jets, against formulas.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>

#include "oracles/description/expression.hpp"
#include "oracles/taylor/jet.hpp"

namespace alembert::oracles {
namespace {

/// Jets of a function against its derivatives by hand, at x with x' = 2, x'' = -3.
void expect_derivatives(const char* text, double x, double f, double f1, double f2) {
  auto symbol = std::make_shared<ExpressionNode>();
  symbol->operation = Operation::coordinate;
  const Expression e = parse(text, [&](const std::string& name) { return name == "x" ? symbol : nullptr; });
  const Jet<double> y = evaluate<Jet<double>>(e, {Jet<double>(x, 2, -3)}, Jet<double>(0.0));
  EXPECT_NEAR(y.value, f, 1e-14) << text;
  EXPECT_NEAR(y.first, 2 * f1, 1e-13) << text;
  EXPECT_NEAR(y.second, 4 * f2 - 3 * f1, 1e-13) << text;
}

TEST(Jet, Derivatives) {
  using std::cos, std::exp, std::log, std::sin, std::sqrt, std::cosh, std::sinh, std::tanh, std::tan;
  const double x = 0.7, s = sin(x), c = cos(x);
  expect_derivatives("sin(x)", x, s, c, -s);
  expect_derivatives("cos(x)", x, c, -s, -c);
  expect_derivatives("tan(x)", x, tan(x), 1 / (c * c), 2 * s / (c * c * c));
  expect_derivatives("asin(x)", x, std::asin(x), 1 / sqrt(1 - x * x), x / std::pow(1 - x * x, 1.5));
  expect_derivatives("acos(x)", x, std::acos(x), -1 / sqrt(1 - x * x), -x / std::pow(1 - x * x, 1.5));
  expect_derivatives("atan(x)", x, std::atan(x), 1 / (1 + x * x), -2 * x / ((1 + x * x) * (1 + x * x)));
  expect_derivatives("atan2(x, 1)", x, std::atan(x), 1 / (1 + x * x), -2 * x / ((1 + x * x) * (1 + x * x)));
  expect_derivatives("atan2(sin(x), cos(x))", 2.9, 2.9, 1, 0);
  expect_derivatives("sqrt(x)", x, sqrt(x), 0.5 / sqrt(x), -0.25 / (x * sqrt(x)));
  expect_derivatives("exp(x)", x, exp(x), exp(x), exp(x));
  expect_derivatives("log(x)", x, log(x), 1 / x, -1 / (x * x));
  expect_derivatives("abs(x)", -x, x, -1, 0);
  expect_derivatives("sinh(x)", x, sinh(x), cosh(x), sinh(x));
  expect_derivatives("cosh(x)", x, cosh(x), sinh(x), cosh(x));
  const double th = tanh(x);
  expect_derivatives("tanh(x)", x, th, 1 - th * th, -2 * th * (1 - th * th));
  expect_derivatives("x^3", -x, -x * x * x, 3 * x * x, -6 * x);
  expect_derivatives("x^1.5", x, std::pow(x, 1.5), 1.5 * sqrt(x), 0.75 / sqrt(x));
  expect_derivatives("2^x", x, std::pow(2, x), log(2) * std::pow(2, x), log(2) * log(2) * std::pow(2, x));
  expect_derivatives("1/x - -x*(x + 2)", x, 1 / x + x * (x + 2), -1 / (x * x) + 2 * x + 2,
                     2 / (x * x * x) + 2);
  expect_derivatives("-x^2", x, -x * x, -2 * x, -2);
  expect_derivatives("2^3^2 + 6/2/3 - 4 - 3", x, 506, 0, 0);
}

TEST(Jet, DerivativesOfTheBranchThatIsTaken) {
  for (const double x : {-0.7, 0.7}) {
    const double above = x > 0 ? 1 : 0;
    expect_derivatives("min(x, x^2)", x, x > 0 ? x * x : x, x > 0 ? 2 * x : 1, x > 0 ? 2 : 0);
    expect_derivatives("max(x, x^2)", x, x > 0 ? x : x * x, x > 0 ? 1 : 2 * x, x > 0 ? 0 : 2);
    expect_derivatives("step(x)", x, above, 0, 0);
    expect_derivatives("sign(x)", x, 2 * above - 1, 0, 0);
    expect_derivatives("abs(x^3)", x, std::abs(x * x * x), 3 * x * std::abs(x), 6 * std::abs(x));
    expect_derivatives("select(x, x^3, 2*x)", x, x > 0 ? x * x * x : 2 * x, x > 0 ? 3 * x * x : 2,
                       x > 0 ? 6 * x : 0);
  }
  expect_derivatives("clamp(x, -0.2, 2*x - 0.4)", 0.3, 0.2, 2, 0);
  expect_derivatives("clamp(x, -0.2, 2*x - 0.4)", 0.5, 0.5, 1, 0);
  expect_derivatives("clamp(x, -0.2, 1)", -0.5, -0.2, 0, 0);
  expect_derivatives("smoothstep(x)", -0.1, 0, 0, 0);
  expect_derivatives("smoothstep(x)", 0.3, 3 * 0.09 - 2 * 0.027, 6 * 0.3 * 0.7, 6 - 12 * 0.3);
  expect_derivatives("smoothstep(2*x)", 0.6, 1, 0, 0);
}

// At the edge: step, sign and select say where they belong.
TEST(Jet, ZeroIsNotAbove) {
  expect_derivatives("step(x)", 0, 0, 0, 0);
  expect_derivatives("sign(x)", 0, 0, 0, 0);
  expect_derivatives("select(x, 5, 3*x)", 0, 0, 3, 0);
}

TEST(Jet, WhatIsNotSelectedMayBeNoNumber) {
  expect_derivatives("select(x, sqrt(x), 0)", -0.5, 0, 0, 0);
  expect_derivatives("select(x, sqrt(x), 0)", 0.25, 0.5, 1, -2);
  expect_derivatives("select(x, x, log(-x)/0)", 0.5, 0.5, 1, 0);
}

TEST(Tables, LinearGoesOnBeyondItsEnds) {
  const char* text = "linear(x; [0, 1, 3]; [2, 3, -1])";
  for (const double x : {-2.0, 0.4}) expect_derivatives(text, x, 2 + x, 1, 0);
  for (const double x : {1.5, 3.5}) expect_derivatives(text, x, 5 - 2 * x, -2, 0);
}

// Natural: for the knots 0, 1, 2 and the values 0, 1, 0 it is (3 x - x^3)/2 up to the middle.
TEST(Tables, NaturalSpline) {
  const char* text = "spline(x; [0, 1, 2]; [0, 1, 0])";
  expect_derivatives(text, 0.6, (1.8 - 0.216) / 2, (3 - 3 * 0.36) / 2, -1.8);
  expect_derivatives(text, 1.4, (1.8 - 0.216) / 2, -(3 - 3 * 0.36) / 2, -1.8);
  expect_derivatives(text, -1, -1.5, 1.5, 0);
  expect_derivatives(text, 3, -1.5, -1.5, 0);
}

// Through points of a line, a parabola (three points) and a cubic it is these, between its ends; beyond them, a line
// of the slope there.
TEST(Tables, SimmSplineIsExactForPolynomials) {
  expect_derivatives("simm_spline(x; [0, 2]; [1, 5])", 0.7, 2.4, 2, 0);
  const char* parabola = "simm_spline(x; [0, 1, 3]; [1, 2, 10])";
  for (const double x : {0.2, 2.2}) expect_derivatives(parabola, x, 1 + x * x, 2 * x, 2);
  expect_derivatives(parabola, 4, 10 + 6, 6, 0);
  expect_derivatives(parabola, -2, 1, 0, 0);
  const auto cubic = [](double x) { return x * x * x - 2 * x; };
  for (const std::string text : {"simm_spline(x; [-1, 0, 0.5, 2]; [1, 0, -0.875, 4])",
                                 "simm_spline(x; [-1, 0, 0.5, 2, 3]; [1, 0, -0.875, 4, 21])"}) {
    for (const double x : {-0.8, 0.3, 1.1})
      expect_derivatives(text.c_str(), x, cubic(x), 3 * x * x - 2, 6 * x);
    expect_derivatives(text.c_str(), -3, 1 - 2 * 1, 1, 0);
  }
}

// Of five points that lie on no cubic: values and bends are continuous, and the third derivatives at the ends are those
// of the cubics through four points.
TEST(Tables, SimmSplineOfFivePoints) {
  const std::array<double, 5> knots{0, 1, 1.5, 3, 4}, values{0, 2, -1, 1, 0.5};
  auto symbol = std::make_shared<ExpressionNode>();
  symbol->operation = Operation::coordinate;
  const Expression e = parse("simm_spline(x; [0, 1, 1.5, 3, 4]; [0, 2, -1, 1, 0.5])",
                             [&](const std::string&) { return symbol; });
  const auto at = [&](double x) {
    return evaluate<Jet<double>>(e, {Jet<double>(x, 1, 0)}, Jet<double>(0.0));
  };
  const auto third_in = [&](double low, double high) {
    const double a = low + 0.25 * (high - low), b = low + 0.75 * (high - low);
    return (at(b).second - at(a).second) / (b - a);
  };
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(at(knots[i]).value, values[i], 1e-14);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_NEAR(at(knots[i] - 1e-9).first, at(knots[i] + 1e-9).first, 1e-6);
    EXPECT_NEAR(at(knots[i] - 1e-9).second, at(knots[i] + 1e-9).second, 1e-6);
  }
  // 6 times the divided difference of four points, by Lagrange's formula.
  const auto cubic = [&](std::size_t first) {
    double sum = 0;
    for (std::size_t i = first; i < first + 4; ++i) {
      double product = 1;
      for (std::size_t j = first; j < first + 4; ++j) product *= i == j ? 1 : knots[i] - knots[j];
      sum += values[i] / product;
    }
    return 6 * sum;
  };
  EXPECT_NEAR(third_in(0, 1), cubic(0), 1e-11);
  EXPECT_NEAR(third_in(3, 4), cubic(1), 1e-11);
  EXPECT_NEAR(at(5).value, 0.5 + at(4).first, 1e-14);
  EXPECT_NEAR(at(-1).value, -at(0).first, 1e-14);
}

}  // namespace
}  // namespace alembert::oracles
