// The rotation that takes one direction to another on the shortest way. In: two vectors. Out: a unit quaternion.
#pragma once

#include <Eigen/Geometry>

namespace alembert {

/// Takes the direction of `from` to that of `to`, to rounding. The vectors may have any length but zero. Opposite directions
/// have many shortest turns: then it is about the coordinate axis that is least along `from`, made orthogonal to it.
Eigen::Quaterniond shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace alembert
