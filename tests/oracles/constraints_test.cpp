// The constraints of the numeric Lagrangian against formulas: rows, accelerations and reactions that
// textbooks have.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <string>

#include "oracles/random_mechanism.hpp"
#include "oracles/taylor/numeric_constraints.hpp"
#include "oracles/taylor/numeric_lagrangian.hpp"
#include "oracles/taylor/poses.hpp"

namespace alembert::oracles {
namespace {

constexpr double kGravity = 9.81;

Description paper_mechanism(const std::string& name) {
  return read_description(std::string(ALEMBERT_SOURCE_DIR) + "/mechanisms/paper/" + name + ".yaml");
}

/// Motion under no forces but gravity.
ConstrainedMotion unforced(const Description& description, const State& state) {
  State at_rest = state;
  at_rest.rates.assign(state.speeds.size(), 0);
  Dynamics dynamics = numeric_lagrangian(description, at_rest);
  dynamics.tau.setZero();
  return constrained_motion(dynamics, numeric_constraints(description, at_rest));
}

std::vector<State> consistent_states(const Description& description, int count) {
  std::mt19937_64 random(17);
  std::vector<State> states;
  for (int i = 0; i < count; ++i)
    states.push_back(with_consistent_speeds(description, random_state(description, random)));
  return states;
}

// v' = a w^2, J w' = -m a v w, and the edge bears m (v w + a w').
TEST(Constraints, ChaplyginsSleigh) {
  const Description d = paper_mechanism("chaplygin_sleigh");
  const double m = d.parameter("m"), a = d.parameter("a"), J = d.parameter("I") + m * a * a;
  for (const State& state : consistent_states(d, 20)) {
    const double c = std::cos(state.q[2]), s = std::sin(state.q[2]), w = state.speeds[2];
    const double v = c * state.speeds[0] + s * state.speeds[1];
    EXPECT_NEAR(c * state.speeds[1] - s * state.speeds[0], 0, 1e-14);
    const ConstrainedMotion motion = unforced(d, state);
    const double v_rate = a * w * w, w_rate = -m * a * v * w / J;
    EXPECT_NEAR(motion.rates[0], c * v_rate - s * v * w, 1e-12);
    EXPECT_NEAR(motion.rates[1], s * v_rate + c * v * w, 1e-12);
    EXPECT_NEAR(motion.rates[2], w_rate, 1e-12);
    EXPECT_NEAR(motion.multipliers[0], m * (v * w + a * w_rate), 1e-12);
  }
}

// In a steady motion lean, d(heading) and d(roll) have no rates, at every lean and rate of the heading.
TEST(Constraints, DiscInSteadyMotion) {
  const Description d = paper_mechanism("rolling_disc");
  const double R = d.parameter("R"), m = d.parameter("m"), A = m * R * R / 4, C = m * R * R / 2;
  for (const double lean : {-0.9, 0.2, 0.7}) {
    for (const double W : {-2.1, 1.3, 4.0}) {
      const double w = (A * W * W * std::sin(lean) * std::cos(lean) - m * kGravity * R * std::sin(lean)) /
                       ((C + m * R * R) * W * std::cos(lean));
      const double roll = w - W * std::sin(lean), heading = 0.8;
      const State state{{0.1, -0.2, heading, lean, 0.4},
                        {R * roll * std::cos(heading), R * roll * std::sin(heading), W, 0, roll},
                        {},
                        0,
                        {}};
      const ConstrainedMotion motion = unforced(d, state);
      EXPECT_NEAR(motion.rates[0], -R * roll * std::sin(heading) * W, 1e-11);
      EXPECT_NEAR(motion.rates[1], R * roll * std::cos(heading) * W, 1e-11);
      for (int k = 2; k < 5; ++k) EXPECT_NEAR(motion.rates[k], 0, 1e-11);
    }
  }
}

/// Velocity and acceleration of a body's centre of mass in the world, with com at the body's origin.
struct PointMotion {
  Eigen::Vector3d position, velocity, acceleration;
};
PointMotion origin_of(const Description& d, const State& state, const Eigen::VectorXd& rates,
                      std::size_t body) {
  const auto q = trajectory(d, state, {rates.data(), rates.data() + rates.size()});
  const auto p = world_poses(d, q, Jet<double>(state.time, 1, 0))[body].translation;
  return {{p[0].value, p[1].value, p[2].value},
          {p[0].first, p[1].first, p[2].first},
          {p[0].second, p[1].second, p[2].second}};
}

// Of the centre of a ball on a turntable: v' = 2/7 rate (0 0 1) x v. No slip: v + om x (-a z) = rate z x r.
TEST(Constraints, BallOnATurntable) {
  const Description d = paper_mechanism("rolling_ball");
  const double rate = d.parameter("rate");
  for (const State& state : consistent_states(d, 20)) {
    const ConstrainedMotion motion = unforced(d, state);
    EXPECT_LT(motion.inconsistency, 1e-10);
    const PointMotion centre = origin_of(d, state, motion.rates, 1);
    const Eigen::Vector3d expected = 2.0 / 7 * rate * Eigen::Vector3d::UnitZ().cross(centre.velocity);
    EXPECT_NEAR((centre.acceleration - expected).norm(), 0, 1e-10);
  }
}

// The rate of a row is P du/dt + gamma: rolling, holonomic and pfaffian rows, by central differences of
// order 4.
TEST(Constraints, GammaIsTheRateOfVelocity) {
  for (const char* name : {"rolling_ellipsoids", "rolling_ball", "rolling_disc", "five_bar", "stewart"}) {
    const Description d = paper_mechanism(name);
    std::mt19937_64 random(5);
    const State state = random_state(d, random);
    const ConstraintRows rows = numeric_constraints(d, state);
    const Eigen::VectorXd rates = Eigen::Map<const Eigen::VectorXd>(state.rates.data(), d.nv);
    const auto velocity = [&](double h) {
      State moved = state;
      const auto q = trajectory(d, state, state.rates);
      for (std::size_t i = 0; i < q.size(); ++i) moved.q[i] += h * q[i].first + h * h / 2 * q[i].second;
      for (std::size_t k = 0; k < moved.speeds.size(); ++k) moved.speeds[k] += h * state.rates[k];
      moved.time += h;
      return numeric_constraints(d, moved).velocity.eval();
    };
    const double h = 1e-3;
    const Eigen::VectorXd rate =
        (8 * (velocity(h) - velocity(-h)) - (velocity(2 * h) - velocity(-2 * h))) / (12 * h);
    const Eigen::VectorXd expected = rows.P * rates + rows.gamma;
    EXPECT_LT((rate - expected).cwiseAbs().maxCoeff(), 1e-7 * std::max(1.0, expected.cwiseAbs().maxCoeff()))
        << name;
  }
}

// What random mechanisms test is there: each type of constraint, many times in 200.
TEST(Constraints, OfRandomMechanismsAreOfAllTypes) {
  std::array<int, 3> found{};
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    for (const Constraint& constraint : parse_description(random_mechanism(seed)).constraints)
      ++found[static_cast<std::size_t>(constraint.kind)];
  }
  EXPECT_GT(found[static_cast<std::size_t>(ConstraintKind::pfaffian)], 20);
  EXPECT_GT(found[static_cast<std::size_t>(ConstraintKind::rolling)], 8);
  EXPECT_GT(found[static_cast<std::size_t>(ConstraintKind::holonomic)], 40);
}

// A weight held by its position bears its weight, one held twice bears it together, and nothing moves.
TEST(Constraints, ReactionOfAHangingWeight) {
  for (const char* again : {"", "  - {name: too, type: holonomic, equations: [2*z]}\n"}) {
    const Description d = parse_description(std::string(R"(
name: weight
coordinates: [x, z, tilt]
bodies:
  - name: weight
    transform: [{translate: [x, 0, z]}, {rotate: {axis: y, angle: tilt}}]
    mass: 3
    inertia: {xx: 1, yy: 1, zz: 1}
constraints:
  - {name: hook, type: holonomic, equations: [x, z]}
)") + again);
    const State state{{0, 0, 0.3}, {0, 0, 0}, {0, 0, 0}, 0, {}};
    const ConstrainedMotion motion = unforced(d, state);
    const ConstraintRows rows = numeric_constraints(d, state);
    EXPECT_NEAR(motion.rates.norm(), 0, 1e-13);
    const Eigen::VectorXd force = rows.P.transpose() * motion.multipliers;
    EXPECT_NEAR(force[0], 0, 1e-12);
    EXPECT_NEAR(force[1], 3 * kGravity, 1e-12);
    EXPECT_EQ(std::isinf(motion.condition) || motion.condition > 1e12, rows.gamma.size() == 3);
  }
}

}  // namespace
}  // namespace alembert::oracles
