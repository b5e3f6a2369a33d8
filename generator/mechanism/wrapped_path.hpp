// Paths that lead around what is round. In: two points and an obstacle between them. Out: the length of the path, and
// points along it.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "symbolic/matrix.hpp"

namespace alembert {

/// A sphere about the origin, or a cylinder about the z axis, of which half its length is on each side of the origin.
struct RoundObstacle {
  bool cylinder = false;
  Expr radius;
  std::optional<Expr> length = {};  ///< of a cylinder; none: endless
};

/// Length of a taut line between two points that leads around an obstacle: the straight line where that passes it by, and
/// where a point is inside; else a tangent from each point and the arc (on a cylinder, the helix) between them. With a
/// `side`, a point outside, the arc is the one on its side of the obstacle, and the line leads around also where it would
/// pass on the other side. The laws are those of MuJoCo's tendons that wrap around a geom with a sidesite outside of it; a
/// line that would touch a cylinder beyond its ends, with both ends of the arc, passes it by, as in OpenSim.
/// Differentiable wherever the path does not jump.
///
/// \param straight  the distance of the points, m
Expr length_around(const RoundObstacle& obstacle, const Vec3& from, const Vec3& to,
                   const std::optional<Vec3>& side, const Expr& straight);
/// The same of numbers, and of endless cylinders.
double length_around(bool cylinder, double radius, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                     const std::optional<Eigen::Vector3d>& side);

/// So many points of the arc, its ends included; all of them `from` where the line does not lead around.
std::vector<Vec3> points_around(const RoundObstacle& obstacle, const Vec3& from, const Vec3& to,
                                const std::optional<Vec3>& side, int count);

}  // namespace alembert
