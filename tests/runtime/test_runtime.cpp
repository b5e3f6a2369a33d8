// Runtime library on mechanisms written by hand: solutions known in closed form, failures reported, no heap.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "alembert/energy.hpp"
#include "alembert/forward_dynamics.hpp"
#include "alembert/integrate.hpp"
#include "alembert/linearize.hpp"
#include "alembert/version.hpp"
#include "runtime/allocation_counter.hpp"
#include "runtime/models.hpp"

namespace {

using alembert::Status;
using models::Dense;
using models::no_force;
using models::NotAMechanism;
using models::Pendulum;
using models::SpinningBody;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

static_assert(alembert::is_mechanism_v<Pendulum<double>>);
static_assert(alembert::is_mechanism_v<Pendulum<float>>);
static_assert(alembert::is_mechanism_v<SpinningBody<>>);
static_assert(!alembert::is_mechanism_v<NotAMechanism>);
static_assert(!alembert::is_mechanism_v<int>);
static_assert(alembert::has_energy_v<SpinningBody<>>);
static_assert(!alembert::has_energy_v<Dense<3>>);
static_assert(alembert::has_derivatives_v<SpinningBody<>> && !alembert::has_derivatives_v<Dense<3>>);
static_assert(alembert::MechanismType<Pendulum<>> && !alembert::MechanismType<NotAMechanism>);

template <int N>
void check_dense_solution() {
  using M = Dense<N>;
  typename M::Vector q, qd, tau, qdd, bias;
  qdd.setZero();  // gcc does not see that ASSERT_EQ lets nothing pass but ok
  for (int i = 0; i < N; ++i) {
    q(i) = 0;
    qd(i) = std::sin(i);
    tau(i) = std::cos(3 * i);
  }
  typename M::Inputs in{1.0};
  ASSERT_EQ(alembert::forward_dynamics<M>(q, qd, tau, in, qdd), Status::ok);
  Eigen::Matrix<double, N, N> mass;
  M::mass_matrix_and_bias(q, qd, in, mass, bias);
  EXPECT_LT((mass * qdd + bias - tau).cwiseAbs().maxCoeff(), 1e-13) << "n = " << N;
}

TEST(ForwardDynamics, SolvesTheEquationsOfMotion) {
  check_dense_solution<1>();
  check_dense_solution<2>();
  check_dense_solution<6>();
  check_dense_solution<40>();
  check_dense_solution<100>();
}

TEST(ForwardDynamics, PendulumInFloat) {
  using M = Pendulum<float>;
  const M::Vector q(0.7f), qd(0.1f), tau(0.3f);
  M::Vector qdd;
  ASSERT_EQ(alembert::forward_dynamics<M>(q, qd, tau, {}, qdd), Status::ok);
  EXPECT_NEAR(qdd(0), (0.3f - 2 * 9.81f * 0.5f * std::sin(0.7f)) / 0.5f, 1e-5f);
}

TEST(ForwardDynamics, SingularMassMatrixIsReported) {
  using M = Dense<4>;
  M::Vector q, qd, tau, qdd;
  q.setZero();
  qd.setZero();
  tau.setOnes();
  qdd.setConstant(7);
  const M::Vector before = qdd;
  EXPECT_EQ(alembert::forward_dynamics<M>(q, qd, tau, {-1.5}, qdd), Status::not_positive_definite);
  EXPECT_EQ(qdd, before);
}

TEST(ForwardDynamics, SemidefiniteUpToRoundingIsReported) {
  // Rank one: x x^T leaves pivots that are zero, or rounding errors of either sign.
  Eigen::Vector3d x(0.1, 0.7, 1.3);
  Eigen::Matrix3d A = x * x.transpose();
  EXPECT_EQ(alembert::factor_ldlt(A), Status::not_positive_definite);
  Eigen::Matrix3d zero = Eigen::Matrix3d::Zero();
  EXPECT_EQ(alembert::factor_ldlt(zero), Status::not_positive_definite);
}

TEST(ForwardDynamics, WidelyScaledButRegularIsSolved) {
  Eigen::Matrix3d A = Eigen::Vector3d(1e12, 1, 1e-12).asDiagonal();
  ASSERT_EQ(alembert::factor_ldlt(A), Status::ok);
  Eigen::Vector3d x(1e12, 1, 1e-12);
  alembert::solve_ldlt(A, x);
  EXPECT_EQ(x, Eigen::Vector3d::Ones());
}

template <int N>
void expect_solved() {
  std::mt19937 random(N);
  std::uniform_real_distribution<double> uniform(-1, 1);
  using Matrix = Eigen::Matrix<double, N, N>;
  using Vector = Eigen::Matrix<double, N, 1>;
  const Matrix B = Matrix::NullaryExpr([&] { return uniform(random); });
  const Matrix A = B * B.transpose() + Matrix::Identity();
  const Vector x = Vector::NullaryExpr([&] { return uniform(random); });
  Matrix factor = A;
  factor.template triangularView<Eigen::StrictlyUpper>().setConstant(
      kNan);  // only the lower triangle is read
  ASSERT_EQ(alembert::factor_ldlt(factor), Status::ok);
  Vector solved = A * x;
  alembert::solve_ldlt(factor, solved);
  EXPECT_LT((solved - x).norm(), 1e-12) << N;
}

TEST(ForwardDynamics, SystemsOfAnySizeAreSolved) {
  expect_solved<1>();
  expect_solved<5>();
  expect_solved<12>();
  expect_solved<13>();
  expect_solved<40>();
}

TEST(ForwardDynamics, IsTheGeneratedOneWhereMIsSurelyPositive) {
  using M = models::WrittenPendulum<0>;
  const M::Vector q(0.7), qd(0.1), tau(0.3);
  const double expected = tau(0) / (M::m * M::l * M::l) - M::g / M::l * std::sin(0.7);
  M::Vector qdd(7.0);
  M::rates_asked = 0;
  ASSERT_EQ(alembert::forward_dynamics<M>(q, qd, tau, {}, qdd), Status::ok);
  EXPECT_EQ(M::rates_asked, 1);
  EXPECT_NEAR(qdd(0), expected, 1e-14);
  M::Inputs in;
  M::Vector q1 = q, qd1 = qd, q2 = q, qd2 = qd;
  ASSERT_EQ(alembert::rk4_step<M>(q1, qd1, in, 0.01, no_force<M>), Status::ok);
  EXPECT_EQ(M::rates_asked, 5);
  Pendulum<>::Inputs plain;
  ASSERT_EQ(alembert::rk4_step<Pendulum<>>(q2, qd2, plain, 0.01, no_force<Pendulum<>>), Status::ok);
  EXPECT_NEAR(q1(0), q2(0), 1e-15);
  EXPECT_NEAR(qd1(0), qd2(0), 1e-14);
  // M decides what no checks have found.
  for (const double found : {kNan, kInfinity, 1e12}) {
    M::singular = found;
    ASSERT_EQ(alembert::forward_dynamics<M>(q, qd, tau, {}, qdd), Status::ok);
    EXPECT_NEAR(qdd(0), expected, 1e-14) << found;
  }
  M::singular = 0;
  // A mass that is an argument may be negative.
  using Changed = models::WrittenPendulum<1>;
  ASSERT_EQ(alembert::forward_dynamics<Changed>(q, qd, tau, {}, qdd), Status::ok);
  EXPECT_EQ(Changed::rates_asked, 0);
  // Inputs, for what a controller sets, are no masses.
  using Driven = models::WrittenPendulum<2, 2>;
  ASSERT_EQ(alembert::forward_dynamics<Driven>(q, qd, tau, {}, qdd), Status::ok);
  EXPECT_EQ(Driven::rates_asked, 1);
  EXPECT_NEAR(qdd(0), expected, 1e-14);
}

TEST(ForwardDynamics, SingularMassMatrixIsReportedWithoutForcesToo) {
  using M = models::HingesInLine;
  const M::Vector none = M::Vector::Zero(), before = M::Vector::Constant(7);
  M::Vector qdd = before;
  M::inner = 1e-17;
  for (const M::Vector& tau : {none, M::Vector(1, 0)}) {
    EXPECT_EQ(alembert::forward_dynamics<M>(none, none, tau, {}, qdd), Status::not_positive_definite);
    EXPECT_EQ(qdd, before);
  }
  M::Vector q = none, qd = none;
  M::Inputs in;
  EXPECT_EQ(alembert::rk4_step<M>(q, qd, in, 0.01, no_force<M>), Status::not_positive_definite);
  M::inner = 0.5;
  EXPECT_EQ(alembert::forward_dynamics<M>(none, none, none, {}, qdd), Status::ok);
  EXPECT_EQ(qdd, none);
}

TEST(Linearize, IsTheGeneratedDerivativesOfFewSpeeds) {
  using M = models::WrittenPendulum<0>;
  const M::Vector q(0.7), qd(0.1), tau(0.3);
  alembert::Linearization<M> out;
  alembert::Linearization<Pendulum<>> other;
  M::derivatives_asked = 0;
  ASSERT_EQ(alembert::linearize<M>(q, qd, tau, {}, out), Status::ok);
  EXPECT_EQ(M::derivatives_asked, 1);
  ASSERT_EQ(alembert::linearize<Pendulum<>>(q, qd, tau, {}, other), Status::ok);
  EXPECT_NEAR(out.qdd(0), other.qdd(0), 1e-14);
  EXPECT_NEAR(out.qdd_q(0), other.qdd_q(0), 1e-14);
  EXPECT_EQ(out.qdd_qd(0), other.qdd_qd(0));
  EXPECT_NEAR(out.qdd_tau(0), other.qdd_tau(0), 1e-15);
}

TEST(ForwardDynamics, WhatIsNotFiniteIsReported) {
  using M = Pendulum<>;
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    M::Vector qdd(7.0);
    EXPECT_EQ(alembert::forward_dynamics<M>(M::Vector(bad), M::Vector(0.0), M::Vector(0.0), {}, qdd),
              Status::not_finite);
    EXPECT_EQ(alembert::forward_dynamics<M>(M::Vector(0.0), M::Vector(0.0), M::Vector(bad), {}, qdd),
              Status::not_finite);
    EXPECT_EQ(qdd(0), 7.0);
  }
  using D = Dense<2>;
  D::Vector qdd(7.0, 7.0);
  const D::Vector zero = D::Vector::Zero();
  EXPECT_EQ(alembert::forward_dynamics<D>(zero, zero, zero, {kNan}, qdd), Status::not_finite);
  // Finite arguments, but the result overflows.
  EXPECT_EQ(alembert::forward_dynamics<D>(zero, zero, D::Vector(1.7e308, -1.7e308), {0.0}, qdd),
            Status::not_finite);
  EXPECT_EQ(qdd, D::Vector(7.0, 7.0));
}

