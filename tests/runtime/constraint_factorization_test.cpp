// The bordered equations, against a dense solution of the same by complete pivoting: random sizes and ranks.
#include "alembert/constraint_factorization.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <random>

namespace {

using alembert::Status;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Factorization = alembert::ConstraintFactorization<double, Eigen::Dynamic, Eigen::Dynamic>;

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1));
  }
  MatrixXd matrix(Eigen::Index rows, Eigen::Index columns) {
    MatrixXd out(rows, columns);
    for (Eigen::Index j = 0; j < columns; ++j)
      for (Eigen::Index i = 0; i < rows; ++i) out(i, j) = static_cast<double>(engine_()) * 0x1p-31 - 1.0;
    return out;
  }
  MatrixXd positive_definite(Eigen::Index n) {
    const MatrixXd A = matrix(n, n);
    return A * A.transpose() + 0.1 * MatrixXd::Identity(n, n);
  }

 private:
  std::mt19937 engine_;
};

struct Solution {
  VectorXd x, force;  ///< P^T lambda: lambda itself is not unique
};

Solution dense_solution(const MatrixXd& M, const MatrixXd& P, const VectorXd& b, const VectorXd& r) {
  const Eigen::Index n = M.rows(), k = P.rows();
  MatrixXd A = MatrixXd::Zero(n + k, n + k);
  A << M, -P.transpose(), P, MatrixXd::Zero(k, k);
  VectorXd right(n + k);
  right << b, r;
  const VectorXd y = A.fullPivLu().solve(right);
  return {y.head(n), P.transpose() * y.tail(k)};
}

TEST(ConstraintFactorization, EqualsTheDenseSolution) {
  Random random(1);
  int deficient = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const int n = random.integer(1, 12), k = random.integer(1, 12), rank = random.integer(1, std::min(n, k));
    const MatrixXd M = random.positive_definite(n);
    const MatrixXd mix = random.matrix(k, rank), P = mix * random.matrix(rank, n);
    const VectorXd b = random.matrix(n, 1), r = P * random.matrix(n, 1);  // consistent
    Factorization factorization;
    ASSERT_EQ(factorization.factor(M, P), Status::ok);
    ASSERT_EQ(factorization.rank(), rank) << "trial " << trial;
    ASSERT_EQ(factorization.redundant().count(), k - rank);
    deficient += rank < k ? 1 : 0;
    VectorXd x, lambda;
    ASSERT_EQ(factorization.solve(b, r, x, lambda), -1) << "trial " << trial;
    const Solution expected = dense_solution(M, P, b, r);
    const double scale = 1 + expected.x.norm() + expected.force.norm();
    EXPECT_LT((x - expected.x).norm(), 1e-9 * scale) << "trial " << trial;
    EXPECT_LT((P.transpose() * lambda - expected.force).norm(), 1e-9 * scale) << "trial " << trial;
    EXPECT_LT((P * x - r).norm(), 1e-11 * scale) << "trial " << trial;
    for (int i = 0; i < k; ++i) EXPECT_TRUE(!factorization.redundant(i) || lambda(i) == 0);
  }
  EXPECT_GT(deficient, 100);
}

TEST(ConstraintFactorization, NamesTheRowThatContradictsTheOthers) {
  Random random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const int n = random.integer(3, 9);
    const MatrixXd M = random.positive_definite(n);
    MatrixXd P = random.matrix(3, n);
    P.row(2) = P.row(0) - 2 * P.row(1);
    VectorXd r = P * random.matrix(n, 1), x, lambda;
    Factorization factorization;
    ASSERT_EQ(factorization.factor(M, P), Status::ok);
    ASSERT_EQ(factorization.rank(), 2);
    ASSERT_EQ(factorization.solve(VectorXd::Zero(n), r, x, lambda), -1);
    r(0) += 1e-3;
    const int row = factorization.solve(VectorXd::Zero(n), r, x, lambda);
    ASSERT_GE(row, 0);
    EXPECT_TRUE(factorization.redundant(row));
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(i == row || std::abs((P * x)(i)-r(i)) < 1e-10);
  }
}

