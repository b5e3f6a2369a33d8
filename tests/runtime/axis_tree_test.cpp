// Trees of axes in world axes against recursive Newton-Euler equations in the axes of each frame, with dual numbers for
// derivatives.
#include "alembert/axis_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

namespace {

/// A number and its derivative.
struct Dual {
  double value = 0, rate = 0;
  Dual() = default;
  Dual(double v, double r = 0) : value(v), rate(r) {}
  friend Dual operator+(Dual a, Dual b) { return {a.value + b.value, a.rate + b.rate}; }
  friend Dual operator-(Dual a, Dual b) { return {a.value - b.value, a.rate - b.rate}; }
  friend Dual operator*(Dual a, Dual b) { return {a.value * b.value, a.rate * b.value + a.value * b.rate}; }
};
using Vector = std::array<Dual, 3>;
using Matrix = std::array<Vector, 3>;  // rows

Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vector operator*(Dual k, const Vector& a) {
  return {k * a[0], k * a[1], k * a[2]};
}
Dual dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector operator*(const Matrix& A, const Vector& b) {
  return {dot(A[0], b), dot(A[1], b), dot(A[2], b)};
}
Matrix transposed(const Matrix& A) {
  return {{{A[0][0], A[1][0], A[2][0]}, {A[0][1], A[1][1], A[2][1]}, {A[0][2], A[1][2], A[2][2]}}};
}
Matrix operator*(const Matrix& A, const Matrix& B) {
  const Matrix columns = transposed(B);
  return transposed({A * columns[0], A * columns[1], A * columns[2]});
}
/// A turn by an angle about a unit vector.
Matrix turn(const Vector& axis, Dual angle) {
  const Dual c{std::cos(angle.value), -std::sin(angle.value) * angle.rate};
  const Dual s{std::sin(angle.value), std::cos(angle.value) * angle.rate};
  Matrix out;
  for (std::size_t k = 0; k < 3; ++k) {
    Vector unit;
    unit[k] = 1;
    const Vector column = c * unit + s * cross(axis, unit) + (Dual(1) - c) * dot(axis, unit) * axis;
    for (std::size_t r = 0; r < 3; ++r) out[r][k] = column[r];
  }
  return out;
}

/// As M::Axes of a generated M.
template <int N>
struct Numbers {
  std::array<int, N> kParents{};
  std::array<std::array<double, N>, 3> kDirections{}, kCenters{};
  std::array<bool, N> kTurns{}, kFirstOfThree{};
  std::array<double, N> kMasses{}, kArmatures{};
  std::array<std::array<double, N>, 6> kInertias{};
  std::array<double, 3> kGravity{{0.3, -0.2, -9.81}};
};

/// Joints of one or, by a quaternion, of three speeds.
template <int N>
class RandomTree {
 public:
  explicit RandomTree(unsigned seed) : random_(seed) {
    for (int row = 0; row < N;) {
      Joint joint{row, row + 3 <= N && uniform() > 0.4 ? 3 : 1, static_cast<int>(joints_.size()) - 1,
                  turn(direction(), 3 * uniform()), direction()};
      while (joint.parent >= 0 && uniform() > 0.5) joint.parent = joints_[at(joint.parent)].parent;
      const bool three = joint.count == 3;
      const Vector axis = direction();
      const bool turns = three || uniform() > -0.4;
      for (int k = 0; k < joint.count; ++k, ++row) {
        const std::size_t i = at(row);
        numbers.kParents[i] = k > 0 ? row - 1 : joint.parent < 0 ? -1 : joints_[at(joint.parent)].last();
        numbers.kTurns[i] = turns;
        for (int c = 0; c < 3; ++c)
          numbers.kDirections[at(c)][i] = three ? (c == k ? 1 : 0) : axis[at(c)].value;
        numbers.kFirstOfThree[i] = three && k == 0;
        numbers.kArmatures[i] = 0.2 + 0.1 * uniform();
      }
      const std::size_t i = at(joint.last());
      numbers.kMasses[i] = 1.5 + uniform();
      for (std::size_t c = 0; c < 3; ++c) numbers.kCenters[c][i] = uniform();
      for (std::size_t c = 0; c < 3; ++c) numbers.kInertias[c][i] = 1.5 + 0.5 * uniform();
      for (std::size_t c = 3; c < 6; ++c) numbers.kInertias[c][i] = 0.2 * uniform();
      joints_.push_back(joint);
    }
    for (std::vector<Dual>* values : {&q, &u, &rates})
      for (int k = 0; k < N; ++k) values->push_back(uniform());
  }

