// Where a frame lies in another.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>

namespace alembert {

/// Shift, then rotation.
struct RigidPose {
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  double summed = 0;  ///< the longest shift that this one is a sum of; none where the file states it

  /// The same of a shift that this one is a part of.
  double longest() const { return std::max(summed, shift.norm()); }
};
RigidPose operator*(const RigidPose& first, const RigidPose& then);
RigidPose inverse(const RigidPose& pose);

}  // namespace alembert
