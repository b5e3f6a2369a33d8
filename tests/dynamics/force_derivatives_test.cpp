// Derivatives of forces by recursions: those by complex steps, however far pairs come together and on every
// tree of motions that the equations are written from.
#include <gtest/gtest.h>

#include "dynamics/by_complex_steps.hpp"
#include "dynamics/random_trees.hpp"
#include "dynamics/recursions/derivative_recursion.hpp"
#include "dynamics/recursions/meeting_frames.hpp"
#include "dynamics/recursions/reduced.hpp"
#include "oracles/random_mechanism.hpp"
#include "symbolic/value_number.hpp"

namespace alembert::test {
namespace {

constexpr FarPairs kFarPairs[] = {FarPairs::carry, FarPairs::meet, FarPairs::meet_sooner};

void expect_recursions(const LoadedMechanism& loaded, std::span<const FarPairs> far_pairs, unsigned states) {
  const Kinematics kinematics = loaded.kinematics();
  const std::vector<Expr> Q = reduced_inverse_dynamics(*loaded.mechanism, kinematics.tree, *loaded.graph);
  for (const WrittenTree& tree : trees_of(loaded, kinematics)) {
    for (const FarPairs far : far_pairs) {
      SCOPED_TRACE(static_cast<int>(far));
      const std::vector<Expr> found =
          recursive_force_derivatives(*loaded.mechanism, tree, kinematics.derivatives, *loaded.graph, far);
      EXPECT_GE(expect_force_derivatives(loaded, kinematics.derivatives, Q, found, states), 1U);
    }
  }
}

class RandomForceDerivatives : public testing::TestWithParam<unsigned> {};

TEST_P(RandomForceDerivatives, AreThoseByComplexSteps) {
  const std::string text = oracles::random_mechanism(GetParam());
  SCOPED_TRACE(text);
  expect_recursions(LoadedMechanism::text(text), kFarPairs, 3);
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomForceDerivatives, testing::Range(101u, 116u));

class ForceDerivativesOf : public testing::TestWithParam<TreeShape> {};

TEST_P(ForceDerivativesOf, AreThoseByComplexSteps) {
  const auto& [name, bodies, reach, revolute] = GetParam();
  const LoadedMechanism loaded = LoadedMechanism::text(TreeWriter(7).description(bodies, reach, revolute));
  expect_recursions(loaded, std::span(kFarPairs).subspan(1, 1), 1);
}
INSTANTIATE_TEST_SUITE_P(Random, ForceDerivativesOf, testing::ValuesIn(kTreeShapes),
                         [](const auto& shape) { return shape.param.name; });

/// A generic chain: a far pair of joints has four entries, for which it takes two dot products of six and two
/// of nine.
TEST(ForceDerivatives, TakeFiftySixOperationsAPair) {
  const auto operations_of_chain = [](int n) {
    const LoadedMechanism loaded = LoadedMechanism::text(TreeWriter(1).description(n, 1, true));
    const Kinematics kinematics = loaded.kinematics();
    const std::vector<Expr> values =
        value_number(recursive_force_derivatives(*loaded.mechanism, trees_of(loaded, kinematics)[1],
                                                 kinematics.derivatives, *loaded.graph, FarPairs::meet));
    return static_cast<double>(kinematics.lengths.of(values).second);
  };
  const double second_difference =
      operations_of_chain(40) - 2 * operations_of_chain(30) + operations_of_chain(20);
  EXPECT_LE(second_difference / 100, 56.5);
}

}  // namespace
}  // namespace alembert::test
