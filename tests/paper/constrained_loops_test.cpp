// Loops without a closed form: assembled from a guess by Newton's method, closed for a minute, and what
// redundant and contradictory rows come to.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <contradiction/contradiction.hpp>
#include <five_bar/five_bar.hpp>
#include <five_bar_in_space/five_bar_in_space.hpp>
#include <out_of_reach/out_of_reach.hpp>
#include <stewart/stewart.hpp>
#include <string>
#include <vector>

#include "paper/constrained_simulation.hpp"

namespace alembert::test {
namespace {

using FiveBar = mechanisms::five_bar::Mechanism<double>;
using FiveBarInSpace = mechanisms::five_bar_in_space::Mechanism<double>;
using Stewart = mechanisms::stewart::Mechanism<double>;
using OutOfReach = mechanisms::out_of_reach::Mechanism<double>;
using Contradiction = mechanisms::contradiction::Mechanism<double>;

template <class M>
double largest_gap(const Simulation<M>& s) {
  typename M::ConstraintMatrix P;
  typename M::ConstraintVector gamma, velocity, position;
  M::constraints(s.q, s.u, s.in, P, gamma, velocity, position);
  return position.cwiseAbs().maxCoeff();
}

/// Tip of the five-bar's left or right half, by hand.
Eigen::Vector2d tip(double pivot, double shoulder, double elbow) {
  return {pivot - 0.3 * std::sin(shoulder) - 0.42 * std::sin(shoulder + elbow),
          -0.3 * std::cos(shoulder) - 0.42 * std::cos(shoulder + elbow)};
}

TEST(Loops, FiveBarIsAssembledFromAGuess) {
  Simulation<FiveBar> s;
  EXPECT_GT(largest_gap(s), 0.02);
  const FiveBar::CoordinateVector guess = s.q;
  ASSERT_EQ(s.make_consistent(), Status::ok);
  EXPECT_LT((tip(-0.125, s.q[0], s.q[1]) - tip(0.125, s.q[2], s.q[3])).norm(), 1e-12);
  EXPECT_LT((s.q - guess).norm(), 0.6);
}

TEST(Loops, FiveBarCanBeAssembledWithItsShouldersHeld) {
  Simulation<FiveBar> s;
  const FiveBar::CoordinateVector guess = s.q;
  ProjectionOptionsOf<FiveBar> options;
  options.held.resize(4);
  options.held << true, false, true, false;
  ASSERT_EQ(consistent_state<FiveBar>(s.q, s.u, s.in, s.report, options), Status::ok);
  EXPECT_EQ(s.q[0], guess[0]);
  EXPECT_EQ(s.q[2], guess[2]);
  EXPECT_LT((tip(-0.125, s.q[0], s.q[1]) - tip(0.125, s.q[2], s.q[3])).norm(), 1e-12);
}

/// Legs of the Stewart platform as they are driven.
double leg_length(int leg, double t) {
  constexpr double kPhase[] = {0, 2, 4.5, 1, 3.2, 5.5};
  return 0.68 + 0.05 * std::sin(1.7 * t + kPhase[leg]);
}
double leg_rate(int leg, double t) {
  constexpr double kPhase[] = {0, 2, 4.5, 1, 3.2, 5.5};
  return 0.05 * 1.7 * std::cos(1.7 * t + kPhase[leg]);
}

/// Distance between the joints of leg 0 to 5 on the ground and on the platform.
double joint_distance(const Simulation<Stewart>& s, int leg) {
  constexpr double kGround[] = {10, 110, 130, 230, 250, 350}, kPlatform[] = {50, 70, 170, 190, 290, 310};
  const auto on_circle = [](double radius, double degrees) -> Eigen::Vector3d {
    const double angle = degrees * 3.14159265358979323846 / 180;
    return {radius * std::cos(angle), radius * std::sin(angle), 0};
  };
  const auto pose = Stewart::body_poses(s.q, s.in)[0];
  return (pose.leftCols<3>() * on_circle(0.3, kPlatform[leg]) + pose.col(3) - on_circle(0.5, kGround[leg]))
      .norm();
}

// The platform's joints are as far from the ground's as the drives say; and the drives' work, integrated from
// their forces, is the change of the energy.
TEST(Loops, StewartPlatformFollowsItsDrives) {
  Simulation<Stewart> s;
  EXPECT_GT(largest_gap(s), 0.1);
  ASSERT_EQ(s.make_consistent(), Status::ok);
  EXPECT_EQ(s.report.rank, 24);
  const double start = s.energy();
  double worst_length = 0, worst_gap = 0, work = 0, worst_work = 0, least_power = 0, most_power = 0;
  const double h = 4e-3;
  std::vector<double> powers;  // of the last two steps, for Simpson's rule
  ASSERT_EQ(s.run(60, h,
                  [&] {
                    for (int leg = 0; leg < 6; ++leg)
                      worst_length =
                          std::max(worst_length, std::abs(joint_distance(s, leg) - leg_length(leg, s.in.t)));
                    worst_gap = std::max(worst_gap, largest_gap(s));
                    ConstrainedMotionOf<Stewart> motion;
                    ASSERT_EQ(constrained_forward_dynamics<Stewart>(s.q, s.u, Stewart::SpeedVector::Zero(),
                                                                    s.in, motion),
                              Status::ok);
                    double power = 0;
                    for (int leg = 0; leg < 6; ++leg)
                      power += motion.lambda[18 + leg] * leg_rate(leg, s.in.t);
                    least_power = std::min(least_power, power);
                    most_power = std::max(most_power, power);
                    powers.push_back(power);
                    if (powers.size() < 3) return;
                    work += h / 3 * (powers[0] + 4 * powers[1] + powers[2]);
                    powers.erase(powers.begin(), powers.begin() + 2);
                    worst_work = std::max(worst_work, std::abs(s.energy() - start - work));
                  }),
            Status::ok);
  EXPECT_LT(worst_length, 1e-10);
  EXPECT_LT(worst_gap, 1e-10);
  EXPECT_LT(worst_work, 1e-8);
  EXPECT_GT(most_power - least_power, 1);
}

// The legs bear the platform: at rest the sum of the forces on it is its weight. Here by virtual work of the
// drives.
TEST(Loops, RedundantRowIsNamed) {
  Simulation<FiveBarInSpace> s;
  ASSERT_EQ(s.make_consistent(), Status::ok);
  EXPECT_EQ(s.report.rank, 2);
  std::vector<std::string> redundant;
  for (int row = 0; row < FiveBarInSpace::kNc; ++row)
    if (s.report.redundant[row])
      redundant.emplace_back(FiveBarInSpace::kConstraintNames[static_cast<std::size_t>(row)]);
  EXPECT_THAT(redundant, testing::ElementsAre("loop[1]"));
}

TEST(Loops, RedundantRowChangesNothing) {
  Simulation<FiveBar> plane;
  Simulation<FiveBarInSpace> space;
  plane.u << 1, 0, -2, 0;
  space.u = plane.u;
  ASSERT_EQ(plane.make_consistent(), Status::ok);
  ASSERT_EQ(space.make_consistent(), Status::ok);
  ASSERT_EQ(plane.run(2, 1e-3, [] {}), Status::ok);
  ASSERT_EQ(space.run(2, 1e-3, [] {}), Status::ok);
  EXPECT_LT((plane.q - space.q).norm(), 1e-9);
}

// Until the pull is above rounding the second row is redundant; then the run stops, names it, and keeps the
// state.
TEST(Loops, ContradictionStopsWithItsNameAndTime) {
  Simulation<Contradiction> s;
  s.u << 0, 1;
  ASSERT_EQ(s.make_consistent(), Status::ok);
  EXPECT_TRUE(s.report.redundant[1]);
  ASSERT_EQ(s.run(2, 1e-3, [] {}), Status::inconsistent_constraints);
  EXPECT_GT(s.in.t, 0.5);
  EXPECT_LT(s.in.t, 1.6);
  ASSERT_EQ(s.report.inconsistent_row, 1);
  EXPECT_STREQ(Contradiction::kConstraintNames[1], "pull");
  EXPECT_NEAR(s.q[1], s.in.t, 1e-12);
}

// At t = 1 the tip is straight below the pivot and asked to go further.
TEST(Loops, RunStopsWhereALoopCannotBeClosed) {
  Simulation<OutOfReach> s;
  ASSERT_EQ(s.make_consistent(), Status::ok);
  const Status status = s.run(2, 1e-3, [] {});
  EXPECT_THAT(status, testing::AnyOf(Status::inconsistent_constraints, Status::no_convergence));
  EXPECT_NEAR(s.in.t, 1, 0.01);
  EXPECT_TRUE(s.q.allFinite());
  EXPECT_NEAR(s.q[1], 0.5, 1e-9);
}

}  // namespace
}  // namespace alembert::test
