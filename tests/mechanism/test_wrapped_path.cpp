// Lines around spheres and cylinders, against what geometry says.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "mechanism/wrapped_path.hpp"
#include "symbolic/evaluate.hpp"

namespace alembert {
namespace {

using Eigen::Vector3d;
constexpr double kPi = std::numbers::pi;
const Vector3d kA(-2, 0, 0), kB(0, 2, 0);

TEST(WrappedPath, IsTwoTangentsAndAnArc) {
  // From two radii away a tangent is sqrt(3) long and its end a sixth of a turn on.
  const double expected = 2 * std::sqrt(3) + kPi - 2 * kPi / 3;
  EXPECT_NEAR(length_around(false, 1, kA, -kA, {}), expected, 1e-15);
  EXPECT_NEAR(length_around(true, 1, kA, -kA, {}), expected, 1e-15);
  EXPECT_NEAR(length_around(true, 1, kA, Vector3d(2, 0, 3), {}), std::hypot(expected, 3), 1e-14);
}

TEST(WrappedPath, IsStraightWhereNothingIsInTheWay) {
  for (const bool cylinder : {false, true}) {
    EXPECT_EQ(length_around(cylinder, 1, kA, kB, {}), (kB - kA).norm());
    EXPECT_EQ(length_around(cylinder, 1, Vector3d(-0.5, 0.1, 0), kB, {}),
              (kB - Vector3d(-0.5, 0.1, 0)).norm());
    EXPECT_EQ(length_around(cylinder, 1, kA, kA, {}), 0);
  }
  EXPECT_EQ(length_around(false, 1, Vector3d(-2, 0, 1.1), Vector3d(2, 0, 1.1), {}), 4);
}

TEST(WrappedPath, PassesCylindersThatItWouldTouchBeyondTheirEnds) {
  ExprGraph graph;
  const auto vector = [&](const Vector3d& x) {
    return Vec3{{graph.real(x[0]), graph.real(x[1]), graph.real(x[2])}};
  };
  const auto length = [&](const Vector3d& a, const Vector3d& b, double size) {
    return value_of(length_around({true, graph.one(), graph.real(size)}, vector(a), vector(b), std::nullopt,
                                  graph.real((b - a).norm())));
  };
  // It climbs by 2 over 2 sqrt(3) + pi/3, and touches first and last sqrt(3) from the ends.
  const Vector3d a(-2, 0, -1), b(2, 0, 1);
  const double flat = 2 * std::sqrt(3) + kPi / 3, touch = 1 - 2 * std::sqrt(3) / flat;
  const double around = std::hypot(flat, 2), straight = (b - a).norm();
  EXPECT_NEAR(length(a, b, 2 * std::abs(touch) + 1e-6), around, 1e-14);
  EXPECT_EQ(length(a, b, 2 * std::abs(touch) - 1e-6), straight);
  // One end is enough.
  const Vector3d up(0, 0, touch);
  EXPECT_NEAR(length(a + up, b + up, 1e-6), around, 1e-14);
  EXPECT_EQ(length(a + 1.01 * up, b + 1.01 * up, 1e-6), straight);
}

TEST(WrappedPath, LeadsAroundOnItsSide) {
  const double near = 2 * std::sqrt(3) - 2 * kPi / 3, far = near + 1.5 * kPi;
  for (const bool cylinder : {false, true}) {
    EXPECT_EQ(length_around(cylinder, 1, kA, kB, Vector3d(-1, 1, 0)), (kB - kA).norm());
    EXPECT_NEAR(length_around(cylinder, 1, kA, kB, Vector3d(1, -1, 0)), far, 1e-14);
    // Half of a turn apart, either way is as long.
    EXPECT_NEAR(length_around(cylinder, 1, kA, -kA, Vector3d(0.3, -1.5, 0)), near + kPi, 1e-14);
  }
}

TEST(WrappedPath, ItsPointsAreOnTheObstacle) {
  ExprGraph graph;
  const auto vector = [&](double x, double y, double z) {
    return Vec3{{graph.real(x), graph.real(y), graph.real(z)}};
  };
  const auto number = [](const Vec3& x) { return Vector3d(value_of(x[0]), value_of(x[1]), value_of(x[2])); };
  const double r = 0.7;
  const Vec3 from = vector(-1.3, 0.2, 0.4), to = vector(0.9, -0.5, -0.3);
  for (const bool cylinder : {false, true}) {
    for (const auto& side :
         {std::optional<Vec3>(), std::optional(vector(0, 2, 0)), std::optional(vector(0, -2, 0))}) {
      const RoundObstacle obstacle{cylinder, graph.real(r)};
      const std::vector<Vec3> points = points_around(obstacle, from, to, side, 200);
      double length =
          (number(points.front()) - number(from)).norm() + (number(to) - number(points.back())).norm();
      for (std::size_t i = 0; i < points.size(); ++i) {
        Vector3d point = number(points[i]);
        if (i > 0) length += (point - number(points[i - 1])).norm();
        if (cylinder) point.z() = 0;
        EXPECT_NEAR(point.norm(), r, 1e-14);
      }
      EXPECT_NEAR(length, value_of(length_around(obstacle, from, to, side, graph.one())), 2e-4);
    }
  }
  for (const Vec3& point : points_around({false, graph.real(0.01)}, from, to, {}, 3))
    EXPECT_EQ(number(point), number(from));
}

}  // namespace
}  // namespace alembert
