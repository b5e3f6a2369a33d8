// Probabilistic value numbering: what is merged, and what must not be.
#include <cmath>

#include "symbolic/count_operations.hpp"
#include "symbolic/evaluate.hpp"
#include "symbolic/random_dag.hpp"
#include "symbolic/same.hpp"
#include "symbolic/value_number.hpp"

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
  // sqrt(a + 2 sqrt(b)) = sqrt(p) + sqrt(q) for a = p + q, b = p q: the field may take any of the signs. They
  // matter in small numbers too.
  for (const std::int64_t parts : {std::int64_t{1}, std::int64_t{100'000'000'000'000'000}}) {
    for (int p = 2; p < 12; ++p) {
      for (int q = p + 1; q < 13; ++q) {
        ExprGraph graph;
        const Expr u = graph.symbol("u");
        const auto number = [&](std::int64_t n) { return graph.integer(n) / graph.integer(parts); };
        const Expr nested =
            sqrt(number(p + q) + graph.integer(2) * sqrt(graph.integer(p * q)) / graph.integer(parts));
        const Expr plain = sqrt(number(p)) + sqrt(number(q));
        const Expr other = sqrt(number(q)) - sqrt(number(p));
        const std::vector<Expr> roots{plain * u, nested * u * u, other * u + nested};
        const std::vector<double> at{1.7};
        const std::vector<double> before = evaluate(roots, at), after = evaluate(value_number(roots), at);
        for (std::size_t i = 0; i < roots.size(); ++i)
          EXPECT_NEAR(after[i] / before[i], 1, 1e-12) << p << " " << q << " / " << parts;
      }
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
    const OperationCount before = count_operations(dag.roots),
                         after = count_operations(value_number(dag.roots));
    EXPECT_LE(after.all(), before.all()) << seed;
  }
}

/// A number that no short decimal stands for.
double computed_constant(TestRandom& random) {
  return std::sqrt(2.0) * random.uniform(0.5, 2) * std::pow(10.0, random.uniform(-6, 6));
}

double moved(double x, int units) {
  const double towards = units < 0 ? 0 : HUGE_VAL;
  for (int i = 0; i < std::abs(units); ++i) x = std::nextafter(x, towards);
  return x;
}

TEST_F(ValueNumber, ConstantsEqualToRoundingShareTheirProducts) {
  TestRandom random(1);
  for (int k = 0; k < 1000; ++k) {
    const double c = computed_constant(random);
    const double d = moved(c, static_cast<int>(random.below(9)) - 4) * (random.one_in(2) ? -1 : 1);
    const std::vector<Expr> roots{g.real(c) * (x + y) + z, z - g.real(d) * (x + y)};
    const std::vector<Expr> out = value_number(roots);
    const OperationCount n = count_operations(out);
    EXPECT_EQ(n.mul, 1u) << c << ' ' << d;
    const std::vector<double> at{0.3, 0.9, -0.2};
    const std::vector<double> before = evaluate(roots, at), after = evaluate(out, at);
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(before[i], after[i], 1e-15 * (std::abs(c) * 1.2 + std::abs(before[i]))) << c << ' ' << d;
  }
}

TEST_F(ValueNumber, ConstantsThatDifferStayApart) {
  TestRandom random(2);
  for (int k = 0; k < 1000; ++k) {
    const double c = computed_constant(random), d = c * (1 + 1e-14);
    const std::vector<Expr> roots{g.real(c) * (x + y) + z, z - g.real(d) * (x + y)};
    const std::vector<Expr> out = value_number(roots);
    EXPECT_EQ(count_operations(out).mul, 2u) << c;
    const std::vector<double> at{0.3, 0.9, -0.2};
    EXPECT_EQ(evaluate(out, at), evaluate(roots, at)) << c;
  }
}

TEST_F(ValueNumber, DifferencesOfConstantsAreKept) {
  TestRandom random(3);
  for (int k = 0; k < 1000; ++k) {
    const double c = computed_constant(random), d = moved(c, 1 + static_cast<int>(random.below(4)));
    const std::vector<Expr> out =
        value_number(std::vector<Expr>{x * g.real(d - c), g.real(c) * y + g.real(d) * z});
    EXPECT_EQ(evaluate(out, std::vector<double>{1, 0, 0})[0], d - c) << c << ' ' << d;
    EXPECT_EQ(evaluate(out, std::vector<double>{0, 1, -1})[1], 0) << c << ' ' << d;
  }
}

TEST_F(ValueNumber, RationalsAreWhatWasWritten) {
  const Expr third = g.rational({1, 3}), binary = g.rational({6004799503160661, 18014398509481984});
  const std::vector<Expr> roots{third * x, binary * x};
  EXPECT_EQ(value_number(roots), roots);
  // What was computed gives way to what was written, even where that comes later.
  const std::vector<Expr> mixed{g.real(moved(0.1, 3)) * x, g.rational({1, 10}) * x * y};
  EXPECT_TRUE(same(value_number(mixed)[0], g.rational({1, 10}) * x));
}

}  // namespace
}  // namespace alembert
