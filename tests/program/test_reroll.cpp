// Steps that do the same are found and become loops: same values, same operations, iterations that are alike.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "program/dump.hpp"
#include "program/loops/dot_products.hpp"
#include "program/loops/reroll.hpp"
#include "program/optimized.hpp"
#include "program/program_maker.hpp"
#include "program/schedule.hpp"
#include "rounds.hpp"

namespace alembert {
namespace {

/// Loops do not overlap; their iterations have the same operations on the same values of their own, or on
/// none.
void expect_sound_loops(const Program& program) {
  ASSERT_TRUE(is_ordered(program));
  std::uint32_t free = 0;
  for (const Loop& loop : program.loops) {
    ASSERT_GE(loop.first, free);
    ASSERT_GT(loop.count, 1u);
    free = loop.first + loop.length * loop.count;
    ASSERT_LE(free, program.code.size() - program.dot_product_code);
    for (std::uint32_t k = 1; k < loop.count; ++k)
      for (std::uint32_t i = 0; i < loop.length; ++i) {
        const std::uint32_t begin = loop.first + k * loop.length;
        const Instruction &x = program.code[loop.first + i], &y = program.code[begin + i];
        ASSERT_EQ(x.op, y.op);
        const auto inside = [](std::uint32_t v, std::uint32_t first) {
          return v >= first ? v - first + 1 : 0;
        };
        const int operands = operand_count(x.op);
        if (operands > 0) {
          ASSERT_EQ(inside(x.a, loop.first), inside(y.a, begin));
        }
        if (operands > 1) {
          ASSERT_EQ(inside(x.b, loop.first), inside(y.b, begin));
        }
      }
  }
}

enum class Values : std::uint8_t { exactly, but_for_rounding };

void expect_same(const Program& given, const Program& rerolled, Values same, std::mt19937_64& random) {
  expect_sound_loops(rerolled);
  const OperationCount before = count(given), after = count(rerolled);
  EXPECT_EQ(after.mul, before.mul);
  EXPECT_EQ(after.add, before.add);
  EXPECT_EQ(after.div, before.div);
  EXPECT_EQ(after.trig, before.trig);
  EXPECT_EQ(after.other, before.other);
  for (int point = 0; point < 5; ++point)
    if (const std::vector<double> at = random_point(given.inputs.size(), random); same == Values::exactly)
      EXPECT_TRUE(same_outputs(given, rerolled, at));
    else
      EXPECT_TRUE(same_but_for_rounding(given, rerolled, at));
  EXPECT_EQ(dump(reroll(given)), dump(rerolled));
}

TEST(Reroll, ARecursionBecomesLoopsWhateverItsSignsAndOrder) {
  std::mt19937_64 random(3);
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(test::rounds(10)); ++seed) {
    const std::uint32_t n = 12 + 3 * static_cast<std::uint32_t>(seed);
    const Program given = schedule(ChainMaker(n, seed).m.program);
    const Program rerolled = reroll(given);
    expect_same(given, rerolled, Values::exactly, random);
    EXPECT_GE(rerolled.loops.size(), 2u);
    // The ends of the chain apart, from which matching values are told a few operations deep.
    EXPECT_GE(operations_in_loops(rerolled) * n, count(given).arithmetic() * (n - 9)) << n;
  }
}

TEST(Reroll, StepsMayHaveTermsInAnyOrderAndNegativeAxes) {
  std::mt19937_64 random(6);
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(test::rounds(10)); ++seed) {
    const std::uint32_t n = 12 + 3 * static_cast<std::uint32_t>(seed);
    const Program given = schedule(ChainMaker(n, seed, ChainMaker::Steps::varied).m.program);
    const Program rerolled = reroll(given);
    expect_same(given, rerolled, Values::but_for_rounding, random);
    // Angles stay known ahead of all sines.
    for (const Instruction& c : rerolled.code)
      if (c.op == Operation::sin || c.op == Operation::cos) {
        EXPECT_EQ(rerolled.code[c.a].op, Operation::sub);
      }
    EXPECT_GE(rerolled.loops.size(), 2u);
    EXPECT_GE(operations_in_loops(rerolled) * n, count(given).arithmetic() * (n - 9)) << n;
  }
}

TEST(Reroll, DotProductsStayBehindTheLoops) {
  std::mt19937_64 random(4);
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(test::rounds(10)); ++seed) {
    constexpr std::uint32_t n = 20;
    ChainMaker chain(n, seed);
    std::vector<std::uint32_t> M(std::size_t{n} * n);
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = i; j < n; ++j)
        M[i * n + j] = M[j * n + i] =
            append_dot_product(chain.m, chain.rows[i], chain.rows[j], i % 2 == 1, random);
    chain.m.program.outputs = {{"M", n, n, M}};
    const Program given = gather_dot_products(schedule(chain.m.program), 1);
    const Program rerolled = reroll(given);
    expect_same(given, rerolled, Values::but_for_rounding, random);
    EXPECT_FALSE(rerolled.loops.empty());
    EXPECT_EQ(dot_products(rerolled), dot_products(given));
    EXPECT_GT(dot_products(rerolled), n * n / 4u);
  }
}

