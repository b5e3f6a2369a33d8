// `optimize` on programs made by hand, one for each rewrite, and on random ones: equal values, never a higher
// count.
#include <gtest/gtest.h>

#include "program/dump.hpp"
#include "program/optimized.hpp"
#include "program/program_maker.hpp"
#include "program/schedule.hpp"

namespace alembert {
namespace {

/// Optimises, checks the values at a few points against error bounds, and returns the result.
Program checked(const Program& program) {
  const Program result = optimized(program);
  std::mt19937_64 random(7);
  for (int point = 0; point < 4; ++point) {
    const std::vector<double> x = random_point(program.inputs.size(), random);
    const std::vector<Approximate> wanted = run_bounded(program, x), found = run_bounded(result, x);
    for (std::size_t k = 0; k < wanted.size(); ++k)
      EXPECT_NEAR(found[k].value, wanted[k].value, 16 * (wanted[k].error + found[k].error))
          << dump(program) << "became\n"
          << dump(result);
  }
  return result;
}

/// mul, add, div and negations of the optimised program.
std::vector<std::size_t> arithmetic_of(const Program& program) {
  const Program result = checked(program);
  const OperationCount n = count(result);
  return {n.mul, n.add, n.div, negations(result)};
}
using Counts = std::vector<std::size_t>;

class Optimize : public ::testing::Test {
 protected:
  ProgramMaker m{6};
  std::uint32_t a = m.input(0), b = m.input(1), c = m.input(2), d = m.input(3), x = m.input(4),
                y = m.input(5);
};

TEST_F(Optimize, CommonFactor) {
  EXPECT_EQ(arithmetic_of(m.returning({m.add(m.mul(a, b), m.mul(c, a))})), (Counts{1, 1, 0, 0}));
}
TEST_F(Optimize, CommonFactorWithSigns) {
  EXPECT_EQ(arithmetic_of(m.returning({m.sub(m.neg(m.mul(a, b)), m.mul(m.neg(c), a))})),
            (Counts{1, 1, 0, 0}));
}
TEST_F(Optimize, CommonFactorAcrossAChain) {
  const auto sum = m.sub(m.add(m.mul(a, b), x), m.mul(a, c));
  EXPECT_EQ(arithmetic_of(m.returning({m.add(m.add(sum, y), m.mul(d, a))})), (Counts{1, 4, 0, 0}));
}
TEST_F(Optimize, NestedCommonFactors) {
  // a*b*c + a*b*d + a*x = a*(b*(c + d) + x)
  const auto first = m.mul(m.mul(a, b), c), second = m.mul(b, m.mul(a, d));
  EXPECT_EQ(arithmetic_of(m.returning({m.add(m.add(first, second), m.mul(x, a))})), (Counts{2, 2, 0, 0}));
}
TEST_F(Optimize, TheFactorWithMostTermsWins) {
  // a*b + a*c + a*d + b*x: a gathers three terms, b only two.
  const auto sum = m.add(m.add(m.mul(a, b), m.mul(a, c)), m.mul(a, d));
  EXPECT_EQ(arithmetic_of(m.returning({m.add(sum, m.mul(b, x))})), (Counts{2, 3, 0, 0}));
}
TEST_F(Optimize, ABareTermJoinsWhereItHelps) {
  // x + x*a + x*b = x*(a + b + 1); with one product only there is nothing to gain.
  EXPECT_EQ(arithmetic_of(m.returning({m.add(m.add(x, m.mul(x, a)), m.mul(x, b))})), (Counts{1, 2, 0, 0}));
  EXPECT_EQ(arithmetic_of(m.returning({m.add(x, m.mul(x, a))})), (Counts{1, 1, 0, 0}));
}
TEST_F(Optimize, SharedProductsStay) {
  const auto ab = m.mul(a, b), ac = m.mul(a, c);
  EXPECT_EQ(arithmetic_of(m.returning({m.add(ab, ac), ab, ac})), (Counts{2, 1, 0, 0}));
}
TEST_F(Optimize, ProductsShareTheirPairs) {
  // 3/7 a a, 3/7 a b, 3/7 b b: with 3/7 a and 3/7 b there are five products instead of six.
  const auto k = m.constant(3.0 / 7);
  EXPECT_EQ(arithmetic_of(m.returning({m.mul(k, m.mul(a, a)), m.mul(k, m.mul(a, b)), m.mul(k, m.mul(b, b))})),
            (Counts{5, 0, 0, 0}));
  // a b c, b (a d), x (y (b a)), in whatever order they are bracketed
  EXPECT_EQ(arithmetic_of(
                m.returning({m.mul(a, m.mul(b, c)), m.mul(b, m.mul(a, d)), m.mul(x, m.mul(y, m.mul(b, a)))})),
            (Counts{5, 0, 0, 0}));
}
TEST_F(Optimize, LikeTerms) {
  // 3x + x/2 - x = 2.5x; x + y - x = y
  const auto three = m.constant(3), half = m.constant(0.5);
  EXPECT_EQ(arithmetic_of(m.returning({m.sub(m.add(m.mul(three, x), m.mul(half, x)), x)})),
            (Counts{1, 0, 0, 0}));
  EXPECT_EQ(arithmetic_of(m.returning({m.sub(m.add(x, y), x)})), (Counts{0, 0, 0, 0}));
}
TEST_F(Optimize, ConstantFactorsAreCollected) {
  // 3a + 3b = 3(a + b); (3a)*(0.5b) = 1.5ab; 3*(0.5*a) = 1.5a
  const auto three = m.constant(3), half = m.constant(0.5);
  EXPECT_EQ(arithmetic_of(m.returning({m.add(m.mul(three, a), m.mul(b, three))})), (Counts{1, 1, 0, 0}));
  EXPECT_EQ(arithmetic_of(m.returning({m.mul(m.mul(three, a), m.mul(b, half))})), (Counts{2, 0, 0, 0}));
  EXPECT_EQ(arithmetic_of(m.returning({m.mul(three, m.mul(half, a))})), (Counts{1, 0, 0, 0}));
}
TEST_F(Optimize, ConstantTermsAreCollected) {
  const auto three = m.constant(3), half = m.constant(0.5);
  EXPECT_EQ(arithmetic_of(m.returning({m.add(m.add(m.add(a, three), b), half)})), (Counts{0, 2, 0, 0}));
  EXPECT_EQ(arithmetic_of(m.returning({m.sub(three, m.add(half, a))})), (Counts{0, 1, 0, 0}));
}
TEST_F(Optimize, AnOffsetInsideAnAngleComesLast) {
  const auto angle = m.add(m.add(a, m.constant(0.5)), b);
  EXPECT_EQ(count(m.returning({m.sin(angle)})).add, 2u);
  EXPECT_EQ(arithmetic_of(m.program), (Counts{0, 1, 0, 0}));
}
TEST_F(Optimize, ZerosAndOnes) {
  const auto zero = m.constant(0), one = m.constant(1), minus = m.constant(-1);
  const auto kept = m.add(m.mul(one, a), m.mul(zero, b));
  EXPECT_EQ(arithmetic_of(m.returning({m.sub(m.div(kept, minus), zero)})), (Counts{0, 0, 0, 1}));
  EXPECT_EQ(arithmetic_of(m.returning({m.sub(b, b), m.div(a, a)})), (Counts{0, 0, 0, 0}));
}
TEST_F(Optimize, TwiceIsASum) {
  const auto two = m.constant(2);
  const Program result = checked(m.returning({m.mul(two, a)}));
  ASSERT_EQ(result.code.size(), 2u);
  EXPECT_EQ(result.code[1].op, Operation::add);
  EXPECT_EQ(arithmetic_of(m.returning({m.add(m.add(b, b), m.add(b, b))})), (Counts{1, 0, 0, 0}));
}
TEST_F(Optimize, EqualValuesAreOneUpToOrderAndSign) {
  const auto p = m.sub(a, b), q = m.sub(b, a);
  EXPECT_EQ(arithmetic_of(m.returning({m.mul(p, c), m.mul(c, q), m.mul(m.neg(c), p)})), (Counts{1, 1, 0, 1}));
  EXPECT_EQ(arithmetic_of(m.returning({m.mul(m.add(a, b), m.add(b, a))})), (Counts{1, 1, 0, 0}));
  const Program result = checked(m.returning({m.sin(p), m.sin(q), m.cos(p), m.cos(q)}));
  EXPECT_EQ(count(result).trig, 2u);
}
TEST_F(Optimize, NegationsVanish) {
  EXPECT_EQ(arithmetic_of(m.returning({m.add(m.neg(a), b)})), (Counts{0, 1, 0, 0}));
  EXPECT_EQ(arithmetic_of(m.returning({m.sub(a, m.neg(b))})), (Counts{0, 1, 0, 0}));
  EXPECT_EQ(arithmetic_of(m.returning({m.neg(m.sub(a, b))})), (Counts{0, 1, 0, 0}));
  EXPECT_EQ(arithmetic_of(m.returning({m.neg(m.mul(m.constant(2.5), a))})), (Counts{1, 0, 0, 0}));
  EXPECT_EQ(arithmetic_of(m.returning({m.neg(m.mul(c, m.sub(a, b)))})), (Counts{1, 1, 0, 0}));
  EXPECT_EQ(arithmetic_of(m.returning({m.mul(m.neg(a), m.neg(b))})), (Counts{1, 0, 0, 0}));
  for (const bool first : {true, false}) {  // -a*(b - c) - x*y with the products in either order
    const auto early = first ? m.mul(a, m.sub(b, c)) : m.mul(x, y);
    const auto late = first ? m.mul(x, y) : m.mul(a, m.sub(b, c));
    EXPECT_EQ(arithmetic_of(m.returning({m.neg(m.add(early, late))})), (Counts{2, 2, 0, 0}));
  }
}
TEST_F(Optimize, ReciprocalsAreShared) {
  EXPECT_EQ(arithmetic_of(m.returning({m.div(a, x), m.div(b, x)})), (Counts{2, 0, 1, 0}));
  EXPECT_EQ(arithmetic_of(m.returning({m.div(a, x), m.div(b, m.neg(x)), m.div(m.constant(1), x)})),
            (Counts{2, 0, 1, 1}));
  EXPECT_EQ(arithmetic_of(m.returning({m.div(a, x), m.div(b, y)})), (Counts{0, 0, 2, 0}));
}
TEST_F(Optimize, QuotientsMerge) {
  EXPECT_EQ(arithmetic_of(m.returning({m.div(m.div(a, b), c)})), (Counts{1, 0, 1, 0}));
  EXPECT_EQ(arithmetic_of(m.returning({m.div(a, m.div(b, c))})), (Counts{1, 0, 1, 0}));
  EXPECT_EQ(arithmetic_of(m.returning({m.mul(m.div(a, b), m.div(c, d))})), (Counts{2, 0, 1, 0}));
  EXPECT_EQ(arithmetic_of(m.returning({m.mul(m.div(m.constant(1), b), a)})), (Counts{0, 0, 1, 0}));
  EXPECT_EQ(arithmetic_of(m.returning({m.add(m.div(a, x), m.div(b, x))})), (Counts{0, 1, 1, 0}));
  EXPECT_EQ(arithmetic_of(m.returning({m.div(m.mul(m.mul(a, b), c), b)})), (Counts{1, 0, 0, 0}));
  EXPECT_EQ(arithmetic_of(m.returning({m.div(a, m.constant(4))})), (Counts{1, 0, 0, 0}));
}
TEST_F(Optimize, EqualValuesInOtherFormsMerge) {
  const auto s = m.sin(x), co = m.cos(x);
  const auto circle = m.add(m.mul(s, s), m.mul(co, co));
  EXPECT_EQ(arithmetic_of(m.returning({circle, m.mul(a, circle)})), (Counts{0, 0, 0, 0}));
  const auto root = m.append(Operation::sqrt, a);
  EXPECT_EQ(arithmetic_of(m.returning({m.mul(root, root)})), (Counts{0, 0, 0, 0}));
  // a*(b - c) beside c*a - b*a + d: the first is there once the second is factored
  const auto bracket = m.mul(a, m.sub(b, c));
  const auto sum = m.add(m.sub(m.mul(c, a), m.mul(b, a)), d);
  EXPECT_EQ(arithmetic_of(m.returning({bracket, sum})), (Counts{1, 2, 0, 0}));
}
TEST_F(Optimize, DeadInstructionsGo) {
  m.mul(a, b);
  const auto kept = m.add(a, b);
  m.div(c, kept);
  EXPECT_EQ(checked(m.returning({kept})).code.size(), 3u);
}
TEST_F(Optimize, ConstantsFold) {
  const auto three = m.constant(3), half = m.constant(0.5);
  const Program result = checked(m.returning({m.sin(m.mul(three, half)), m.sub(three, three)}));
  ASSERT_EQ(result.code.size(), 2u);
  EXPECT_EQ(run(result, std::vector<double>(6))[0], std::sin(1.5));
  EXPECT_FALSE(std::signbit(run(result, std::vector<double>(6))[1]));
}
TEST_F(Optimize, OutputsMayRepeatOrBeInputsOrConstants) {
  const auto p = m.mul(a, b);
  const Program result = checked(m.returning({p, a, p, m.neg(p), m.constant(-3), m.neg(a)}));
  const std::vector<double> out = run(result, std::vector<double>{2, 5, 0, 0, 0, 0});
  EXPECT_EQ(out, (std::vector<double>{10, 2, 10, -10, -3, -2}));
}

// The bound of a comparison is the sum of both sides' running error bounds, times 64 because folding
// constants rounds too.
class RandomPrograms : public ::testing::TestWithParam<Mix> {};

TEST_P(RandomPrograms, KeepTheirValuesAndNeverCostMore) {
  std::mt19937_64 random(GetParam() == Mix::arithmetic ? 1 : 2);
  std::size_t compared = 0, before = 0, after = 0;
  for (int round = 0; round < 1000; ++round) {
    const Program program = random_program(30 + random() % 120, GetParam(), random);
    const Program result = optimized(program);
    const std::size_t given = count(program).weight, reached = count(result).weight;
    ASSERT_LE(reached, given) << dump(program);
    before += given;
    after += reached;
    for (int point = 0; point < 3; ++point) {
      const std::vector<double> x = random_point(program.inputs.size(), random);
      const std::vector<Approximate> wanted = run_bounded(program, x), found = run_bounded(result, x);
      for (std::size_t k = 0; k < wanted.size(); ++k) {
        // Where a value does not exist (0*infinity is 0 here) or rounding decides it, there is nothing to
        // compare.
        const double bound = 64 * (wanted[k].error + found[k].error);
        if (!(bound < 1e-6 * (1 + std::abs(wanted[k].value)))) continue;
        ++compared;
        ASSERT_NEAR(found[k].value, wanted[k].value, bound + 1e-300) << dump(program) << "became\n"
                                                                     << dump(result);
      }
    }
  }
  EXPECT_GT(compared, GetParam() == Mix::arithmetic ? 9000u : 2000u) << "of 12000";
  EXPECT_LT(after, before);
}
INSTANTIATE_TEST_SUITE_P(Mixes, RandomPrograms, ::testing::Values(Mix::arithmetic, Mix::everything),
                         [](const auto& mix) {
                           return mix.param == Mix::arithmetic ? "arithmetic" : "everything";
                         });

TEST(OptimizeAgain, ChangesNothing) {
  std::mt19937_64 random(3);
  for (int round = 0; round < 100; ++round) {
    const Program once = optimized(random_program(100, Mix::arithmetic, random));
    EXPECT_EQ(count(optimized(once)).weight, count(once).weight);
  }
}

// Turned and scaled three times: two products c*x, c*y serve all, where c taken out of each sum costs three.
TEST(OptimizeFactors, AFactorStaysInProductsThatManySumsShare) {
  ProgramMaker m(8);
  const auto c = m.constant(0.805664471353141), x = m.input(0), y = m.input(1);
  std::vector<std::uint32_t> sums;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const auto u = m.input(2 + 2 * k), v = m.input(3 + 2 * k);
    const auto xu = m.mul(x, u), yv = m.mul(y, v);
    const auto left = m.mul(c, xu);
    const auto right = m.mul(c, yv);
    sums.push_back(m.sub(left, right));
  }
  const OperationCount n = count(optimized(m.returning(sums)));
  EXPECT_EQ(n.mul, 8u);
  EXPECT_EQ(n.add, 3u);
}

TEST(OptimizeLarge, AChainOfAMillionWorks) {
  ProgramMaker m(2);
  auto value = m.input(0);
  const auto y = m.input(1);
  for (int i = 0; i < 250000; ++i) {
    value = m.mul(value, y);
    value = m.add(value, y);
    value = m.sin(value);
    value = m.sub(y, value);
  }
  const Program result = schedule(optimized(m.returning({value})));
  EXPECT_EQ(result.code.size(), m.program.code.size());
  const std::vector<double> x{0.3, 0.7};
  EXPECT_NEAR(run(result, x)[0], run(m.program, x)[0], 1e-9);
}

TEST(OptimizeLarge, ASumOfAMillionTermsIsFactored) {
  ProgramMaker m(3);
  const auto x = m.input(0), y = m.input(1), z = m.input(2);
  auto sum = m.mul(x, y);
  auto other = z;
  for (int i = 0; i < 250000; ++i) {
    other = m.sin(other);
    const auto product = m.mul(x, other);
    sum = m.add(sum, product);
  }
  const OperationCount n = count(optimized(m.returning({sum})));
  EXPECT_EQ(n.mul, 1u);
  EXPECT_EQ(n.add, 250000u);
}

}  // namespace
}  // namespace alembert
