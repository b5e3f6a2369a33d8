// Joints found in a motion. In: poses of a body in its parent. Out: the points that stay together.
#pragma once

#include <Eigen/Geometry>
#include <span>

namespace alembert {

/// Where a body is held by its parent, as its motion shows it: the points that stay together.
struct FoundJoint {
  enum class Kind {
    none,   ///< no point of the body rests in the parent
    fixed,  ///< all do
    axis,   ///< those of a line
    point,  ///< one
    slide,  ///< none, but the body moves along a line without turning
  };
  Kind kind = Kind::none;
  Eigen::Vector3d in_body = Eigen::Vector3d::Zero();  ///< the point next to the body's origin, body frame
  Eigen::Vector3d in_parent =
      Eigen::Vector3d::Zero();                      ///< the same point in the parent's frame; slide: one end
  Eigen::Vector3d end = Eigen::Vector3d::Zero();    ///< slide: the other end, parent's frame
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< axis: unit vector, body frame
};

/// Least squares over frames k: x in the body and y in the parent with R_k x + p_k = y. `size` is a length of
/// the mechanism, against which errors are judged.
FoundJoint find_joint(std::span<const Eigen::Isometry3d> relative_poses, double size);

}  // namespace alembert
