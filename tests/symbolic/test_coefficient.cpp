// Coefficients of linear expressions, and what is refused.
#include <gmock/gmock.h>

#include "symbolic/coefficient.hpp"
#include "symbolic/evaluate_modular.hpp"
#include "symbolic/random_dag.hpp"
#include "symbolic/same.hpp"
#include "symbolic/substitute.hpp"

namespace alembert {
namespace {

class Coefficient : public testing::Test {
 protected:
  Expr of(Expr root) { return coefficient(std::vector<Expr>{root}, x)[0]; }
  // The message and the subexpression of the error.
  void refuses(Expr root, Expr where) {
    try {
      of(root);
      FAIL() << to_string(root) << " was accepted";
    } catch (const NotLinear& error) {
      EXPECT_TRUE(same(error.where(), where));
      EXPECT_THAT(error.what(), testing::HasSubstr(to_string(where)));
    }
  }
  ExprGraph g;
  Expr x = g.symbol("x"), y = g.symbol("y"), z = g.symbol("z");
};

TEST_F(Coefficient, OfSumsProductsAndQuotients) {
  EXPECT_TRUE(same(of(x), g.one()));
  EXPECT_TRUE(same(of(-x), -g.one()));
  EXPECT_TRUE(same(of(y), g.zero()));
  EXPECT_TRUE(same(of(g.integer(7)), g.zero()));
  EXPECT_TRUE(same(of(y - x), -g.one()));
  EXPECT_TRUE(same(of(y * (z - x)), -y));
  EXPECT_TRUE(same(of(x / y + z), g.one() / y));
  EXPECT_TRUE(same(of((y * x + z) * cos(y) - x), y * cos(y) - g.one()));
}

TEST_F(Coefficient, FunctionsOfOthersMayMultiply) {
  EXPECT_TRUE(same(of(sin(y) * x), sin(y)));
  EXPECT_TRUE(same(of(sqrt(y) * x + exp(z)), sqrt(y)));
}

TEST_F(Coefficient, SharedNodesCountAsOftenAsTheyAreUsed) {
  const Expr shared = x * y + z;
  EXPECT_TRUE(same(of(shared * sin(y) + shared * cos(y)), y * sin(y) + y * cos(y)));
}

TEST_F(Coefficient, RefusesWithTheSubexpression) {
  refuses(x * x, x * x);
  refuses(y + (x * y) * (x + z), (x * y) * (x + z));
  refuses(z + y / x, y / x);
  refuses(sin(x) * y, sin(x));
  refuses(sqrt(x + y), sqrt(x + y));
  refuses(pow(x, 3), pow(x, 2));
  refuses(pow(x, y), pow(x, y));
  refuses(pow(y, x), pow(y, x));
  refuses(atan2(y, x), atan2(y, x));
  refuses(abs(x), abs(x));
}

TEST_F(Coefficient, OnlyOfSymbols) {
  const std::vector<Expr> roots{x};
  EXPECT_THROW(coefficient(roots, x + y), std::logic_error);
  EXPECT_THROW(coefficient(roots, -x), std::logic_error);
}

TEST_F(Coefficient, IsNotExponentialOnSharing) {
  Expr e = x;
  for (int i = 0; i < 2000; ++i) e = e * sin(y) + e * cos(y);
  EXPECT_TRUE(of(e).valid());
}

TEST_F(Coefficient, RebuildsRandomLinearExpressions) {
  RandomDagOptions options;
  options.square_roots = true;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    ExprGraph graph;
    const RandomDag dag = random_dag(graph, seed, options);
    const Expr u = graph.symbol("u");
    // A tangle of sums and products, linear in u by the way it is made.
    Expr root = dag.roots[0];
    for (std::size_t i = 0; i < dag.values.size(); i += 3) {
      root = (i % 2 == 0) ? root + dag.values[i] * u : dag.values[i] * (root - u);
    }
    const Expr d = coefficient(std::vector<Expr>{root}, u)[0];
    const std::vector<std::pair<Expr, Expr>> zero{{u, graph.zero()}};
    const Expr rest = substitute(std::vector<Expr>{root}, zero)[0];
    const std::vector<Expr> both{root, d * u + rest};
    const std::vector<Modular> value =
        evaluate_modular(both, random_modular_point(graph.symbol_count(), seed));
    EXPECT_EQ(value[0], value[1]) << to_string(root) << "\n" << to_string(d);
  }
}

}  // namespace
}  // namespace alembert
