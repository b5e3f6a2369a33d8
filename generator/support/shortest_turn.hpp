// The rotation that takes one direction to another on the shortest way. In: two vectors. Out: a unit quaternion.
#pragma once

#include <Eigen/Geometry>

namespace alembert {

/// About from x to, by the angle between them. Vectors of any length that can be squared, but zero; of opposite ones half a turn about the
/// part across `from` of the coordinate axis that is least along it, the first of several.
Eigen::Quaterniond shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace alembert