TEST(ConstraintFactorization, OfEqualRowsTheFirstStays) {
  const MatrixXd M = MatrixXd::Identity(3, 3);
  MatrixXd P(4, 3);
  P << 0, 1, 0, 1, 2, 3, 0, 5, 0, 0, 0, 0;
  Factorization factorization;
  ASSERT_EQ(factorization.factor(M, P), Status::ok);
  EXPECT_EQ(factorization.rank(), 2);
  EXPECT_FALSE(factorization.redundant(0));
  EXPECT_FALSE(factorization.redundant(1));
  EXPECT_TRUE(factorization.redundant(2));
  EXPECT_TRUE(factorization.redundant(3));
  VectorXd x, lambda;
  EXPECT_EQ(factorization.solve(VectorXd::Zero(3), Eigen::Vector4d(1, 0, 5, 0), x, lambda), -1);
  EXPECT_EQ(factorization.solve(VectorXd::Zero(3), Eigen::Vector4d(1, 0, 5, 1), x, lambda), 3);
}

TEST(ConstraintFactorization, RowsMayHaveAnyUnits) {
  // Rows in units a billion times apart are as independent as before.
  const MatrixXd M = MatrixXd::Identity(3, 3);
  MatrixXd P(2, 3);
  P << 1e9, 2e9, 0, 0, 1e-3, 1e-3;
  Factorization factorization;
  ASSERT_EQ(factorization.factor(M, P), Status::ok);
  EXPECT_EQ(factorization.rank(), 2);
  VectorXd x, lambda;
  EXPECT_EQ(factorization.solve(VectorXd::Zero(3), Eigen::Vector2d(1e9, 1e-3), x, lambda), -1);
  EXPECT_LT((P * x - Eigen::Vector2d(1e9, 1e-3)).cwiseQuotient(Eigen::Vector2d(1e9, 1e-3)).norm(), 1e-14);
}

TEST(ConstraintFactorization, UnitsOfRowsAndCoordinatesDoNotMatter) {
  // Millimetres beside metres, degrees, grams: powers of two, so that nothing is rounded.
  Random random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const int n = random.integer(1, 9), k = random.integer(1, 9), rank = random.integer(1, std::min(n, k));
    const MatrixXd M = random.positive_definite(n), P = random.matrix(k, rank) * random.matrix(rank, n);
    const VectorXd b = random.matrix(n, 1), r = P * random.matrix(n, 1);
    const auto powers = [&](int size) {
      VectorXd out(size);
      for (double& each : out) each = std::ldexp(1, random.integer(-17, 17));
      return out;
    };
    const VectorXd of_row = powers(k), of_coordinate = powers(n);
    const Eigen::DiagonalMatrix<double, Eigen::Dynamic> rows(of_row), columns(of_coordinate);
    Factorization plain, scaled;
    ASSERT_EQ(plain.factor(M, P), Status::ok);
    ASSERT_EQ(scaled.factor(columns * M * columns, rows * P * columns), Status::ok);
    ASSERT_EQ(scaled.rank(), rank) << "trial " << trial;
    ASSERT_TRUE((scaled.redundant() == plain.redundant()).all()) << "trial " << trial;
    VectorXd x, y, lambda, mu;
    ASSERT_EQ(plain.solve(b, r, x, lambda), -1);
    ASSERT_EQ(scaled.solve(columns * b, rows * r, y, mu), -1);
    EXPECT_EQ(columns * y, x) << "trial " << trial;
    EXPECT_EQ(rows * mu, lambda) << "trial " << trial;
  }
}

TEST(ConstraintFactorization, PositionsAndOrientationsAreComparedWhateverTheSizeOfTheBody) {
  // A body in the plane, of radius of gyration r: the position of a point on it, its angle, that of another point.
  for (const double r : {1e3, 1.0, 1e-3, 1e-6, 1e-9}) {
    const MatrixXd M = Eigen::Vector3d(2, 2, 2 * r * r).asDiagonal();
    MatrixXd P(5, 3);
    P << 1, 0, -0.3 * r,  //
        0, 0, 1,          //
        0, 1, 0.7 * r,    //
        1, 0, 0.4 * r,    //
        0, 1, -1.1 * r;
    for (const double unit : {1.0, 1e3, 1e-3}) {
      MatrixXd in_units = P;
      in_units.bottomRows(2) *= unit;
      Factorization factorization;
      ASSERT_EQ(factorization.factor(M, in_units.topRows(2)), Status::ok);
      EXPECT_EQ(factorization.rank(), 2) << r;
      ASSERT_EQ(factorization.factor(M, in_units), Status::ok);
      EXPECT_EQ(factorization.rank(), 3) << r;
      for (int i = 0; i < 5; ++i) EXPECT_EQ(factorization.redundant(i), i > 2) << r << " row " << i;
      const VectorXd acceleration = Eigen::Vector3d(r, -2 * r, 3);
      VectorXd x, lambda;
      EXPECT_EQ(factorization.solve(VectorXd::Zero(3), in_units * acceleration, x, lambda), -1) << r;
      EXPECT_LT((x - acceleration).cwiseQuotient(acceleration).norm(), 1e-13) << r;
    }
  }
}

