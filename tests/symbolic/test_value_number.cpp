// Probabilistic value numbering: what is merged, and what must not be.
#include "symbolic/random_dag.hpp"
#include "symbolic/same.hpp"

namespace alembert {
namespace {

class ValueNumber : public testing::Test {
 protected:
  Expr one_root(Expr root) { return value_number(std::vector<Expr>{root})[0]; }
  ExprGraph g;
  Expr x = g.symbol("x"), y = g.symbol("y"), z = g.symbol("z");
  Expr s1 = sin(x), c1 = cos(x), s2 = sin(y), c2 = cos(y);
};

TEST_F(ValueNumber, FindsWhatConstructionCannotSee) {
  EXPECT_TRUE(same(one_root((x + y) * (x - y) - x * x + y * y), g.zero()));
  EXPECT_TRUE(same(one_root((x * g.integer(3) + y * g.integer(3)) / (x + y)), g.integer(3)));
  EXPECT_TRUE(
      same(one_root((x - y) / (g.rational({7, 2}) * y - g.rational({7, 2}) * x)), g.rational({-2, 7})));
}

TEST_F(ValueNumber, LongSumBecomesCosineThatIsThere) {
  const Expr sum = (s1 * c2 * s1 + s2 * z) * g.one() + c1 * (c2 * c1) - z * s2;
  const std::vector<Expr> out = value_number(std::vector<Expr>{sum * z, c2 + z});
  EXPECT_TRUE(same(out[0], c2 * z));
}

TEST_F(ValueNumber, MergesUpToSign) {
  const Expr p = (x - y) * z, q = y * z - x * z;
  const std::vector<Expr> out = value_number(std::vector<Expr>{sin(p), sin(q)});
  EXPECT_TRUE(same(out[0], -out[1]));
}

TEST_F(ValueNumber, SignsOfRootsAreNotGuessed) {
  // In the field the root of (x + y)^2 is x + y or its negative.
  const Expr root = sqrt(x * x + g.integer(2) * x * y + y * y);
  const std::vector<Expr> roots{root, x + y, root * (x + y)};
  const std::vector<Expr> out = value_number(roots);
  EXPECT_TRUE(same(out[0], root));
  const std::vector<double> at{-3, 1, 0};
  EXPECT_EQ(evaluate(out, at), (std::vector<double>{2, -2, -4}));
}

TEST_F(ValueNumber, SignsOfConstantRootsAreNotGuessed) {
  // sqrt(a + 2 sqrt(b)) = sqrt(p) + sqrt(q) for a = p + q, b = p q: the field may take any of the signs.
  for (int p = 2; p < 12; ++p) {
    for (int q = p + 1; q < 13; ++q) {
      ExprGraph graph;
      const Expr u = graph.symbol("u");
      const Expr nested = sqrt(graph.integer(p + q) + graph.integer(2) * sqrt(graph.integer(p * q)));
      const Expr plain = sqrt(graph.integer(p)) + sqrt(graph.integer(q));
      const Expr other = sqrt(graph.integer(q)) - sqrt(graph.integer(p));
      const std::vector<Expr> roots{plain * u, nested * u * u, other * u + nested};
      const std::vector<double> at{1.7};
      const std::vector<double> before = evaluate(roots, at), after = evaluate(value_number(roots), at);
      for (std::size_t i = 0; i < roots.size(); ++i) EXPECT_NEAR(before[i], after[i], 1e-12) << p << " " << q;
    }
  }
}

TEST_F(ValueNumber, RootsMergeWhereTheyAreEqual) {
  const Expr p = sqrt((x + y) * (x + y) + z), q = sqrt(x * x + g.integer(2) * x * y + y * y + z);
  ASSERT_NE(p, q);
  EXPECT_TRUE(same(one_root(p - q), g.zero()));
}

TEST_F(ValueNumber, DifferentFunctionsStayApart) {
  const std::vector<Expr> roots{abs(x), x, sign(x) + y, sqrt(x), exp(x)};
  EXPECT_EQ(value_number(roots), roots);
  EXPECT_TRUE(value_number({}).empty());
}

TEST_F(ValueNumber, NeverMoreOperations) {
  RandomDagOptions options;
  options.square_roots = options.functions = options.absolute = true;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    ExprGraph graph;
    const RandomDag dag = random_dag(graph, seed, options);
    const ExprCount before = count_operations(dag.roots), after = count_operations(value_number(dag.roots));
    EXPECT_LE(after.total() + after.trig, before.total() + before.trig) << seed;
  }
}

}  // namespace
}  // namespace alembert
