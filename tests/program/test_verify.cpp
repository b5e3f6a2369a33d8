// `verify` can fail: every way of damaging a program is found, and sound programs pass.
#include <gtest/gtest.h>

#include "program/dump.hpp"
#include "program/expression_maker.hpp"
#include "program/optimized.hpp"
#include "program/program_maker.hpp"
#include "program/schedule.hpp"
#include "program/verify/verify.hpp"
#include "support/error.hpp"

namespace alembert {
namespace {

class Verify : public ::testing::Test {
 protected:
  /// Expects that damage to the instruction of that operation is found, and that the message names the place.
  template <class Damage>
  void expect_found(Operation op, Damage damage, const char* what) {
    Program damaged = program;
    for (Instruction& i : damaged.code)
      if (i.op == op) {
        damage(damaged, i);
        expect_rejected(damaged, what);
        return;
      }
    ADD_FAILURE() << "no such instruction for: " << what;
  }
  void expect_rejected(const Program& damaged, const char* what) {
    try {
      verify(damaged, outputs, bindings);
      ADD_FAILURE() << what << " was not noticed\n" << dump(damaged);
    } catch (const InternalError& error) {
      EXPECT_NE(std::string(error.what()).find("damaged_function"), std::string::npos) << error.what();
    }
  }
  static void swap_operands(Program&, Instruction& i) { std::swap(i.a, i.b); }
  static auto becomes(Operation op) {
    return [op](Program&, Instruction& i) { i.op = op; };
  }

