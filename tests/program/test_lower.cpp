// `lower`: shapes of small programs, signs, constants, order, and values of random expressions.
#include <gtest/gtest.h>

#include <numbers>

#include "program/count.hpp"
#include "program/dump.hpp"
#include "program/expression_maker.hpp"
#include "program/optimized.hpp"
#include "program/program_maker.hpp"
#include "program/schedule.hpp"
#include "program/verify/verify.hpp"
#include "support/error.hpp"
#include "symbolic/to_string.hpp"

namespace alembert {
namespace {

class Lower : public ::testing::Test {
 protected:
  std::string lowered(std::vector<Expr> values) { return dump(program_of(std::move(values))); }
  Program program_of(std::vector<Expr> values) { return lower("f", outputs_of(std::move(values)), bindings); }

  ExprGraph graph;
  std::vector<SymbolBinding> bindings = coordinates(graph, 4);
  Expr a = bindings[0].symbol, b = bindings[1].symbol, c = bindings[2].symbol, d = bindings[3].symbol;
};

TEST_F(Lower, TwiceAValueIsASum) {
  EXPECT_EQ(lowered({graph.integer(2) * a}), "function f\nt0 = q[0]  # q0\nt1 = t0 + t0\nout[0] = t1\n");
}

TEST_F(Lower, FractionsAreTheNearestDoubles) {
  EXPECT_EQ(lowered({a * graph.rational(Rational(1, 3))}),
            "function f\nt0 = q[0]  # q0\nt1 = 0.3333333333333333\nt2 = t1 * t0\nout[0] = t2\n");
  const Program third = program_of({a / graph.integer(3)});
  EXPECT_EQ(third.constants, std::vector<double>{1.0 / 3.0});
}

TEST_F(Lower, ConstantSubexpressionsAreOneDouble) {
  const Expr constant = sqrt(graph.integer(2)) * cos(graph.rational(Rational(1, 5))) + graph.pi();
  const Program program = program_of({constant * a, constant, graph.pi(Rational(-1, 2)), graph.integer(0)});
  const std::vector<double> out = run(program, std::vector<double>{1, 0, 0, 0});
  const long double expected = std::sqrt(2.0L) * std::cos(0.2L) + std::numbers::pi_v<long double>;
  EXPECT_EQ(out[0], static_cast<double>(expected));
  EXPECT_EQ(out[1], static_cast<double>(expected));
  EXPECT_EQ(out[2], -std::numbers::pi / 2);
  EXPECT_EQ(out[3], 0);
  EXPECT_EQ(count(program).mul, 1u);
  EXPECT_EQ(count(program).arithmetic() + count(program).other + count(program).trig, 1u);
}

TEST_F(Lower, CancelledConstantsAreZero) {
  // sin(1)^2 + cos(1)^2 - 1 is some 1e-20 in extended precision if the engine does not see that it is 0.
  const Expr s = sin(graph.one()), co = cos(graph.one());
  Expr sum = s * s;
  sum += co * co;
  const Program program = program_of({(sum - graph.one()) * a + b});
  EXPECT_EQ(count(program).arithmetic(), 0u) << dump(program);
}

TEST_F(Lower, CancelledConstantsKeepTheirDigits) {
  // 1 - cos(1e-10) is 5e-21, of which long double has nothing left.
  const Expr angle = graph.rational(*make_rational(1, 10'000'000'000));
  const Expr left = graph.one() - cos(angle);
  const Program program = program_of({a / sqrt(left * left), left * b});
  const std::vector<double> out = run(program, std::vector<double>{1, 1, 0, 0});
  EXPECT_DOUBLE_EQ(out[0], 2e20);
  EXPECT_DOUBLE_EQ(out[1], 5e-21);
}

TEST_F(Lower, ConstantsWithoutAValueAreRefused) {
  const Expr bad = exp(graph.integer(1000));  // finite in extended precision, not in double
  EXPECT_THROW(program_of({bad * a}), InternalError);
}

TEST_F(Lower, UnboundSymbolsAndBadShapesAreRefused) {
  const Expr stranger = graph.symbol("stranger");
  try {
    program_of({a + stranger});
    FAIL() << "nothing was thrown";
  } catch (const InternalError& error) {
    EXPECT_NE(std::string(error.what()).find("'stranger'"), std::string::npos) << error.what();
  }
  std::vector<OutputExpressions> outputs = outputs_of({a, b});
  outputs[0].columns = 2;
  EXPECT_THROW(lower("f", outputs, bindings), InternalError);
}

TEST_F(Lower, NeedsNoNegationWhereASignIsFree) {
  const Expr quarter = graph.rational(Rational(1, 4));
  for (const Expr& e :
       {-(a - b), -(quarter * a), -(a - b) * c, -(sin(a - b) * c), -(a * b) - c * (d - a), b - (-(a * c)),
        -((a - b) / c), -(graph.one() / a), -sin(a - b), graph.one() - a, -graph.one() - (a - b)}) {
    const Program program = program_of({e});
    EXPECT_EQ(negations(program), 0u) << to_string(e) << "\n" << dump(program);
  }
}

TEST_F(Lower, NegatesOnceWhereItMust) {
  const Expr product = a * b;
  const Program program = program_of({product, -product, c - product, exp(-product)});
  EXPECT_EQ(negations(program), 1u) << dump(program);
  const std::vector<double> out = run(program, std::vector<double>{2, 3, 5, 0});
  EXPECT_EQ(out, (std::vector<double>{6, -6, -1, std::exp(-6.0)}));
}

TEST_F(Lower, AnOutputNeededOnlyNegativelyIsBuiltSo) {
  const Expr sum = sin(a - b) + (c - d) * a;
  const Program program = program_of({-sum, -sum * b});
  EXPECT_EQ(negations(program), 0u) << dump(program);
}

TEST_F(Lower, KeepsInputsAndOutputsAsGiven) {
  std::vector<OutputExpressions> outputs = outputs_of({a, a, -b, graph.one()});
  outputs[0].rows = 2;
  outputs[0].columns = 2;
  outputs.push_back({"none", 0, 1, {}});
  const Program program = lower("f", outputs, bindings);
  ASSERT_EQ(program.inputs.size(), 4u) << "inputs that nothing needs keep their place";
  EXPECT_EQ(program.inputs[3].name, "q3");
  ASSERT_EQ(program.outputs.size(), 2u);
  EXPECT_EQ(program.outputs[0].rows, 2u);
  EXPECT_EQ(program.outputs[0].columns, 2u);
  EXPECT_EQ(run(program, std::vector<double>{7, 5, 0, 0}), (std::vector<double>{7, 7, -5, 1}));
  EXPECT_TRUE(lower("empty", {}, bindings).code.empty());
}

TEST_F(Lower, TheOrderOfConstructionDoesNotShow) {
  const auto build = [](ExprGraph& g, bool reversed) {
    const auto bind = [&g](std::string_view name) { return g.symbol(name); };
    if (reversed) {  // other ids for everything below
      const Expr noise = bind("d") * bind("c");
      const Expr more = sin(noise + bind("b")) - cos(bind("a"));
      static_cast<void>(more * noise);
    }
    const Expr x = bind("a"), y = bind("b"), z = bind("c"), w = bind("d");
    std::vector<Expr> parts(6);
    for (int i = 0; i < 6; ++i) switch (reversed ? 5 - i : i) {
        case 0:
          parts[0] = x * y;
          break;
        case 1:
          parts[1] = z - w;
          break;
        case 2:
          parts[2] = sin(x + y);
          break;
        case 3:
          parts[3] = cos(y + x);
          break;
        case 4:
          parts[4] = w * z;
          break;
        case 5:
          parts[5] = x / (y + z);
          break;
      }
    std::vector<Expr> out(2);
    if (reversed) {
      out[1] = parts[5] * parts[4] - parts[1] * parts[2];
      out[0] = parts[2] * parts[1] + parts[3] * parts[0];
    } else {
      out[0] = parts[0] * parts[3] + parts[1] * parts[2];
      out[1] = parts[4] * parts[5] - parts[2] * parts[1];
    }
    std::vector<SymbolBinding> bound;
    for (std::uint32_t i = 0; i < 4; ++i)
      bound.push_back({std::vector<Expr>{x, y, z, w}[i], {ArgumentKind::q, i, ""}});
    const Program program = lower("f", outputs_of(out), bound);
    return dump(program) + dump(schedule(lower("f", optimized(outputs_of(out)), bound)));
  };
  ExprGraph first, second;
  const std::string one = build(first, false);
  const std::string other = build(second, true);
  EXPECT_EQ(one, other);
  EXPECT_GT(one.size(), 200u);
}

TEST_F(Lower, AMillionNodesDeep) {
  const Expr quarter = graph.rational(Rational(1, 4));
  Expr value = a;
  for (int i = 0; i < 250000; ++i) {
    value = value * b;
    value = value + c;
    value = sin(value);
    value = quarter * value;
  }
  const std::vector<OutputExpressions> outputs = outputs_of({value});
  const Program program = lower("deep", outputs, bindings);
  EXPECT_EQ(count(program).arithmetic(), 750000u);
  EXPECT_EQ(count(program).trig, 250000u);
  const Program result = schedule(lower("deep", optimized(outputs), bindings));
  EXPECT_EQ(count(result).arithmetic(), 500002u);  // b/4 is made once
  verify(result, outputs, bindings);
  EXPECT_GT(dump(result).size(), 1000000u);
}

class RandomExpressions : public ::testing::TestWithParam<Kinds> {};

TEST_P(RandomExpressions, SurviveEveryStage) {
  std::mt19937_64 random(11);
  std::size_t saved = 0;
  for (int round = 0; round < 300; ++round) {
    ExprGraph graph;
    const std::vector<SymbolBinding> bindings = coordinates(graph, 4);
    const std::vector<OutputExpressions> outputs = outputs_of(
        random_expressions(graph, bindings, 20 + static_cast<int>(random() % 80), 4, GetParam(), random));
    const Program program = lower("random", outputs, bindings);
    ASSERT_NO_THROW(verify(program, outputs, bindings)) << dump(program);
    const Program better = lower("random", optimized(outputs), bindings);
    ASSERT_NO_THROW(verify(better, outputs, bindings)) << dump(program) << "became\n" << dump(better);
    ASSERT_LE(count(better).weight, count(program).weight);
    saved += count(program).weight - count(better).weight;
    const Program scheduled = schedule(better);
    ASSERT_NO_THROW(verify(scheduled, outputs, bindings));
    const std::vector<double> x = random_point(4, random);
    ASSERT_EQ(run(scheduled, x), run(better, x));
  }
  EXPECT_GT(saved, 0u);
}
INSTANTIATE_TEST_SUITE_P(Kinds, RandomExpressions, ::testing::Values(Kinds::rational, Kinds::functions),
                         [](const auto& kind) {
                           return kind.param == Kinds::rational ? "rational" : "functions";
                         });

}  // namespace
}  // namespace alembert
