// `order_for_registers`: same instructions and values bit for bit, sines first and loops last, fewer values
// out of registers, less waiting.
#include <gtest/gtest.h>

#include "program/dump.hpp"
#include "program/loops/dot_products.hpp"
#include "program/optimized.hpp"
#include "program/program_maker.hpp"
#include "program/schedule.hpp"
#include "registers/register_order.hpp"
#include "rounds.hpp"

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
  for (int round = 0; round < test::rounds(300); ++round) {
    const Program program = schedule(optimized(random_program(150, Mix::everything, random)));
    for (const States states : {States::one, States::many}) {
      const Program result = order_for_registers(program, states);
      ASSERT_EQ(result.code.size(), program.code.size());
      ASSERT_TRUE(is_ordered(result)) << dump(program);
      const std::vector<double> x = random_point(program.inputs.size(), random);
      ASSERT_TRUE(same_outputs(program, result, x)) << dump(program);
      ASSERT_EQ(dump(order_for_registers(program, states)), dump(result));
    }
  }
}

TEST(RegisterOrder, KeepsLoopsAtTheEnd) {
  std::mt19937_64 random(12);
  ProgramMaker m(40);
  std::vector<std::uint32_t> entries, results;
  for (std::uint32_t i = 0; i < 40; ++i) entries.push_back(m.input(i));
  entries.push_back(m.constant(0.5));
  for (std::uint32_t i = 0; i < 39; ++i) entries.push_back(m.add(i, m.sin(i + 1)));
  const auto row = [&](std::size_t i) { return std::span(entries).subspan(4 * i, 4); };
  for (std::size_t i = 0; i < 10; ++i)
    for (std::size_t j = 10; j < 20; ++j)
      results.push_back(append_dot_product(m, row(i), row(j), false, random));
  const Program program = gather_dot_products(schedule(m.returning(results)), 100);
  for (const States states : {States::one, States::many}) {
    const Program result = order_for_registers(program, states);
    ASSERT_EQ(result.code.size(), program.code.size());
    ASSERT_TRUE(is_ordered(result));
    EXPECT_TRUE(same_outputs(program, result, random_point(40, random)));
    EXPECT_EQ(dot_products(result), 100u);
    const std::size_t straight = result.code.size() - result.dot_product_code;
    const DotProducts &before = program.dot_products.at(0), &after = result.dot_products.at(0);
    for (const auto rows : {&DotProducts::left, &DotProducts::right})
      for (std::size_t i = 0; i < (after.*rows).size(); ++i) {
        const std::uint32_t v = (after.*rows)[i];
        ASSERT_LT(v, straight);
        EXPECT_EQ(result.code[v].op, program.code[(before.*rows)[i]].op);
      }
    for (std::size_t i = straight; i < result.code.size(); ++i)
      EXPECT_TRUE(result.code[i].op == Operation::mul || result.code[i].op == Operation::add);
  }
}

TEST(RegisterOrder, LeavesTheSinesOfAllAnglesTogether) {
  ProgramMaker m(4);
  std::vector<std::uint32_t> values;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const auto angle = m.add(m.input(i), m.constant(0.5 + i));
    values.push_back(m.mul(m.sin(angle), m.cos(angle)));
  }
  const Program result = order_for_registers(schedule(m.returning(values)), States::many);
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
  const Program result = order_for_registers(program, States::many);
  EXPECT_EQ(loads(program, 15), 62u) << "each input and each square, and one input again";
  EXPECT_EQ(loads(result, 15), 31u) << "each input\n" << dump(result);
}

/// When the last result is known, if one instruction is fetched at a time, starts once its operands are known
/// and takes four times as long as fetching it.
std::size_t duration(const Program& program) {
  std::vector<std::size_t> known(program.code.size(), 0);
  std::size_t fetched = 0;
  for (std::size_t i = 0; i < program.code.size(); ++i) {
    const Instruction& c = program.code[i];
    const int operands = operand_count(c.op);
    if (operands == 0) continue;
    std::size_t start = std::max(++fetched, known[c.a]);
    if (operands > 1) start = std::max(start, known[c.b]);
    known[i] = start + 4;
  }
  return *std::ranges::max_element(known);
}

// A recursion of forty steps, and sixty products that nothing waits for.
TEST(RegisterOrder, OneStateDoesNotWaitForWhatCouldHaveBegunSooner) {
  ProgramMaker m(4);
  std::vector<std::uint32_t> values;
  for (std::uint32_t i = 0; i < 4; ++i) m.input(i);
  for (int i = 0; i < 60; ++i) values.push_back(m.mul(m.add(1, m.constant(0.1 * i)), 2));
  std::uint32_t x = 0;
  for (int i = 0; i < 40; ++i) values.push_back(x = m.add(m.mul(x, 3), 1));
  const Program program = schedule(m.returning(values));
  const std::size_t shortest = 40 * 8;
  EXPECT_GT(duration(program), shortest + 100);
  EXPECT_LE(duration(order_for_registers(program, States::one)), shortest + 2);
}

}  // namespace
}  // namespace alembert