  /// Generalized forces, but for those of armatures. A rate of q of a quaternion's speed is that of a turn about an axis
  /// of the frame.
  std::vector<Dual> forces() const {
    struct Body {
      Matrix E;
      Vector r, w, v, al, a, n, f;  // in the axes of its frame
    };
    std::vector<Body> bodies;
    for (const Joint& joint : joints_) {
      Body parent{};
      for (std::size_t c = 0; c < 3; ++c) parent.a[c] = -numbers.kGravity[c];
      if (joint.parent >= 0) parent = bodies[at(joint.parent)];
      Body own{};
      std::tie(own.E, own.r) = motion(joint);
      const Matrix T = transposed(own.E);
      Vector turned{}, slid{}, turned_more{}, slid_more{};
      for (int row = joint.first; row <= joint.last(); ++row) {
        const bool turns = numbers.kTurns[at(row)];
        (turns ? turned : slid) = (turns ? turned : slid) + u[at(row)] * axis(row);
        (turns ? turned_more : slid_more) = (turns ? turned_more : slid_more) + rates[at(row)] * axis(row);
      }
      own.w = T * parent.w + turned;
      own.v = T * (parent.v + cross(parent.w, own.r)) + slid;
      own.al = T * parent.al + cross(own.w, turned) + turned_more;
      own.a = T * (parent.a + cross(parent.al, own.r) + cross(parent.w, cross(parent.w, own.r))) +
              Dual(2) * cross(T * parent.w, slid) + slid_more;
      const std::size_t i = at(joint.last());
      const auto& J = numbers.kInertias;
      const Vector c{numbers.kCenters[0][i], numbers.kCenters[1][i], numbers.kCenters[2][i]};
      const Matrix I{{{J[0][i], J[3][i], J[4][i]}, {J[3][i], J[1][i], J[5][i]}, {J[4][i], J[5][i], J[2][i]}}};
      own.f = Dual(numbers.kMasses[i]) * (own.a + cross(own.al, c) + cross(own.w, cross(own.w, c)));
      own.n = I * own.al + cross(own.w, I * own.w) + cross(c, own.f);
      bodies.push_back(own);
    }
    std::vector<Dual> tau(N);
    for (std::size_t j = joints_.size(); j-- > 0;) {
      const Body& own = bodies[j];
      for (int row = joints_[j].first; row <= joints_[j].last(); ++row)
        tau[at(row)] = dot(axis(row), numbers.kTurns[at(row)] ? own.n : own.f);
      if (joints_[j].parent < 0) continue;
      Body& parent = bodies[at(joints_[j].parent)];
      const Vector force = own.E * own.f;
      parent.f = parent.f + force;
      parent.n = parent.n + own.E * own.n + cross(own.r, force);
    }
    return tau;
  }

  /// What generated code gives, about the origin of the world, and room for a vector.
  template <class S>
  std::vector<S> frames() const {
    std::vector<S> out(12 * N + 64);
    std::vector<std::pair<Matrix, Vector>> poses;
    for (const Joint& joint : joints_) {
      auto [R, p] = motion(joint);
      if (joint.parent >= 0) {
        const auto& [before, from] = poses[at(joint.parent)];
        R = before * R;
        p = from + before * p;
      }
      poses.emplace_back(R, p);
      for (int row = joint.first; row <= joint.last(); ++row)
        for (std::size_t r = 0; r < 3; ++r) {
          for (std::size_t c = 0; c < 3; ++c) out[(4 * r + c) * N + at(row)] = static_cast<S>(R[r][c].value);
          out[(4 * r + 3) * N + at(row)] = static_cast<S>(p[r].value);
        }
    }
    return out;
  }

  Numbers<N> numbers;
  std::vector<Dual> q, u, rates;

 private:
  struct Joint {
    int first, count, parent;
    Matrix before;
    Vector shift;
    int last() const { return first + count - 1; }
  };

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  double uniform() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  Vector direction() {
    Vector out;
    for (Dual& x : out) x = uniform() + 0.1;
    return Dual(1 / std::sqrt(dot(out, out).value)) * out;
  }
  Vector axis(int row) const {
    return {numbers.kDirections[0][at(row)], numbers.kDirections[1][at(row)],
            numbers.kDirections[2][at(row)]};
  }
  std::pair<Matrix, Vector> motion(const Joint& joint) const {
    const Vector own = axis(joint.first);
    const Dual x = q[at(joint.first)];
    if (joint.count == 1 && numbers.kTurns[at(joint.first)])
      return {joint.before * turn(own, x), joint.shift};
    if (joint.count == 1) return {joint.before, joint.shift + joint.before * (x * own)};
    Matrix E = joint.before;
    for (int row = joint.first; row <= joint.last(); ++row) E = E * turn(axis(row), q[at(row)].value);
    const Dual a(0, x.rate), b(0, q[at(joint.first + 1)].rate), c(0, q[at(joint.last())].rate);
    return {E * Matrix{{{1, Dual() - c, b}, {c, 1, Dual() - a}, {Dual() - b, a, 1}}}, joint.shift};
  }

