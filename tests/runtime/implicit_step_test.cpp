// Implicit steps against solutions in closed form, on what is stiff, under constraints; failures reported.
#include "alembert/implicit_step.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "alembert/energy.hpp"
#include "runtime/allocation_counter.hpp"
#include "runtime/constrained_models.hpp"
#include "runtime/models.hpp"

namespace {

using alembert::Status;
using models::no_force;

constexpr double kBad = std::numeric_limits<double>::quiet_NaN();

/// A block of m = 2 on a spring k with a damper b, whose other end moves at a speed given: m u' + b u + k (x - v t).
template <class S = double>
struct SpringBlock {
  using Scalar = S;
  struct Inputs {
    S t = S(0), k = S(0), b = S(0), v = S(0);
  };
  using Vector = Eigen::Matrix<S, 1, 1>;
  static constexpr int kNq = 1, kNv = 1;
  static constexpr std::array<int, 0> kQuaternionOffsets{};
  static constexpr S m = S(2);
  static void mass_matrix_and_bias(const Vector& q, const Vector& u, const Inputs& in, Vector& M, Vector& c) {
    M(0) = m;
    c(0) = in.b * u(0) + in.k * (q(0) - in.v * in.t);
  }
  static void inverse_dynamics_derivatives(const Vector&, const Vector&, const Vector&, const Inputs& in,
                                           Vector& tau_q, Vector& tau_qd) {
    tau_q(0) = in.k;
    tau_qd(0) = in.b;
  }
  static Vector coordinate_rates(const Vector&, const Vector& u) { return u; }
  static Eigen::Matrix<S, 2, 1> energy(const Vector& q, const Vector& u, const Inputs& in) {
    return {m * u(0) * u(0) / 2, in.k * q(0) * q(0) / 2};
  }
};

constexpr double power_of_two(int n) {
  return n < 0 ? power_of_two(n + 1) / 2 : n > 0 ? 2 * power_of_two(n - 1) : 1;
}

/// A ball that slides and bounces: Hunt and Crossley's force with regularised friction at z < 0, as in descriptions.
/// Lengths are 4^Size times as large, and masses 16^Size.
template <int Size = 0>
struct SlidingBall {
  using Scalar = double;
  using Inputs = models::Inputs<double>;
  using Vector = Eigen::Vector2d;  // x, z
  static constexpr int kNq = 2, kNv = 2;
  static constexpr std::array<int, 0> kQuaternionOffsets{};
  static constexpr double length = power_of_two(2 * Size), mass = power_of_two(4 * Size);
  static constexpr double m = 1.5 * mass, g = 9.81 * length, k = 1e5 * mass / power_of_two(Size),
                          c = 0.2 / length, mu = 0.6, slow = 0.01 * length;
  static void mass_matrix_and_bias(const Vector& q, const Vector& u, const Inputs&, Eigen::Matrix2d& M,
                                   Vector& bias) {
    M << m, 0, 0, m;
    const double d = std::max(0.0, -q(1)), f = k * d * std::sqrt(d) * std::max(0.0, 1 - 1.5 * c * u(1));
    bias << mu * f * u(0) / std::hypot(u(0), slow), m * g - f;
  }
  static void inverse_dynamics_derivatives(const Vector& q, const Vector& u, const Vector&, const Inputs&,
                                           Eigen::Matrix2d& tau_q, Eigen::Matrix2d& tau_qd) {
    const double d = std::max(0.0, -q(1)), damped = std::max(0.0, 1 - 1.5 * c * u(1));
    const double f = k * d * std::sqrt(d) * damped, f_z = -1.5 * k * std::sqrt(d) * damped;
    const double f_u = damped > 0 ? -1.5 * c * k * d * std::sqrt(d) : 0, size = std::hypot(u(0), slow);
    tau_q << 0, mu * f_z * u(0) / size, 0, -f_z;
    tau_qd << mu * f * slow * slow / (size * size * size), mu * f_u * u(0) / size, 0, -f_u;
  }
  static Vector coordinate_rates(const Vector&, const Vector& u) { return u; }
  static Eigen::Vector2d energy(const Vector& q, const Vector& u, const Inputs&) {
    return {m * u.squaredNorm() / 2, m * g * q(1) + k * std::pow(std::max(0.0, -q(1)), 2.5) / 2.5};
  }
};

static_assert(alembert::has_derivatives_v<SpringBlock<>> && alembert::has_derivatives_v<SlidingBall<>>);

enum class Method { linearly_implicit, implicit };

template <class M, class Force = decltype(&no_force<M>)>
Status step(Method method, alembert::CoordinateVector<M>& q, alembert::SpeedVector<M>& u,
            typename M::Inputs& in, typename M::Scalar h, Force force = &no_force<M>) {
  return method == Method::implicit ? alembert::implicit_euler_step<M>(q, u, in, h, force)
                                    : alembert::linearly_implicit_euler_step<M>(q, u, in, h, force);
}

class ImplicitSteps : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Both, ImplicitSteps, testing::Values(Method::linearly_implicit, Method::implicit),
                         [](const auto& of) {
                           return std::string(of.param == Method::implicit ? "Implicit" : "LinearlyImplicit");
                         });

