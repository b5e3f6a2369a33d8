// The wheels of Fig. 5c roll: their centres keep their distances, and the two bodies that touch have the same
// velocity where they touch. Velocities are differences of poses along the motion.
#include "paper/tree_motion.hpp"

namespace alembert::test {
namespace {

using Eigen::Vector3d;

/// One wheel on what it rolls on; centres are the bodies' origins, or a point of the world.
struct Rolling {
  std::string wheel, on;  ///< `on` may be "": at rest about `centre`
  Vector3d centre;
  double radius, on_radius;
  bool inside;  ///< the wheel is inside of what it rolls on
};

void expect_no_slip(const std::string& name,
                    const std::function<std::vector<Rolling>(const TreeMotion&)>& rollings) {
  const TreeMotion m(name);
  const std::vector<Moment> moments = m.simulate(60, 1.0 / 60, 60);
  constexpr double kStep = 1e-4;
  std::vector<std::pair<double, std::vector<double>>> states;
  for (const Moment& moment : moments) {
    for (const double along : {0.0, kStep, -kStep, 2 * kStep, -2 * kStep}) {
      std::vector<double> q = moment.q;
      for (std::size_t i = 0; i < q.size(); ++i) q[i] += along * moment.speeds[i];
      states.emplace_back(moment.t, std::move(q));
    }
  }
  const auto poses = m.poses(states);
  double off = 0, slip = 0, fastest = 0;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    for (const Rolling& rolling : rollings(m)) {
      const auto pose = [&](const std::string& body, std::size_t which) {
        if (!body.empty()) return poses[5 * i + which].at(body);
        Pose fixed = Pose::Zero();
        fixed.leftCols<3>().setIdentity();
        fixed.col(3) = rolling.centre;
        return fixed;
      };
      const Pose wheel = pose(rolling.wheel, 0), on = pose(rolling.on, 0);
      const Vector3d line = origin(wheel) - origin(on);
      const double wanted =
          rolling.inside ? rolling.on_radius - rolling.radius : rolling.on_radius + rolling.radius;
      off = std::max(off, std::abs(line.norm() - wanted));
      const Vector3d contact = origin(on) + rolling.on_radius * line.normalized();
      const auto velocity = [&](const std::string& body) {
        const Vector3d own = seen_from(pose(body, 0), contact);
        const auto moved = [&](std::size_t which) { return at(pose(body, which), own[0], own[1], own[2]); };
        return Vector3d((8 * (moved(1) - moved(2)) - (moved(3) - moved(4))) / (12 * kStep));
      };
      slip = std::max(slip, (velocity(rolling.wheel) - velocity(rolling.on)).norm());
      fastest = std::max(
          fastest, ((origin(pose(rolling.wheel, 1)) - origin(pose(rolling.wheel, 2))) / (2 * kStep)).norm());
    }
  }
  EXPECT_LE(off, 1e-12);
  EXPECT_LE(slip, 1e-8);
  EXPECT_GT(fastest, 0.3);
}

TEST(RollingWheels, HoopsInABowl) {
  expect_no_slip("rolling_wheels_bowl", [](const TreeMotion& m) -> std::vector<Rolling> {
    const double R = m.parameter("R");
    return {{"hoop", "", {0, 0, R}, m.parameter("r1"), R, true},
            {"small_hoop", "hoop", {}, m.parameter("r2"), m.parameter("i1"), true},
            {"disc", "small_hoop", {}, m.parameter("r3"), m.parameter("i2"), true}};
  });
}
TEST(RollingWheels, WheelOnAHill) {
  expect_no_slip("rolling_wheels_hill", [](const TreeMotion& m) -> std::vector<Rolling> {
    return {{"wheel", "", {0, 0, 0}, m.parameter("r1"), m.parameter("R"), false},
            {"disc", "wheel", {}, m.parameter("r2"), m.parameter("i1"), true}};
  });
}
TEST(RollingWheels, WheelsOutsideEachOther) {
  expect_no_slip("rolling_wheels_outside", [](const TreeMotion& m) -> std::vector<Rolling> {
    return {{"wheel", "", {0, 0, 0}, m.parameter("r1"), m.parameter("R"), false},
            {"small_wheel", "wheel", {}, m.parameter("r2"), m.parameter("r1"), false}};
  });
}

}  // namespace
}  // namespace alembert::test
