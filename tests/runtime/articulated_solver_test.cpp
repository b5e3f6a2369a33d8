// The solver of long chains against products with the mass matrix of the same tree of axes; what is not finite or not
// positive definite is reported.
#include "alembert/articulated_solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace {

using alembert::Status;

/// As in M::Axes of a generated M, at random; joints of one or, by a quaternion, of three speeds.
template <int N>
struct JointNumbers {
  template <class T>
  using PerRow = std::array<T, static_cast<std::size_t>(N)>;
  PerRow<int> parents{};
  std::array<PerRow<double>, 3> directions{}, centers{};
  std::array<PerRow<double>, 6> inertias{};
  PerRow<bool> turns{}, first_of_three{};
  PerRow<double> masses{}, armatures{};

  /// \param forks  how often in a hundred joints one goes on from further in
  constexpr explicit JointNumbers(unsigned forks) {
    PerRow<int> carriers{};  // of a row the last one of the joint that carries its own
    int last = -1;
    for (int row = 0; row < N;) {
      const bool three = row + 3 <= N && random() % 4 == 0;
      const bool turning = three || random() % 5 > 0;
      int parent = last;
      while (parent >= 0 && random() % 100 < forks) parent = carriers[at(parent)];
      for (int k = 0; k < (three ? 3 : 1); ++k, ++row) {
        parents[at(row)] = k == 0 ? parent : row - 1;
        carriers[at(row)] = parent;
        turns[at(row)] = turning;
        first_of_three[at(row)] = three && k == 0;
        armatures[at(row)] = random() % 3 == 0 ? 0.1 : 0;
        const int axis = three ? k : static_cast<int>(random() % 3);
        directions[at(axis)][at(row)] = three ? 1 : 0.6;
        if (!three) directions[at((axis + 1) % 3)][at(row)] = -0.8;
      }
      last = row - 1;
      masses[at(last)] = 1.5 + number();
      for (auto& center : centers) center[at(last)] = number();
      for (int c = 0; c < 6; ++c) inertias[at(c)][at(last)] = c < 3 ? 1.5 + 0.5 * number() : 0.2 * number();
    }
  }

 private:
  static constexpr std::size_t at(int k) { return static_cast<std::size_t>(k); }
  constexpr unsigned random() {
    state_ = state_ * 1664525 + 1013904223;
    return state_ >> 8;
  }
  constexpr double number() { return random() % 1000 / 500.0 - 1; }
  unsigned state_ = N;
};

/// What the solver asks of a generated mechanism.
template <class S, int N, unsigned forks, bool reversed>
struct ChainLike {
  using Scalar = S;
  static constexpr int kNv = N;
  struct Axes {
    static constexpr JointNumbers<N> kNumbers{forks};
    static constexpr auto kSpeeds = [] {
      std::array<int, static_cast<std::size_t>(N)> out{};
      for (int k = 0; k < N; ++k) out[static_cast<std::size_t>(k)] = reversed ? N - 1 - k : k;
      return out;
    }();
    static constexpr auto kParents = kNumbers.parents;
    static constexpr auto kDirections = kNumbers.directions, kCenters = kNumbers.centers;
    static constexpr auto kInertias = kNumbers.inertias;
    static constexpr auto kTurns = kNumbers.turns, kFirstOfThree = kNumbers.first_of_three;
    static constexpr auto kMasses = kNumbers.masses, kArmatures = kNumbers.armatures;
    static constexpr std::array<double, 3> kGravity{{0, 0, -9.81}};
  };
};

template <class M>
class SolvedByBodies {
  using S = typename M::Scalar;
  static constexpr int N = M::kNv;
  using Matrix = Eigen::Matrix<S, N, N>;