TEST_P(ImplicitSteps, AreTheImplicitEulerMethodWhereAllIsLinear) {
  using M = SpringBlock<>;
  for (const double h : {1e-3, 1.0 / 60, 2.0, -0.01}) {
    for (const double k : {0.0, 50.0, 1e9}) {
      M::Inputs in{0.5, k, 7, 0.3};
      M::Vector q(0.4), u(-1.2);
      const double end = in.t + h,
                   speed = (M::m * -1.2 - h * k * (0.4 - 0.3 * end)) / (M::m + h * 7 + h * h * k);
      ASSERT_EQ(step<M>(GetParam(), q, u, in, h), Status::ok);
      EXPECT_NEAR(u(0), speed, 1e-13 * (1 + std::abs(speed))) << h << " " << k;
      EXPECT_NEAR(q(0), 0.4 + h * speed, 1e-13) << h << " " << k;
      EXPECT_EQ(in.t, end);
    }
  }
}

TEST_P(ImplicitSteps, WhatIsInfinitelyStiffIsThereInOneStep) {
  using M = SpringBlock<>;
  M::Inputs in{0, 1e14, 0, 2};
  M::Vector q(5), u(1);
  ASSERT_EQ(step<M>(GetParam(), q, u, in, 0.1), Status::ok);
  EXPECT_NEAR(q(0), 2 * 0.1, 1e-9) << "the moving end at the end of the step";
}

TEST_P(ImplicitSteps, TakeTheEnergyOfAnOscillationThatTheyShould) {
  using M = SpringBlock<>;
  M::Inputs in{0, 50, 0, 0};
  M::Vector q(0.4), u(0.0);
  const double h = 1.0 / 60, start = alembert::energy<M>(q, u, in).total();
  for (int n = 1; n <= 120; ++n) {
    ASSERT_EQ(step<M>(GetParam(), q, u, in, h), Status::ok);
    EXPECT_NEAR(alembert::energy<M>(q, u, in).total(), start * std::pow(1 + 25 * h * h, -n), 1e-12 * start);
  }
}

