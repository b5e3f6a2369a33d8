// Compiled for AVX, where rows of dot products are taken two by two: bit for bit what the program says.
#include <gtest/gtest.h>

#include <chain/chain.hpp>
#include <cstdint>
#include <string>

#include "emit/interpreted_states.hpp"
#include "mechanism/load.hpp"
#include "mechanism/source.hpp"
#include "pipeline.hpp"
#include "program/loops/dot_products.hpp"

namespace {

TEST(LongVectors, RowsTwoByTwoAreTheSameNumbers) {
  if (!__builtin_cpu_supports("avx")) GTEST_SKIP() << "this processor has no AVX";
  using Model = avx::chain::Mechanism<>;
  alembert::CompileOptions options;
  options.loop_results = 6;
  options.functions = {alembert::FunctionKind("mass_matrix")};
  const alembert::CompiledMechanism compiled = alembert::compile_mechanism(
      alembert::read_source(std::string(ALEMBERT_SOURCE_DIR) + "/tests/emit/chain.yaml"), options);
  const alembert::Program& program = compiled.functions.at(0).program;
  ASSERT_GT(alembert::dot_products(program), 60u);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto s = sample::random_state<Model>(seed);
    const Model::SpeedMatrix M = Model::mass_matrix(s.q, s.in);
    sample::expect_same_bits({M.data(), static_cast<std::size_t>(M.size())}, sample::interpreted(program, s),
                             "mass_matrix");
  }
}

}  // namespace