/// Global error of a method on the spinning body at t = 1, with n steps, against one with many more.
template <class Step>
double spin_error(Step step, int n, const Eigen::Vector4d& exact_q, const Eigen::Vector3d& exact_w) {
  using M = SpinningBody<>;
  Eigen::Vector4d q(0, 0, 0, 1);
  Eigen::Vector3d w(1, 0.5, -2);
  M::Inputs in;
  for (int i = 0; i < n; ++i) EXPECT_EQ(step(q, w, in, 1.0 / n), Status::ok);
  EXPECT_NEAR(in.t, 1.0, 1e-12);
  EXPECT_NEAR(q.norm(), 1.0, 1e-15);
  return std::max((q - exact_q).norm(), (w - exact_w).norm());
}

TEST(Linearize, Pendulum) {
  using M = Pendulum<>;
  alembert::Linearization<M> out;
  ASSERT_EQ(alembert::linearize<M>(M::Vector(0.7), M::Vector(0.1), M::Vector(0.3), {}, out), Status::ok);
  const double ml2 = M::m * M::l * M::l;
  EXPECT_NEAR(out.qdd(0), 0.3 / ml2 - M::g / M::l * std::sin(0.7), 1e-14);
  EXPECT_NEAR(out.qdd_q(0), -M::g / M::l * std::cos(0.7), 1e-14);
  EXPECT_EQ(out.qdd_qd(0), 0.0);
  EXPECT_NEAR(out.qdd_tau(0), 1 / ml2, 1e-15);
  const double before = out.qdd_q(0);
  EXPECT_EQ(alembert::linearize<M>(M::Vector(kNan), M::Vector(0.1), M::Vector(0.3), {}, out),
            Status::not_finite);
  EXPECT_EQ(out.qdd_q(0), before);
}

