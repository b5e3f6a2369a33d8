// Mass, centre of mass and inertia, and how they add up.
#pragma once

#include <Eigen/Core>

namespace alembert {

struct BodyMass {
  double mass = 0;                                    ///< kg
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();   ///< m
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the centre, kg m^2

  BodyMass& operator+=(const BodyMass& other);
  /// The same after a rotation, then a shift.
  BodyMass moved(const Eigen::Matrix3d& turn, const Eigen::Vector3d& shift) const;
  BodyMass times(double factor) const { return {factor * mass, centre, factor * inertia}; }
};

}  // namespace alembert