// Eigenvalues -a and -b: one fades in 0.5 ms, the other in 2 s.
TEST_P(ImplicitSteps, ConvergeToAStiffDampedOscillatorsEnergyByOrderOne) {
  using M = SpringBlock<>;
  const double a = 2000, b = 0.5, t = 1;
  const auto exact_x = [&](double time) {
    return (a * std::exp(-b * time) - b * std::exp(-a * time)) / (a - b);
  };
  const auto exact_u = [&](double time) {
    return a * b * (std::exp(-a * time) - std::exp(-b * time)) / (a - b);
  };
  const auto error = [&](int n) {
    M::Inputs in{0, M::m * a * b, M::m * (a + b), 0};
    M::Vector q(1), u(0.0);
    for (int i = 0; i < n; ++i) EXPECT_EQ(step<M>(GetParam(), q, u, in, t / n), Status::ok);
    const double energy = (M::m * exact_u(t) * exact_u(t) + in.k * exact_x(t) * exact_x(t)) / 2;
    return alembert::energy<M>(q, u, in).total() / energy - 1;
  };
  EXPECT_NEAR(error(60), b * b / 60, 1e-4) << "closed form of the error: t b^2 h";
  EXPECT_NEAR(std::log2(error(60) / error(120)), 1, 0.02);
  // What it is for: the explicit methods are gone by then.
  M::Inputs in{0, M::m * a * b, M::m * (a + b), 0};
  M::Vector q(1), u(0.0);
  for (int i = 0; i < 10; ++i) ASSERT_EQ(alembert::rk4_step<M>(q, u, in, t / 60, no_force<M>), Status::ok);
  EXPECT_GT(std::abs(q(0)), 1e6);
}

TEST_P(ImplicitSteps, AreOfOrderOneWithQuaternions) {
  using M = models::SpinningBody<>;
  const auto spin = [&](int n, bool exact) {
    Eigen::Vector4d q(0, 0, 0, 1);
    Eigen::Vector3d w(1, 0.5, -2);
    M::Inputs in;
    for (int i = 0; i < n; ++i) {
      EXPECT_EQ(exact ? alembert::rk4_step<M>(q, w, in, 1.0 / n, no_force<M>)
                      : step<M>(GetParam(), q, w, in, 1.0 / n),
                Status::ok);
    }
    EXPECT_NEAR(q.norm(), 1.0, 1e-15);
    Eigen::Matrix<double, 7, 1> state;
    state << q, w;
    return state;
  };
  const Eigen::Matrix<double, 7, 1> exact = spin(2000, true);
  const double coarse = (spin(500, false) - exact).norm(), fine = (spin(1000, false) - exact).norm();
  EXPECT_NEAR(std::log2(coarse / fine), 1, 0.05);
}

TEST_P(ImplicitSteps, KeepConstraints) {
  using M = models::PointOnRod<>;
  using P = models::Pendulum<>;
  P::Vector angle(1.2), rate(0.0);
  P::Inputs in;
  for (int i = 0; i < 500; ++i)
    ASSERT_EQ(alembert::rk4_step<P>(angle, rate, in, 1e-3, no_force<P>), Status::ok);
  const auto error = [&](int n) {
    M::Vector q(M::l * std::sin(1.2), -M::l * std::cos(1.2)), u(0, 0);
    M::Inputs inputs;
    for (int i = 0; i < n; ++i) EXPECT_EQ(step<M>(GetParam(), q, u, inputs, 0.5 / n), Status::ok);
    EXPECT_NEAR(q.norm(), M::l, 1e-12);
    EXPECT_NEAR(q.dot(u), 0, 1e-12);
    return std::abs(std::atan2(q(0), -q(1)) - angle(0));
  };
  EXPECT_LT(error(500), 5e-3);
  EXPECT_NEAR(std::log2(error(250) / error(500)), 1, 0.1);
}

