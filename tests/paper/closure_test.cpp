// What holds by construction, measured from poses: beads and cars are on their curves, surfaces touch with
// opposite normals, the loops of linkages close. At every tenth state of a minute with steps of 1/30 s, or at
// random states.
#include <functional>
#include <random>

#include "paper/tree_motion.hpp"

namespace alembert::test {
namespace {

using Eigen::Vector3d;

constexpr double kRounding = 1e-12;  // of metres, and of the length of a normal

double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

/// Coordinates anywhere: limits, or 2 to both sides of the initial value.
std::vector<std::pair<double, std::vector<double>>> random_states(const TreeMotion& mechanism, int count) {
  std::mt19937_64 random(7);
  std::vector<std::pair<double, std::vector<double>>> states;
  for (int i = 0; i < count; ++i) {
    std::vector<double> q;
    for (const oracles::Coordinate& c : mechanism.description().coordinates) {
      EXPECT_FALSE(c.quaternion);
      q.push_back(c.limits ? uniform(random, c.limits->first, c.limits->second)
                           : uniform(random, c.initial[0] - 2, c.initial[0] + 2));
    }
    states.emplace_back(0.0, std::move(q));
  }
  return states;
}

/// Distance of a point from a closed curve with parameter 0 to 2 pi: the nearest of many samples, halved
/// steps from there, and what is left across the tangent (the square of what is left along it is below
/// rounding).
double distance(const std::function<Vector3d(double)>& curve, const Vector3d& point) {
  constexpr int kSamples = 1000;
  double step = 2 * M_PI / kSamples, s = 0;
  const auto squared = [&](double x) { return (curve(x) - point).squaredNorm(); };
  for (int i = 1; i < kSamples; ++i) {
    if (squared(i * step) < squared(s)) s = i * step;
  }
  for (; step > 1e-8; step /= 2) {
    if (squared(s + step) < squared(s)) s += step;
    if (squared(s - step) < squared(s)) s -= step;
  }
  const Vector3d tangent = (curve(s + 1e-5) - curve(s - 1e-5)).normalized(), left = point - curve(s);
  return (left - left.dot(tangent) * tangent).norm();
}

/// Every tenth state of a minute.
std::vector<Moment> minute(const TreeMotion& mechanism) {
  return mechanism.simulate(60, 1.0 / 30, 10);
}

void expect_on_curve(const std::string& name, const std::function<Vector3d(double)>& curve, double size) {
  const TreeMotion mechanism(name);
  double worst = 0, travelled = 0;
  Vector3d before = Vector3d::Zero();
  for (const auto& poses : mechanism.poses(minute(mechanism))) {
    for (const auto& [body, pose] : poses) {
      if (body == "wire" || body == "track") continue;  // at rest
      worst = std::max(worst, distance(curve, origin(pose)));
      if (body == "bead" || body == "car1") {
        travelled += travelled == 0 ? 1e-9 : (origin(pose) - before).norm();
        before = origin(pose);
      }
    }
  }
  EXPECT_LE(worst, kRounding * size) << name;
  EXPECT_GT(travelled, size) << name;
}

TEST(Closure, BeadIsOnTheWire) {
  const TreeMotion m("bead_on_wire");
  const double a = m.parameter("a"), b = m.parameter("b"), h = m.parameter("h"), tilt = m.parameter("tilt");
  expect_on_curve(
      "bead_on_wire",
      [=](double s) -> Vector3d {
        return {a * std::cos(s), b * std::sin(s), 1 + h * std::cos(3 * s) + tilt * std::cos(s)};
      },
      1);
}

TEST(Closure, CarsAreOnTheTrack) {
  for (const char* name : {"train", "train_coupled"}) {
    const TreeMotion m(name);
    const double a = m.parameter("a"), b = m.parameter("b"), h1 = m.parameter("h1"), h2 = m.parameter("h2");
    expect_on_curve(
        name,
        [=](double s) -> Vector3d {
          return {a * std::cos(s), b * std::sin(s), 4 + h2 * std::sin(2 * s) + h1 * std::sin(s)};
        },
        10);
  }
  const TreeMotion m("train_reference");
  const double a = m.parameter("a"), b = m.parameter("b"), h = m.parameter("h");
  expect_on_curve(
      "train_reference",
      [=](double s) -> Vector3d {
        return {a * std::sin(s), b * std::sin(2 * s), 3 + h * (std::cos(s) - std::cos(3 * s) / 9)};
      },
      10);
}

/// The point of a torus about z, and the normal there.
std::pair<Vector3d, Vector3d> on_torus(double R, double r, double u, double v) {
  const Vector3d out(std::cos(u), std::sin(u), 0),
      normal = std::cos(v) * out + std::sin(v) * Vector3d::UnitZ();
  return {R * out + r * normal, normal};
}

TEST(Closure, ToriTouch) {
  for (const char* name : {"torus_chain_6", "torus_chain_14", "torus_chain_linked_14"}) {
    const TreeMotion m(name);
    const double R = m.parameter("R"), r = m.parameter("r");
    const std::vector<Moment> moments = minute(m);
    const auto poses = m.poses(moments);
    const int tori = (m.description().nq + 2) / 4;
    double gap = 0, tilt = 0, slide = 0;
    for (std::size_t i = 0; i < moments.size(); ++i) {
      const std::vector<double>& q = moments[i].q;
      // The point at rest and its normal, which is up, or down where rings hang from their inside.
      Vector3d point = Vector3d::Zero(), normal = std::string(name).find("linked") == std::string::npos
                                                      ? Vector3d(0, 0, 1)
                                                      : Vector3d(0, 0, -1);
      for (int k = 1; k <= tori; ++k) {
        const Pose& pose = poses[i].at("torus" + std::to_string(k));
        // As in the torus's implicit equation: the nearest point of its centre line is r away, along the
        // normal.
        const Vector3d x = seen_from(pose, point);
        const Vector3d nearest = R * Vector3d(x[0], x[1], 0).normalized();
        gap = std::max(gap, std::abs((x - nearest).norm() - r));
        const Vector3d own = axes(pose) * (x - nearest).normalized();
        tilt = std::max(tilt, k == 1 ? (own - normal).norm() : (own + normal).norm());
        if (k == tori) break;
        const std::size_t next = 2 + 4 * static_cast<std::size_t>(k - 1);
        const auto [contact, outward] = on_torus(R, r, q[next], q[next + 1]);
        slide = std::max(slide, std::abs(q[next + 1] - moments[0].q[next + 1]));
        point = at(pose, contact[0], contact[1], contact[2]);
        normal = axes(pose) * outward;
      }
    }
    EXPECT_LE(gap, 10 * kRounding) << name;
    EXPECT_LE(tilt, 100 * kRounding) << name;
    EXPECT_GT(slide, 0.5) << name;
  }
}

/// Where the gradient of (x/a)^2 + (y/b)^2 + (z/c)^2 points.
Vector3d ellipsoid_normal(const Vector3d& x, double a, double b, double c) {
  return Vector3d(x[0] / (a * a), x[1] / (b * b), x[2] / (c * c)).normalized();
}

TEST(Closure, ScapulaTouchesTheThorax) {
  const TreeMotion m("scapula");
  const double A = m.parameter("A"), B = m.parameter("B"), C = m.parameter("C");
  const double e = m.parameter("e"), f = m.parameter("f"), g = m.parameter("g");
  const std::vector<Moment> moments = minute(m);
  const auto poses = m.poses(moments);
  double gap = 0, tilt = 0;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const double w = moments[i].q[m.coordinate("w")], k = moments[i].q[m.coordinate("k")];
    const Vector3d own(e * std::cos(w) * std::cos(k), f * std::sin(w) * std::cos(k), g * std::sin(k));
    const Pose &scapula = poses[i].at("scapula"), &thorax = poses[i].at("thorax");
    const Vector3d x = seen_from(thorax, at(scapula, own[0], own[1], own[2]));
    gap = std::max(gap, std::abs(Vector3d(x[0] / A, x[1] / B, x[2] / C).norm() - 1));
    tilt = std::max(
        tilt, (axes(scapula) * ellipsoid_normal(own, e, f, g) + axes(thorax) * ellipsoid_normal(x, A, B, C))
                  .norm());
  }
  EXPECT_LE(gap, 10 * kRounding);
  EXPECT_LE(tilt, 100 * kRounding);
}

TEST(Closure, ShoulderBladesOfTheBodyTouchAndClaviclesFollow) {
  const TreeMotion m("upper_body");
  const double A = m.parameter("A"), B = m.parameter("B"), C = m.parameter("C");
  const std::vector<Moment> moments = minute(m);
  const auto poses = m.poses(moments);
  double gap = 0, tilt = 0, clavicle = 0;
  int counted = 0;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    for (const std::string side : {"right", "left"}) {
      const double up = side == "right" ? 1 : -1;  // direction of the blade's y
      const double p = moments[i].q[m.coordinate("p_" + side)], r = moments[i].q[m.coordinate("r_" + side)];
      const Pose &scapula = poses[i].at("scapula_" + side), &torso = poses[i].at("torso");
      const Vector3d x = seen_from(torso, at(scapula, 0.02 * p, up * 0.03 * r, 0));
      gap = std::max(gap, std::abs(Vector3d(x[0] / A, x[1] / B, x[2] / C).norm() - 1));
      tilt = std::max(tilt,
                      (axes(torso).transpose() * axes(scapula).col(2) - ellipsoid_normal(x, A, B, C)).norm());
      if (std::abs(p) > 0.3 || std::abs(r) > 0.3) continue;
      ++counted;
      clavicle = std::max(clavicle, (at(scapula, 0.05, up * 0.02, 0.03) -
                                     at(poses[i].at("clavicle_" + side), 0, -up * 0.15, 0))
                                        .norm());
    }
  }
  EXPECT_LE(gap, 10 * kRounding);
  EXPECT_LE(tilt, 100 * kRounding);
  EXPECT_GT(counted, 100);
  EXPECT_LE(clavicle, 0.009);
}

