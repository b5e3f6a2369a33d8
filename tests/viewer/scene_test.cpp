// Scenes: what a mechanism looks like, found joints, places and signs.
#include "viewer/scene.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "viewer/found_joint.hpp"
#include "viewer/looks.hpp"
#include "viewer/small_scene.hpp"

namespace alembert::test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using Kind = FoundJoint::Kind;

/// Poses T(in_parent) R T(-in_body) for a series of rotations.
std::vector<Isometry3d> turned_about(const Vector3d& in_parent, const Vector3d& in_body,
                                     const std::vector<Eigen::Quaterniond>& rotations) {
  std::vector<Isometry3d> out;
  for (const Eigen::Quaterniond& r : rotations)
    out.push_back(Eigen::Translation3d(in_parent) * r * Eigen::Translation3d(-in_body));
  return out;
}

TEST(FindJoint, SeesAnAxis) {
  const Vector3d axis = Vector3d(1, 2, 2) / 3;
  const Eigen::Quaterniond fixed(AngleAxisd(0.7, Vector3d(0.6, 0, 0.8)));
  std::vector<Eigen::Quaterniond> rotations;
  for (int k = 0; k < 20; ++k) rotations.push_back(fixed * AngleAxisd(0.01 * k, axis));
  const Vector3d in_body(0.1, -0.4, 0.3), in_parent(0.5, 0.2, 0.9);
  const auto poses = turned_about(in_parent, in_body, rotations);
  const FoundJoint joint = find_joint(poses, 1);
  ASSERT_EQ(joint.kind, Kind::axis);
  EXPECT_NEAR(std::abs(joint.axis.dot(axis)), 1, 1e-9);
  // On the axis, next to the body's origin.
  EXPECT_NEAR((joint.in_body - in_body).cross(axis).norm(), 0, 1e-7);
  EXPECT_NEAR(joint.in_body.dot(axis), 0, 1e-7);
  for (const Isometry3d& pose : poses) EXPECT_NEAR((pose * joint.in_body - joint.in_parent).norm(), 0, 1e-7);
}

TEST(FindJoint, SeesAPoint) {
  std::vector<Eigen::Quaterniond> rotations;
  for (int k = 0; k < 20; ++k)
    rotations.emplace_back(AngleAxisd(0.1 * k, Vector3d(std::cos(k), std::sin(k), 0.5).normalized()));
  const Vector3d in_body(0.1, -0.4, 0.3), in_parent(0.5, 0.2, 0.9);
  const FoundJoint joint = find_joint(turned_about(in_parent, in_body, rotations), 1);
  ASSERT_EQ(joint.kind, Kind::point);
  EXPECT_NEAR((joint.in_body - in_body).norm(), 0, 1e-7);
  EXPECT_NEAR((joint.in_parent - in_parent).norm(), 0, 1e-7);
}

TEST(FindJoint, SeesASlideAndWhatIsFixedOrFree) {
  std::vector<Isometry3d> slide, free;
  for (int k = 0; k < 12; ++k) {
    slide.emplace_back(Eigen::Translation3d(0.1 * k, 0.2 * k, 1));
    free.emplace_back(Eigen::Translation3d(0.1 * k, 0.02 * k * k, 0) *
                      AngleAxisd(0.1 * k, Vector3d::UnitZ()));
  }
  const FoundJoint joint = find_joint(slide, 1);
  ASSERT_EQ(joint.kind, Kind::slide);
  const Vector3d a(0, 0, 1), b(1.1, 2.2, 1);
  const double straight = (joint.in_parent - a).norm() + (joint.end - b).norm();
  const double crossed = (joint.in_parent - b).norm() + (joint.end - a).norm();
  EXPECT_NEAR(std::min(straight, crossed), 0, 1e-9);
  EXPECT_EQ(find_joint(free, 1).kind, Kind::none);
  EXPECT_EQ(find_joint(std::vector<Isometry3d>(5, slide[3]), 1).kind, Kind::fixed);
}

