// Constrained motion of mechanisms written by hand: closed forms, the same mechanism in fewer coordinates,
// redundant and contradictory rows, consistent states, no heap.
#include "alembert/constrained_dynamics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "alembert/consistent_state.hpp"
#include "alembert/energy.hpp"
#include "alembert/integrate.hpp"
#include "runtime/allocation_counter.hpp"
#include "runtime/constrained_models.hpp"

namespace {

using alembert::Status;
using models::HeldTop;
using models::no_force;
using models::Pendulum;
using models::PointOnRod;
using models::Rod;
using models::Sleigh;

static_assert(alembert::has_constraints_v<PointOnRod<>> && alembert::has_constraints_v<Sleigh<float>>);
static_assert(!alembert::has_constraints_v<Pendulum<>>);

template <class M>
using Report = alembert::ConstraintReport<M::kNc>;

/// Largest violation of the constraints at a state.
template <class M>
double residual(const alembert::CoordinateVector<M>& q, const alembert::SpeedVector<M>& u,
                const typename M::Inputs& in) {
  typename M::ConstraintMatrix P;
  typename M::ConstraintVector gamma, velocity, position;
  M::constraints(q, u, in, P, gamma, velocity, position);
  return double(std::max(velocity.cwiseAbs().maxCoeff(), position.cwiseAbs().maxCoeff()));
}

TEST(ConstrainedDynamics, PendulumInTwoCoordinatesIsThePendulumInOne) {
  using M = PointOnRod<>;
  using P = Pendulum<>;
  P::Vector angle(2.0), rate(0.5);
  M::Vector q(M::l * std::sin(2.0), -M::l * std::cos(2.0)),
      u(0.5 * M::l * std::cos(2.0), 0.5 * M::l * std::sin(2.0));
  P::Inputs in_p;
  M::Inputs in;
  alembert::ConstrainedMotionOf<M> motion;
  for (int i = 0; i < 5000; ++i) {
    ASSERT_EQ(alembert::constrained_forward_dynamics<M>(q, u, M::Vector::Zero(), in, motion), Status::ok);
    const double tension = M::m * M::l * rate(0) * rate(0) + M::m * M::g * std::cos(angle(0));
    ASSERT_NEAR(motion.lambda(0), -tension / M::l, 1e-6);
    ASSERT_EQ(alembert::rk4_step<M>(q, u, in, 1e-3, no_force<M>), Status::ok);
    ASSERT_EQ(alembert::rk4_step<P>(angle, rate, in_p, 1e-3, no_force<P>), Status::ok);
  }
  EXPECT_NEAR(q(0), M::l * std::sin(angle(0)), 1e-9);
  EXPECT_NEAR(q(1), -M::l * std::cos(angle(0)), 1e-9);
  EXPECT_LT(residual<M>(q, u, in), 1e-12);
}

TEST(ConstrainedDynamics, SleighFollowsItsClosedForm) {
  // v = V tanh(s t), w = W / cosh(s t) with s = m a V / J; theta = (W / s) 2 atan(tanh(s t / 2)).
  using M = Sleigh<>;
  const double W = 2.0, V = W * std::sqrt(M::J / M::m), s = M::m * M::a * V / M::J;
  M::Vector q = M::Vector::Zero(), u(0, 0, W);
  M::Inputs in;
  double worst = 0, worst_residual = 0;
  for (int i = 1; i <= 6000; ++i) {  // 60 s in steps of 0.01 s
    ASSERT_EQ(alembert::rk4_step<M>(q, u, in, 0.01, no_force<M>), Status::ok);
    const double v = u(0) * std::cos(q(2)) + u(1) * std::sin(q(2));
    worst = std::max({worst, std::abs(v - V * std::tanh(s * in.t)), std::abs(u(2) - W / std::cosh(s * in.t)),
                      std::abs(q(2) - 2 * W / s * std::atan(std::tanh(s * in.t / 2)))});
    worst_residual = std::max(worst_residual, residual<M>(q, u, in));
    const double kinetic = alembert::kinetic_energy<M>(q, u, in);
    ASSERT_NEAR(kinetic, M::J * W * W / 2, 1e-8);
  }
  EXPECT_LT(worst, 1e-7);
  EXPECT_LT(worst_residual, 1e-14);
}

TEST(ConstrainedDynamics, HeldTopKeepsWhatATopKeepsForAMinute) {
  using M = HeldTop<>;
  Eigen::Matrix<double, 7, 1> q;
  const Eigen::Quaterniond tilt(Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitX()));
  q << tilt * Eigen::Vector3d(0, 0, M::length), tilt.x(), tilt.y(), tilt.z(), tilt.w();
  Eigen::Matrix<double, 6, 1> u;
  u << 0, 0, 0, 0, 0, 40;
  M::Inputs in;
  Report<M> report;
  ASSERT_EQ(alembert::consistent_state<M>(q, u, in, report), Status::ok);
  EXPECT_EQ(report.rank, 3);
  const auto vertical = [](const auto& x, const auto& v) {  // angular momentum about the world's z axis
    const Eigen::Vector3d r = x.template head<3>(), p = M::m * v.template head<3>();
    return r.cross(p).z() + (M::rotation(x) * M::inertia().cwiseProduct(v.template tail<3>())).z();
  };
  const double energy = alembert::energy<M>(q, u, in).total(), spin = u(5), momentum = vertical(q, u);
  double worst_energy = 0, worst_residual = 0, lowest = q(2);
  for (int i = 0; i < 60000; ++i) {
    ASSERT_EQ(alembert::rk4_step<M>(q, u, in, 1e-3, no_force<M>), Status::ok);
    worst_energy = std::max(worst_energy, std::abs(alembert::energy<M>(q, u, in).total() - energy));
    worst_residual = std::max(worst_residual, residual<M>(q, u, in));
    lowest = std::min(lowest, q(2));
  }
  RecordProperty("energy_drift", testing::PrintToString(worst_energy / energy));
  RecordProperty("residual", testing::PrintToString(worst_residual));
  EXPECT_LT(worst_energy, 1e-5 * energy);
  EXPECT_LT(worst_residual, 1e-8);
  EXPECT_LT(lowest, 0.9 * M::length * std::cos(0.4));  // it nutates
  EXPECT_NEAR(u(5), spin, 1e-6 * spin);
  EXPECT_NEAR(vertical(q, u), momentum, 1e-5 * momentum);
}

