// The Coriolis matrix by recursions: its laws, however far pairs come together and on every tree of motions that the
// equations are written from.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dynamics/random_trees.hpp"
#include "dynamics/recursions/coriolis_recursion.hpp"
#include "dynamics/recursions/mass_matrix.hpp"
#include "dynamics/recursions/reduced.hpp"
#include "dynamics/tree/symbols.hpp"
#include "oracles/random_mechanism.hpp"
#include "symbolic/substitute.hpp"

namespace alembert::test {
namespace {

constexpr FarPairs kWays[] = {FarPairs::carry, FarPairs::meet, FarPairs::meet_sooner};

/// dM/dt = C + C^T, and C u is the bias without gravity and forces, where time moves nothing.
void expect_laws(const LoadedMechanism& loaded, std::span<const FarPairs> ways, unsigned states) {
  const Kinematics kinematics = loaded.kinematics();
  const Mechanism& mechanism = *loaded.mechanism;
  const SpeedDerivatives& derivatives = kinematics.derivatives;
  const std::size_t nv = static_cast<std::size_t>(mechanism.nv);
  const std::vector<Expr> M = composite_mass_matrix(mechanism, kinematics.tree, *loaded.graph);
  const std::vector<Expr> rate = derivatives.first_rate(derivatives.partials(M), M.size());
  const std::vector<Expr> reference =
      recursive_coriolis_matrix(mechanism, kinematics.tree, derivatives, *loaded.graph, FarPairs::carry);
  std::vector<Expr> bias = bias_by_substitution(
      mechanism, reduced_inverse_dynamics(mechanism, kinematics.tree, *loaded.graph), *loaded.graph);
  const std::vector<Expr> gravity = gravity_forces(mechanism, kinematics.tree, *loaded.graph);
  const bool timed = std::ranges::any_of(kinematics.tree.nodes, [&](const MotionNode& node) {
    return !node.partials.empty() && node.partials.back().speed == mechanism.nv;
  });
  for (std::size_t i = 0; i < nv; ++i) bias[i] -= gravity[i];
  std::vector<std::pair<Expr, Expr>> no_wrench;
  for (const auto& [body, wrench] : wrench_symbols(mechanism, *loaded.graph))
    for (std::size_t i = 0; i < 6; ++i) no_wrench.emplace_back(wrench[i], loaded.graph->zero());
  bias = substitute(bias, no_wrench);
  unsigned finite = 0;
  for (unsigned seed = 1; seed <= states; ++seed) {
    const std::vector<double> rates = loaded.values(rate, seed), c = loaded.values(bias, seed);
    const std::vector<double> first = loaded.values(reference, seed);
    std::vector<Expr> speeds;
    for (std::size_t k = 0; k < nv; ++k) speeds.push_back(derivatives.speed(static_cast<int>(k)));
    const std::vector<double> u = loaded.values(speeds, seed);
    double size = 1;
    for (const double x : rates) size = std::max(size, std::abs(x));
    if (!std::isfinite(size)) continue;
    ++finite;
    for (const WrittenTree& tree : trees_of(loaded, kinematics)) {
      for (const FarPairs far : ways) {
        SCOPED_TRACE(static_cast<int>(far));
        const std::vector<double> C =
            loaded.values(recursive_coriolis_matrix(mechanism, tree, derivatives, *loaded.graph, far), seed);
        for (std::size_t i = 0; i < nv; ++i) {
          double moved = 0;
          for (std::size_t j = 0; j < nv; ++j) {
            EXPECT_NEAR(C[i * nv + j] + C[j * nv + i], rates[i * nv + j], 1e-10 * size);
            EXPECT_NEAR(C[i * nv + j], first[i * nv + j], 1e-10 * size);
            moved += C[i * nv + j] * u[j];
          }
          if (!timed) {
            EXPECT_NEAR(moved, c[i], 1e-9 * size) << "row " << i;
          }
        }
      }
    }
  }
  EXPECT_GE(finite, 1U);
}

class RandomCoriolisMatrix : public testing::TestWithParam<unsigned> {};

TEST_P(RandomCoriolisMatrix, ObeysItsLaws) {
  const std::string text = oracles::random_mechanism(GetParam());
  SCOPED_TRACE(text);
  expect_laws(LoadedMechanism::text(text), kWays, 2);
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomCoriolisMatrix, testing::Range(201u, 207u));

class CoriolisMatrixOf : public testing::TestWithParam<TreeShape> {};

TEST_P(CoriolisMatrixOf, ObeysItsLaws) {
  const auto& [name, bodies, reach, revolute] = GetParam();
  const LoadedMechanism loaded = LoadedMechanism::text(TreeWriter(11).description(bodies, reach, revolute));
  expect_laws(loaded, std::span(kWays).subspan(1, 1), 1);
}
std::vector<TreeShape> small_trees() {
  std::vector<TreeShape> small = kTreeShapes;
  std::erase_if(small, [](const TreeShape& shape) { return shape.bodies > 12; });
  return small;
}
INSTANTIATE_TEST_SUITE_P(Random, CoriolisMatrixOf, testing::ValuesIn(small_trees()),
                         [](const auto& shape) { return shape.param.name; });

}  // namespace
}  // namespace alembert::test