TEST_P(ImplicitSteps, TellRowsThatDependAndRowsThatContradict) {
  using Once = models::PointOnRod<>;
  using Twice = models::PointOnRod<double, models::Rod::twice>;
  Once::Vector q(0.3, -0.4), u(0, 0), q2 = q, u2 = u;
  Once::Inputs in, in2;
  alembert::ConstraintReport<2> report;
  for (int i = 0; i < 30; ++i) {
    ASSERT_EQ(step<Once>(GetParam(), q, u, in, 0.01), Status::ok);
    ASSERT_EQ(
        GetParam() == Method::implicit
            ? alembert::implicit_euler_step<Twice>(q2, u2, in2, 0.01, no_force<Twice>, {}, &report)
            : alembert::linearly_implicit_euler_step<Twice>(q2, u2, in2, 0.01, no_force<Twice>, {}, &report),
        Status::ok);
  }
  EXPECT_EQ(report.rank, 1);
  EXPECT_LT((q - q2).norm(), 1e-12);
  using Not = models::PointOnRod<double, models::Rod::contradictory>;
  Not::Vector at(0.3, -0.4), speed(1, 0);
  Not::Inputs inputs;
  EXPECT_EQ(step<Not>(GetParam(), at, speed, inputs, 0.01), Status::inconsistent_constraints);
  EXPECT_EQ(at, Not::Vector(0.3, -0.4));
  EXPECT_EQ(speed, Not::Vector(1, 0));
  EXPECT_EQ(inputs.t, 0);
}

TEST_P(ImplicitSteps, HoldATopWithAQuaternionAtItsPoint) {
  using M = models::HeldTop<>;
  M::CoordinateVector q;
  q << 0, 0, 0, 0.1, 0, 0, 1;
  M::SpeedVector u = M::SpeedVector::Zero();
  u(5) = 60;
  M::Inputs in;
  alembert::ConstraintReport<3> report;
  ASSERT_EQ(alembert::consistent_state<M>(q, u, in, report), Status::ok);
  const double energy = alembert::energy<M>(q, u, in).total();
  for (int i = 0; i < 600; ++i) ASSERT_EQ(step<M>(GetParam(), q, u, in, 1e-3), Status::ok);
  EXPECT_LT((q.head<3>() + M::rotation(q) * M::pivot()).norm(), 1e-12);
  EXPECT_NEAR(alembert::energy<M>(q, u, in).total(), energy, 0.02 * energy);
}

TEST_P(ImplicitSteps, AnswerWhatHasNoStep) {
  using M = SpringBlock<>;
  const double h = 0.25;
  M::Inputs in{0, -M::m / (h * h), 0, 0};
  M::Vector q(0.3), u(0.1);
  if (GetParam() == Method::linearly_implicit) {
    EXPECT_EQ(step<M>(GetParam(), q, u, in, h), Status::singular_step);
    EXPECT_EQ(u(0), 0.1);
  } else {  // by two halves
    EXPECT_EQ(step<M>(GetParam(), q, u, in, h), Status::ok);
    M::Inputs by_halves{0, -M::m / (h * h), 0, 0};
    M::Vector x(0.3), v(0.1);
    for (int i = 0; i < 2; ++i)
      EXPECT_EQ(step<M>(Method::linearly_implicit, x, v, by_halves, h / 2), Status::ok);
    EXPECT_NEAR(u(0), v(0), 1e-12);
    EXPECT_EQ(in.t, h);
  }
  in = {0, 100, 0, 0};
  q(0) = 0.3;
  u(0) = 0.1;
  EXPECT_EQ(step<M>(GetParam(), q, u, in, kBad), Status::not_finite);
  const auto bad = [](double, const M::Vector&, const M::Vector&) { return M::Vector(kBad); };
  EXPECT_EQ(step<M>(GetParam(), q, u, in, h, bad), Status::not_finite);
  in.k = kBad;
  EXPECT_EQ(step<M>(GetParam(), q, u, in, h), Status::not_finite);
  in.k = 100;
  in.t = std::numeric_limits<double>::infinity();
  EXPECT_EQ(step<M>(GetParam(), q, u, in, h), Status::not_finite);
  EXPECT_EQ(q(0), 0.3);
  EXPECT_EQ(u(0), 0.1);
  in.t = 0;
  EXPECT_EQ(step<M>(GetParam(), q, u, in, 0), Status::ok);
  EXPECT_EQ(q(0), 0.3);
  EXPECT_EQ(u(0), 0.1);
}

