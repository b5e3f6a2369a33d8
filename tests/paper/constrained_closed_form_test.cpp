// Motions under constraints that are known in closed form, or by name: Chaplygin's sleigh, a disc in steady
// motion, a ball on a turntable, the rattleback, a weight on a hook.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <chaplygin_sleigh/chaplygin_sleigh.hpp>
#include <rattleback/rattleback.hpp>
#include <rolling_ball/rolling_ball.hpp>
#include <rolling_disc/rolling_disc.hpp>
#include <weight/weight.hpp>

#include "paper/constrained_simulation.hpp"

namespace alembert::test {
namespace {

using Sleigh = mechanisms::chaplygin_sleigh::Mechanism<double>;
using Disc = mechanisms::rolling_disc::Mechanism<double>;
using Ball = mechanisms::rolling_ball::Mechanism<double>;
using Rattleback = mechanisms::rattleback::Mechanism<double>;
using Weight = mechanisms::weight::Mechanism<double>;

constexpr double kG = 9.81;

// v = V tanh(k t), w = V sqrt(m/J) sech(k t), heading' = w, from t = -3/k, when it goes backwards, to 3/k.
TEST(ClosedForm, ChaplyginsSleigh) {
  const double m = 1.4, a = 0.35, J = 0.11 + m * a * a, V = 0.9, k = m * a * V / J;
  const auto speed = [&](double t) { return V * std::tanh(k * t); };
  const auto turn = [&](double t) { return V * std::sqrt(m / J) / std::cosh(k * t); };
  const auto heading = [&](double t) {
    return 2 * V * std::sqrt(m / J) / k * std::atan(std::tanh(k * t / 2));
  };
  const double start = -3 / k;
  Simulation<Sleigh> s;
  s.q << 0, 0, heading(start);
  s.u << speed(start) * std::cos(s.q[2]), speed(start) * std::sin(s.q[2]), turn(start);
  double worst = 0;
  ASSERT_EQ(s.run(6 / k, 1e-3 / k,
                  [&] {
                    const double t = start + s.in.t;
                    const double v = s.u[0] * std::cos(s.q[2]) + s.u[1] * std::sin(s.q[2]);
                    worst = std::max({worst, std::abs(v - speed(t)), std::abs(s.u[2] - turn(t)),
                                      std::abs(s.q[2] - heading(t))});
                  }),
            Status::ok);
  EXPECT_LT(worst, 1e-10);
  EXPECT_NEAR(s.u.head<2>().norm(), speed(3 / k), 1e-10);  // it goes forwards at last
}

// A W^2 sin cos - (C + m R^2) w W cos - m g R sin = 0 (rolling_disc.yaml): the lean and the rates stay, and
// the contact goes round a circle of radius R d(roll) / W.
TEST(ClosedForm, DiscInSteadyMotion) {
  const double R = 0.4, m = 1.2, A = m * R * R / 4, C = m * R * R / 2;
  for (const double W : {-2.0, 3.5}) {
    Simulation<Disc> s;
    const double lean = s.q[3], sine = std::sin(lean), cosine = std::cos(lean);
    const double w = (A * W * W * sine * cosine - m * kG * R * sine) / ((C + m * R * R) * W * cosine);
    const double roll = w - W * sine, heading = s.q[2];
    s.u << R * roll * std::cos(heading), R * roll * std::sin(heading), W, 0, roll;
    const Disc::CoordinateVector start = s.q;
    double worst = 0;
    ASSERT_EQ(s.run(60, 1e-3,
                    [&] {
                      const double angle = heading + W * s.in.t, radius = R * roll / W;
                      const double x = radius * (std::sin(angle) - std::sin(heading)),
                                   y = radius * (std::cos(heading) - std::cos(angle));
                      worst = std::max({worst, std::abs(s.q[0] - start[0] - x),
                                        std::abs(s.q[1] - start[1] - y), std::abs(s.q[3] - lean),
                                        std::abs(s.u[2] - W), std::abs(s.u[3]), std::abs(s.u[4] - roll)});
                    }),
              Status::ok);
    EXPECT_LT(worst, 1e-8) << "d(heading) = " << W;
  }
}

// The centre goes round a circle at 2/7 of the table's rate, whatever the start: r = c + rho, v = 2/7 rate z
// x rho.
void expect_circle(double x_rate, double turn_rate) {
  const double rate = 1.4, a = 0.12, p = 2.0 / 7 * rate;
  Simulation<Ball> s;
  s.u << x_rate, -0.64, -0.64 / a, x_rate / a, turn_rate;
  ASSERT_EQ(s.make_consistent(), Status::ok);
  const auto centre = [&]() -> Eigen::Vector3d { return Ball::body_poses(s.q, s.in)[1].col(3); };
  const double x = s.q[0], y = s.q[1];  // in the table's axes, which are the room's at t = 0
  const Eigen::Vector2d r(x, y), v(s.u[0] - rate * y, s.u[1] + rate * x);
  const Eigen::Vector2d rho(v.y() / p, -v.x() / p), c = r - rho;
  double worst = 0;
  ASSERT_EQ(
      s.run(60, 1e-3,
            [&] {
              const Eigen::Vector2d expected = c + Eigen::Rotation2Dd(p * s.in.t) * rho;
              worst = std::max({worst, (centre().head<2>() - expected).norm(), std::abs(centre().z() - a)});
            }),
      Status::ok);
  EXPECT_LT(worst, 1e-8);
  EXPECT_GT(c.norm(), 0.05);  // not about the table's axis
}
TEST(ClosedForm, BallOnATurntable) {
  expect_circle(0, -1);
}
TEST(ClosedForm, BallOnATurntableThatSpinsAndWanders) {
  expect_circle(0.2, -1);
}

/// Spins of a rattleback about the vertical after some seconds, with a small lean to begin with.
struct Spin {
  double after_4, after_10, least, most;
};
Spin rattleback_spin(double spin) {
  Simulation<Rattleback> s;
  s.u[4] = spin;
  EXPECT_EQ(s.make_consistent(), Status::ok);
  Spin result{0, 0, spin, spin};
  EXPECT_EQ(s.run(10, 1e-4,
                  [&] {
                    const double now = s.u[4];
                    if (s.in.t < 4.00005) result.after_4 = now;
                    result.after_10 = now;
                    result.least = std::min(result.least, now);
                    result.most = std::max(result.most, now);
                  }),
            Status::ok);
  return result;
}

// Spun in the wrong sense it rattles lengthwise and has turned back after 4 s. Spun in the other it goes on:
// what it does then, to rock sideways and turn back too, is weaker by an order (A. Garcia and M. Hubbard,
// Proc. Royal Society A 418 (1988)).
TEST(ClosedForm, RattlebackReverses) {
  const Spin wrong = rattleback_spin(-5);
  EXPECT_GT(wrong.after_4, 0.2);
  EXPECT_GT(wrong.after_10, 4.5);  // nearly all of its spin, the other way round
  const Spin right = rattleback_spin(5);
  EXPECT_GT(right.after_4, 4.9);
  EXPECT_GT(right.least, 4.5);
}

TEST(ClosedForm, HookBearsTheWeight) {
  ConstrainedMotionOf<Weight> motion;
  ASSERT_EQ(constrained_forward_dynamics<Weight>({0, 0, 0.3}, {0, 0, 0.7}, {0, 0, 0}, {}, motion),
            Status::ok);
  EXPECT_NEAR(motion.lambda[0], 0, 1e-13);
  EXPECT_NEAR(motion.lambda[1], 3 * kG, 1e-13);
  EXPECT_NEAR(motion.qdd.norm(), 0, 1e-13);
}

}  // namespace
}  // namespace alembert::test
