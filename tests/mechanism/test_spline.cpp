// Splines in expressions, against the natural cubic spline found as one dense system for all pieces.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <cstdio>

#include "differentiation/d_star.hpp"
#include "differentiation/forward.hpp"
#include "differentiation/jacobian.hpp"
#include "differentiation/reverse.hpp"
#include "mechanism/loaded.hpp"
#include "processor_time.hpp"
#include "symbolic/coefficient.hpp"
#include "symbolic/evaluate.hpp"
#include "symbolic/simplify.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {
namespace {

using test::error_of;
using test::Loaded;
using test::shift;

/// Natural cubic spline: unknowns a, b, c, d of each piece; interpolation at both ends of each piece, two
/// derivatives continuous at inner knots, no curvature at the ends. Scaled to pieces of length one.
class PiecewiseCubic {
 public:
  PiecewiseCubic(std::vector<double> knots, const std::vector<double>& values) : k_(std::move(knots)) {
    const auto n = static_cast<Eigen::Index>(k_.size()) - 1;
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(4 * n, 4 * n);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(4 * n);
    const auto h = [&](Eigen::Index i) {
      return k_[static_cast<std::size_t>(i) + 1] - k_[static_cast<std::size_t>(i)];
    };
    for (Eigen::Index i = 0; i < n; ++i) {
      A(4 * i, 4 * i) = 1;
      b(4 * i) = values[static_cast<std::size_t>(i)];
      A.row(4 * i + 1).segment(4 * i, 4) << 1, 1, 1, 1;
      b(4 * i + 1) = values[static_cast<std::size_t>(i) + 1];
      if (i + 1 == n) continue;
      A.row(4 * i + 2).segment(4 * i, 4) << 0, 1, 2, 3;
      A(4 * i + 2, 4 * (i + 1) + 1) = -h(i) / h(i + 1);
      A.row(4 * i + 3).segment(4 * i, 4) << 0, 0, 2, 6;
      A(4 * i + 3, 4 * (i + 1) + 2) = -2 * std::pow(h(i) / h(i + 1), 2);
    }
    A(4 * n - 2, 2) = 1;
    A.row(4 * n - 1).segment(4 * (n - 1), 4) << 0, 0, 2, 6;
    x_ = A.fullPivLu().solve(b);
  }
  /// Value, first and second derivative.
  std::array<double, 3> operator()(double x) const {
    const std::size_t last = k_.size() - 1;
    const double inside = std::min(std::max(x, k_.front()), k_.back());
    std::size_t i = 0;
    while (i + 1 < last && inside > k_[i + 1]) ++i;
    const double h = k_[i + 1] - k_[i], s = (inside - k_[i]) / h;
    const auto c = x_.segment(4 * static_cast<Eigen::Index>(i), 4);
    const double slope = (c[1] + s * (2 * c[2] + s * 3 * c[3])) / h;
    const double bend = x == inside ? (2 * c[2] + 6 * s * c[3]) / (h * h) : 0;
    return {c[0] + s * (c[1] + s * (c[2] + s * c[3])) + slope * (x - inside), slope, bend};
  }

