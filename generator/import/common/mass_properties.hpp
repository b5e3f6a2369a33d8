// Mass, centre of mass and inertia, and how they add up.
#pragma once

#include "import/common/rigid_pose.hpp"

namespace alembert {

struct BodyMass {
  double mass = 0;                                    ///< kg
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();   ///< m
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the centre, kg m^2
  double summed = 0;  ///< the longest shift that the centre is a sum of, as that of a pose

  BodyMass& operator+=(const BodyMass& other);
  /// As a frame at that pose has it.
  BodyMass moved(const RigidPose& pose) const;
  BodyMass times(double factor) const { return {factor * mass, centre, factor * inertia, summed}; }
  /// At the centre, with these axes.
  RigidPose frame(const Eigen::Quaterniond& axes = Eigen::Quaterniond::Identity()) const {
    return {centre, axes, summed};
  }
};

}  // namespace alembert