TEST(ConstrainedDynamics, ProjectionHasTheOrderOfTheMethod) {
  // The error in energy of the projected method falls with the fourth power of the step or faster.
  using M = PointOnRod<>;
  const auto drift = [](double h) {
    M::Vector q(M::l, 0), u(0, -1);
    M::Inputs in;
    const double energy = alembert::energy<M>(q, u, in).total();
    double worst = 0;
    for (int i = 0; i < std::lround(10 / h); ++i) {
      EXPECT_EQ(alembert::rk4_step<M>(q, u, in, h, no_force<M>), Status::ok);
      worst = std::max(worst, std::abs(alembert::energy<M>(q, u, in).total() - energy));
    }
    return worst;
  };
  EXPECT_GT(std::log2(drift(0.02) / drift(0.01)), 3.8);
}

template <Rod rod>
void check_first_row_alone_moves_it() {
  using M = PointOnRod<double, rod>;
  using Once = PointOnRod<>;
  Once::Vector q(0.3, -0.4), u(0.8, 0.6);
  typename M::Vector q2 = q, u2 = u;
  Once::Inputs in;
  typename M::Inputs in2;
  Report<M> report;
  for (int i = 0; i < 1000; ++i) {
    ASSERT_EQ(alembert::rk4_step<Once>(q, u, in, 1e-3, no_force<Once>), Status::ok);
    ASSERT_EQ(alembert::rk4_step<M>(q2, u2, in2, 1e-3, no_force<M>, {}, &report), Status::ok);
  }
  EXPECT_LT((q - q2).norm() + (u - u2).norm(), 1e-12);
  EXPECT_EQ(report.rank, 1);
  EXPECT_FALSE(report.redundant(0));
  EXPECT_TRUE(report.redundant(1));
}

TEST(ConstrainedDynamics, RedundantRowsChangeNothing) {
  check_first_row_alone_moves_it<Rod::twice>();
}

