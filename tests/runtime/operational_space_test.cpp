// The dynamics of a frame against its definition: of an arm whose numbers are drawn once, with and without a generated
// inverse of its mass matrix.
#include "alembert/operational_space.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "runtime/allocation_counter.hpp"
#include "runtime/models.hpp"

namespace {

using alembert::Status;
using alembert::Task;

/// Seven speeds, two frames; its coordinates change nothing. Where the first of them is above 1, the second frame has
/// lost a motion.
struct Arm {
  using Scalar = double;
  using Inputs = models::Inputs<double>;
  using Vector = Eigen::Matrix<double, 7, 1>;
  using Matrix = Eigen::Matrix<double, 7, 7>;
  static constexpr int kNq = 7, kNv = 7;
  static constexpr std::array<int, 0> kQuaternionOffsets{};

  /// Of no pattern, and the same on every machine.
  static double number(int i, int k) {
    return double((31 * i * i + 17 * k * k + 7 * i * k + i + 3 * k) % 23) / 11 - 1;
  }
  static void mass_matrix_and_bias(const Vector&, const Vector&, const Inputs&, Matrix& M, Vector& c) {
    Matrix root;
    for (int i = 0; i < 7; ++i)
      for (int k = 0; k < 7; ++k) root(i, k) = number(i, k) + (i == k ? 3 : 0);
    M = root * root.transpose();
    for (int i = 0; i < 7; ++i) c(i) = number(i, 9);
  }
  static Vector coordinate_rates(const Vector&, const Vector& qd) { return qd; }
  static std::array<Eigen::Matrix<double, 6, 7>, 2> frame_jacobians(const Vector& q, const Inputs&) {
    std::array<Eigen::Matrix<double, 6, 7>, 2> J;
    for (int f = 0; f < 2; ++f)
      for (int i = 0; i < 6; ++i)
        for (int k = 0; k < 7; ++k) J[std::size_t(f)](i, k) = number(i + 7 * f + 2, k + 11);
    if (q(0) > 1) J[1].row(5).setZero();
    return J;
  }
  static Eigen::Matrix<double, 12, 1> frame_bias_accelerations(const Vector&, const Vector&, const Inputs&) {
    Eigen::Matrix<double, 12, 1> bias;
    for (int i = 0; i < 12; ++i) bias(i) = number(i, 5);
    return bias;
  }
};

struct ArmWithInverse : Arm {
  static Matrix mass_matrix_inverse(const Vector& q, const Inputs& in) {
    Matrix M;
    Vector c;
    mass_matrix_and_bias(q, q, in, M, c);
    if (q(0) > 2) M.setConstant(std::numeric_limits<double>::quiet_NaN());
    return M.inverse();
  }
};

static_assert(alembert::has_frame_accelerations_v<Arm>);
static_assert(!alembert::has_frame_accelerations_v<models::Pendulum<>>);

/// A force F at the frame gives it the acceleration with which Lambda a + mu = F.
template <class M, Task task>
void expect_that_a_force_accelerates_the_frame(int frame, int first) {
  const Arm::Vector q = Arm::Vector::Zero(), qd = Arm::Vector::Ones();
  alembert::OperationalSpace<M, task> space;
  const std::size_t before = allocation_count();
  const Status status = alembert::operational_space<M, task>(frame, q, qd, {}, space);
  EXPECT_EQ(allocation_count(), before);
  ASSERT_EQ(status, Status::ok);
  constexpr int rows = task == Task::pose ? 6 : 3;
  Arm::Matrix mass;
  Arm::Vector c;
  Arm::mass_matrix_and_bias(q, qd, {}, mass, c);
  const Eigen::Matrix<double, rows, 7> J =
      Arm::frame_jacobians(q, {})[std::size_t(frame)].template middleRows<rows>(first);
  const Eigen::Matrix<double, rows, 1> wanted = Eigen::Matrix<double, rows, 1>::LinSpaced(-1, 2);
  const Eigen::Matrix<double, rows, 1> F = space.inertia * wanted + space.bias;
  const Arm::Vector qdd = mass.inverse() * (J.transpose() * F - c);
  const Eigen::Matrix<double, rows, 1> found =
      J * qdd + Arm::frame_bias_accelerations(q, qd, {}).template segment<rows>(6 * frame + first);
  EXPECT_LT((found - wanted).norm(), 1e-10);
  EXPECT_LT((J * space.Jbar - Eigen::Matrix<double, rows, rows>::Identity()).norm(), 1e-10);
  // What Jbar leaves of forces does not move the frame.
  const Arm::Matrix left = Arm::Matrix::Identity() - J.transpose() * space.Jbar.transpose();
  EXPECT_LT((J * mass.inverse() * left).norm(), 1e-10);
  EXPECT_LT((space.inverse_inertia * space.inertia - Eigen::Matrix<double, rows, rows>::Identity()).norm(),
            1e-10);
  EXPECT_EQ(space.J, J);
}

TEST(OperationalSpace, AForceAcceleratesTheFrameAsItSays) {
  expect_that_a_force_accelerates_the_frame<Arm, Task::pose>(1, 0);
  expect_that_a_force_accelerates_the_frame<Arm, Task::rotation>(0, 0);
  expect_that_a_force_accelerates_the_frame<Arm, Task::position>(1, 3);
  expect_that_a_force_accelerates_the_frame<ArmWithInverse, Task::pose>(0, 0);
  expect_that_a_force_accelerates_the_frame<ArmWithInverse, Task::position>(1, 3);
}

TEST(OperationalSpace, SaysWhyThereIsNone) {
  alembert::OperationalSpace<ArmWithInverse> space;
  space.bias.setConstant(7);
  Arm::Vector q = Arm::Vector::Zero(), qd = Arm::Vector::Zero();
  q(0) = 1.5;
  EXPECT_EQ(alembert::operational_space<ArmWithInverse>(1, q, qd, {}, space), Status::not_positive_definite);
  q(0) = 2.5;
  EXPECT_EQ(alembert::operational_space<ArmWithInverse>(0, q, qd, {}, space), Status::not_positive_definite);
  qd(3) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(alembert::operational_space<ArmWithInverse>(0, q, qd, {}, space), Status::not_finite);
  EXPECT_EQ(space.bias(2), 7);
}

}  // namespace