TEST(Looks, EquivalentEllipsoidHasTheInertia) {
  const double m = 2.5, a = 0.3, b = 0.2, c = 0.15;
  const Vector3d moments = m / 5 * Vector3d(b * b + c * c, a * a + c * c, a * a + b * b);
  EXPECT_NEAR((equivalent_ellipsoid(m, moments) - Vector3d(a, b, c)).norm(), 0, 1e-12);
}

constexpr const char* kPendulum = R"(alembert: 1
name: pendulum
gravity: [0, -9.81, 0]
parameters: {l: 0.5}
coordinates: [{name: q, initial: 0.4}]
bodies:
  - name: bob
    transform:
      - rotate: {axis: z, angle: q}
      - translate: [0, -l, 0]
    mass: 2
)";

TEST(Scene, StandsUpright) {
  const SmallScene small(kPendulum, {0.4, 0.2, -0.1});
  const SceneMechanism& mechanism = small.scene.mechanisms.at(0);
  EXPECT_NEAR((mechanism.placement.linear() * Vector3d(0, -1, 0) + Vector3d::UnitZ()).norm(), 0, 1e-12);
}

TEST(Scene, LinksTheBobToItsPivot) {
  const SmallScene small(kPendulum, {0.4, 0.2, -0.1});
  const SceneBody& bob = small.scene.mechanisms.at(0).bodies.at(0);
  // Link, ball of the mass, pin at the pivot.
  ASSERT_EQ(bob.parts.size(), 3u);
  const double reach = 0.5 + small.scene.meshes[bob.parts[1].mesh].positions[0].cast<double>().norm();
  const Eigen::AlignedBox3d box = bounds(small.scene, small.scene.mechanisms[0]);
  EXPECT_LT(box.max().cwiseAbs().maxCoeff(), reach + 0.05);
  EXPECT_NEAR((bob.parts[2].placement.translation() - Vector3d(0, 0.5, 0)).norm(), 0, 1e-7);
}

TEST(Scene, KeepsPosesAndTheSideOfQuaternions) {
  std::vector<double> angles;
  for (int k = 0; k < 200; ++k) angles.push_back(0.1 * k);  // three turns: the sign would flip
  const SmallScene small(kPendulum, angles);
  const SceneBody& bob = small.scene.mechanisms.at(0).bodies.at(0);
  ASSERT_EQ(bob.rotations.size(), angles.size());
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const double q = angles[k];
    EXPECT_NEAR((bob.origins[k] - Vector3d(0.5 * std::sin(q), -0.5 * std::cos(q), 0)).norm(), 0, 1e-12);
    EXPECT_NEAR((bob.rotations[k] * Vector3d::UnitX() - Vector3d(std::cos(q), std::sin(q), 0)).norm(), 0,
                1e-12);
    if (k > 0) {
      EXPECT_GT(bob.rotations[k].dot(bob.rotations[k - 1]), 0.99);
    }
  }
}

TEST(Scene, PlacesMechanismsBesideEachOther) {
  SmallScene small(kPendulum, {0.4, 0.2, -0.1});
  small.add(kPendulum, {1, 2});
  small.add(kPendulum, {3});
  place_side_by_side(small.scene);
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const SceneMechanism& mechanism : small.scene.mechanisms) {
    boxes.push_back(bounds(small.scene, mechanism).transformed(mechanism.placement));
    EXPECT_NEAR(boxes.back().min()[2], 0, 1e-9);
  }
  EXPECT_TRUE(boxes[0].intersection(boxes[1]).isEmpty());
  EXPECT_TRUE(boxes[0].intersection(boxes[2]).isEmpty());
  EXPECT_TRUE(boxes[1].intersection(boxes[2]).isEmpty());
  EXPECT_EQ(small.scene.mechanisms[1].name, "pendulum 2");
  EXPECT_EQ(small.scene.mechanisms[2].name, "pendulum 3");
}