TEST(ConstrainedDynamics, ContradictoryRowsAreNamed) {
  using M = PointOnRod<double, Rod::contradictory>;
  M::Vector q(0.3, -0.4), u(0.8, 0.6);
  const M::Vector before = q;
  M::Inputs in;
  Report<M> report;
  EXPECT_EQ(alembert::consistent_state<M>(q, u, in, report), Status::inconsistent_constraints);
  EXPECT_EQ(report.inconsistent_row, 1);
  EXPECT_EQ(q, before);
  report.inconsistent_row = -1;
  EXPECT_EQ(alembert::rk4_step<M>(q, u, in, 1e-3, no_force<M>, {}, &report),
            Status::inconsistent_constraints);
  EXPECT_EQ(report.inconsistent_row, 1);
  EXPECT_EQ(q, before);
  EXPECT_EQ(in.t, 0);
  // With stabilisation the two rows ask for different accelerations too.
  alembert::ConstrainedMotionOf<M> motion;
  EXPECT_EQ(alembert::constrained_forward_dynamics<M>(q, u, u, in, motion, {10, 10}),
            Status::inconsistent_constraints);
  EXPECT_EQ(motion.inconsistent_row, 1);
}

TEST(ConstrainedDynamics, StabilisationFadesAViolationAsItIsMeantTo) {
  // phi'' + 2 a phi' + a^2 phi = 0 from phi'(0) = 0: phi = phi(0) (1 + a t) exp(-a t).
  using M = PointOnRod<>;
  M::Vector q(0.6, 0), u(0, 0.3);
  M::Inputs in;
  alembert::StepOptions<double> options;
  options.project = false;
  options.gains = {5, 5};
  const double start = (q.squaredNorm() - M::l * M::l) / 2;
  for (int i = 0; i < 1000; ++i)
    ASSERT_EQ(alembert::rk4_step<M>(q, u, in, 1e-3, no_force<M>, options), Status::ok);
  EXPECT_NEAR((q.squaredNorm() - M::l * M::l) / 2, start * 6 * std::exp(-5.0), 1e-10);
}

TEST(ConsistentState, LeastChangeInKineticEnergy) {
  using M = HeldTop<>;
  Eigen::Matrix<double, 7, 1> q;
  q << 0.1, -0.2, 0.5, 0, 0, 0, 1;
  Eigen::Matrix<double, 6, 1> u;
  u << 1, 2, 3, -1, 0.5, 2;
  M::Inputs in;
  Report<M> report;
  ASSERT_EQ(alembert::project_positions<M>(q, in, report), Status::ok);
  const Eigen::Matrix<double, 6, 1> before = u;
  ASSERT_EQ(alembert::project_velocities<M>(q, u, in, report), Status::ok);
  EXPECT_LT(residual<M>(q, u, in), 1e-12);
  EXPECT_NEAR(q.tail<4>().norm(), 1, 1e-15);
  // The change is orthogonal, in M, to every motion that the constraints allow: M du = P^T lambda.
  Eigen::Matrix<double, 6, 6> mass;
  Eigen::Matrix<double, 6, 1> c;
  M::mass_matrix_and_bias(q, u, in, mass, c);
  M::ConstraintMatrix P;
  M::ConstraintVector gamma, velocity, position;
  M::constraints(q, u, in, P, gamma, velocity, position);
  const Eigen::MatrixXd allowed = P.fullPivLu().kernel();
  EXPECT_EQ(allowed.cols(), 3);
  EXPECT_LT((allowed.transpose() * mass * (u - before)).norm(), 1e-12);
}

TEST(ConsistentState, HeldSpeedsStay) {
  using M = HeldTop<>;
  Eigen::Matrix<double, 7, 1> q;
  q << 0.1, 0.05, 0.2, 0, 0, 0, 1;
  Eigen::Matrix<double, 6, 1> u;
  u << 1, 2, 3, 0, 0, 2;
  M::Inputs in;
  Report<M> report;
  alembert::ProjectionOptionsOf<M> options;
  options.held.setConstant(6, false);
  options.held(0) = true;
  options.held(5) = true;
  ASSERT_EQ(alembert::consistent_state<M>(q, u, in, report, options), Status::ok);
  EXPECT_EQ(q(0), 0.1);
  EXPECT_EQ(u(0), 1);
  EXPECT_EQ(u(5), 2);
  EXPECT_LT(residual<M>(q, u, in), 1e-12);
  // Held too far from the pivot there is no such state.
  q << 0.4, 0.05, 0.2, 0, 0, 0, 1;
  EXPECT_NE(alembert::consistent_state<M>(q, u, in, report, options), Status::ok);
  EXPECT_EQ(q(0), 0.4);
}