 private:
  std::vector<double> k_;
  Eigen::VectorXd x_;
};

std::string exact_text(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}
std::string list_of(const std::vector<double>& numbers) {
  std::string text;
  for (const double x : numbers) text += (text.empty() ? "" : ", ") + exact_text(x);
  return text;
}
/// A description whose body is shifted by `expression` of q.
std::string shifted_by(const std::string& expression) {
  return test::with_parameters("[\"" + expression + "\", q, 0]", "[{name: q, initial: 0.4}]");
}

/// Largest errors of value, first and second derivative at knots, between and beyond them, relative to the
/// largest of each; of the expression as read and, if `simplified`, as the pipeline would simplify it.
std::array<double, 3> errors_of(const std::vector<double>& knots, const std::vector<double>& values,
                                bool simplified) {
  Loaded loaded(shifted_by("spline(q; [" + list_of(knots) + "]; [" + list_of(values) + "])"));
  const Expr q = loaded.symbol("q");
  const Expr variable[] = {q};
  std::vector<Expr> roots = {shift(loaded)};
  roots.push_back(jacobian_forward(std::span(roots).first(1), variable)(0, 0));
  roots.push_back(jacobian_forward(std::span(roots).subspan(1), variable)(0, 0));
  if (simplified) roots = value_number(simplify(roots));
  const PiecewiseCubic expected(knots, values);
  const double length = knots.back() - knots.front();
  std::vector<double> points = knots;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    for (const double s : {1e-9, 0.3, 0.5, 0.81}) points.push_back(knots[i] + s * (knots[i + 1] - knots[i]));
  for (const double s : {1e-9, 0.2, 1.5}) {
    points.push_back(knots.front() - s * length);
    points.push_back(knots.back() + s * length);
  }
  std::array<double, 3> error{}, size{};
  for (const double x : points) {
    std::vector<double> state(loaded.graph.symbol_count(), 0.0);
    state[loaded.graph.symbol_index(q.ref().node())] = x;
    const std::vector<double> found = evaluate(roots, state);
    const std::array<double, 3> wanted = expected(x);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_TRUE(std::isfinite(found[i])) << x;
      error[i] = std::max(error[i], std::abs(found[i] - wanted[i]));
      size[i] = std::max(size[i], std::abs(wanted[i]));
    }
  }
  for (std::size_t i = 0; i < 3; ++i)
    if (size[i] > 0) error[i] /= size[i];
  return error;
}

void expect_errors_below(double as_read, double simplified, const std::vector<double>& knots,
                         const std::vector<double>& values) {
  const std::array<double, 3> read_errors = errors_of(knots, values, false);
  const std::array<double, 3> simplified_errors = errors_of(knots, values, true);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LE(read_errors[i], as_read) << "derivative " << i;
    EXPECT_LE(simplified_errors[i], simplified) << "derivative " << i;
  }
}

TEST(Spline, IsTheNaturalCubicSpline) {
  // With few short numbers, simplification may gather powers of q, which cancel far out.
  expect_errors_below(2e-15, 5e-14, {0, 0.5, 1}, {0, 0.1, 0.3});
  expect_errors_below(2e-15, 5e-14, {-1, 0, 0.25, 2}, {3, -1, 0.5, 0.25});
  expect_errors_below(2e-15, 5e-14, {-2.1, -1.3, -0.4, 0.2, 0.9, 1.7, 2.6},
                      {0.034, 0.051, 0.049, 0.02, -0.013, -0.01, 0.004});
}

TEST(Spline, IsTheNaturalCubicSplineThroughFiftyKnots) {
  std::vector<double> knots, values;
  for (int i = 0; i < 50; ++i) {
    knots.push_back(-2 + 0.08 * i + 0.03 * std::sin(7.0 * i));
    values.push_back(std::sin(2 * knots.back()) + 0.05 * std::cos(11.0 * i));
  }
  expect_errors_below(1e-14, 1e-14, knots, values);
}

TEST(Spline, IsALineThroughTwoKnots) {
  Loaded loaded(shifted_by("spline(q; [0, 2]; [1, 2])"));
  std::vector<double> state(loaded.graph.symbol_count(), 0.0);
  const Expr root[] = {shift(loaded)};
  for (const double x : {-3.0, 0.0, 0.5, 2.0, 7.0}) {
    state[loaded.graph.symbol_index(loaded.symbol("q").ref().node())] = x;
    EXPECT_DOUBLE_EQ(evaluate(root, state)[0], 1 + x / 2);
  }
}

TEST(Spline, ContinuesInStraightLinesToWhereverItGoes) {
  Loaded loaded(shifted_by("spline(q; [0, 1, 2, 3]; [0, 1, -1, 2])"));
  const Expr q = loaded.symbol("q"), root[] = {shift(loaded)}, variable[] = {q};
  const std::vector<Expr> slope = jacobian_reverse(root, variable).entries;
  const std::vector<Expr> bend = jacobian_reverse(slope, variable).entries;
  const auto at = [&](const std::vector<Expr>& expression, double x) {
    std::vector<double> state(loaded.graph.symbol_count(), 0.0);
    state[loaded.graph.symbol_index(q.ref().node())] = x;
    return evaluate(expression, state)[0];
  };
  EXPECT_DOUBLE_EQ(at(slope, 1e6), at(slope, 3));
  EXPECT_EQ(at(slope, 1e6), at(slope, 4));
  EXPECT_EQ(at(bend, 1e6), 0);
  EXPECT_EQ(at(bend, -5), 0);
}