TEST(Scene, DrawsWhatBodiesMoveOn) {
  const SmallScene small(R"(alembert: 1
name: slider
coordinates: [{name: u, initial: 0.1}, {name: v, initial: 0.2}]
bodies:
  - name: slider
    transform:
      - translate: [0, 0, 3]
      - surface: {point: [(1.1 + 0.35*cos(v))*cos(u), (1.1 + 0.35*cos(v))*sin(u), 0.35*sin(v)], along: [u, v]}
    mass: 1
)",
                         {0.1, 0.3});
  const SceneMechanism& mechanism = small.scene.mechanisms.at(0);
  ASSERT_EQ(mechanism.scenery.size(), 1u);
  const Mesh& torus = small.scene.meshes[mechanism.scenery[0].mesh];
  EXPECT_TRUE(torus.closed);
  EXPECT_TRUE(watertight(torus));
  EXPECT_NEAR(volume(torus), 2 * 9.8696 * 1.1 * 0.35 * 0.35, 0.04);
  EXPECT_EQ(mechanism.scenery[0].placement.translation(), Vector3d(0, 0, 3));
}

/// One coordinate shifts a body along a rail; what several coordinates move may run straight without one, as a body
/// that falls.
TEST(Scene, DrawsRailsForSlidesOnly) {
  const auto scenery_of = [](const char* coordinates, const char* shift) {
    const SmallScene small(fmt::format("alembert: 1\nname: block\ncoordinates: [{}]\nbodies:\n"
                                       "  - {{name: block, transform: [translate: [{}]], mass: 1}}\n",
                                       coordinates, shift),
                           {0, -2, -50});
    return small.scene.mechanisms.at(0).scenery.size();
  };
  EXPECT_EQ(scenery_of("x", "x, 0, 0"), 1u);
  EXPECT_EQ(scenery_of("x, y, z", "x, y, z"), 0u);
}

TEST(Scene, DrawsASurfaceInAnInverseOnItsBody) {
  const SmallScene small(R"(alembert: 1
name: ring
coordinates: [{name: u, initial: 0.1}, {name: v, initial: 0.2}]
bodies:
  - name: ring
    transform:
      - inverse:
          - translate: [0, 0, 3]
          - surface: {point: [(1.1 + 0.35*cos(v))*cos(u), (1.1 + 0.35*cos(v))*sin(u), 0.35*sin(v)], along: [u, v]}
    mass: 1
)",
                         {0.1, 0.3});
  const SceneMechanism& mechanism = small.scene.mechanisms.at(0);
  EXPECT_TRUE(mechanism.scenery.empty());
  const auto is_torus = [&](const ScenePart& part) {
    return std::abs(volume(small.scene.meshes[part.mesh]) - 2 * 9.8696 * 1.1 * 0.35 * 0.35) < 0.04 &&
           part.placement.translation().isApprox(Vector3d(0, 0, 3), 1e-12);
  };
  EXPECT_EQ(std::ranges::count_if(mechanism.bodies.at(0).parts, is_torus), 1);
}

TEST(Scene, DrawsShapesOfTheDescription) {
  const SmallScene small(R"(alembert: 1
name: shaped
coordinates: [q]
bodies:
  - name: body
    transform: [{rotate: {axis: z, angle: q}}]
    mass: 1
    com: [1, 0, 0]
    geometry:
      - {box: [1, 2, 3], color: [1, 0.5, 0], transform: [{translate: [0, 0, 7]}]}
      - {torus: {radius: 2, tube: 0.5}}
)",
                         {0.1, 0.3});
  const SceneBody& body = small.scene.mechanisms.at(0).bodies.at(0);
  ASSERT_EQ(body.parts.size(), 2u);  // and no default shapes beside them
  EXPECT_EQ(body.parts[0].color, (Color{1, 0.5, 0}));
  EXPECT_EQ(body.parts[0].placement.translation(), Vector3d(0, 0, 7));
  EXPECT_EQ(small.scene.meshes[body.parts[0].mesh], box_mesh({1, 2, 3}));
  EXPECT_EQ(small.scene.meshes[body.parts[1].mesh], torus_mesh(2, 0.5));
}