/// Two arms, their speeds in turn.
struct TwoArms : Dense<6> {
  using Matrix = Eigen::Matrix<double, kNv, kNv>;
  static constexpr std::array<int, kNv> kSpeedParents = {-1, -1, 0, 1, 2, 3};
  using SpeedParentsOf = TwoArms;
  static void mass_matrix_and_bias(const Vector&, const Vector& qd, const Inputs& in, Matrix& M, Vector& c) {
    Dense::mass_matrix_and_bias(qd, qd, in, M, c);
    for (int i = 0; i < kNv; ++i)
      for (int j = 1 - i % 2; j < kNv; j += 2) M(i, j) = 0;
  }
  static void inverse_dynamics_derivatives(const Vector&, const Vector&, const Vector& qdd, const Inputs&,
                                           Matrix& tau_q, Matrix& tau_qd) {
    for (int i = 0; i < kNv; ++i) tau_q.row(i).setConstant(i + qdd(i));
    tau_qd = 2 * Matrix::Identity();
  }
};

TEST(Linearize, TwoArms) {
  using M = TwoArms;
  const M::Vector none = M::Vector::Zero(), tau = M::Vector::LinSpaced(1, 2);
  const M::Inputs in{0.5};
  alembert::Linearization<M> out;
  ASSERT_EQ(alembert::linearize<M>(none, none, tau, in, out), Status::ok);
  M::Matrix mass, tau_q, tau_qd;
  M::Vector bias;
  M::mass_matrix_and_bias(none, none, in, mass, bias);
  M::inverse_dynamics_derivatives(none, none, out.qdd, in, tau_q, tau_qd);
  EXPECT_LT((mass * out.qdd - tau).norm(), 1e-13);
  EXPECT_LT((mass * out.qdd_q + tau_q).norm(), 1e-13 * tau_q.norm());
  EXPECT_LT((mass * out.qdd_qd + tau_qd).norm(), 1e-13);
  EXPECT_LT((mass * out.qdd_tau - M::Matrix::Identity()).norm(), 1e-13);
  EXPECT_EQ(out.qdd_tau(0, 1), 0);
  EXPECT_EQ(out.qdd_tau(5, 2), 0);
}