TEST(ConsistentState, ReportsWhatIsNotFinite) {
  using M = PointOnRod<>;
  M::Vector q(std::numeric_limits<double>::quiet_NaN(), 1), u(0, 0);
  Report<M> report;
  EXPECT_EQ(alembert::project_positions<M>(q, {}, report), Status::not_finite);
  q = M::Vector(0.5, 0);
  u(0) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(alembert::project_velocities<M>(q, u, {}, report), Status::not_finite);
  // From the pivot itself no direction leads to the circle.
  q.setZero();
  EXPECT_EQ(alembert::project_positions<M>(q, {}, report), Status::inconsistent_constraints);
  EXPECT_EQ(report.inconsistent_row, 0);
}

TEST(ConstrainedDynamics, InFloat) {
  using M = PointOnRod<float>;
  M::Vector q(M::l, 0), u(0, -1);
  M::Inputs in;
  const float energy = alembert::energy<M>(q, u, in).total();
  for (int i = 0; i < 2000; ++i) ASSERT_EQ(alembert::rk4_step<M>(q, u, in, 1e-3f, no_force<M>), Status::ok);
  EXPECT_NEAR(alembert::energy<M>(q, u, in).total(), energy, 1e-3f);
  EXPECT_LT(residual<M>(q, u, in), 1e-4);
  using Twice = PointOnRod<float, Rod::twice>;
  Report<Twice> report;
  for (int i = 0; i < 2000; ++i) {
    Twice::Inputs now;
    ASSERT_EQ(alembert::rk4_step<Twice>(q, u, now, 1e-3f, no_force<Twice>, {}, &report), Status::ok);
    ASSERT_EQ(report.rank, 1);
  }
  using Top = HeldTop<float>;
  Top::CoordinateVector x;
  Top::SpeedVector v;
  x << 0.1f, 0.f, 0.2f, 0.f, 0.f, 0.f, 1.f;
  v << 1.f, 0.f, 0.f, 1.f, 2.f, 30.f;
  Report<Top> top_report;
  ASSERT_EQ(alembert::consistent_state<Top>(x, v, {}, top_report), Status::ok);
  EXPECT_LT(residual<Top>(x, v, {}), 1e-4);
}

template <class M>
std::size_t allocations_of_constrained_calls(alembert::CoordinateVector<M> q) {
  alembert::SpeedVector<M> u = alembert::SpeedVector<M>::Constant(0.1);
  typename M::Inputs in{};
  Report<M> report;
  alembert::ConstrainedMotionOf<M> motion;
  alembert::ProjectionOptionsOf<M> options;
  options.held.setConstant(M::kNv, false);
  Eigen::internal::set_is_malloc_allowed(false);
  const std::size_t before = allocation_count();
  bool ok = alembert::consistent_state<M>(q, u, in, report, options) == Status::ok;
  ok = ok && alembert::constrained_forward_dynamics<M>(q, u, u, in, motion) == Status::ok;
  ok = ok && alembert::rk4_step<M>(q, u, in, 1e-3, no_force<M>) == Status::ok;
  ok = ok && alembert::semi_implicit_euler_step<M>(q, u, in, 1e-3, no_force<M>, {}, &report) == Status::ok;
  const std::size_t after = allocation_count();
  Eigen::internal::set_is_malloc_allowed(true);
  EXPECT_TRUE(ok);
  return after - before;
}

TEST(ConstrainedDynamics, NoHeapInAnyCall) {
  EXPECT_EQ(allocations_of_constrained_calls<PointOnRod<>>({0.3, -0.5}), 0u);
  EXPECT_EQ((allocations_of_constrained_calls<PointOnRod<double, Rod::twice>>({0.3, -0.5})), 0u);
  EXPECT_EQ(allocations_of_constrained_calls<Sleigh<>>({0.1, 0.2, 0.3}), 0u);
  Eigen::Matrix<double, 7, 1> q;
  q << 0.1, -0.2, 0.5, 0, 0, 0, 1;
  EXPECT_EQ(allocations_of_constrained_calls<HeldTop<>>(q), 0u);
}

}  // namespace
