#include "import/common/mass_properties.hpp"

namespace alembert {
namespace {

/// Inertia of a unit mass at an offset.
Eigen::Matrix3d of_point(const Eigen::Vector3d& offset) {
  return offset.squaredNorm() * Eigen::Matrix3d::Identity() - offset * offset.transpose();
}

}  // namespace

BodyMass& BodyMass::operator+=(const BodyMass& other) {
  const double sum = mass + other.mass;
  if (sum <= 0) return *this;
  const Eigen::Vector3d between = other.centre - centre;
  summed = std::max(frame().longest(), other.frame().longest());
  inertia += other.inertia + mass * other.mass / sum * of_point(between);
  centre += other.mass / sum * between;
  mass = sum;
  return *this;
}

BodyMass BodyMass::moved(const RigidPose& pose) const {
  const Eigen::Matrix3d turn = pose.turn.toRotationMatrix();
  return {mass, turn * centre + pose.shift, turn * inertia * turn.transpose(), (pose * frame()).summed};
}

}  // namespace alembert