TEST(Closure, LigamentsEndAtTheShank) {
  for (const auto& [name, suffix] : std::vector<std::pair<std::string, std::string>>{
           {"knee", ""}, {"upper_body", "_right"}, {"upper_body", "_left"}}) {
    const TreeMotion m(name);
    const double a = m.parameter("a"), b = m.parameter("b"), c = m.parameter("c");
    double gap = 0;
    for (const auto& poses : m.poses(minute(m))) {
      const Pose& shank = poses.at("shank" + suffix);
      gap = std::max(gap, (at(poses.at("anterior_ligament" + suffix), a, 0, 0) - origin(shank)).norm());
      gap =
          std::max(gap, (at(poses.at("posterior_ligament" + suffix), c, 0, 0) - at(shank, -b, 0, 0)).norm());
    }
    EXPECT_LE(gap, kRounding) << name << suffix;
  }
}

TEST(Closure, LoopsOfTheTongClose) {
  const TreeMotion m("tong");
  int bars = 0;
  for (const oracles::Body& body : m.description().bodies)
    bars += body.name[0] == 'a' || body.name[0] == 'b' ? 1 : 0;
  ASSERT_EQ(bars, 32);
  ASSERT_EQ(m.description().nv, 3);
  const double h = m.parameter("h");
  const auto states = random_states(m, 50);
  const auto all = m.poses(states);
  double gap = 0;
  for (const auto& poses : all) {
    for (int k = 1; k <= bars / 2; ++k) {
      const Pose &a = poses.at("a" + std::to_string(k)), &b = poses.at("b" + std::to_string(k));
      gap = std::max(gap, (origin(a) - origin(b)).norm());
      if (k == bars / 2) break;
      gap = std::max(gap, (at(a, h, 0, 0) - at(poses.at("b" + std::to_string(k + 1)), -h, 0, 0)).norm());
      gap = std::max(gap, (at(b, h, 0, 0) - at(poses.at("a" + std::to_string(k + 1)), -h, 0, 0)).norm());
    }
  }
  EXPECT_LE(gap, kRounding);
  // The pairs open evenly, one after the other along a line.
  const Vector3d first = origin(all[0].at("a1")), second = origin(all[0].at("a2")),
                 last = origin(all[0].at("a16"));
  EXPECT_NEAR((last - first).norm(), 15 * 2 * h * std::abs(std::cos(states[0].second[0])), kRounding);
  EXPECT_NEAR((second - first).cross(last - first).norm(), 0, kRounding);
}

}  // namespace
}  // namespace alembert::test
