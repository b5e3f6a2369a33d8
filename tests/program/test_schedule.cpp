// `schedule`: same values bit for bit, operands before users, sin and cos of one value side by side, nothing
// dead.
#include <gtest/gtest.h>

#include "program/count.hpp"
#include "program/dump.hpp"
#include "program/optimized.hpp"
#include "program/program_maker.hpp"
#include "program/schedule.hpp"
#include "support/error.hpp"

namespace alembert {
namespace {

TEST(Schedule, KeepsEveryBitAndDropsTheDead) {
  std::mt19937_64 random(5);
  for (int round = 0; round < 300; ++round) {
    const Program program = random_program(120, Mix::everything, random);
    const Program result = schedule(program);
    EXPECT_LE(result.code.size(), program.code.size());
    ASSERT_TRUE(is_ordered(result)) << dump(program);
    const std::vector<double> x = random_point(program.inputs.size(), random);
    ASSERT_TRUE(same_outputs(program, result, x)) << dump(program);
    const Program final = schedule(optimized(program));
    EXPECT_EQ(dump(schedule(final)), dump(final)) << "a schedule of distinct values is final";
  }
}

TEST(Schedule, SineAndCosineStandTogether) {
  ProgramMaker m(2);
  const auto x = m.input(0), y = m.input(1);
  const auto s = m.sin(x);
  auto value = s;
  for (int i = 0; i < 10; ++i) value = m.mul(value, y);
  const auto c = m.cos(x);
  m.cos(y);
  const Program result = schedule(m.returning({m.mul(value, c)}));
  std::size_t sine = 0, cosine = 0;
  for (std::size_t i = 0; i < result.code.size(); ++i) {
    if (result.code[i].op == Operation::sin) sine = i;
    if (result.code[i].op == Operation::cos) cosine = i;
  }
  EXPECT_EQ(cosine, sine + 1) << dump(result);
  EXPECT_EQ(count(result).trig, 2u) << "the cosine that nothing needs is gone";
}

TEST(Schedule, IsDepthFirstFromTheOutputs) {
  ProgramMaker m(2);
  const auto x = m.input(0), y = m.input(1);
  const auto a = m.mul(x, x), b = m.mul(y, y), c = m.add(y, x);
  EXPECT_EQ(dump(schedule(m.returning({m.add(b, c), a}))),
            "function made\n"
            "t0 = q[1]  # x1\n"
            "t1 = t0 * t0\n"
            "t2 = q[0]  # x0\n"
            "t3 = t0 + t2\n"
            "t4 = t1 + t3\n"
            "t5 = t2 * t2\n"
            "out[0] = t4\n"
            "out[1] = t5\n");
}

TEST(Interpret, RejectsArraysOfTheWrongSize) {
  ProgramMaker m(2);
  m.returning({m.add(m.input(0), m.input(1))});
  std::vector<double> in(1), out(1), scratch;
  EXPECT_THROW(interpret(m.program, in, out, scratch), InternalError);
  in.resize(2);
  out.resize(2);
  EXPECT_THROW(interpret(m.program, in, out, scratch), InternalError);
}

}  // namespace
}  // namespace alembert
