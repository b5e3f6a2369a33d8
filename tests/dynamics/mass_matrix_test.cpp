// M of long chains and large trees: momenta that meet twists in common frames give what momenta give that
// are carried from joint to joint, and take fewer operations.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "dynamics/formulations.hpp"
#include "dynamics/mechanism_file.hpp"
#include "dynamics/meeting_frames.hpp"
#include "dynamics/rigid_links.hpp"
#include "dynamics/scaled_vectors.hpp"

namespace alembert::test {
namespace {

/// Writes random trees: joints of every kind, cores with two speeds, coordinates shared between bodies,
/// prescribed motions.
class Writer {
 public:
  explicit Writer(unsigned seed) : random_(seed) {}

  /// `reach`: a body's parent is one of so many before it; 1: a chain. `revolute`: no other joints.
  std::string description(int bodies, int reach, bool revolute) {
    std::string text;
    for (int i = 0; i < bodies; ++i) {
      text += fmt::format("  - name: b{}\n", i);
      if (i > 0) text += fmt::format("    parent: b{}\n", std::max(0, i - 1 - below(reach)));
      text += fmt::format("    transform:\n      - translate: [{}, {}, {}]\n", length(), length(), length());
      text += fmt::format("      - rotate: {{axis: {}, angle: {:.2f}}}\n", axis(), uniform(-2, 2));
      text += "      - " + (revolute ? revolute_joint() : joint()) + "\n";
      text += fmt::format("    mass: {:.2f}\n    com: [{}, {}, {}]\n", uniform(1, 4), length(), length(),
                          length());
      text += fmt::format(
          "    inertia: {{xx: {:.3f}, yy: {:.3f}, zz: {:.3f}, xy: {:.4f}, xz: {:.4f}, yz: {:.4f}}}\n",
          uniform(0.2, 0.3), uniform(0.2, 0.3), uniform(0.2, 0.3), uniform(-0.03, 0.03), uniform(-0.03, 0.03),
          uniform(-0.03, 0.03));
    }
    std::string names;
    for (const std::string& name : coordinates_) names += "  - " + name + "\n";
    return "alembert: 1\nname: random\ncoordinates:\n" + names + "bodies:\n" + text;
  }

 private:
  std::string revolute_joint() {
    return fmt::format("joint: {{type: revolute, axis: {}, coordinates: [{}]}}", axis(), coordinate());
  }
  std::string joint() {
    switch (below(9)) {
      case 0:
        return fmt::format("joint: {{type: prismatic, axis: {}, coordinates: [{}]}}", axis(), coordinate());
      case 1:
        return fmt::format("joint: {{type: helical, axis: {}, pitch: 0.03, coordinates: [{}]}}", axis(),
                           coordinate());
      case 2:
        coordinates_.push_back(fmt::format("{{name: r{}, type: quaternion}}", coordinates_.size()));
        return fmt::format("joint: {{type: spherical, coordinates: [r{}]}}", coordinates_.size() - 1);
      case 3: {
        const std::string u = coordinate(), v = coordinate();
        return fmt::format(
            "surface: {{point: [(0.5 + 0.2*cos({1}))*cos({0}), (0.5 + 0.3*cos({1}))*sin({0}), "
            "0.2*sin({1})], along: [{0}, {1}]}}",
            u, v);
      }
      case 4: {  // one that others have too
        const std::string q = coordinate();
        shared_ = shared_.empty() ? q : shared_;
        return fmt::format("rotate: {{axis: {}, angle: \"{} + 0.5*{}^2\"}}", axis(), q, shared_);
      }
      case 5:
        return fmt::format("translate: [\"0.3*sin({0})\", \"0.2*{0}\", 0.1]", coordinate());
      case 6:
        return fmt::format("rotate: {{axis: z, angle: \"{} + 0.2*t\"}}", coordinate());
      default:
        return revolute_joint();
    }
  }
  std::string coordinate() {
    coordinates_.push_back(fmt::format("q{}", coordinates_.size()));
    return coordinates_.back();
  }
  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }
  double uniform(double from, double to) {
    return from + (to - from) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  std::string length() { return fmt::format("{:.3f}", uniform(-0.5, 0.5)); }
  std::string axis() {
    if (below(2) == 0) return std::array{"x", "y", "z"}[static_cast<std::size_t>(below(3))];
    const double x = uniform(-1, 1), y = uniform(-1, 1);
    return fmt::format("[{:.1f}, {:.1f}, {:.1f}]", x, y, uniform(0.1, 1));
  }

  std::mt19937_64 random_;
  std::vector<std::string> coordinates_;
  std::string shared_;
};

struct Shape {
  const char* name;
  int bodies, reach;
  bool revolute;
};

class FarPairsOf : public testing::TestWithParam<Shape> {
 protected:
  /// All trees of motions that the equations are written from.
  static std::vector<MotionTree> trees_of(const LoadedMechanism& loaded, const Kinematics& kinematics) {
    std::vector<MotionTree> trees{kinematics.tree};
    if (kinematics.peeled) trees.push_back(*kinematics.peeled);
    const MotionTree given = trees.back();
    const RigidLinks links(*loaded.mechanism, given, *loaded.graph);
    trees.push_back(links.link_tree(minimal_regroupings(links), *loaded.graph));
    trees.push_back(trees.back());
    mark_scaled(trees.back(), scalable_turns(trees.back()));
    return trees;
  }
};

std::size_t operations(const std::vector<Expr>& M) {
  return count_operations(value_number(M)).total();
}

/// To 1e-11 of the largest entry.
TEST_P(FarPairsOf, MeetAsTheyAreCarried) {
  const Shape& shape = GetParam();
  int fewer = 0;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const LoadedMechanism loaded =
        LoadedMechanism::text(Writer(seed).description(shape.bodies, shape.reach, shape.revolute));
    const Kinematics kinematics = loaded.kinematics();
    std::size_t least_met = ~std::size_t{0}, least_carried = ~std::size_t{0};
    for (const MotionTree& tree : trees_of(loaded, kinematics)) {
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
INSTANTIATE_TEST_SUITE_P(Random, FarPairsOf,
                         testing::Values(Shape{"chain_of_8", 8, 1, true}, Shape{"chain_of_16", 16, 1, false},
                                         Shape{"chain_of_48", 48, 1, true},
                                         Shape{"chain_of_30_of_every_kind", 30, 1, false},
                                         Shape{"tree_of_12", 12, 3, false}, Shape{"tree_of_40", 40, 3, true},
                                         Shape{"tree_of_30_of_every_kind", 30, 4, false}),
                         [](const auto& shape) { return shape.param.name; });

/// A generic chain: pairs that are carried take some 30 operations each, those that meet 11.
TEST(MeetingFrames, TakeElevenOperationsAPair) {
  const auto operations_of_chain = [](int n, FarPairs far) {
    const LoadedMechanism loaded = LoadedMechanism::text(Writer(1).description(n, 1, true));
    const Kinematics kinematics = loaded.kinematics();
    const RigidLinks links(*loaded.mechanism, kinematics.tree, *loaded.graph);
    const MotionTree tree = links.link_tree(minimal_regroupings(links), *loaded.graph);
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
