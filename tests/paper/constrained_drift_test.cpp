// What a minute of motion does to constraints and energy: no slip within 1e-8 m/s, loops closed, energy
// within 1e-5 of the largest kinetic energy.
#include <gtest/gtest.h>

#include <cstdio>
#include <five_bar/five_bar.hpp>
#include <rattleback/rattleback.hpp>
#include <rolling_disc/rolling_disc.hpp>
#include <rolling_ellipsoids/rolling_ellipsoids.hpp>

#include "paper/constrained_simulation.hpp"

namespace alembert::test {
namespace {

using Ellipsoids = mechanisms::rolling_ellipsoids::Mechanism<double>;
using Disc = mechanisms::rolling_disc::Mechanism<double>;
using Rattleback = mechanisms::rattleback::Mechanism<double>;
using FiveBar = mechanisms::five_bar::Mechanism<double>;

constexpr double kMinute = 60, kSlip = 1e-8, kEnergy = 1e-5;

template <class M>
void expect_small_drift(const typename M::SpeedVector& speeds, double h, double gap) {
  Simulation<M> s;
  s.u = speeds;
  ASSERT_EQ(s.make_consistent(), Status::ok);
  EXPECT_EQ(s.report.rank, M::kNc);
  Drift<M> drift(s);
  ASSERT_EQ(s.run(kMinute, h, [&] { drift.observe(); }), Status::ok);
  std::printf("slip %.1e, gap %.1e, energy %.1e of the largest kinetic energy\n", drift.slip, drift.gap,
              drift.relative_energy());
  EXPECT_LT(drift.slip, kSlip);
  EXPECT_LE(drift.gap, gap);
  EXPECT_LT(drift.relative_energy(), kEnergy);
  EXPECT_GT(drift.kinetic, 0);
}

TEST(Drift, RollingEllipsoids) {
  expect_small_drift<Ellipsoids>({1.2, 0.5, 0, 0, 1.5}, 1e-3, 0);
}
TEST(Drift, RollingDisc) {
  expect_small_drift<Disc>({2.4, 0, -2, 0, 6}, 1e-3, 0);
}
TEST(Drift, Rattleback) {
  expect_small_drift<Rattleback>({0, 0, 0, 0, -5}, 2e-4, 0);
}
TEST(Drift, FiveBar) {
  expect_small_drift<FiveBar>({1, 0, -2, 0}, 5e-4, 1e-10);
}

// Slip without the generated rows: the point of the ellipsoid at the contact has no velocity at all, by
// central differences of order 4 of its pose along the speeds.
TEST(Drift, TheMaterialPointOfTheEllipsoidAtTheContactIsAtRest) {
  const double a = 0.4, b = 0.25, c = 0.2;
  Simulation<Ellipsoids> s;
  s.u << 1.2, 0.5, 0, 0, 1.5;
  ASSERT_EQ(s.make_consistent(), Status::ok);
  double worst = 0, fastest = 0;
  for (int second = 0; second < 60; ++second) {
    ASSERT_EQ(s.run(1, 1e-3, [] {}), Status::ok);
    const double lon = s.q[2], lat = s.q[3], h = 1e-3;
    const Eigen::Vector4d point(a * std::sin(lat), b * std::cos(lat) * std::sin(lon),
                                -c * std::cos(lat) * std::cos(lon), 1);
    const auto at = [&](double step) -> Eigen::Matrix<double, 3, 4> {
      return Ellipsoids::body_poses(s.q + step * s.u, s.in)[0];
    };
    const Eigen::Matrix<double, 3, 4> rate = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
    worst = std::max(worst, (rate * point).norm());
    fastest = std::max(fastest, rate.col(3).norm());
  }
  EXPECT_LT(worst, 1e-8);
  EXPECT_GT(fastest, 0.5);
}

}  // namespace
}  // namespace alembert::test