struct TiedArms : TwoArms {
  static void mass_matrix_and_bias(const Vector& q, const Vector& qd, const Inputs& in, Matrix& M,
                                   Vector& c) {
    TwoArms::mass_matrix_and_bias(q, qd, in, M, c);
    M(2, 5) = M(5, 2) = 0.1;
  }
};

TEST(Linearize, WhatATypeAddsToTheMassMatrixOfAnotherIsSeen) {
  using M = TiedArms;
  const M::Vector none = M::Vector::Zero();
  alembert::Linearization<M> out;
  ASSERT_EQ(alembert::linearize<M>(none, none, M::Vector::Ones(), {0.5}, out), Status::ok);
  M::Matrix mass;
  M::Vector bias;
  M::mass_matrix_and_bias(none, none, {0.5}, mass, bias);
  EXPECT_LT((mass * out.qdd - M::Vector::Ones()).norm(), 1e-13);
  EXPECT_LT((mass * out.qdd_tau - M::Matrix::Identity()).norm(), 1e-13);
}

/// Euler's equations of a free body, J w' = tau - w x J w: w'_1 = (tau_1 - (J_3 - J_2) w_2 w_3) / J_1.
TEST(Linearize, SpinningBody) {
  using M = SpinningBody<>;
  const M::Vector w(0.3, -0.8, 0.5), tau(0.1, 0.2, -0.4), J = M::inertia();
  alembert::Linearization<M> out;
  ASSERT_EQ(alembert::linearize<M>(Eigen::Vector4d(0, 0, 0, 1), w, tau, {}, out), Status::ok);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double gyration = (J(k) - J(j)) / J(i);
    EXPECT_NEAR(out.qdd(i), tau(i) / J(i) - gyration * w(j) * w(k), 1e-15);
    EXPECT_NEAR(out.qdd_qd(i, i), 0, 1e-15);
    EXPECT_NEAR(out.qdd_qd(i, j), -gyration * w(k), 1e-15);
    EXPECT_NEAR(out.qdd_qd(i, k), -gyration * w(j), 1e-15);
    EXPECT_NEAR(out.qdd_tau(i, i), 1 / J(i), 1e-15);
  }
  EXPECT_EQ(out.qdd_q.norm(), 0.0);
}

TEST(Integrate, OrderOfConvergenceWithQuaternions) {
  using M = SpinningBody<>;
  const auto rk4 = [](Eigen::Vector4d& q, Eigen::Vector3d& w, M::Inputs& in, double h) {
    return alembert::rk4_step<M>(q, w, in, h, no_force<M>);
  };
  const auto euler = [](Eigen::Vector4d& q, Eigen::Vector3d& w, M::Inputs& in, double h) {
    return alembert::semi_implicit_euler_step<M>(q, w, in, h, no_force<M>);
  };
  Eigen::Vector4d q(0, 0, 0, 1);
  Eigen::Vector3d w(1, 0.5, -2);
  M::Inputs in;
  for (int i = 0; i < 4000; ++i) ASSERT_EQ(rk4(q, w, in, 1.0 / 4000), Status::ok);
  const double rk4_order = std::log2(spin_error(rk4, 20, q, w) / spin_error(rk4, 40, q, w));
  EXPECT_NEAR(rk4_order, 4.0, 0.2);
  const double euler_order = std::log2(spin_error(euler, 1000, q, w) / spin_error(euler, 2000, q, w));
  EXPECT_NEAR(euler_order, 1.0, 0.1);
}

