// Shortest turns (see the header).
#include "support/shortest_turn.hpp"

#include <cmath>
#include <limits>

namespace alembert {

Eigen::Quaterniond shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d a = from.normalized(), b = to.normalized();
  const double cosine = b.dot(a);
  if (cosine < 0) {
    // 1 + cosine cancels; a + b, of length 2 cos(angle/2), is exact where they are nearly opposite.
    const Eigen::Vector3d sum = a + b;
    Eigen::Vector3d across = a.cross(sum);
    if (across.norm() <= std::numeric_limits<double>::epsilon()) {
      Eigen::Index least = 0;
      a.cwiseAbs().minCoeff(&least);
      const Eigen::Vector3d unit = Eigen::Vector3d::Unit(least);
      across = unit - unit.dot(a) * a;
    }
    const Eigen::Vector3d part = across.normalized() * ((a - b).norm() / 2);
    return {sum.norm() / 2, part.x(), part.y(), part.z()};
  }
  const double s = std::sqrt(2 * (1 + cosine));
  const Eigen::Vector3d part = a.cross(b) * (1 / s);
  return {s * 0.5, part.x(), part.y(), part.z()};
}

}  // namespace alembert