 public:
  explicit SolvedByBodies(unsigned seed) : random_(seed), tree_(alembert::detail::kAxisTables<M>) {
    for (int row = 0; row < N; ++row) {
      const Eigen::Matrix3d R(Eigen::Quaterniond(number(), number(), number(), number()).normalized());
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) frame(4 * r + c, row) = static_cast<S>(R(r, c));
        frame(4 * r + 3, row) = static_cast<S>(3 * number());
      }
      // Speeds of a quaternion have one frame.
      if (alembert::detail::kAxisTables<M>.is_within_three(row))
        for (int entry = 0; entry < 12; ++entry) frame(entry, row) = frame(entry, row - 1);
    }
    place();
  }

  void expect_solved() {
    const double allowed = 20 * static_cast<double>(std::numeric_limits<S>::epsilon());
    const Matrix A = mass_matrix(), P = by_speeds();
    ASSERT_EQ(solver_.factor(tree_), Status::ok);
    const Matrix B = random_matrix(), C = random_matrix();
    Eigen::Matrix<S, N, N, Eigen::RowMajor> rows = B, more = C;
    Matrix X, Y, inverse;
    ASSERT_EQ(solver_.solve({{rows.data(), X.data()}, {more.data(), Y.data()}}, inverse.data()), Status::ok);
    const double scale = A.norm() * inverse.norm();
    EXPECT_LT((A * P.transpose() * X * P + B).norm(), allowed * scale);
    EXPECT_LT((A * P.transpose() * Y * P + C).norm(), allowed * scale);
    EXPECT_LT((A * P.transpose() * inverse * P - Matrix::Identity()).norm(), allowed * scale);
    Eigen::Matrix<S, N, 1> x = B.col(0);
    solver_.solve(x);
    EXPECT_LT((A * x - B.col(0)).norm(), allowed * scale);

    rows(static_cast<int>(random_() % N), N - 1) = std::numeric_limits<S>::infinity();
    const Matrix kept = Y;
    EXPECT_EQ(solver_.solve({{more.data(), Y.data()}, {rows.data(), X.data()}}, inverse.data()),
              Status::not_finite);
    EXPECT_EQ(Y, kept);
  }

  void expect_refused() {
    const int row = static_cast<int>(random_() % N);
    const std::vector<S> frames = frames_;
    frame(static_cast<int>(random_() % 12), row) = std::numeric_limits<S>::quiet_NaN();
    place();
    EXPECT_EQ(solver_.factor(tree_), Status::not_finite) << row;
    frames_ = frames;
    place();
  }

 private:
  double number() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  Matrix random_matrix() {
    return Matrix::NullaryExpr([&] { return static_cast<S>(number()); });
  }
  S& frame(int entry, int row) { return frames_[static_cast<std::size_t>(entry * N + row)]; }
  void place() {
    const std::vector<S> speeds(N, S(0));
    tree_.set_state(frames_.data(), speeds.data());
  }
  Matrix mass_matrix() {
    std::vector<S> entries(N * N + 64);
    tree_.mass_matrix(entries.data());
    const Eigen::Map<const Eigen::Matrix<S, N, N, Eigen::RowMajor>> rows(entries.data());
    return rows.template selfadjointView<Eigen::Lower>();
  }
  /// Entry (speed of k, k) is 1.
  static Matrix by_speeds() {
    Matrix out = Matrix::Zero();
    for (int k = 0; k < N; ++k) out(M::Axes::kSpeeds[static_cast<std::size_t>(k)], k) = 1;
    return out;
  }

  std::mt19937 random_;
  std::vector<S> frames_ = std::vector<S>(12 * N + 64);
  alembert::detail::AxisTree<S, N> tree_;
  alembert::detail::ArticulatedSolver<M> solver_;
};

template <class M>
void expect_solved_by_bodies() {
  for (unsigned seed = 0; seed < 4; ++seed) {
    SolvedByBodies<M> solved(seed);
    solved.expect_solved();
    solved.expect_refused();
  }
}

TEST(ArticulatedSolver, SolvesForAllColumns) {
  expect_solved_by_bodies<ChainLike<double, 9, 30, true>>();
  expect_solved_by_bodies<ChainLike<double, 37, 0, false>>();
  expect_solved_by_bodies<ChainLike<double, 45, 25, false>>();
  expect_solved_by_bodies<ChainLike<float, 22, 25, true>>();
}

/// A tip that has neither a body nor an armature.
struct MasslessTip : ChainLike<double, 12, 0, false> {
  struct Axes : ChainLike::Axes {
    static constexpr auto kMasses = [] {
      auto out = ChainLike::Axes::kMasses;
      out.back() = 0;
      return out;
    }();
    static constexpr auto kInertias = [] {
      auto out = ChainLike::Axes::kInertias;
      for (auto& entries : out) entries.back() = 0;
      return out;
    }();
    static constexpr auto kArmatures = std::array<double, 12>{};
  };
};
TEST(ArticulatedSolver, TellsWhatMovesNothing) {
  const auto& tables = alembert::detail::kAxisTables<MasslessTip>;
  alembert::detail::AxisTree<double, 12> tree(tables);
  std::vector<double> frames(12 * 12 + 64), speeds(12);
  for (int entry : {0, 5, 10}) std::fill_n(frames.begin() + entry * 12, 12, 1.0);
  for (int row = 0; row < 12; ++row) frames[static_cast<std::size_t>(3 * 12 + row)] = row;
  tree.set_state(frames.data(), speeds.data());
  alembert::detail::ArticulatedSolver<MasslessTip> solver;
  EXPECT_EQ(solver.factor(tree), Status::not_positive_definite);
}

}  // namespace
