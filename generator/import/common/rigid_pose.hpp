// Where a frame lies in another.
#pragma once

#include <Eigen/Geometry>

namespace alembert {

/// Shift, then rotation.
struct RigidPose {
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
};
RigidPose operator*(const RigidPose& first, const RigidPose& then);
RigidPose inverse(const RigidPose& pose);

}  // namespace alembert