TEST(ConstraintFactorization, RowsOfRoundingAreRedundant) {
  // Of a hinge that closes a chain in a plane the rows of its axis are products of directions at right angles: by
  // themselves they are as independent as any, and have no correct digit.
  Random random(4);
  for (int trial = 0; trial < 50; ++trial) {
    MatrixXd P = random.matrix(4, 6);
    P.bottomRows(2) *= 0x1p-52;
    Factorization factorization;
    ASSERT_EQ(factorization.factor(random.positive_definite(6), P), Status::ok);
    EXPECT_EQ(factorization.rank(), 2);
    EXPECT_TRUE(factorization.redundant(2) && factorization.redundant(3));
  }
}

TEST(ConstraintFactorization, RowsMayBeAsShortAsTheirLengthsSay) {
  // A row that is 1e14 times shorter than another is a row if it is known to be that short, and rounding if not.
  MatrixXd P(3, 3);
  P << 1, 2, 0, 1e-14, 3e-14, 1e-14, 2e-30, 0, -1e-30;
  const MatrixXd M = MatrixXd::Identity(3, 3);
  Factorization factorization;
  ASSERT_EQ(factorization.factor(M, P), Status::ok);
  EXPECT_EQ(factorization.rank(), 1);
  ASSERT_EQ(factorization.factor(M, P, Eigen::Vector3d(1, 1e-14, 1e-14)), Status::ok);
  EXPECT_EQ(factorization.rank(), 2);
  EXPECT_TRUE(factorization.redundant(2));
  VectorXd x, lambda;
  EXPECT_EQ(factorization.solve(Eigen::Vector3d(1, 1, 1), VectorXd::Zero(3), x, lambda), -1);
  EXPECT_LT((P * x).cwiseQuotient(Eigen::Vector3d(1, 1e-14, 1e-14)).norm(), 1e-14);
  // What rounding may leave in metres is much in millionths of them.
  EXPECT_EQ(factorization.solve(VectorXd::Zero(3), Eigen::Vector3d(0, 0, 1e-20), x, lambda), 2);
}

TEST(ConstraintFactorization, AngleBetweenRowsDecides) {
  // Two rows an angle apart: independent at 1e-5, redundant at 1e-9, in double precision.
  for (const double angle : {1e-5, 1e-9}) {
    MatrixXd P(2, 2);
    P << 1, 0, std::cos(angle), std::sin(angle);
    Factorization factorization;
    ASSERT_EQ(factorization.factor(MatrixXd::Identity(2, 2), P), Status::ok);
    EXPECT_EQ(factorization.rank(), angle > 1e-7 ? 2 : 1);
    VectorXd x, lambda;
    EXPECT_EQ(factorization.solve(VectorXd::Zero(2), Eigen::Vector2d(1, 1), x, lambda), -1);
    EXPECT_LT((P * x - Eigen::Vector2d(1, 1)).norm(), 1e-12);
  }
}

TEST(ConstraintFactorization, NoRows) {
  const MatrixXd M = 2 * MatrixXd::Identity(2, 2);
  Factorization factorization;
  ASSERT_EQ(factorization.factor(M, MatrixXd(0, 2)), Status::ok);
  EXPECT_EQ(factorization.rank(), 0);
  VectorXd x, lambda;
  EXPECT_EQ(factorization.solve(Eigen::Vector2d(2, 4), VectorXd(0), x, lambda), -1);
  EXPECT_EQ(x, Eigen::Vector2d(1, 2));
}

TEST(ConstraintFactorization, WhatIsWrongWithMIsReported) {
  Factorization factorization;
  MatrixXd M = MatrixXd::Identity(2, 2), P = MatrixXd::Ones(1, 2);
  M(1, 1) = 0;
  EXPECT_EQ(factorization.factor(M, P), Status::not_positive_definite);
  M(1, 1) = 1;
  P(0, 1) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(factorization.factor(M, P), Status::not_finite);
}

}  // namespace
