#include "import/common/mass_properties.hpp"

namespace alembert {
namespace {

/// Inertia of a unit mass at an offset: moments are sums of two squares, since in a difference from all three a large
/// one takes the others' digits.
Eigen::Matrix3d of_point(const Eigen::Vector3d& offset) {
  const Eigen::Vector3d squares = offset.cwiseAbs2();
  Eigen::Matrix3d inertia = -offset * offset.transpose();
  inertia.diagonal() << squares.y() + squares.z(), squares.z() + squares.x(), squares.x() + squares.y();
  return inertia;
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
