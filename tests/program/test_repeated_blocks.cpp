// Aligned programs and their cuts into blocks: same values, same operations, every instruction once.
#include <gtest/gtest.h>

#include <bit>

#include "program/program_maker.hpp"
#include "program/repeated_blocks.hpp"

namespace alembert {
namespace {

std::vector<std::uint32_t> operations_of(const Program& program) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t v = 0; v < program.code.size(); ++v)
    if (operand_count(program.code[v].op) > 0) order.push_back(v);
  return order;
}

void expect_sound(const Program& program, const RepeatedBlocks& blocks,
                  const std::vector<std::uint32_t>& order) {
  ASSERT_EQ(blocks.order, order);
  std::vector<std::uint32_t> first(blocks.lengths.size(), ~std::uint32_t{0});
  std::uint32_t at = 0;
  for (const BlockOccurrence& occurrence : blocks.occurrences) {
    ASSERT_LT(occurrence.block, blocks.lengths.size());
    ASSERT_EQ(occurrence.begin, at);
    const std::uint32_t length = blocks.lengths[occurrence.block];
    ASSERT_GT(length, 0u);
    EXPECT_LE(length, kMaxBlockLength);
    std::uint32_t& begin = first[occurrence.block];
    if (begin == ~std::uint32_t{0}) begin = at;
    for (std::uint32_t i = 0; i < length; ++i)
      EXPECT_EQ(program.code[order[at + i]].op, program.code[order[begin + i]].op);
    at += length;
  }
  EXPECT_EQ(at, order.size());
  for (const std::uint32_t begin : first) EXPECT_NE(begin, ~std::uint32_t{0});
}

bool same(const RepeatedBlocks& x, const RepeatedBlocks& y) {
  if (x.order != y.order || x.lengths != y.lengths || x.occurrences.size() != y.occurrences.size())
    return false;
  for (std::size_t i = 0; i < x.occurrences.size(); ++i)
    if (x.occurrences[i].block != y.occurrences[i].block || x.occurrences[i].begin != y.occurrences[i].begin)
      return false;
  return true;
}

TEST(RepeatedBlocks, RandomProgramsAreCutSoundly) {
  std::mt19937_64 random(5);
  for (const std::size_t size : {30u, 300u, 5000u})
    for (int k = 0; k < 10; ++k) {
      const Program program = random_program(size, k % 2 == 0 ? Mix::arithmetic : Mix::everything, random);
      const std::vector<std::uint32_t> order = operations_of(program);
      const RepeatedBlocks blocks = find_repeated_blocks(program, order);
      expect_sound(program, blocks, order);
      EXPECT_LE(blocks.code(), order.size());
      EXPECT_TRUE(same(blocks, find_repeated_blocks(program, order)));
    }
  EXPECT_TRUE(find_repeated_blocks(Program{}, {}).occurrences.empty());
}

TEST(RepeatedBlocks, ARecursionIsFound) {
  std::mt19937_64 random(6);
  ProgramMaker m(3);
  std::uint32_t x = m.input(0), y = m.input(1);
  const std::uint32_t z = m.input(2);
  for (int step = 0; step < 300; ++step) {
    const std::uint32_t k = m.constant(0.1 + static_cast<double>(random() % 800) * 1e-3);
    std::uint32_t t = m.add(m.mul(k, x), m.mul(z, y));
    for (int i = 0; i < 20; ++i) t = i % 3 == 0 ? m.sub(t, x) : m.mul(t, i % 3 == 1 ? y : z);
    y = m.add(t, m.mul(k, y));
    x = m.sub(t, y);
  }
  const Program program = m.returning({x, y});
  const std::vector<std::uint32_t> order = operations_of(program);
  const RepeatedBlocks blocks = find_repeated_blocks(program, order);
  expect_sound(program, blocks, order);
  EXPECT_LT(10 * blocks.code(), order.size());
}

TEST(AlignRepeats, ValuesAndCountsStay) {
  std::mt19937_64 random(7);
  for (int k = 0; k < 60; ++k) {
    const Program given =
        optimize(random_program(400, k % 2 == 0 ? Mix::arithmetic : Mix::everything, random));
    const Program aligned = schedule(align_repeats(given));
    EXPECT_TRUE(aligned.repeats);
    const OperationCount before = count(given), after = count(aligned);
    EXPECT_LE(weighted(after), weighted(before));
    for (int point = 0; point < 5; ++point)
      EXPECT_TRUE(same_but_for_rounding(given, aligned, random_point(given.inputs.size(), random)));
  }
}

TEST(AlignRepeats, OrderAndSignsOfTheGivenProgramDoNotMatter) {
  // c x - s y and its negative, with operands either way round, become one pattern.
  const auto program = [](bool turned) {
    ProgramMaker m(3);
    const std::uint32_t q = m.input(0), x = m.input(1), y = m.input(2);
    const std::uint32_t s = m.sin(q), c = m.cos(q);
    const std::uint32_t cx = turned ? m.mul(x, c) : m.mul(c, x), sy = m.mul(s, y);
    return m.returning({turned ? m.neg(m.sub(sy, cx)) : m.sub(cx, sy)});
  };
  EXPECT_EQ(dump(schedule(align_repeats(program(false)))), dump(schedule(align_repeats(program(true)))));
}

}  // namespace
}  // namespace alembert