TEST(Integrate, FreeSpinKeepsEnergyAndMomentum) {
  using M = SpinningBody<>;
  Eigen::Vector4d q(0, 0, 0, 1);
  Eigen::Vector3d w(0.01, 3, 0.02);  // about the middle axis: it tumbles
  M::Inputs in;
  const auto momentum = [](const Eigen::Vector4d& p, const Eigen::Vector3d& u) {
    return Eigen::Vector3d(Eigen::Quaterniond(p) * M::inertia().cwiseProduct(u));
  };
  const double energy = alembert::energy<M>(q, w, in).total();
  EXPECT_NEAR(energy, alembert::kinetic_energy<M>(q, w, in), 1e-15 * energy);
  const Eigen::Vector3d before = momentum(q, w);
  for (int i = 0; i < 20000; ++i) ASSERT_EQ(alembert::rk4_step<M>(q, w, in, 1e-3, no_force<M>), Status::ok);
  EXPECT_NEAR(alembert::energy<M>(q, w, in).total(), energy, 1e-10 * energy);
  EXPECT_LT((momentum(q, w) - before).norm(), 1e-9);
}

TEST(Integrate, PendulumEnergy) {
  using M = Pendulum<>;
  M::Vector q(2.0), qd(0.0);
  M::Inputs in;
  const double start = alembert::energy<M>(q, qd, in).total();
  double worst = 0;
  for (int i = 0; i < 10000; ++i) {
    ASSERT_EQ(alembert::semi_implicit_euler_step<M>(q, qd, in, 1e-3, no_force<M>), Status::ok);
    worst = std::max(worst, std::abs(alembert::energy<M>(q, qd, in).total() - start));
  }
  EXPECT_LT(worst, 0.05);  // bounded: it oscillates with h instead of growing
  q(0) = 2.0;
  qd(0) = 0.0;
  for (int i = 0; i < 10000; ++i) ASSERT_EQ(alembert::rk4_step<M>(q, qd, in, 1e-3, no_force<M>), Status::ok);
  EXPECT_NEAR(alembert::energy<M>(q, qd, in).total(), start, 1e-9);
}

TEST(Integrate, ForceSeesTimeOfTheStage) {
  // m l^2 qdd = tau with gravity cancelled: qdd = t exactly integrates to t^3/6 under order 4.
  using M = Pendulum<>;
  M::Vector q(0.0), qd(0.0);
  M::Inputs in;
  const auto force = [](double t, const M::Vector& x, const M::Vector&) {
    return M::Vector(M::m * M::l * M::l * t + M::m * M::g * M::l * std::sin(x(0)));
  };
  for (int i = 0; i < 10; ++i) ASSERT_EQ(alembert::rk4_step<M>(q, qd, in, 0.1, force), Status::ok);
  EXPECT_NEAR(q(0), 1.0 / 6, 1e-14);
  EXPECT_NEAR(qd(0), 0.5, 1e-14);
}

TEST(Integrate, RepeatedStepsCountTime) {
  using M = Pendulum<>;
  M::Vector q(0.1), qd(0.0), by_one(0.1), speed(0.0);
  M::Inputs in, summed;
  const int n = 100000;
  ASSERT_EQ(alembert::repeat_step(in.t, 1e-3, n,
                                  [&] { return alembert::rk4_step<M>(q, qd, in, 1e-3, no_force<M>); }),
            Status::ok);
  EXPECT_EQ(in.t, n * 1e-3);
  for (int i = 0; i < n; ++i)
    ASSERT_EQ(alembert::rk4_step<M>(by_one, speed, summed, 1e-3, no_force<M>), Status::ok);
  EXPECT_NE(summed.t, in.t) << "no test at all";
  EXPECT_EQ(q(0), by_one(0));
  EXPECT_EQ(qd(0), speed(0));
  // The first step that fails is the last.
  int calls = 0;
  in.t = 2;
  const auto until = [&] {
    in.t += 0.5;
    return ++calls == 3 ? Status::no_convergence : Status::ok;
  };
  EXPECT_EQ(alembert::repeat_step(in.t, 0.5, 10, until), Status::no_convergence);
  EXPECT_EQ(calls, 3);
  EXPECT_EQ(alembert::repeat_step(in.t, 0.5, 0, until), Status::ok);
  EXPECT_EQ(alembert::repeat_step(in.t, 0.5, -1, until), Status::ok);
  EXPECT_EQ(calls, 3);
}

