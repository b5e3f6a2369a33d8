// Simplification of small sets.
#include "symbolic/count_operations.hpp"
#include "symbolic/evaluate.hpp"
#include "symbolic/evaluate_modular.hpp"
#include "symbolic/random_dag.hpp"
#include "symbolic/same.hpp"
#include "symbolic/simplify.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {
namespace {

class Simplify : public testing::Test {
 protected:
  // Equal to `expected` with as few operations, whatever the association of products.
  void becomes(Expr root, Expr expected) {
    const Expr found = of(root);
    EXPECT_TRUE(same(value_number(std::vector<Expr>{found - expected})[0], g.zero())) << to_string(found);
    EXPECT_EQ(count_operations(std::vector<Expr>{found}).total(),
              count_operations(std::vector<Expr>{expected}).total())
        << to_string(found);
  }
  Expr of(Expr root) { return simplify(std::vector<Expr>{root})[0]; }
  ExprGraph g;
  Expr x = g.symbol("x"), y = g.symbol("y"), z = g.symbol("z"), one = g.one(), two = g.integer(2);
  Expr s = sin(x), c = cos(x), t = sin(y), d = cos(y);
};

TEST_F(Simplify, CommonFactors) {
  EXPECT_TRUE(same(of(x * y + x * z), x * (y + z)));
  EXPECT_TRUE(same(of(x * y * s + z * x * s + x * s), x * s * (y + z + one)));
  EXPECT_TRUE(same(of(g.rational({3, 10}) * x + g.rational({3, 10}) * y), g.rational({3, 10}) * (x + y)));
  EXPECT_EQ(count_operations(std::vector<Expr>{of(x * y + x * z + t * y + t * z)}).total(), 3u);
}

TEST_F(Simplify, LikeTerms) {
  EXPECT_TRUE(same(of((x + y) + (x - y)), two * x));
  EXPECT_TRUE(same(of(((x + y) + z) - ((z + x) + t)), y - t));
  EXPECT_TRUE(same(of((x + y) * (x + y) - x * x - y * y), two * (x * y)));
}

TEST_F(Simplify, CircleWithCommonFactors) {
  becomes(((x + y) * s) * ((x + y) * s) * z + (x + y) * (c * (z * c) * (y + x)), (x + y) * (x + y) * z);
  EXPECT_TRUE(same(of(s * s * t * t + s * s * d * d + c * c), one));
  EXPECT_TRUE(same(of(x * x * x - x * x * x * d * d), x * x * x * (t * t)));
  EXPECT_TRUE(same(of((s * t - c * d) * (s * t - c * d) + (s * d + c * t) * (s * d + c * t)), one));
  EXPECT_TRUE(same(of(cosh(x) * cosh(x) * y - y * z - sinh(x) * (sinh(x) * y)), y * (one - z)));
}

TEST_F(Simplify, RootsOfSquares) {
  EXPECT_TRUE(same(of(sqrt(x * x + two * x * y + y * y)), abs(x + y)));
  EXPECT_TRUE(same(of(sqrt((x + y) * (x + y) * s * s + (x + y) * c * c * (x + y))), abs(x + y)));
  g.assume(x, {1, 2});
  g.assume(y, {0, 1});
  EXPECT_TRUE(same(of(sqrt(x * x + two * x * y + y * y)), x + y));
  EXPECT_TRUE(same(of(sqrt(x * x * z + x * x)), x * sqrt(z + one)));
}

TEST_F(Simplify, Quotients) {
  EXPECT_TRUE(same(of((x * x - y * y) / (x - y)), x + y));
  EXPECT_TRUE(same(of((x * s + y * s) / (y + x)), s));
  EXPECT_TRUE(same(of(one / (x + y) + z / (x + y)), (one + z) / (x + y)));
  EXPECT_TRUE(same(of((one - s * s * t * t - c * c * t * t) / d), d));
}

TEST_F(Simplify, DistancesFromNumbersKeepTheirDigits) {
  const Expr slope = g.integer(400) * (x - g.integer(6)), p = sin(z), q = cos(z);
  const Expr found =
      of((slope * q - y * p) * (slope * q - y * p) + (slope * p + y * q) * (slope * p + y * q));
  EXPECT_LT(count_operations(std::vector<Expr>{found}).total(), 7u) << to_string(found);
  const std::vector<double> near{6 + 0x1p-20, 0, 0.3};
  EXPECT_EQ(evaluate(std::vector<Expr>{found}, near)[0], 160000 * 0x1p-40);
}

TEST_F(Simplify, ConstantsStayExact) {
  const Expr a = sin(g.rational({3, 10})), b = cos(g.rational({3, 10}));
  EXPECT_TRUE(same(of((a * x) * (a * y) + (b * y) * (b * x)), x * y));
  EXPECT_TRUE(same(of(sqrt(two) * x * (sqrt(two) * y) - two * x * y), g.zero()));
  EXPECT_TRUE(same(of(a * x + a * y), a * (x + y)));
}

TEST_F(Simplify, LeavesSmallThingsAlone) {
  for (const Expr e : {x, -x, x + y, sin(x), g.zero(), x * y - z, sqrt(x)}) EXPECT_TRUE(same(of(e), e));
  EXPECT_TRUE(simplify({}).empty());
}

TEST_F(Simplify, HiddenZeroDivisorIsAnError) {
  const Expr nothing = (x + y) * (x - y) - x * x + y * y;
  EXPECT_THROW(of(z / nothing), std::domain_error);
}

// Shapes whose full expansion is astronomic: it gives up on them, and the values stay.
TEST_F(Simplify, GivesUpInTime) {
  Expr fibonacci = x, last = y;
  for (int i = 0; i < 80; ++i) {
    const Expr next = fibonacci * last;
    last = fibonacci;
    fibonacci = next;
  }
  Expr tower = x;
  for (int i = 0; i < 80; ++i) tower = tower * tower;
  Expr sums = z;
  for (int i = 0; i < 60; ++i) sums = (sums + x * y) * (sums - z) * sums + t;
  Expr circles = one;
  for (int i = 0; i < 40; ++i) {
    const Expr angle = g.symbol(numbered('a', i));
    circles = circles * (x * cos(angle) * cos(angle) + y * sin(angle) * sin(angle) + z);
  }
  Expr mixed = z;
  for (int i = 0; i < 300; ++i) {
    const Expr q = g.symbol(numbered('a', i % 40));
    mixed = mixed * cos(q) + (mixed - x) * (sin(q) * mixed) + sqrt(mixed * mixed + y) / (mixed + one);
  }
  const std::vector<Expr> roots{fibonacci, tower + y, sums, circles, mixed};
  const std::vector<Modular> point = random_modular_point(g.symbol_count(), 3);
  for (const Expr& root : roots) {
    const std::vector<Expr> alone{root};
    EXPECT_EQ(evaluate_modular(simplify(alone), point), evaluate_modular(alone, point));
  }
}

TEST_F(Simplify, NeverMoreOperations) {
  RandomDagOptions options;
  options.square_roots = true;
  options.steps = 16;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    ExprGraph graph;
    const RandomDag dag = random_dag(graph, seed, options);
    const OperationCount before = count_operations(dag.roots), after = count_operations(simplify(dag.roots));
    EXPECT_LE(after.total() + after.trig, before.total() + before.trig) << seed;
  }
}

}  // namespace
}  // namespace alembert