/// A ball over a plane that leans, and its contact at two frames.
SmallScene ball_on_plane(const std::string& ball_geometry, const std::string& more_bodies) {
  Acting acting;
  acting.forces = {{"touch", {0, 1}, "N", {}}};
  acting.contacts = {{0, {Vector3d(0.2, 0, 1), Vector3d(0.6, 0.3, 1)}}};
  return SmallScene(R"(alembert: 1
name: ball
coordinates: [x, z]
bodies:
  - {name: ball, transform: [{translate: [x, 0, z + 2]}], mass: 1)" +
                        ball_geometry + "}\n" + more_bodies + R"(
frames: [{name: center, body: ball, transform: [{translate: [0.1, 0, 0]}]}]
forces:
  - {name: touch, contact: {frame: center, radius: 0.25, plane: {point: [0, 0, 1], normal: [0, -3, 4]}, stiffness: 10}}
)",
                    {0.1, 0.2}, acting);
}

TEST(Scene, HintsAtWhatTouches) {
  const SmallScene small = ball_on_plane("", "");
  const SceneMechanism& shown = small.scene.mechanisms.at(0);
  const auto is_sphere = [&](const ScenePart& part) {
    return small.scene.meshes[part.mesh] == ellipsoid_mesh(Vector3d::Constant(0.25)) &&
           (part.placement.translation() - Vector3d(0.1, 0, 0)).norm() < 1e-12;
  };
  EXPECT_EQ(std::count_if(shown.bodies.at(0).parts.begin(), shown.bodies[0].parts.end(), is_sphere), 1);
  // No point of the piece lies beyond the plane, and some on it; it reaches below both contacts.
  const ScenePart& piece = shown.scenery.back();
  const Vector3d normal(0, -0.6, 0.8);
  double highest = -1;
  Eigen::AlignedBox3d local;
  for (const Eigen::Vector3f& vertex : small.scene.meshes[piece.mesh].positions) {
    local.extend(vertex.cast<double>());
    highest = std::max(highest, normal.dot(piece.placement * vertex.cast<double>() - Vector3d(0, 0, 1)));
  }
  EXPECT_NEAR(highest, 0, 1e-7);
  for (const Vector3d& point : shown.acting.contacts[0].points) {
    const Vector3d on_piece =
        piece.placement.inverse() * (point - normal * normal.dot(point - Vector3d(0, 0, 1)));
    EXPECT_TRUE(local.contains(Vector3d(on_piece[0], on_piece[1], 0)));
  }
}

TEST(Scene, HintsAtNothingThatHasAShape) {
  const SmallScene small = ball_on_plane(", geometry: [{box: [0.5, 0.5, 0.5]}]",
                                         "  - {name: ground, geometry: [{box: [3, 3, 0.1]}]}");
  const SceneMechanism& shown = small.scene.mechanisms.at(0);
  EXPECT_EQ(shown.bodies.at(0).parts.size(), 1u);
  EXPECT_TRUE(shown.scenery.empty());
}

TEST(Scene, BoundsHoldLines) {
  Acting acting;
  acting.forces = {{"rope", {1, 1}, "N", {}}};
  acting.lines = {{0, {{Vector3d(0, 0, 9), Vector3d(0, 0, 9)}, {Vector3d(0, 0, 0), Vector3d(-7, 0, 0)}}}};
  const SmallScene small(R"(alembert: 1
name: point
coordinates: [x]
bodies: [{name: p, transform: [{translate: [x, 0, 0]}], mass: 1}]
)",
                         {0.1, 0.2}, acting);
  const SceneMechanism& shown = small.scene.mechanisms.at(0);
  EXPECT_EQ(bounds(small.scene, shown).max()[2], 9);
  EXPECT_EQ(bounds(small.scene, shown).min()[0], -7);
  EXPECT_GT(bounds(small.scene, shown, 1).min()[0], -1);
}

}  // namespace
}  // namespace alembert::test