TEST(Integrate, FailureLeavesTheStateAlone) {
  using M = Pendulum<>;
  const auto bad_later = [](double t, const M::Vector&, const M::Vector&) {
    return M::Vector(t > 0 ? kNan : 0.0);
  };
  M::Vector q(0.3), qd(0.2);
  M::Inputs in;
  EXPECT_EQ(alembert::rk4_step<M>(q, qd, in, 0.1, bad_later), Status::not_finite);
  EXPECT_EQ(q(0), 0.3);
  EXPECT_EQ(qd(0), 0.2);
  EXPECT_EQ(in.t, 0.0);
  const auto bad = [](double, const M::Vector&, const M::Vector&) { return M::Vector(kInfinity); };
  EXPECT_EQ(alembert::semi_implicit_euler_step<M>(q, qd, in, 0.1, bad), Status::not_finite);
  EXPECT_EQ(q(0), 0.3);
  using Q = SpinningBody<>;
  Eigen::Vector4d zero = Eigen::Vector4d::Zero();
  EXPECT_EQ(alembert::normalize_quaternions<Q>(zero), Status::not_finite);
  EXPECT_EQ(zero.norm(), 0.0);
}

template <class M>
std::size_t allocations_of_all_calls(alembert::CoordinateVector<M> q) {
  alembert::SpeedVector<M> qd = alembert::SpeedVector<M>::Constant(0.1), qdd;
  typename M::Inputs in{};
  in.t = 1;
  Eigen::internal::set_is_malloc_allowed(false);
  const std::size_t before = allocation_count();
  bool ok = alembert::forward_dynamics<M>(q, qd, qd, in, qdd) == Status::ok;
  ok = ok && alembert::rk4_step<M>(q, qd, in, 1e-3, no_force<M>) == Status::ok;
  ok = ok && alembert::semi_implicit_euler_step<M>(q, qd, in, 1e-3, no_force<M>) == Status::ok;
  ok = ok && alembert::kinetic_energy<M>(q, qd, in) > 0;
  if constexpr (alembert::has_derivatives_v<M>) {
    alembert::Linearization<M> out;
    ok = ok && alembert::linearize<M>(q, qd, qd, in, out) == Status::ok;
  }
  const std::size_t after = allocation_count();
  Eigen::internal::set_is_malloc_allowed(true);
  EXPECT_TRUE(ok);
  return after - before;
}

TEST(Runtime, NoHeapInAnyCall) {
  // The counter works at all:
  const std::size_t before = allocation_count();
  ::operator delete(::operator new(sizeof(int)));  // a new-expression might be optimised away
  ASSERT_GT(allocation_count(), before);
  EXPECT_EQ(allocations_of_all_calls<Pendulum<>>(Eigen::Matrix<double, 1, 1>(0.5)), 0u);
  EXPECT_EQ(allocations_of_all_calls<SpinningBody<>>(Eigen::Vector4d(0, 0, 0, 1)), 0u);
  EXPECT_EQ(allocations_of_all_calls<Dense<60>>(Dense<60>::Vector::Zero()), 0u);
  EXPECT_EQ(allocations_of_all_calls<Dense<110>>(Dense<110>::Vector::Zero()), 0u);
}

TEST(Runtime, StatusInWords) {
  EXPECT_STREQ(alembert::to_string(Status::ok), "ok");
  EXPECT_STREQ(alembert::to_string(Status::not_finite), "a value is not finite");
  EXPECT_STREQ(alembert::to_string(Status::not_positive_definite),
               "the mass matrix is not positive definite");
  EXPECT_STREQ(alembert::to_string(Status::inconsistent_constraints),
               "the constraints contradict each other");
  EXPECT_STREQ(alembert::to_string(Status::no_convergence), "the iteration found no solution");
  EXPECT_STREQ(alembert::to_string(Status::residual_too_large), "the closest state is too far away");
  EXPECT_STREQ(alembert::to_string(Status::singular_step), "the equations of the implicit step are singular");
  EXPECT_STREQ(alembert::to_string(Status::missing_function),
               "the mechanism was generated without a function that is needed");
}

}  // namespace