  std::mt19937 random_;
  std::vector<Joint> joints_;
};

template <class S>
double largest(const std::vector<S>& values, std::size_t count) {
  S out = 0;
  for (std::size_t i = 0; i < count; ++i) out = std::max(out, std::abs(values[i]));
  return out;
}

template <class S, int N>
void expect_equations(unsigned seed) {
  SCOPED_TRACE(::testing::Message() << N << " speeds, seed " << seed);
  constexpr std::size_t n = N;
  const double allowed = 1e3 * static_cast<double>(std::numeric_limits<S>::epsilon());
  RandomTree<N> tree(seed);
  const alembert::detail::AxisTables<S, N> tables(tree.numbers);
  alembert::detail::AxisTree<S, N> axes(tables);
  std::vector<S> u(n), rates(n), M(n * n + 64), c(n + 64), tau_q(n * n + 64), tau_qd(n * n + 64);
  for (std::size_t k = 0; k < n; ++k) {
    u[k] = static_cast<S>(tree.u[k].value);
    rates[k] = static_cast<S>(tree.rates[k].value);
  }
  axes.set_state(tree.template frames<S>().data(), u.data());
  axes.mass_matrix(M.data());
  axes.set_accelerations(u.data(), nullptr);
  axes.forces(c.data());
  axes.set_accelerations(u.data(), rates.data());
  axes.derivatives(tau_q.data(), tau_qd.data());

  // Of one joint tau_qd is zero.
  const double size = std::max({largest(tau_q, n * n), largest(tau_qd, n * n), largest(c, n)});
  const auto expect_column = [&](std::size_t j, std::vector<Dual>& by, const auto& of) {
    by[j].rate = 1;
    const std::vector<Dual> tau = tree.forces();
    by[j].rate = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double found = of(i, tau[i].rate);
      EXPECT_NEAR(found, tau[i].rate, allowed * size) << "row " << i << ", column " << j;
    }
  };
  for (std::size_t j = 0; j < n; ++j) {
    expect_column(j, tree.q, [&](std::size_t i, double) -> double { return tau_q[i * n + j]; });
    expect_column(j, tree.u, [&](std::size_t i, double) -> double { return tau_qd[i * n + j]; });
    expect_column(j, tree.rates, [&](std::size_t i, double wanted) -> double {
      if (i < j) return wanted;
      return M[i * n + j] - (i == j ? tree.numbers.kArmatures[j] : 0);
    });
  }
  for (Dual& rate : tree.rates) rate = 0;
  const std::vector<Dual> tau = tree.forces();
  for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(c[i], tau[i].value, allowed * size) << "row " << i;
}

template <class S>
void expect_equations_of_all_sizes() {
  for (unsigned seed = 0; seed < 8; ++seed) {
    expect_equations<S, 1>(seed);
    expect_equations<S, 3>(seed);
    expect_equations<S, 8>(seed);
    expect_equations<S, 13>(seed);
    expect_equations<S, 34>(seed);
  }
}

TEST(AxisTree, EquationsInDouble) {
  expect_equations_of_all_sizes<double>();
}
TEST(AxisTree, EquationsInFloat) {
  expect_equations_of_all_sizes<float>();
}
/// Of so many speeds numbers are kept on the heap.
TEST(AxisTree, ManySpeeds) {
  expect_equations<double, 150>(1);
}
TEST(AxisTree, FewerSpeedsThanThereIsRoomFor) {
  const RandomTree<13> tree(5);
  const alembert::detail::AxisTables<double, 13> tables(tree.numbers);
  const alembert::detail::AxisTables<double, 40> larger(tree.numbers, 13);
  alembert::detail::AxisTree<double, 13> exact(tables);
  alembert::detail::AxisTree<double, 40> roomy(larger);
  std::vector<double> u(13, 0.5), rates(13, -0.25);
  std::array<std::vector<double>, 4> found;
  for (std::vector<double>& values : found) values.assign(13 * 13 + 64, 0);
  const auto run = [&](auto& axes, std::vector<double>& tau_q, std::vector<double>& tau_qd) {
    axes.set_state(tree.frames<double>().data(), u.data());
    axes.set_accelerations(u.data(), rates.data());
    axes.derivatives(tau_q.data(), tau_qd.data());
  };
  run(exact, found[0], found[1]);
  run(roomy, found[2], found[3]);
  for (std::size_t k = 0; k < 13 * 13; ++k) {
    EXPECT_EQ(found[0][k], found[2][k]);
    EXPECT_EQ(found[1][k], found[3][k]);
  }
}

}  // namespace
