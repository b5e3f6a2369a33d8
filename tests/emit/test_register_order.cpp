// `order_for_registers`: same instructions and values bit for bit, sines first, fewer values out of
// registers.
#include <gtest/gtest.h>

#include "emit/register_order.hpp"
#include "program/program_maker.hpp"

namespace alembert {
namespace {

/// Operands that are not among the `registers` values used last, inputs included: what is loaded.
std::size_t loads(const Program& program, std::size_t registers) {
  std::vector<std::uint32_t> held;  // the value used last stands last
  std::size_t missing = 0;
  const auto use = [&](std::uint32_t v) {
    if (std::erase(held, v) == 0) ++missing;
    held.push_back(v);
    if (held.size() > registers) held.erase(held.begin());
  };
  for (std::uint32_t i = 0; i < program.code.size(); ++i) {
    const Instruction& c = program.code[i];
    const int operands = operand_count(c.op);
    if (operands == 0) continue;
    use(c.a);
    if (operands > 1) use(c.b);
    use(i);
    --missing;  // the result is computed
  }
  return missing;
}

TEST(RegisterOrder, KeepsInstructionsAndEveryBit) {
  std::mt19937_64 random(11);
  for (int round = 0; round < 300; ++round) {
    const Program program = schedule(optimize(random_program(150, Mix::everything, random)));
    const Program result = order_for_registers(program);
    ASSERT_EQ(result.code.size(), program.code.size());
    ASSERT_TRUE(is_ordered(result)) << dump(program);
    const std::vector<double> x = random_point(program.inputs.size(), random);
    ASSERT_TRUE(same_outputs(program, result, x)) << dump(program);
    ASSERT_EQ(dump(order_for_registers(program)), dump(result));
  }
}

TEST(RegisterOrder, LeavesTheSinesOfAllAnglesTogether) {
  ProgramMaker m(4);
  std::vector<std::uint32_t> values;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const auto angle = m.add(m.input(i), m.constant(0.5 + i));
    values.push_back(m.mul(m.sin(angle), m.cos(angle)));
  }
  const Program result = order_for_registers(schedule(m.returning(values)));
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < result.code.size(); ++i)
    if (is_trigonometric(result.code[i].op)) places.push_back(i);
  ASSERT_EQ(places.size(), 8u);
  EXPECT_EQ(places.back() - places.front(), 7u) << dump(result);
  for (const std::size_t place : places) EXPECT_LT(result.code[place].a, places.front()) << dump(result);
}

// Two sums over the same thirty squares, of which every part is wanted: depth first, each square is long
// forgotten when the second sum needs it.
TEST(RegisterOrder, ReadsValuesWhileTheyAreHeld) {
  ProgramMaker m(31);
  std::uint32_t first = m.input(30), second = first;
  std::vector<std::uint32_t> firsts, seconds;
  for (std::uint32_t i = 0; i < 30; ++i) {
    const auto x = m.input(i);
    const auto square = m.mul(x, x);
    firsts.push_back(first = m.add(first, square));
    seconds.push_back(second = m.sub(second, square));
  }
  firsts.insert(firsts.end(), seconds.begin(), seconds.end());
  const Program program = schedule(m.returning(firsts));
  const Program result = order_for_registers(program);
  EXPECT_EQ(loads(program, 15), 62u) << "each input and each square, and one input again";
  EXPECT_EQ(loads(result, 15), 31u) << "each input\n" << dump(result);
}

}  // namespace
}  // namespace alembert