TEST_P(ImplicitSteps, HoldTheForceThatIsGiven) {
  using M = SpringBlock<float>;
  M::Inputs in;
  M::Vector q(0.f), u(0.f);
  const auto force = [](float t, const M::Vector&, const M::Vector&) { return M::Vector(2 + t); };
  ASSERT_EQ(step<M>(GetParam(), q, u, in, 0.5f, force), Status::ok);
  EXPECT_FLOAT_EQ(u(0), 0.5f);
  ASSERT_EQ(step<M>(GetParam(), q, u, in, 0.5f, force), Status::ok);
  EXPECT_FLOAT_EQ(u(0), 0.5f + 0.5f * 2.5f / 2);
}

TEST_P(ImplicitSteps, TakeNoHeap) {
  using M = models::HeldTop<>;
  M::CoordinateVector q;
  q << 0, 0, 0, 0, 0, 0, 1;
  q.head<3>() = -M::pivot();
  M::SpeedVector u = M::SpeedVector::Zero();
  M::Inputs in;
  Eigen::internal::set_is_malloc_allowed(false);
  const std::size_t before = allocation_count();
  const Status status = step<M>(GetParam(), q, u, in, 0.01);
  const std::size_t after = allocation_count();
  Eigen::internal::set_is_malloc_allowed(true);
  EXPECT_EQ(status, Status::ok);
  EXPECT_EQ(after, before);
}

/// Thrown at the ground, 10 s at 60 frames a second. \return the largest gain of energy in a step.
double thrown(Method method, SlidingBall<>::Vector& q, SlidingBall<>::Vector& u) {
  SlidingBall<>::Inputs in;
  q = {0, 1};
  u = {1, -3};
  double gain = 0, energy = alembert::energy<SlidingBall<>>(q, u, in).total();
  for (int i = 0; i < 600; ++i) {
    EXPECT_EQ(step<SlidingBall<>>(method, q, u, in, 1.0 / 60), Status::ok);
    const double next = alembert::energy<SlidingBall<>>(q, u, in).total();
    gain = std::max(gain, next - energy);
    energy = next;
  }
  return gain;
}

TEST(ImplicitStep, ABallComesToRestOnHardGroundAndGainsNothing) {
  using M = SlidingBall<>;
  M::Vector q, u;
  EXPECT_LT(thrown(Method::implicit, q, u), 1e-6);
  EXPECT_NEAR(q(1), -std::pow(M::m * M::g / M::k, 2.0 / 3), 1e-7);
  EXPECT_LT(u.norm(), 1e-6);
  EXPECT_NEAR(q(0), 0.2395, 1.5 / 60) << "it is thrown so far, and friction stops it where it lands";
  // Finite, and at rest in the end; but friction has thrown it about.
  EXPECT_GT(thrown(Method::linearly_implicit, q, u), 1);
  EXPECT_NEAR(q(1), -std::pow(M::m * M::g / M::k, 2.0 / 3), 1e-3);
}

template <int Size>
void expect_the_same_motion() {
  using M = SlidingBall<>;
  using Scaled = SlidingBall<Size>;
  M::Inputs in, scaled_in;
  M::Vector q(0, 1), u(1, -3), scaled_q = Scaled::length * q, scaled_u = Scaled::length * u;
  for (int i = 0; i < 120; ++i) {
    ASSERT_EQ(step<M>(Method::implicit, q, u, in, 1.0 / 60), Status::ok);
    ASSERT_EQ(step<Scaled>(Method::implicit, scaled_q, scaled_u, scaled_in, 1.0 / 60), Status::ok);
    ASSERT_EQ(scaled_q, Scaled::length * q) << Size << " " << i;
    ASSERT_EQ(scaled_u, Scaled::length * u) << Size << " " << i;
  }
}

TEST(ImplicitStep, ABallOfAnySizeMovesAlike) {
  expect_the_same_motion<-20>();
  expect_the_same_motion<20>();
}

}  // namespace
