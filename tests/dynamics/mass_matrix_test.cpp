// M of long chains and large trees: momenta that meet twists in common frames give what momenta give that
// are carried from joint to joint, and take fewer operations.
#include "dynamics/recursions/mass_matrix.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/random_trees.hpp"
#include "dynamics/recursions/meeting_frames.hpp"
#include "symbolic/count_operations.hpp"
#include "symbolic/value_number.hpp"

namespace alembert::test {
namespace {

class FarPairsOf : public testing::TestWithParam<TreeShape> {};

std::size_t operations(const std::vector<Expr>& M) {
  return count_operations(value_number(M)).total();
}

/// To 1e-11 of the largest entry.
TEST_P(FarPairsOf, MeetAsTheyAreCarried) {
  const TreeShape& shape = GetParam();
  int fewer = 0;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const LoadedMechanism loaded =
        LoadedMechanism::text(TreeWriter(seed).description(shape.bodies, shape.reach, shape.revolute));
    const Kinematics kinematics = loaded.kinematics();
    std::size_t least_met = ~std::size_t{0}, least_carried = ~std::size_t{0};
    for (const WrittenTree& tree : trees_of(loaded, kinematics)) {
      const std::vector<Expr> carried =
          composite_mass_matrix(*loaded.mechanism, tree, *loaded.graph, FarPairs::carry);
      const FarPairs far = seed % 2 == 0 ? FarPairs::meet_sooner : FarPairs::meet;
      const std::vector<Expr> met = composite_mass_matrix(*loaded.mechanism, tree, *loaded.graph, far);
      least_carried = std::min(least_carried, operations(carried));
      least_met = std::min(least_met, operations(met));
      for (unsigned state = 1; state <= 2; ++state) {
        const std::vector<double> a = loaded.values(met, state), b = loaded.values(carried, state);
        double largest = 0;
        for (const double x : b) largest = std::max(largest, std::abs(x));
        ASSERT_TRUE(std::isfinite(largest) && largest > 0);
        for (std::size_t i = 0; i < b.size(); ++i) ASSERT_NEAR(a[i], b[i], 1e-11 * largest) << "entry " << i;
      }
    }
    if (least_met < least_carried) ++fewer;
  }
  EXPECT_GE(fewer, 2) << "so that something was compared";
}
INSTANTIATE_TEST_SUITE_P(Random, FarPairsOf, testing::ValuesIn(kTreeShapes),
                         [](const auto& shape) { return shape.param.name; });

/// A generic chain: pairs that are carried take some 30 operations each, those that meet 11.
TEST(MeetingFrames, TakeElevenOperationsAPair) {
  const auto operations_of_chain = [](int n, FarPairs far) {
    const LoadedMechanism loaded = LoadedMechanism::text(TreeWriter(1).description(n, 1, true));
    const Kinematics kinematics = loaded.kinematics();
    const RigidLinks links(*loaded.mechanism, kinematics.tree, *loaded.graph);
    const WrittenTree tree = links.link_tree(minimal_regroupings(links), *loaded.graph);
    return static_cast<double>(
        operations(composite_mass_matrix(*loaded.mechanism, tree, *loaded.graph, far)));
  };
  const auto a_pair = [&](FarPairs far) {  // the second difference
    const double few = operations_of_chain(30, far), more = operations_of_chain(40, far);
    return (operations_of_chain(50, far) - 2 * more + few) / 100;
  };
  EXPECT_LE(a_pair(FarPairs::meet), 11.1);
  EXPECT_GT(a_pair(FarPairs::carry), 28);
}

}  // namespace
}  // namespace alembert::test
