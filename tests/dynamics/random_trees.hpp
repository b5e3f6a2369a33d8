// Random trees of up to dozens of bodies, and the trees of motions that equations are written from.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "dynamics/choice/regrouping.hpp"
#include "dynamics/mechanism_file.hpp"
#include "dynamics/rewrites/rigid_links.hpp"
#include "dynamics/rewrites/written_tree.hpp"

namespace alembert::test {

/// Writes random trees: joints of every kind, cores with two speeds, coordinates shared between bodies,
/// prescribed motions.
class TreeWriter {
 public:
  explicit TreeWriter(unsigned seed) : random_(seed) {}

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

/// What a TreeWriter is to write.
struct TreeShape {
  const char* name;
  int bodies, reach;
  bool revolute;
};

inline const std::vector<TreeShape> kTreeShapes{{"chain_of_8", 8, 1, true},
                                                {"chain_of_16", 16, 1, false},
                                                {"chain_of_48", 48, 1, true},
                                                {"chain_of_30_of_every_kind", 30, 1, false},
                                                {"tree_of_12", 12, 3, false},
                                                {"tree_of_40", 40, 3, true},
                                                {"tree_of_30_of_every_kind", 30, 4, false}};

/// All trees of motions that the equations are written from.
inline std::vector<WrittenTree> trees_of(const LoadedMechanism& loaded, const Kinematics& kinematics) {
  std::vector<WrittenTree> trees{kinematics.tree};
  if (kinematics.peeled) trees.push_back(*kinematics.peeled);
  const MotionTree given = trees.back().tree;
  const RigidLinks links(*loaded.mechanism, given, *loaded.graph);
  trees.push_back(links.link_tree(minimal_regroupings(links), *loaded.graph));
  trees.push_back(trees.back());
  const MotionTree& last = trees.back().tree;
  trees.back().scaling = Scaling(last, scalable_turns(last));
  return trees;
}

}  // namespace alembert::test
