// Shortest turns (see the header).
#include "support/shortest_turn.hpp"

#include <cmath>

namespace alembert {

Eigen::Quaterniond shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  constexpr double kOpposite = 1e-12;  // 1 + the cosine: less has no digit of the axis
  const Eigen::Vector3d a = from.normalized(), b = to.normalized();
  const double cosine = b.dot(a);
  if (cosine < -1 + kOpposite) {
    Eigen::Index least = 0;
    a.cwiseAbs().minCoeff(&least);
    const Eigen::Vector3d unit = Eigen::Vector3d::Unit(least);
    const Eigen::Vector3d axis = (unit - unit.dot(a) * a).normalized();
    return {0, axis.x(), axis.y(), axis.z()};
  }
  const double s = std::sqrt(2 * (1 + cosine));
  const Eigen::Vector3d part = a.cross(b) * (1 / s);
  return {s * 0.5, part.x(), part.y(), part.z()};
}

}  // namespace alembert