  ExprGraph graph;
  std::vector<SymbolBinding> bindings = coordinates(graph, 4);
  Expr a = bindings[0].symbol, b = bindings[1].symbol, c = bindings[2].symbol, d = bindings[3].symbol;
  // Not all functions of one value, so that no damage can hide.
  std::vector<OutputExpressions> outputs = outputs_of(
      {graph.rational(Rational(3, 10)) * a - b * c, (a + d) / (graph.integer(3) + b * b),
       sin(a) * cos(b) + exp(c), atan2(a, b + d) - pow(graph.integer(2) + sin(d), a), -(a* d), tanh(a* b)});
  Program program = lower("damaged_function", outputs, bindings);
};

TEST_F(Verify, AcceptsWhatIsRight) {
  EXPECT_NO_THROW(verify(program, outputs, bindings));
  EXPECT_NO_THROW(verify(schedule(lower("f", optimized(outputs), bindings)), outputs, bindings));
}

TEST_F(Verify, FindsAnotherOperation) {
  expect_found(Operation::add, becomes(Operation::sub), "add -> sub");
  expect_found(Operation::sub, becomes(Operation::add), "sub -> add");
  expect_found(Operation::mul, becomes(Operation::div), "mul -> div");
  expect_found(Operation::div, becomes(Operation::mul), "div -> mul");
  expect_found(Operation::sin, becomes(Operation::cos), "sin -> cos");
  expect_found(Operation::cos, becomes(Operation::sin), "cos -> sin");
  expect_found(Operation::exp, becomes(Operation::cosh), "exp -> cosh");
  expect_found(Operation::neg, becomes(Operation::abs), "neg -> abs");
  expect_found(Operation::tanh, becomes(Operation::atan), "tanh -> atan");
}

TEST_F(Verify, FindsSwappedOperands) {
  for (const Operation op : {Operation::sub, Operation::div, Operation::atan2, Operation::pow})
    expect_found(op, swap_operands, "swapped operands");
}

TEST_F(Verify, FindsAnotherOperand) {
  const auto next_operand = [](Program&, Instruction& i) { i.a = i.a == 0 ? 1 : i.a - 1; };
  for (const Operation op :
       {Operation::add, Operation::sub, Operation::mul, Operation::div, Operation::sin, Operation::pow})
    expect_found(op, next_operand, "another operand");
}

TEST_F(Verify, FindsAnotherConstantHoweverNear) {
  for (std::size_t i = 0; i < program.constants.size(); ++i)
    for (const double factor : {-1.0, 2.0, 1 + 1e-6, 1 - 1e-10}) {
      Program damaged = program;
      damaged.constants[i] *= factor;
      expect_rejected(damaged, "another constant");
    }
}

TEST_F(Verify, FindsAnotherInput) {
  expect_found(
      Operation::input, [](Program&, Instruction& i) { i.a = (i.a + 1) % 4; }, "another input");
  Program damaged = program;
  std::swap(damaged.inputs[0], damaged.inputs[1]);
  expect_rejected(damaged, "exchanged input slots");
  damaged = program;
  damaged.inputs.pop_back();
  expect_rejected(damaged, "a missing input");
}

TEST_F(Verify, FindsOtherOutputs) {
  for (std::size_t k = 0; k < 6; ++k) {
    Program damaged = program;
    auto& values = damaged.outputs[0].values;
    std::swap(values[k], values[(k + 1) % 6]);
    expect_rejected(damaged, "exchanged outputs");
  }
  Program damaged = program;
  damaged.outputs[0].values.pop_back();
  expect_rejected(damaged, "a missing element");
  damaged = program;
  damaged.outputs[0].name = "other";
  expect_rejected(damaged, "another name");
  damaged = program;
  std::swap(damaged.outputs[0].rows, damaged.outputs[0].columns);
  expect_rejected(damaged, "another shape");
  damaged = program;
  damaged.outputs.clear();
  expect_rejected(damaged, "no outputs");
}

TEST_F(Verify, FindsProgramsThatAreNone) {
  expect_found(
      Operation::add, [](Program& p, Instruction& i) { i.b = static_cast<std::uint32_t>(p.code.size() - 1); },
      "an operand that comes later");
  expect_found(
      Operation::constant,
      [](Program& p, Instruction& i) { i.a = static_cast<std::uint32_t>(p.constants.size()); },
      "a constant that does not exist");
  expect_found(
      Operation::input, [](Program&, Instruction& i) { i.a = 99; }, "an input that does not exist");
  Program damaged = program;
  damaged.outputs[0].values[0] = static_cast<std::uint32_t>(damaged.code.size());
  expect_rejected(damaged, "an output that does not exist");
}

TEST_F(Verify, NamesFunctionOutputElementAndBothValues) {
  Program damaged = program;
  std::swap(damaged.outputs[0].values[2], damaged.outputs[0].values[3]);
  try {
    verify(damaged, outputs, bindings);
    FAIL();
  } catch (const InternalError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("damaged_function: out[2] is "), std::string::npos) << text;
    EXPECT_NE(text.find(" in the program and "), std::string::npos) << text;
  }
}

TEST_F(Verify, ComparesExactlyWhereRoundingWouldHideTheDifference) {
  const Expr eight = graph.integer(8);
  Expr large = a * a + graph.integer(2);  // squared again and again: its rounding is far above d*d
  for (int i = 0; i < 6; ++i) large = eight * (large * large + b * b);
  for (const bool exact : {true, false}) {
    const Expr small = exact ? d * d : graph.rational(Rational(1, 3)) * (d * d);
    outputs = outputs_of({large + small});
    program = lower("damaged_function", outputs, bindings);
    ASSERT_NO_THROW(verify(program, outputs, bindings));
    Program damaged = program;
    ASSERT_EQ(damaged.code.back().op, Operation::add);
    damaged.code.back().op = Operation::sub;
    if (exact)
      expect_rejected(damaged, "the sign of a part that rounding hides");
    else  // a third is no binary fraction, and what is left is comparison in double
      EXPECT_NO_THROW(verify(damaged, outputs, bindings));
  }
}

TEST_F(Verify, RespectsTheRangesOfSymbols) {
  // Far outside the usual points: only inside the declared range is there a value.
  graph.assume(a, {100, 101});
  outputs = outputs_of({log(a - graph.integer(99)) + b});
  program = lower("damaged_function", outputs, bindings);
  ASSERT_NO_THROW(verify(program, outputs, bindings));
  expect_found(Operation::log, becomes(Operation::sqrt), "log -> sqrt");
}

TEST_F(Verify, RespectsTheUnitsOfSymbols) {
  // Only for an argument about that small is there a value.
  bindings[0].unit = 0x1p-40;
  outputs = outputs_of({log(graph.real(1e-20) - a * a) + b});
  program = lower("damaged_function", outputs, bindings);
  ASSERT_NO_THROW(verify(program, outputs, bindings));
  expect_found(Operation::log, becomes(Operation::sqrt), "log -> sqrt");
}

// Every single change of an operation or an operand in a random program is either found or changes no value.
TEST(VerifyRandom, FindsRandomDamage) {
  std::mt19937_64 random(17);
  int found = 0, equal = 0;
  for (int round = 0; round < 300; ++round) {
    ExprGraph graph;
    const std::vector<SymbolBinding> bindings = coordinates(graph, 4);
    const Kinds kinds = round % 2 == 0 ? Kinds::rational : Kinds::functions;
    const std::vector<OutputExpressions> outputs =
        outputs_of(random_expressions(graph, bindings, 40, 4, kinds, random));
    const Program program = schedule(lower("random", optimized(outputs), bindings));
    Program damaged = program;
    if (damaged.code.empty()) continue;
    Instruction& c = damaged.code[random() % damaged.code.size()];
    const auto place = static_cast<std::uint32_t>(&c - damaged.code.data());
    if (c.op == Operation::constant)
      damaged.constants[c.a] += 0.125;
    else if (c.op == Operation::input)
      c.a = (c.a + 1) % 4;
    else if (operand_count(c.op) == 2 && random() % 2 == 0)
      c.b = (c.b + 1) % place;
    else if (c.op == Operation::add)
      c.op = Operation::sub;
    else if (operand_count(c.op) == 2)
      c.op = Operation::add;
    else
      c.op = Operation::atan;
    bool differs = false;
    for (int point = 0; point < 3; ++point) {
      const std::vector<double> x = random_point(4, random);
      const std::vector<double> wanted = run(program, x), got = run(damaged, x);
      for (std::size_t k = 0; k < wanted.size(); ++k)
        differs |= std::abs(wanted[k] - got[k]) > 1e-6 * std::max(1.0, std::abs(wanted[k]));
    }
    if (!differs) {
      ++equal;
      continue;
    }
    ++found;
    EXPECT_THROW(verify(damaged, outputs, bindings), InternalError) << dump(program) << dump(damaged);
  }
  EXPECT_GT(found, 200) << equal << " were no damage";
}

}  // namespace
}  // namespace alembert
