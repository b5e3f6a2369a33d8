#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/inverse_diagonal.hpp"

namespace alembert {
namespace {

TEST(InverseDiagonal, OfAHilbertMatrixIsThatOfItsInverseInIntegers) {
  Eigen::MatrixXd A(4, 4);
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) A(r, c) = 1.0 / (r + c + 1);
  const std::optional<Eigen::VectorXd> found = inverse_diagonal(A);
  ASSERT_TRUE(found);
  const Eigen::Vector4d exact(16, 1200, 6480, 2800);
  for (int k = 0; k < 4; ++k) EXPECT_NEAR((*found)(k), exact(k), 1e-11 * exact(k));
}

TEST(InverseDiagonal, IsNothingForWhatIsNotPositiveDefinite) {
  EXPECT_FALSE(inverse_diagonal(Eigen::Matrix2d{{1, 2}, {2, 1}}));
  EXPECT_FALSE(inverse_diagonal(Eigen::Matrix2d::Zero()));
  EXPECT_FALSE(inverse_diagonal(Eigen::Matrix2d{{1, 0}, {0, std::numeric_limits<double>::quiet_NaN()}}));
  EXPECT_EQ(inverse_diagonal(Eigen::MatrixXd(0, 0))->size(), 0);
}

}  // namespace
}  // namespace alembert
