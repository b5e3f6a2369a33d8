// The tree of motions: merging, placing bodies, twists of curves, surfaces and quaternions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/mechanism_file.hpp"
#include "symbolic/count_operations.hpp"
#include "symbolic/to_string.hpp"

namespace alembert::test {
namespace {

std::string one_body(const std::string& coordinates, const std::string& transform,
                     const std::string& extra = "") {
  return "alembert: 1\nname: test\n" + extra + "coordinates: [" + coordinates +
         "]\nbodies:\n  - name: a\n    transform:\n" + transform +
         "    mass: 1\n    inertia: {xx: 1, yy: 1, zz: 1}\n";
}

TEST(MotionTree, NeighbouringRotationsAboutOneAxisMerge) {
  const auto loaded =
      LoadedMechanism::text(one_body("q",
                                     "      - rotate: {axis: z, angle: pi/2}\n      - rotate: {axis: z, "
                                     "angle: q}\n      - rotate: {axis: z, angle: -pi/2}\n"));
  const Kinematics kinematics = loaded.kinematics();
  ASSERT_EQ(kinematics.tree.nodes.size(), 1u);
  EXPECT_EQ(to_string(kinematics.tree.nodes[0].motion.angle), "q");
}

TEST(MotionTree, ConstantTailBecomesPartOfTheBodyAndOfItsChild) {
  const auto loaded = LoadedMechanism::text(R"(alembert: 1
name: test
coordinates: [q1, q2]
bodies:
  - name: a
    transform: [{rotate: {axis: z, angle: q1}}, {translate: [2, 0, 0]}]
    mass: 3
    com: [1, 0, 0]
    inertia: {xx: 1, yy: 1, zz: 1}
  - name: b
    parent: a
    transform: [{translate: [0, 1, 0]}, {rotate: {axis: z, angle: q2}}]
    mass: 1
    inertia: {xx: 1, yy: 1, zz: 1}
)");
  const Kinematics kinematics = loaded.kinematics();
  ASSERT_EQ(kinematics.tree.nodes.size(), 3u);  // rotation, one merged translation, rotation
  EXPECT_EQ(kinematics.tree.places[0].node, 0);
  EXPECT_EQ(to_string(kinematics.tree.nodes[1].motion.offset[0]), "2");
  EXPECT_EQ(to_string(kinematics.tree.nodes[1].motion.offset[1]), "1");
  const NodeMass mass = mass_at_node(loaded.mechanism->bodies[0], kinematics.tree.places[0], *loaded.graph);
  EXPECT_EQ(to_string(mass.moment[0]), "9");       // m (2 + 1)
  EXPECT_EQ(to_string(mass.inertia(2, 2)), "28");  // 1 + 3 * 3^2
  EXPECT_EQ(to_string(mass.inertia(0, 0)), "1");
}

TEST(MotionTree, QuaternionSpeedsAreTheChildAxes) {
  const auto loaded = LoadedMechanism::text(
      one_body("{name: base, type: quaternion}", "      - rotate: {quaternion: base}\n"));
  const Kinematics kinematics = loaded.kinematics();
  ASSERT_EQ(kinematics.tree.nodes.size(), 1u);
  ASSERT_EQ(kinematics.tree.nodes[0].partials.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(to_string(kinematics.tree.nodes[0].partials[k].direction[i]), i == k ? "1" : "0");
    }
  }
}

/// E^T dE/dt of the pose equals the node's angular velocity, for every kind of rotation, by finite
/// differences along the motion.
class Twist : public testing::TestWithParam<const char*> {};
TEST_P(Twist, AngularVelocityIsTheRateOfTheRotation) {
  const auto loaded =
      LoadedMechanism::text(one_body("{name: u, initial: 0.3}, {name: v, initial: 0.4}", GetParam()));
  const Kinematics kinematics = loaded.kinematics();
  Pose pose = identity_pose(*loaded.graph);
  Vec3 om = zeros<3, 1>(*loaded.graph);
  for (const MotionNode& node : kinematics.tree.nodes) {
    pose = moved(pose, node.motion);
    if (node.motion.kind != MotionKind::translation) om = node.motion.to_child(om) + node.velocity;
  }
  std::vector<double> state = state_values(*loaded.mechanism, *loaded.graph, 3);
  const auto rotation_at = [&](double h) {
    std::vector<double> moved_state = state;
    for (const Coordinate& c : loaded.mechanism->coordinates) {
      const std::uint32_t q = loaded.graph->symbol_index(c.symbols[0].ref().node());
      moved_state[q] += h * state[loaded.graph->symbol_index(c.speed_symbols[0].ref().node())];
    }
    return evaluate(pose.rotation.entries, moved_state);
  };
  constexpr double kStep = 1e-5;
  const std::vector<double> ahead = rotation_at(kStep), behind = rotation_at(-kStep), here = rotation_at(0);
  const auto entry = [&](std::size_t i, std::size_t j) {  // (E^T dE/dt)_ij
    double sum = 0;
    for (std::size_t r = 0; r < 3; ++r)
      sum += here[3 * r + i] * (ahead[3 * r + j] - behind[3 * r + j]) / (2 * kStep);
    return sum;
  };
  const std::vector<double> expected = evaluate(om.entries, state);
  EXPECT_NEAR(entry(2, 1), expected[0], 1e-8);
  EXPECT_NEAR(entry(0, 2), expected[1], 1e-8);
  EXPECT_NEAR(entry(1, 0), expected[2], 1e-8);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      double product = 0;
      for (std::size_t r = 0; r < 3; ++r) product += here[3 * r + i] * here[3 * r + j];
      EXPECT_NEAR(product, i == j ? 1 : 0, 1e-12);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(
    Rotations, Twist,
    testing::Values(
        "      - rotate: {axis: x, angle: u*v}\n      - rotate: {axis: y, angle: v}\n",
        "      - rotate: {axis: [1, 2, -1], angle: u + v^2}\n      - rotate: {axis: z, angle: v}\n",
        "      - curve: {point: [cos(u), sin(u), u/3], along: u, frame: frenet}\n      - rotate: {axis: x, "
        "angle: v}\n",
        "      - curve: {point: [u, u^3, v], along: u, frame: {reference: [0, 0, 1]}}\n",
        "      - surface: {point: [u, v, u^2 - v^2/2 + u*v], along: [u, v], flip: true}\n",
        "      - surface: {point: [(2 + cos(v)/2)*cos(u), (2 + cos(v)/2)*sin(u), sin(v)/2], along: [u, v]}\n",
        "      - inverse:\n          - surface: {point: [2*cos(u)*cos(v), sin(u)*cos(v), 3*sin(v)], along: "
        "[u, v]}\n"));

TEST(ContactFrames, TorusSurfaceFrameBecomesSinesAndCosines) {
  const auto loaded = LoadedMechanism::text(one_body(
      "u, v",
      "      - surface: {point: [(2 + cos(v)/2)*cos(u), (2 + cos(v)/2)*sin(u), sin(v)/2], along: [u, v]}\n"));
  const Kinematics kinematics = loaded.kinematics();
  ASSERT_EQ(kinematics.tree.nodes.size(), 2u);
  const Mat3& E = kinematics.tree.nodes[1].motion.matrix;
  EXPECT_EQ(to_string(E(0, 0)), "-sin(u)");
  EXPECT_EQ(to_string(E(1, 0)), "cos(u)");
  EXPECT_EQ(to_string(E(2, 2)), "sin(v)");
  EXPECT_EQ(count_operations(E.entries).div, 0u);
}

TEST(ContactFrames, StraightCurveHasNoFrenetFrame) {
  const auto loaded =
      LoadedMechanism::text(one_body("u", "      - curve: {point: [u, 2*u, 0], along: u, frame: frenet}\n"));
  try {
    loaded.kinematics();
    FAIL() << "a straight line has no Frenet frame";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("test.yaml:7:"));
    EXPECT_THAT(error.what(), testing::HasSubstr("reference"));
  }
}

TEST(ContactFrames, InflectionAtTheInitialStateIsNamed) {
  const auto loaded =
      LoadedMechanism::text(one_body("u", "      - curve: {point: [u, u^3, 0], along: u, frame: frenet}\n"));
  EXPECT_THROW(loaded.kinematics(), InputError);
}

}  // namespace
}  // namespace alembert::test
