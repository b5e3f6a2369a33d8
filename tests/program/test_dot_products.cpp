// Results that are dot products of the same rows are found, whatever the order of their terms.
#include <gtest/gtest.h>

#include "program/dump.hpp"
#include "program/loops/dot_products.hpp"
#include "program/optimized.hpp"
#include "program/program_maker.hpp"
#include "program/schedule.hpp"

namespace alembert {
namespace {

/// How the results of a table of dot products are arranged.
enum class Places {
  symmetric,    ///< of rows i <= j, at (i, j) and (j, i)
  rectangular,  ///< of all rows, at (i, j)
  with_single,  ///< so too, and the last entries of the left rows are one
};

struct Table {
  Program program;
  std::size_t products;
};

/// Dot products of `size` rows and as many others of `terms` values.
Table table(std::uint32_t size, std::size_t terms, Places places, std::mt19937_64& random) {
  ProgramMaker m(5);
  std::vector<std::uint32_t> values;
  for (std::uint32_t i = 0; i < 5; ++i) values.push_back(m.input(i));
  while (values.size() < 2000) {
    const std::uint32_t a = values[random() % values.size()], b = values[random() % values.size()];
    values.push_back(m.sin(random() % 2 == 0 ? m.add(a, b) : m.mul(a, b)));
  }
  const auto row = [&] {
    std::vector<std::uint32_t> entries;
    for (std::size_t k = 0; k < terms; ++k) entries.push_back(values[random() % values.size()]);
    return entries;
  };
  std::vector<std::vector<std::uint32_t>> left, right;
  for (std::uint32_t i = 0; i < size; ++i) {
    left.push_back(row());
    right.push_back(row());
  }
  left[1][0] = left[0][0];  // as one component of neighbours is the same at times
  std::vector<std::uint32_t> results(std::size_t{size} * size);
  std::size_t products = 0;
  for (std::uint32_t i = 0; i < size; ++i)
    for (std::uint32_t j = places == Places::symmetric ? i : 0; j < size; ++j) {
      const bool single = places == Places::with_single;
      const std::span a(left[i]), b(right[j]);
      std::uint32_t sum = append_dot_product(m, a.first(terms - (single ? 1 : 0)),
                                             b.first(terms - (single ? 1 : 0)), i % 3 == 1, random);
      if (single) sum = i % 3 == 1 ? m.sub(sum, b.back()) : m.add(b.back(), sum);
      results[i * size + j] = sum;
      if (places == Places::symmetric) results[j * size + i] = sum;
      ++products;
    }
  return {m.returning(results), products};
}

/// Same operations, and the same values but for rounding.
void expect_equivalent(const Program& given, const Program& gathered, std::mt19937_64& random) {
  EXPECT_TRUE(is_ordered(gathered));
  const OperationCount before = count(given), after = count(gathered);
  EXPECT_EQ(before.mul, after.mul);
  EXPECT_EQ(before.add, after.add);
  for (int point = 0; point < 5; ++point)
    EXPECT_TRUE(same_but_for_rounding(given, gathered, random_point(given.inputs.size(), random)));
}

/// 1 or -1 if a value is that constant, otherwise 0.
int unit_of(const Program& program, std::uint32_t v) {
  if (program.code[v].op != Operation::constant) return 0;
  const double value = program.constants[program.code[v].a];
  return value == 1 ? 1 : value == -1 ? -1 : 0;
}

/// Every run's results are the dot products of its rows, and the last instructions are theirs.
void expect_sound(const Program& program) {
  const std::size_t straight = program.code.size() - program.dot_product_code;
  std::size_t instructions = 0;
  for (const DotProducts& products : program.dot_products) {
    for (const std::vector<std::uint32_t>* rows : {&products.left, &products.right})
      for (const std::uint32_t v : *rows) EXPECT_LT(v, straight);
    for (const DotProducts::Run& run : products.runs)
      for (std::uint32_t i = 0; i < run.count; ++i) {
        const std::vector<std::uint32_t>& results = program.outputs.at(products.output).values;
        std::uint32_t v = results.at(run.first + i * run.stride);
        EXPECT_EQ(v, results.at(run.mirror + i * run.step));
        for (std::uint32_t k = products.terms; k-- > 0;) {
          const Instruction sum = program.code[v];
          const std::uint32_t a = products.left.at(run.left * products.terms + k),
                              b = products.right.at((run.right + i) * products.terms + k);
          // Nothing is multiplied by one, and what is multiplied by minus one is subtracted.
          if (const int unit = k == 0 ? 0 : unit_of(program, a) + unit_of(program, b); unit != 0) {
            EXPECT_EQ(sum.op, unit > 0 ? Operation::add : Operation::sub);
            EXPECT_EQ(sum.b, unit_of(program, a) != 0 ? b : a);
            --instructions;
          } else {
            const Instruction product = k == 0 ? sum : program.code[sum.b];
            EXPECT_EQ(product.op, Operation::mul);
            EXPECT_EQ(product.a, a);
            EXPECT_EQ(product.b, b);
            EXPECT_EQ(sum.op, k == 0 ? Operation::mul : Operation::add);
          }
          v = sum.a;
        }
        instructions += 2 * products.terms - 1;
      }
  }
  EXPECT_EQ(instructions, program.dot_product_code);
}

TEST(DotProducts, AllOfATableAreFound) {
  std::mt19937_64 random(11);
  for (const Places places : {Places::symmetric, Places::rectangular, Places::with_single})
    for (const std::size_t terms : {3u, 6u, 9u}) {
      const auto [program, products] = table(24, terms, places, random);
      const Program scheduled = schedule(program), gathered = gather_dot_products(scheduled, 1);
      expect_equivalent(scheduled, gathered, random);
      expect_sound(gathered);
      // But for the last rows of a triangle, which are too short for loops, and where rows have values in
      // common.
      EXPECT_GE(20 * (dot_products(gathered) + 6), 19 * products);
      EXPECT_EQ(dump(gathered), dump(gather_dot_products(scheduled, 1)));
      // In their former order they are where their rows are known.
      EXPECT_TRUE(schedule(gathered).dot_products.empty());
      EXPECT_TRUE(same_outputs(schedule(gathered), gathered, random_point(5, random)));
    }
}

TEST(DotProducts, FewerThanTheLeastStayWhereTheyAre) {
  std::mt19937_64 random(12);
  const Program scheduled = schedule(table(10, 6, Places::symmetric, random).program);
  const std::size_t found = dot_products(gather_dot_products(scheduled, 1));
  EXPECT_GT(found, 40u);
  EXPECT_EQ(dot_products(gather_dot_products(scheduled, found)), found);
  EXPECT_EQ(dump(gather_dot_products(scheduled, found + 1)), dump(scheduled));
}

TEST(DotProducts, WhatElseIsNeededStays) {
  std::mt19937_64 random(13);
  ProgramMaker m(0);
  m.program = table(12, 4, Places::rectangular, random).program;
  // One sum has a further use, and a product of another; one result is more than a sum.
  const std::vector<std::uint32_t> results = m.program.outputs[0].values;
  std::uint32_t product = results[40];
  while (m.program.code[product].op != Operation::mul) product = m.program.code[product].a;
  const std::uint32_t further = m.add(m.add(results[5], results[5]), m.cos(product));
  m.program.outputs[0].values[20] = m.sin(results[20]);
  m.program.outputs.push_back({"further", 1, 1, {further}});
  const Program scheduled = schedule(m.program), gathered = gather_dot_products(scheduled, 1);
  expect_equivalent(scheduled, gathered, random);
  expect_sound(gathered);
  EXPECT_LT(dot_products(gathered), 142u);
  for (const std::uint32_t place : {5u, 20u, 40u})
    EXPECT_LT(gathered.outputs[0].values[place], gathered.code.size() - gathered.dot_product_code);
  EXPECT_GT(dot_products(gathered), 120u);
}

TEST(DotProducts, RandomProgramsKeepTheirValues) {
  std::mt19937_64 random(14);
  for (int k = 0; k < 60; ++k) {
    const Program given =
        schedule(optimized(random_program(600, k % 2 == 0 ? Mix::arithmetic : Mix::everything, random)));
    const Program gathered = gather_dot_products(given, 1);
    expect_equivalent(given, gathered, random);
    expect_sound(gathered);
  }
}

}  // namespace
}  // namespace alembert
