// Every clause of the counting convention, each on a program made for it.
#include <gtest/gtest.h>

#include "program/dump.hpp"
#include "program/program_maker.hpp"

namespace alembert {
namespace {

struct Expected {
  std::size_t mul = 0, add = 0, div = 0, trig = 0, other = 0;
};
void expect_count(const Program& program, Expected e) {
  const OperationCount n = count(program);
  EXPECT_EQ(n.mul, e.mul) << dump(program);
  EXPECT_EQ(n.add, e.add) << dump(program);
  EXPECT_EQ(n.div, e.div) << dump(program);
  EXPECT_EQ(n.trig, e.trig) << dump(program);
  EXPECT_EQ(n.other, e.other) << dump(program);
}

TEST(Count, SubtractionsAreAddsAndNegationIsFree) {
  ProgramMaker m(2);
  const auto x = m.input(0), y = m.input(1);
  const auto d = m.sub(x, y);
  const auto n = m.neg(d);
  expect_count(m.returning({m.add(n, x)}), {.add = 2});
}

TEST(Count, MultiplicationByPlusOrMinusOneIsFree) {
  ProgramMaker m(1);
  const auto x = m.input(0), one = m.constant(1), minus = m.constant(-1), three = m.constant(3);
  const auto a = m.mul(one, x);
  const auto b = m.mul(a, minus);
  expect_count(m.returning({m.mul(three, b)}), {.mul = 1});
}

TEST(Count, TwiceAValueIsOneAdd) {
  ProgramMaker m(1);
  const auto x = m.input(0), two = m.constant(2);
  const auto a = m.add(x, x);
  expect_count(m.returning({m.mul(two, a)}), {.add = 2});
}

TEST(Count, DivisionsAndOtherFunctionsStandApart) {
  ProgramMaker m(2);
  const auto x = m.input(0), y = m.input(1);
  std::vector<std::uint32_t> out{m.div(x, y), m.sin(x), m.cos(x), m.append(Operation::tan, y)};
  for (const Operation op :
       {Operation::sqrt, Operation::asin, Operation::acos, Operation::atan, Operation::exp, Operation::log,
        Operation::abs, Operation::sign, Operation::sinh, Operation::cosh, Operation::tanh})
    out.push_back(m.append(op, x));
  out.push_back(m.append(Operation::atan2, x, y));
  out.push_back(m.append(Operation::pow, x, y));
  expect_count(m.returning(out), {.div = 1, .trig = 3, .other = 13});
}

TEST(Count, WeighsByTheTableOfOperations) {
  ProgramMaker m(2);
  const auto x = m.input(0), y = m.input(1), two = m.constant(2), one = m.constant(1);
  const Program program =
      m.returning({m.div(x, y), m.sin(x), m.mul(two, x), m.mul(one, y), m.neg(m.sub(x, y))});
  EXPECT_EQ(count(program).weight, facts(Operation::div).weight + facts(Operation::sin).weight + 2);
}

TEST(Count, AConstantOffsetInsideAnAngleBelongsToTheCall) {
  for (const Operation op : {Operation::add, Operation::sub}) {
    ProgramMaker m(1);
    const auto x = m.input(0), c = m.constant(0.5);
    const auto angle = m.append(op, x, c);
    expect_count(m.returning({m.sin(angle), m.cos(angle), m.append(Operation::tan, angle)}), {.trig = 3});
  }
  ProgramMaker m(1);
  const auto x = m.input(0), c = m.constant(0.5);
  expect_count(m.returning({m.sin(m.sub(c, x))}), {.trig = 1});
}

TEST(Count, AnOffsetThatIsAlsoNeededElsewhereIsAnAdd) {
  ProgramMaker m(1);
  const auto x = m.input(0), c = m.constant(0.5);
  const auto angle = m.add(x, c);
  const auto s = m.sin(angle);
  expect_count(m.returning({s, m.mul(angle, s)}), {.mul = 1, .add = 1, .trig = 1});
  expect_count(m.returning({s, angle}), {.mul = 1, .add = 1, .trig = 1});
}

TEST(Count, ASumOfVariablesInsideAnAngleIsAnAdd) {
  ProgramMaker m(2);
  const auto x = m.input(0), y = m.input(1), c = m.constant(0.5);
  const auto sum = m.add(x, y);
  expect_count(m.returning({m.sin(m.add(sum, c))}), {.add = 1, .trig = 1});
  expect_count(m.returning({m.append(Operation::exp, m.add(x, c))}), {.add = 2, .trig = 1, .other = 1});
}

TEST(Count, WhatConstantsAloneDecideIsFolded) {
  ProgramMaker m(1);
  const auto x = m.input(0), c = m.constant(0.5), d = m.constant(0.25);
  const auto folded = m.sin(m.mul(m.add(c, d), m.div(c, d)));
  expect_count(m.returning({m.mul(folded, x)}), {.mul = 1});
}

}  // namespace
}  // namespace alembert