/// The axes of frames that turn one after the other about z and x. No operation tells their components apart.
TEST(Reroll, SymmetricComponentsAreToldApartByTheRowsThatTheyAreIn) {
  constexpr std::uint32_t n = 20;
  std::mt19937_64 random(7);
  ProgramMaker m(n);
  using Axis = std::array<std::uint32_t, 3>;
  Axis x, y, z;
  for (Axis* axis : {&x, &y, &z})
    for (std::uint32_t& component : *axis)
      component = m.constant(std::uniform_real_distribution<>(-1, 1)(random));
  const auto turn = [&](Axis& a, Axis& b, std::uint32_t cosine, std::uint32_t sine) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t next = m.add(m.mul(cosine, a[k]), m.mul(sine, b[k]));
      b[k] = m.sub(m.mul(cosine, b[k]), m.mul(sine, a[k]));
      a[k] = next;
    }
  };
  std::vector<std::uint32_t> cosines, sines;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t angle = m.input(i);
    cosines.push_back(m.cos(angle));
    sines.push_back(m.sin(angle));
  }
  std::vector<Axis> axes;
  for (std::uint32_t i = 0; i < n; ++i) {
    turn(x, y, cosines[i], sines[i]);
    const double twist = std::uniform_real_distribution<>(-3, 3)(random);
    turn(y, z, m.constant(std::cos(twist)), m.constant(std::sin(twist)));
    axes.push_back(z);
  }
  std::vector<std::uint32_t> angles(std::size_t{n} * n);
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = i; j < n; ++j)
      angles[i * n + j] = angles[j * n + i] = append_dot_product(m, axes[i], axes[j], false, random);
  m.program.outputs = {{"angles", n, n, angles}};
  const Program given = gather_dot_products(schedule(m.program), 1);
  const Program rerolled = reroll(given);
  expect_same(given, rerolled, Values::but_for_rounding, random);
  constexpr std::size_t kStep = 4 * 9;
  EXPECT_GE(operations_in_loops(rerolled), kStep * (n - 6));
}

/// Velocities turned by one quaternion a step, to which a joint's three speeds are added. In a rotation
/// matrix, elements are twice a sum and twice the difference of the same two products.
TEST(Reroll, StepsMayHaveMoreCoordinatesThanSpeeds) {
  constexpr std::uint32_t n = 20, kCoordinates = 4, kSpeeds = 3;
  std::mt19937_64 random(8);
  ProgramMaker m(n * kCoordinates);
  for (std::uint32_t i = 0; i < n * kSpeeds; ++i)
    m.program.inputs.push_back({ArgumentKind::qd, i, fmt::format("v{}", i)});
  const auto twice = [&](std::uint32_t x) { return m.add(x, x); };
  std::array<std::uint32_t, kSpeeds> velocity;
  for (std::uint32_t& component : velocity)
    component = m.constant(std::uniform_real_distribution<>(-1, 1)(random));
  std::vector<std::uint32_t> velocities;
  for (std::uint32_t i = 0; i < n; ++i) {
    std::array<std::uint32_t, kCoordinates> q;
    for (std::uint32_t k = 0; k < kCoordinates; ++k) q[k] = m.input(i * kCoordinates + k);
    std::array<std::uint32_t, kSpeeds> next;
    std::array<std::uint32_t, 3> sums, differences;  // of axes k and k + 1
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t product = m.mul(q[k], q[(k + 1) % 3]), other = m.mul(q[(k + 2) % 3], q[3]);
      sums[k] = twice(m.add(product, other));
      differences[k] = twice(m.sub(product, other));
    }
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t l = (k + 1) % 3, o = (k + 2) % 3;
      const std::uint32_t off = m.add(m.mul(differences[k], velocity[l]), m.mul(sums[o], velocity[o]));
      const std::uint32_t on = m.mul(m.sub(m.mul(q[3], q[3]), m.mul(q[l], q[o])), velocity[k]);
      next[k] = m.add(m.add(on, off), m.input(n * kCoordinates + i * kSpeeds + k));
    }
    velocity = next;
    velocities.insert(velocities.end(), next.begin(), next.end());
  }
  const Program given = schedule(m.returning(velocities));
  const Program rerolled = reroll(given);
  expect_same(given, rerolled, Values::but_for_rounding, random);
  constexpr std::size_t kStep = 3 * 15;
  EXPECT_GE(operations_in_loops(rerolled), kStep * (n - 6));
}

TEST(Reroll, OtherProgramsKeepTheirValues) {
  std::mt19937_64 random(5);
  for (int k = 0; k < 40; ++k) {
    const Program given =
        schedule(optimized(random_program(600, k % 2 == 0 ? Mix::arithmetic : Mix::everything, random)));
    expect_same(given, reroll(given), Values::exactly, random);
  }
  EXPECT_TRUE(reroll(Program{}).code.empty());
}

TEST(Reroll, FewStepsStayStraight) {
  const Program given = schedule(ChainMaker(4, 1).m.program);
  EXPECT_EQ(dump(reroll(given)), dump(given));
}

}  // namespace
}  // namespace alembert
