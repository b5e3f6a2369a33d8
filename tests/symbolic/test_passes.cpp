// Order, substitution, evaluation and counts.
#include <cmath>

#include "symbolic/count_operations.hpp"
#include "symbolic/evaluate.hpp"
#include "symbolic/evaluate_modular.hpp"
#include "symbolic/postorder.hpp"
#include "symbolic/random_dag.hpp"
#include "symbolic/same.hpp"
#include "symbolic/substitute.hpp"

namespace alembert {
namespace {

class Passes : public testing::Test {
 protected:
  ExprGraph g;
  Expr x = g.symbol("x"), y = g.symbol("y"), z = g.symbol("z");
};

TEST_F(Passes, PostorderPutsOperandsFirst) {
  const Expr shared = sin(x * y);
  const std::vector<Expr> roots{shared + z, shared * shared, shared + z};
  const std::vector<std::uint32_t> order = postorder(roots);
  std::vector<bool> seen(g.size(), false);
  for (const std::uint32_t id : order) {
    EXPECT_FALSE(seen[id]);
    const Node& node = g.node(id);
    if (node.arity() >= 1) {
      EXPECT_TRUE(seen[node.a.node()]);
    }
    if (node.arity() == 2) {
      EXPECT_TRUE(seen[node.b.node()]);
    }
    seen[id] = true;
  }
  EXPECT_EQ(order.size(), 7u);  // x, y, x*y, sin, z, sum, square
  for (const Expr& root : roots) EXPECT_TRUE(seen[root.ref().node()]);
  EXPECT_TRUE(postorder(std::vector<Expr>{}).empty());
}

TEST_F(Passes, SubstitutionIsSimultaneous) {
  const std::vector<Expr> roots{x - g.integer(2) * y, sin(x) / y, z};
  const std::vector<std::pair<Expr, Expr>> swap{{x, y}, {y, x}};
  const std::vector<Expr> out = substitute(roots, swap);
  EXPECT_TRUE(same(out[0], y - g.integer(2) * x));
  EXPECT_TRUE(same(out[1], sin(y) / x));
  EXPECT_TRUE(same(out[2], z));
}

TEST_F(Passes, SubstitutionSimplifies) {
  const std::vector<Expr> roots{x * y + z, -(x + y)};
  const std::vector<std::pair<Expr, Expr>> to_zero{{x, g.zero()}};
  const std::vector<Expr> out = substitute(roots, to_zero);
  EXPECT_TRUE(same(out[0], z));
  EXPECT_TRUE(same(out[1], -y));
}

TEST_F(Passes, SubstitutionRefuses) {
  const std::vector<Expr> roots{x};
  ExprGraph other;
  using Pairs = std::vector<std::pair<Expr, Expr>>;
  EXPECT_THROW(substitute(roots, Pairs{{x + y, z}}), std::logic_error);
  EXPECT_THROW(substitute(roots, Pairs{{-x, z}}), std::logic_error);
  EXPECT_THROW(substitute(roots, Pairs{{x, y}, {x, z}}), std::logic_error);
  EXPECT_THROW(substitute(roots, Pairs{{x, other.one()}}), std::logic_error);
  EXPECT_THROW(substitute(std::vector<Expr>{g.one() / x}, Pairs{{x, g.zero()}}), std::domain_error);
}

TEST_F(Passes, SubstitutionAgreesWithEvaluation) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    ExprGraph graph;
    const RandomDag dag = random_dag(graph, seed);
    TestRandom random(seed);
    const Expr by = dag.symbols[1] * dag.symbols[2] + graph.integer(1);
    const std::vector<std::pair<Expr, Expr>> pair{{dag.symbols[0], by}};
    const std::vector<Expr> out = substitute(dag.roots, pair);
    std::vector<Modular> at = random_modular_point(graph.symbol_count(), seed);
    const std::vector<Modular> found = evaluate_modular(out, at);
    at[0] = evaluate_modular(std::vector<Expr>{by}, at)[0];
    const std::vector<Modular> expected = evaluate_modular(dag.roots, at);
    for (std::size_t i = 0; i < out.size(); ++i) {
      EXPECT_EQ(found[i], expected[i]) << to_string(dag.roots[i]) << "\n" << to_string(out[i]);
    }
  }
}

TEST_F(Passes, EvaluatesEveryOperation) {
  const double a = 0.4, b = -1.3;
  const std::vector<Expr> roots{x + y,   x - y,     x * y,        x / y,      sqrt(x), sin(y),
                                cos(y),  tan(y),    asin(x),      acos(x),    atan(y), atan2(y, x),
                                exp(y),  log(x),    abs(y),       sign(y),    sinh(y), cosh(y),
                                tanh(y), pow(x, y), g.pi({1, 3}), g.real(M_E)};
  const std::vector<double> expected{
      a + b,        a - b,          a * b,        a / b,        std::sqrt(a), std::sin(b),
      std::cos(b),  std::tan(b),    std::asin(a), std::acos(a), std::atan(b), std::atan2(b, a),
      std::exp(b),  std::log(a),    1.3,          -1,           std::sinh(b), std::cosh(b),
      std::tanh(b), std::pow(a, b), M_PI / 3,     M_E};
  const std::vector<double> at{a, b, 0};
  const std::vector<double> found = evaluate(roots, at);
  for (std::size_t i = 0; i < roots.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], 4e-16 * (1 + std::abs(expected[i]))) << to_string(roots[i]);
  EXPECT_THROW(evaluate(roots, std::vector<double>{a}), std::out_of_range);
}

TEST_F(Passes, CountsByTheConvention) {
  const auto count = [](std::vector<Expr> roots) { return count_operations(roots); };
  EXPECT_EQ(count({x - y}).add, 1u);
  EXPECT_EQ(count({-(x * y)}).total(), 1u);
  EXPECT_EQ(count({g.integer(2) * x}).add, 1u);
  EXPECT_EQ(count({g.integer(2) * x}).mul, 0u);
  EXPECT_EQ(count({x / y}).div, 1u);
  EXPECT_EQ(count({sin(x) + cos(x)}).trig, 2u);
  EXPECT_EQ(count({sin(x + g.pi({1, 3}))}).add, 0u);  // the offset belongs to the call
  EXPECT_EQ(count({sin(x + g.pi({1, 3})), x + g.pi({1, 3})}).add, 1u);
  EXPECT_EQ(count({sin(g.rational({3, 10})) * sqrt(g.integer(2)) + g.one()}).total(), 0u);
  EXPECT_EQ(count({sin(g.rational({3, 10})) * x}).total(), 1u);
  EXPECT_EQ(count({x * y, x * y, (x * y) * z}).mul, 2u);
  EXPECT_EQ(count({sqrt(x) + exp(y)}).other, 2u);
}

}  // namespace
}  // namespace alembert
