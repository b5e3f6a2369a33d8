// Scaled components of vectors: the same dynamics on trees where a scale meets more than the turn it is for.
#include "dynamics/rewrites/scaled_vectors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dynamics/mechanism_file.hpp"
#include "dynamics/recursions/mass_matrix.hpp"
#include "dynamics/recursions/meeting_frames.hpp"
#include "dynamics/recursions/reduced.hpp"

namespace alembert::test {
namespace {

// A joint is scaled for the turn of the first branch. From the same frame a ball joint, an axis that is
// scaled alike, and a slider lead on.
constexpr const char* kBranches = R"(alembert: 1
name: branches
gravity: [0.3, -0.4, -9.8]
coordinates: [a, b, c, d, e, {name: ball, type: quaternion}, s]
bodies:
  - name: base
    transform: [rotate: {axis: y, angle: a}, translate: [0.1, 0.2, 0.3], rotate: {axis: x, angle: 0.4}]
    mass: 1.5
    com: [0.1, 0.03, -0.02]
    inertia: {xx: 0.3, yy: 0.2, zz: 0.25, xy: 0.01, xz: 0.02, yz: -0.03}
  - name: hub
    parent: base
    transform: [rotate: {axis: z, angle: b}]
    mass: 1.1
    com: [0.05, -0.04, 0.02]
    inertia: {xx: 0.11, yy: 0.12, zz: 0.15, xy: 0.01, xz: -0.02, yz: 0.02}
  - name: twisted
    parent: hub
    transform: [rotate: {axis: x, angle: 0.7}, translate: [0.3, 0, 0.1], rotate: {axis: z, angle: c}]
    mass: 0.8
    com: [0.1, 0.02, 0.03]
    inertia: {xx: 0.03, yy: 0.02, zz: 0.04, xy: 0.001, xz: 0.002, yz: -0.003}
  - name: alike
    parent: hub
    transform: [rotate: {axis: z, angle: d}]
    mass: 0.7
    com: [0.2, 0.1, 0.03]
    inertia: {xx: 0.02, yy: 0.03, zz: 0.04, xy: 0.002, xz: 0.001, yz: -0.002}
  - name: alike_tip
    parent: alike
    transform: [rotate: {axis: x, angle: 0.7}, rotate: {axis: z, angle: e}]
    mass: 0.6
    com: [0.1, 0.1, 0.1]
    inertia: {xx: 0.02, yy: 0.01, zz: 0.02}
  - name: ball
    parent: hub
    transform: [rotate: {quaternion: ball}]
    mass: 0.5
    com: [0.1, 0.2, -0.1]
    inertia: {xx: 0.02, yy: 0.01, zz: 0.025}
  - name: slider
    parent: hub
    transform: [translate: [s, 0.1, 0.2], rotate: {axis: y, angle: -0.5}]
    mass: 0.4
    com: [0.1, -0.2, 0.1]
    inertia: {xx: 0.02, yy: 0.01, zz: 0.015}
)";

TEST(ScaledVectors, GiveTheSameDynamicsWhereBranchesShareAJoint) {
  const LoadedMechanism loaded = LoadedMechanism::text(kBranches);
  const Kinematics kinematics = loaded.kinematics();
  WrittenTree tree = kinematics.tree;
  const auto dynamics = [&] {
    std::vector<Expr> values = reduced_inverse_dynamics(*loaded.mechanism, tree, *loaded.graph);
    const std::vector<Expr> M =
        composite_mass_matrix(*loaded.mechanism, tree, *loaded.graph, FarPairs::carry);
    values.insert(values.end(), M.begin(), M.end());
    return values;
  };
  const std::vector<Expr> given = dynamics();
  const std::vector<int> turns = scalable_turns(tree.tree);
  tree.scaling = Scaling(tree.tree, turns, turns);
  int scaled_for_a_turn = 0;
  for (std::size_t i = 0; i < tree.tree.nodes.size(); ++i) scaled_for_a_turn += tree.scaling.scales_ahead(i);
  EXPECT_EQ(scaled_for_a_turn, 2);
  const std::vector<Expr> scaled = dynamics();
  ASSERT_EQ(scaled.size(), given.size());
  for (unsigned seed = 0; seed < 8; ++seed) {
    const std::vector<double> x = loaded.values(given, seed), y = loaded.values(scaled, seed);
    for (std::size_t i = 0; i < x.size(); ++i)
      EXPECT_NEAR(x[i], y[i], 1e-12 * std::max(1.0, std::abs(x[i]))) << i;
  }
}

}  // namespace
}  // namespace alembert::test
