// Interval bounds: tight where signs are proved, and never wrong.
#include <cmath>

#include "symbolic/evaluate.hpp"
#include "symbolic/random_dag.hpp"
#include "symbolic/same.hpp"

namespace alembert {
namespace {

TEST(Bounds, ProveWhatFramesNeed) {
  ExprGraph g;
  const Expr big = g.symbol("R"), small = g.symbol("r"), v = g.symbol("v");
  g.assume(big, {2, 3});
  g.assume(small, {0.25, 1});
  EXPECT_GE(g.bounds((big + small * cos(v)).ref()).lower, 1.0 - 1e-12);
  EXPECT_GE(g.bounds((v * v).ref()).lower, 0);
  EXPECT_GE(g.bounds((g.one() + v * v).ref()).lower, 1);
  EXPECT_GE(g.bounds(sqrt(v).ref()).lower, 0);
  EXPECT_LE(g.bounds((-exp(v)).ref()).upper, 0);
  EXPECT_EQ(g.bounds(sin(v).ref()).upper, 1);
  EXPECT_EQ(g.bounds(v.ref()).upper, HUGE_VAL);
  EXPECT_LE(g.bounds((g.one() / (big - small)).ref()).upper, 1.0 + 1e-12);
}

TEST(Bounds, FollowAssumptions) {
  ExprGraph g;
  const Expr x = g.symbol("x"), y = x - g.integer(1);
  EXPECT_LT(g.bounds(y.ref()).lower, 0);
  g.assume(x, {1, 2});
  EXPECT_GE(g.bounds(y.ref()).lower, 0);
  EXPECT_THROW(g.assume(y, {0, 1}), std::logic_error);
  EXPECT_THROW(g.assume(-x, {0, 1}), std::logic_error);
}

TEST(Bounds, HoldRandomValues) {
  RandomDagOptions options;
  options.square_roots = options.functions = options.absolute = true;
  std::size_t checked = 0, finite = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    ExprGraph g;
    const RandomDag dag = random_dag(g, seed, options);
    TestRandom random(seed + 1000);
    std::vector<Interval> ranges;
    for (const Expr& symbol : dag.symbols) {
      const double lower = random.uniform(-3, 3);
      ranges.push_back({lower, lower + (random.one_in(4) ? 0.001 : random.uniform(0, 2))});
      g.assume(symbol, ranges.back());
    }
    for (int point = 0; point < 5; ++point) {
      std::vector<double> at;
      for (const Interval& range : ranges) at.push_back(random.uniform(range.lower, range.upper));
      const std::vector<double> values = evaluate(dag.values, at);
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i])) continue;
        const Interval range = g.bounds(dag.values[i].ref());
        const double slack = 1e-7 * (1 + std::abs(values[i]));  // rounding of `evaluate`, which may cancel
        if (std::abs(values[i]) > 1e9) continue;
        EXPECT_GE(values[i], range.lower - slack) << to_string(dag.values[i]);
        EXPECT_LE(values[i], range.upper + slack) << to_string(dag.values[i]);
        ++checked;
        if (std::isfinite(range.lower) && std::isfinite(range.upper)) ++finite;
      }
    }
  }
  EXPECT_GT(checked, 50000u);
  EXPECT_GT(finite, checked / 2);  // bounds that say nothing would pass as well
}

}  // namespace
}  // namespace alembert
