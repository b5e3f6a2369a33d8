// Tubes and balls of forces (see the header). The page draws the same itself (templates/viewer/source/forces_view.js).
#include "viewer/moving_parts.hpp"

#include <algorithm>
#include <cmath>

#include "support/shortest_turn.hpp"

namespace alembert {

namespace {

using Eigen::Vector3d;

constexpr Color kLineColor{0.79, 0.21, 0.2}, kDotColor{0.95, 0.45, 0.05};

// In sizes of the mechanism: the radius of a line without tension, of the faintest and of the strongest; of a dot; and
// what cannot be seen.
constexpr double kSlackRadius = 0.002, kLeastRadius = 0.0035, kMostRadius = 0.013, kLeastDot = 0.014,
                 kMostDot = 0.032, kInvisible = 1e-6;
constexpr double kNone = 1e-4;  // of the largest force, which is no force

class PartsOfForces {
 public:
  PartsOfForces(Scene& scene, const SceneMechanism& mechanism)
      : scene_(scene), mechanism_(mechanism), size_(bounds(scene, mechanism, 1).sizes().norm()) {}

  std::vector<MovingPart> make() {
    const double tension = largest(mechanism_.acting.lines), normal = largest(mechanism_.acting.contacts);
    for (const SceneLine& line : mechanism_.acting.lines) add(line, tension);
    for (const SceneContact& contact : mechanism_.acting.contacts) add(contact, normal);
    return std::move(parts_);
  }

 private:
  const Series& force(std::size_t index) const { return mechanism_.acting.forces.at(index); }

  template <class All>
  double largest(const All& all) const {
    double most = 0;
    for (const auto& one : all)
      for (const double value : force(one.force).values) most = std::max(most, std::abs(value));
    return most;
  }

  void add(const SceneLine& line, double most) {
    const Series& tension = force(line.force);
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
      MovingPart part{tension.name, scene_.mesh_index(cylinder_mesh(1, 1, 12)), kLineColor, {}, {}, {}};
      for (std::size_t k = 0; k < mechanism_.times.size(); ++k) {
        const Vector3d from = line.points[i][k], along = line.points[i + 1][k] - from;
        Eigen::Quaterniond turned = shortest_turn(Vector3d::UnitZ(), along).normalized();
        if (k > 0 && turned.dot(part.rotations.back()) < 0) turned.coeffs() = -turned.coeffs();
        const double share = most > 0 ? std::abs(tension.values[k]) / most : 0;
        const double radius =
            size_ * (share > kNone ? kLeastRadius + (kMostRadius - kLeastRadius) * share : kSlackRadius);
        part.origins.push_back(from + along / 2);
        part.rotations.push_back(turned);
        part.scales.emplace_back(radius, radius, std::max(along.norm(), kInvisible * size_));
      }
      parts_.push_back(std::move(part));
    }
  }

  void add(const SceneContact& contact, double most) {
    const Series& normal = force(contact.force);
    MovingPart part{normal.name, scene_.mesh_index(ellipsoid_mesh(Vector3d::Ones(), 16)),
                    kDotColor,   contact.points,
                    {},          {}};
    for (const double value : normal.values) {
      const bool touches = value > kNone * most;
      const double radius =
          touches ? kLeastDot + (kMostDot - kLeastDot) * std::cbrt(value / most) : kInvisible;
      part.rotations.push_back(Eigen::Quaterniond::Identity());
      part.scales.push_back(Vector3d::Constant(size_ * radius));
    }
    parts_.push_back(std::move(part));
  }

  Scene& scene_;
  const SceneMechanism& mechanism_;
  double size_;
  std::vector<MovingPart> parts_;
};

}  // namespace

std::vector<MovingPart> moving_parts(Scene& scene, const SceneMechanism& mechanism) {
  return PartsOfForces(scene, mechanism).make();
}

}  // namespace alembert