TEST(Spline, TakesTheThreeMethodsOfDifferentiation) {
  Loaded loaded(shifted_by("spline(q^2 - 0.3; [0, 0.5, 1]; [0, 0.1, 0.3])"));
  const Expr root[] = {shift(loaded)}, variable[] = {loaded.symbol("q")};
  const Expr forward = jacobian_forward(root, variable)(0, 0),
             reverse = jacobian_reverse(root, variable)(0, 0), d_star = jacobian_d_star(root, variable)(0, 0);
  for (const double x : {-1.2, -0.3, 0.0, 0.6, 0.9, 1.1, 2.0}) {
    std::vector<double> state(loaded.graph.symbol_count(), 0.0);
    state[loaded.graph.symbol_index(loaded.symbol("q").ref().node())] = x;
    const Expr all[] = {forward, reverse, d_star};
    const std::vector<double> found = evaluate(all, state);
    const double expected = 2 * x * PiecewiseCubic({0, 0.5, 1}, {0, 0.1, 0.3})(x * x - 0.3)[1];
    for (const double f : found) EXPECT_NEAR(f, expected, 1e-14) << x;
  }
}

TEST(Spline, AcceptsParametersAndPlainLists) {
  Loaded brackets(shifted_by("spline(q; [0, r, 2*r, pi]; [1, 2, r, 0])"));
  Loaded plain(shifted_by("spline(q; 0, r, 2*r, pi; 1, 2, r, 0)"));
  EXPECT_EQ(to_string(shift(brackets)), to_string(shift(plain)));
  EXPECT_EQ(
      error_of(
          "alembert: 1\nname: one\ncoordinates: [q]\nbodies:\n  - name: arm\n    mass: 1\n    transform:\n"
          "      - rotate:\n          axis: z\n          angle: spline(q; [0, 0.5, 1]; [0, 0.1, 0.3])\n"),
      "");
}

TEST(Spline, OfAConstantIsAConstant) {
  Loaded loaded(shifted_by("spline(r; [0, 0.5, 1]; [0, 0.1, 0.3])*q"));
  const Expr root[] = {shift(loaded)};
  const std::vector<Expr> c = coefficient(root, loaded.symbol("q"));
  EXPECT_TRUE(c[0].is_constant());
  EXPECT_DOUBLE_EQ(evaluate(c, std::vector<double>(loaded.graph.symbol_count()))[0],
                   PiecewiseCubic({0, 0.5, 1}, {0, 0.1, 0.3})(0.25)[0]);
  // Its value at the initial state is known, too.
  EXPECT_NE(error_of(shifted_by("q/spline(r; [0, 0.25, 1]; [1, 0, 1])")), "");
  EXPECT_NE(error_of(shifted_by("sqrt(spline(q; [0, 0.8]; [-2, 0]))")), "");
}

TEST(Spline, IsSmoothAndItsArgumentMustBe) {
  EXPECT_NE(error_of(shifted_by("spline(abs(q); [0, 1]; [0, 1])")).find("not twice differentiable"),
            std::string::npos);
  EXPECT_NE(error_of(shifted_by("abs(spline(q; [0, 1]; [0, 1]))")).find("not twice differentiable"),
            std::string::npos);
  EXPECT_EQ(error_of(shifted_by("2*spline(sin(q); [0, 1]; [0, 1])")), "");
}

TEST(Spline, TakesAThousandKnotsInGoodTime) {
  std::vector<double> knots, values;
  for (int i = 0; i < 1000; ++i) {
    knots.push_back(0.001 * i);
    values.push_back(std::sin(0.01 * i));
  }
  const test::ProcessorTime time;
  EXPECT_EQ(error_of(shifted_by("spline(q; [" + list_of(knots) + "]; [" + list_of(values) + "])")), "");
  EXPECT_LT(time.seconds(), 2);
  knots.push_back(2);
  values.push_back(2);
  EXPECT_NE(error_of(shifted_by("spline(q; [" + list_of(knots) + "]; [" + list_of(values) + "])"))
                .find("expected from 2 to 1000"),
            std::string::npos);
}

}  // namespace
}  // namespace alembert
