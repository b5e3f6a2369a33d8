// Shortest turns take one direction to the other, about an axis across both.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/shortest_turn.hpp"

namespace alembert::test {
namespace {

using Eigen::Vector3d;

TEST(ShortestTurn, TakesOneDirectionToTheOther) {
  const Vector3d directions[] = {{0, 0, 1},       {0, 0, -1},       {1, 0, 0},      {-0.3, 0.2, 2},
                                 {0.3, -0.2, -2}, {1e-9, 0, -1e-3}, {0, 1e-14, -1}, {1e100, 1, 1e3}};
  for (const Vector3d& from : directions) {
    for (const Vector3d& to : directions) {
      const Eigen::Quaterniond turn = shortest_turn(from, to);
      EXPECT_NEAR(turn.norm(), 1, 1e-11);
      EXPECT_LT((turn * from.normalized() - to.normalized()).norm(), 3e-6) << from << "\nto\n" << to;
      const double angle = std::acos(std::clamp(from.normalized().dot(to.normalized()), -1.0, 1.0));
      EXPECT_NEAR(Eigen::AngleAxisd(turn).angle(), angle, 3e-6);
    }
  }
}

TEST(ShortestTurn, HalfATurnIsAboutTheAxisLeastAlong) {
  EXPECT_TRUE(shortest_turn({0, 0, 2}, {0, 0, -1}).coeffs().isApprox(Eigen::Vector4d(1, 0, 0, 0)));
  EXPECT_TRUE(shortest_turn({1, 0, 0}, {-5, 0, 0}).coeffs().isApprox(Eigen::Vector4d(0, 1, 0, 0)));
}

}  // namespace
}  // namespace alembert::test
