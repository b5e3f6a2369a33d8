// Compiled for AVX, where rows of dot products are taken two by two: bit for bit what the program says.
#include <gtest/gtest.h>

#include <bit>
#include <chain/chain.hpp>
#include <cstdint>
#include <random>
#include <vector>

#include "mechanism/load.hpp"
#include "pipeline.hpp"
#include "program/passes.hpp"

namespace {

TEST(LongVectors, RowsTwoByTwoAreTheSameNumbers) {
  if (!__builtin_cpu_supports("avx")) GTEST_SKIP() << "this processor has no AVX";
  using Model = avx::chain::Mechanism<>;
  alembert::CompileOptions options;
  options.loop_results = 6;
  options.functions = {alembert::FunctionKind::mass_matrix};
  const alembert::CompiledMechanism compiled = alembert::compile_mechanism(
      alembert::read_source(std::string(ALEMBERT_SOURCE_DIR) + "/tests/emit/chain.yaml"), options);
  const alembert::Program& program = compiled.functions.at(0).program;
  ASSERT_GT(alembert::dot_products(program), 60u);
  std::mt19937_64 random(1);
  for (int state = 0; state < 20; ++state) {
    Model::CoordinateVector q;
    for (double& x : q) x = std::uniform_real_distribution(-3.0, 3.0)(random);
    const Model::SpeedMatrix M = Model::mass_matrix(q);
    std::vector<double> inputs, expected(static_cast<std::size_t>(M.size())), scratch;
    for (const alembert::InputSlot& slot : program.inputs)
      inputs.push_back(q(static_cast<Eigen::Index>(slot.index)));
    alembert::interpret(program, inputs, expected, scratch);
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_EQ(std::bit_cast<std::uint64_t>(M.data()[i]), std::bit_cast<std::uint64_t>(expected[i])) << i;
  }
}

}  // namespace
