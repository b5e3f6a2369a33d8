// The solver of linearize against products with its matrix, for trees of all kinds; what is not finite is reported.
#include "alembert/branch_solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace {

using alembert::Status;

/// Which of N speeds carries which: `branches`, their speeds in turn; 0: each is carried by any one before it or none.
template <int N, int branches>
struct TreeOfSpeeds {
  static constexpr auto kParents = [] {
    std::array<int, N> out{};
    unsigned random = N;
    for (int k = 0; k < N; ++k) {
      random = random * 1664525 + 1013904223;
      out[k] = branches > 0 ? std::max(k - branches, -1) : static_cast<int>((random >> 8) % (k + 1)) - 1;
    }
    return out;
  }();
};

/// A symmetric positive definite matrix like those of mechanisms.
/// \param zeros  the share of entries that are zero though a speed carries the other
template <class S, class Tree, std::size_t N = Tree::kParents.size()>
auto matrix_of_tree(double zeros, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  using Matrix = Eigen::Matrix<S, N, N>;
  Matrix L = Matrix::Identity(), D = L;
  for (int k = 0; k < static_cast<int>(N); ++k) {
    D(k, k) = static_cast<S>(1.5 + uniform(random));
    for (int i = Tree::kParents[k]; i >= 0; i = Tree::kParents[i])
      if (std::abs(uniform(random)) >= zeros) L(k, i) = static_cast<S>(uniform(random) / N);
  }
  return Matrix(L.transpose() * D * L);
}

template <class S, class Tree, int N>
void expect_solved(const Eigen::Matrix<S, N, N>& A, std::mt19937& random) {
  using Matrix = Eigen::Matrix<S, N, N>;
  const double allowed = 1e3 * static_cast<double>(std::numeric_limits<S>::epsilon());
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Matrix B = Matrix::NullaryExpr([&] { return static_cast<S>(uniform(random)); });
  const Matrix C = Matrix::NullaryExpr([&] { return static_cast<S>(uniform(random)); });
  Matrix X, Y, inverse;
  Eigen::Matrix<S, N, N, N == 1 ? Eigen::ColMajor : Eigen::RowMajor> rows = B, more = C;
  alembert::detail::BranchSolver<S, Tree> solver;
  ASSERT_EQ(solver.factor(A), Status::ok);
  ASSERT_EQ(solver.solve({{rows.data(), X.data()}, {more.data(), Y.data()}}, inverse.data()), Status::ok);
  EXPECT_LT((A * X + B).norm(), allowed) << N;
  EXPECT_LT((A * Y + C).norm(), allowed) << N;
  EXPECT_LT((A * inverse - Matrix::Identity()).norm(), allowed) << N;
  Eigen::Matrix<S, N, 1> x = B.col(0);
  solver.solve(x);
  EXPECT_LT((A * x - B.col(0)).norm(), allowed) << N;

  const int at = static_cast<int>(random() % N);
  rows(at, N - 1) = std::numeric_limits<S>::infinity();
  const Matrix kept = Y;
  EXPECT_EQ(solver.solve({{more.data(), Y.data()}, {rows.data(), X.data()}}, inverse.data()),
            Status::not_finite);
  EXPECT_EQ(Y, kept);
  Matrix bad = A;
  bad.row(at).setZero();
  bad.col(at).setZero();
  EXPECT_EQ(solver.factor(bad), Status::not_positive_definite);
  for (int i = at; i >= 0; i = Tree::kParents[i]) {
    bad = A;
    bad(i, at) = bad(at, i) = std::numeric_limits<S>::quiet_NaN();
    EXPECT_EQ(solver.factor(bad), Status::not_finite);
  }
}

template <class S, int N, int branches>
void expect_tree_solved() {
  std::mt19937 random(N);
  using Tree = TreeOfSpeeds<N, branches>;
  for (const double zeros : {0.0, 0.2})
    expect_solved<S, Tree>(matrix_of_tree<S, Tree>(zeros, random), random);
}

TEST(BranchSolver, SolvesForAllColumns) {
  expect_tree_solved<double, 1, 1>();
  expect_tree_solved<double, 7, 0>();
  expect_tree_solved<double, 18, 5>();
  expect_tree_solved<double, 43, 0>();
  expect_tree_solved<float, 18, 0>();
}

// As of shared coordinates.
TEST(BranchSolver, SolvesWhereWhatIsTiedToASpeedNeedNotCarryIt) {
  constexpr int n = 30;
  std::mt19937 random(n);
  Eigen::Matrix<double, n, n> A = Eigen::Matrix<double, n, n>::Identity();
  for (int k = 0; k < n; ++k) {
    const int i = static_cast<int>(random() % n);
    if (i != k) A(i, k) = A(k, i) = 0.9 / n;
  }
  expect_solved<double, TreeOfSpeeds<n, 1>>(A, random);
}

}  // namespace
