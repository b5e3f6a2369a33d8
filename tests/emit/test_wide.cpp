// A mechanism whose matrices Eigen does not hold on the stack: its wrappers, and all that the runtime does
// with it, are those of each of its 130 pendulums, m l^2 qdd + m g l sin q = tau with m = 2 kg and l = 0.5 m.
#include <gtest/gtest.h>
#include <pthread.h>

#include <cmath>
#include <vector>
#include <wide_row/wide_row.hpp>
#include <wide_row/wide_row_batch.hpp>

#include "alembert/body_motion.hpp"
#include "alembert/consistent_state.hpp"
#include "alembert/energy.hpp"
#include "alembert/integrate.hpp"
#include "alembert/linearize.hpp"
#include "alembert/topology.hpp"

namespace {

using alembert::Status;
using M = wide::wide_row::Mechanism<double>;
constexpr double kM = 2, kL = 0.5, kG = 9.81;

static_assert(alembert::has_energy_v<M> && alembert::has_constraints_v<M> && alembert::has_derivatives_v<M> &&
              alembert::has_bodies_v<M>);
static_assert(M::kNv == 130 && M::kNc == 129 && M::SpeedMatrix::SizeAtCompileTime == Eigen::Dynamic);
static_assert(wide::wide_row::Mechanism<float>::SpeedMatrix::SizeAtCompileTime == 130 * 130, "fits in float");

M::SpeedVector no_force(double, const M::CoordinateVector&, const M::SpeedVector&) {
  return M::SpeedVector::Zero();
}

M::CoordinateVector spread() {
  M::CoordinateVector q;
  for (int i = 0; i < M::kNq; ++i) q(i) = 0.01 * i - 0.6;
  return q;
}

TEST(Wide, FunctionsAreThoseOfEachPendulum) {
  const M::CoordinateVector q = spread();
  const M::SpeedMatrix mass = M::mass_matrix(q);
  ASSERT_EQ(mass.rows(), 130);
  ASSERT_EQ(mass.cols(), 130);
  EXPECT_LT((mass - kM * kL * kL * M::SpeedMatrix::Identity()).cwiseAbs().maxCoeff(), 1e-15);
  const auto J = M::body_jacobians(q);
  ASSERT_EQ(J.rows(), 780);
  const auto inertias = M::body_inertias();
  for (int i = 0; i < M::kNv; ++i) {
    EXPECT_EQ(J(6 * i + 1, i), 1);
    EXPECT_NEAR(J(6 * i + 3, i), -kL * std::cos(q(i)), 1e-15);
    EXPECT_EQ(J.row(6 * i + 3).squaredNorm(), J(6 * i + 3, i) * J(6 * i + 3, i));
    EXPECT_EQ(inertias(i, 0), kM);
  }
}

TEST(Wide, TheRuntimeTakesThem) {
  M::CoordinateVector q = spread();
  M::SpeedVector u = M::SpeedVector::Zero(), qdd;
  M::Inputs in;
  ASSERT_EQ(alembert::forward_dynamics<M>(q, u, u, in, qdd), Status::ok);
  alembert::Linearization<M> linear;
  ASSERT_EQ(alembert::linearize<M>(q, u, u, in, linear), Status::ok);
  for (int i = 0; i < M::kNv; ++i) {
    EXPECT_NEAR(qdd(i), -kG / kL * std::sin(q(i)), 1e-12);
    EXPECT_NEAR(linear.qdd_q(i, i), -kG / kL * std::cos(q(i)), 1e-12);
    EXPECT_NEAR(linear.qdd_tau(i, i), 1 / (kM * kL * kL), 1e-12);
  }
}

/// Accelerations of 20 states, where a thread has little memory for variables: the matrices of a pack are
/// larger.
void* accelerations_of_many(void* failures) {
  constexpr std::size_t kN = 20, kV = M::kNv;
  std::vector<double> q(kN * kV), u(kN * kV, 0.0), qdd(kN * kV, 7.0);
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = 0.001 * static_cast<double>(i) - 1;
  std::size_t& failed = *static_cast<std::size_t*>(failures);
  failed = wide::wide_row::forward_dynamics_batch(kN, kN, q.data(), u.data(), u.data(), {}, qdd.data());
  for (std::size_t i = 0; i < q.size(); ++i)
    failed += std::fabs(qdd[i] + kG / kL * std::sin(q[i])) < 1e-12 ? 0 : 1;
  return nullptr;
}

TEST(Wide, ManyStatesInAThreadWithASmallStack) {
  pthread_attr_t attributes;
  ASSERT_EQ(pthread_attr_init(&attributes), 0);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, 1 << 19), 0);
  pthread_t thread;
  std::size_t failures = 1;
  ASSERT_EQ(pthread_create(&thread, &attributes, accelerations_of_many, &failures), 0);
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
  EXPECT_EQ(failures, 0U);
}

TEST(Wide, StepsKeepConstraintsAndEnergy) {
  M::CoordinateVector q = M::CoordinateVector::Constant(0.5);
  M::SpeedVector u = M::SpeedVector::Zero();
  q(17) = 0.49;
  M::Inputs in;
  alembert::ConstraintReport<M::kNc> report;
  ASSERT_EQ(alembert::consistent_state<M>(q, u, in, report), Status::ok);
  EXPECT_EQ(report.rank, 129);
  EXPECT_LT((q.array() - q(0)).abs().maxCoeff(), 1e-12);
  alembert::ConstrainedMotionOf<M> motion;
  ASSERT_EQ(alembert::constrained_forward_dynamics<M>(q, u, u, in, motion), Status::ok);
  EXPECT_LT((motion.qdd.array() + kG / kL * std::sin(q(0))).abs().maxCoeff(), 1e-10);
  alembert::Energy<double> before{}, after{};
  ASSERT_EQ(alembert::energy<M>(q, u, in, before), Status::ok);
  ASSERT_EQ(
      alembert::repeat_step(in.t, 0.01, 5, [&] { return alembert::rk4_step<M>(q, u, in, 0.01, no_force); }),
      Status::ok);
  EXPECT_EQ(in.t, 0.05);
  ASSERT_EQ(alembert::energy<M>(q, u, in, after), Status::ok);
  EXPECT_NEAR(after.total(), before.total(), 1e-6 * std::fabs(before.total()));
  EXPECT_LT((q.array() - q(0)).abs().maxCoeff(), 1e-12);
}

TEST(Wide, ChangesOfTopology) {
  const M::CoordinateVector q = M::CoordinateVector::Constant(0.3);
  const M::SpeedVector u = M::SpeedVector::Constant(0.7);
  M::CoordinateVector next = M::CoordinateVector::Constant(0.31);
  M::SpeedVector speeds;
  const auto bodies = alembert::body_motions<M>(q, u, {});
  ASSERT_EQ(alembert::change_topology<M>(bodies, {}, next, speeds), Status::ok);
  EXPECT_LT((next - q).norm(), 1e-9);
  EXPECT_LT((speeds - u).norm(), 1e-9);
}

}  // namespace
