// Shortest turns take one direction to the other, about an axis across both.
#include <gtest/gtest.h>

#include <cmath>

#include "support/shortest_turn.hpp"

namespace alembert::test {
namespace {

using Eigen::Vector3d;

TEST(ShortestTurn, TakesOneDirectionToTheOther) {
  const Vector3d directions[] = {{0, 0, 1},       {0, 0, -1},       {1, 0, 0},      {-0.3, 0.2, 2},
                                 {0.3, -0.2, -2}, {1e-9, 0, -1e-3}, {0, 1e-14, -1}, {1e100, 1, 1e3},
                                 {1e-3, 0, -1},   {1e-7, 2e-7, -1}, {3e-9, 0, 1}};
  for (const Vector3d& from : directions) {
    for (const Vector3d& to : directions) {
      const Eigen::Quaterniond turn = shortest_turn(from, to);
      EXPECT_NEAR(turn.norm(), 1, 1e-14);
      EXPECT_LT((turn * from.normalized() - to.normalized()).norm(), 2e-15) << from << "\nto\n" << to;
      const Vector3d a = from.normalized(), b = to.normalized();
      EXPECT_NEAR(Eigen::AngleAxisd(turn).angle(), 2 * std::atan2((a - b).norm(), (a + b).norm()), 1e-14);
    }
  }
}

TEST(ShortestTurn, HalfATurnIsAboutTheAxisLeastAlong) {
  EXPECT_TRUE(shortest_turn({0, 0, 2}, {0, 0, -1}).coeffs().isApprox(Eigen::Vector4d(1, 0, 0, 0)));
  EXPECT_TRUE(shortest_turn({1, 0, 0}, {-5, 0, 0}).coeffs().isApprox(Eigen::Vector4d(0, 1, 0, 0)));
}

}  // namespace
}  // namespace alembert::test
