// Rollouts against their steps made one by one, to the bit; independence of packs, threads and neighbours; ends.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include "alembert/rollout_packs.hpp"
#include "runtime/constrained_models.hpp"
#include "runtime/models.hpp"

namespace {

using alembert::PackedDynamics;
using alembert::Rollout;
using alembert::RolloutMoment;
using alembert::RolloutResults;
using alembert::Status;
using alembert::Stepper;

constexpr double kNoResult = std::numeric_limits<double>::quiet_NaN();

/// A block on a spring, pushed by an input through a lag, which is a state: x'' = (a - k x) / m, a' = (drive - a) / 0.05.
struct LaggingBlock {
  using Scalar = double;
  struct Inputs {
    double t = 0;
    std::array<double, 3> parameters{5, 1, 0.25};  // stiffness; drive; a
    std::array<double, 6> wrenches{};
  };
  using Vector = Eigen::Matrix<double, 1, 1>;
  static constexpr int kNq = 1, kNv = 1, kNinputs = 1, kNstates = 1;
  static constexpr std::array<int, 0> kQuaternionOffsets{};
  static void mass_matrix_and_bias(const Vector& q, const Vector&, const Inputs& in, Vector& M, Vector& c) {
    M(0) = 2;
    c(0) = in.parameters[0] * q(0) - in.parameters[2] - in.wrenches[0];
  }
  static Vector coordinate_rates(const Vector&, const Vector& u) { return u; }
  static Vector state_rates(const Vector&, const Vector&, const Inputs& in) {
    return Vector((in.parameters[1] - in.parameters[2]) / 0.05);
  }
  static void inverse_dynamics_derivatives(const Vector&, const Vector&, const Vector&, const Inputs& in,
                                           Vector& tau_q, Vector& tau_qd) {
    tau_q(0) = in.parameters[0];
    tau_qd(0) = 0;
  }
  static void state_rates_derivatives(const Vector&, const Vector&, const Inputs&, Vector& along,
                                      Vector& by_speeds, Vector& by_states) {
    along(0) = by_speeds(0) = 0;
    by_states(0) = -1 / 0.05;
  }
};

/// What a NAME_batch.hpp has for M; a lane whose first coordinate is above 1e6 it leaves without a result.
template <class M>
struct Batch {
  struct Inputs {
    typename M::Inputs common;
    const double *t = nullptr, *parameters = nullptr, *wrenches = nullptr;
  };
  static typename M::Inputs of(const Inputs& in, [[maybe_unused]] std::size_t s,
                               [[maybe_unused]] std::size_t stride) {
    typename M::Inputs out = in.common;
    if constexpr (alembert::detail::ParameterCount<typename M::Inputs>::value > 0)
      for (std::size_t i = 0; i < out.parameters.size() && in.parameters != nullptr; ++i)
        out.parameters[i] = in.parameters[i * stride + s];
    if constexpr (alembert::detail::WrenchNumbers<typename M::Inputs>::value > 0)
      for (std::size_t i = 0; i < out.wrenches.size() && in.wrenches != nullptr; ++i)
        out.wrenches[i] = in.wrenches[i * stride + s];
    return out;
  }
  static std::size_t forward_dynamics(std::size_t n, std::size_t stride, const double* q, const double* qd,
                                      const double* tau, const Inputs& in, double* qdd,
                                      const alembert::BatchOptions&) {
    std::size_t failed = 0;
    for (std::size_t s = 0; s < n; ++s) {
      alembert::CoordinateVector<M> position;
      alembert::SpeedVector<M> speed, force, rate = alembert::SpeedVector<M>::Constant(kNoResult);
      for (int i = 0; i < M::kNq; ++i) position(i) = q[static_cast<std::size_t>(i) * stride + s];
      for (int i = 0; i < M::kNv; ++i) speed(i) = qd[static_cast<std::size_t>(i) * stride + s];
      for (int i = 0; i < M::kNv; ++i) force(i) = tau[static_cast<std::size_t>(i) * stride + s];
      if (position(0) > 1e6 ||
          alembert::forward_dynamics<M>(position, speed, force, of(in, s, stride), rate) != Status::ok)
        ++failed;
      for (int i = 0; i < M::kNv; ++i) qdd[static_cast<std::size_t>(i) * stride + s] = rate(i);
    }
    return failed;
  }
};

/// N starts and what comes of them.
template <class M>
struct Motions {
  static constexpr std::size_t kNq = static_cast<std::size_t>(M::kNq), kNv = static_cast<std::size_t>(M::kNv),
                               kNs = static_cast<std::size_t>(alembert::detail::StateCount<M>::value);
  explicit Motions(std::size_t n) : q(n * kNq), qd(n * kNv) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1, 1);
    for (double& x : q) x = number(random);
    for (double& x : qd) x = number(random);
    way.count = n;
    way.steps = 23;
    way.h = 0.01;
    way.t = 0.5;
    way.every = 5;
    way.q = q.data();
    way.qd = qd.data();
  }
  RolloutResults<double> results() {
    const std::size_t n = way.count, rows = alembert::rollout_rows(way);
    out_q.assign(n * rows * kNq, kNoResult);
    out_qd.assign(n * rows * kNv, kNoResult);
    out_states.assign(n * rows * kNs, kNoResult);
    steps.assign(n, -1);
    status.assign(n, Status::no_convergence);
    stopped.reset(new bool[n]());
    RolloutResults<double> out;
    out.q = out_q.data(), out.qd = out_qd.data(), out.states = out_states.data();
    out.steps = steps.data(), out.status = status.data(), out.stopped = stopped.get();
    return out;
  }
  const double* row(std::size_t s, std::size_t k) const {
    return out_q.data() + (s * alembert::rollout_rows(way) + k) * kNq;
  }
  std::vector<double> all() const {
    std::vector<double> x = out_q;
    x.insert(x.end(), out_qd.begin(), out_qd.end());
    x.insert(x.end(), out_states.begin(), out_states.end());
    return x;
  }

  std::vector<double> q, qd, out_q, out_qd, out_states;
  std::vector<std::int64_t> steps;
  std::vector<Status> status;
  std::unique_ptr<bool[]> stopped;
  Rollout<double> way;
};

template <class M>
std::vector<double> in_packs(Motions<M>& motions) {
  EXPECT_EQ(alembert::rollout_in_packs<M>(motions.way, motions.results(),
                                          PackedDynamics(&Batch<M>::forward_dynamics)),
            0u);
  return motions.all();
}
template <class M>
std::vector<double> one_by_one(Motions<M>& motions) {
  EXPECT_EQ(alembert::rollout<M>(motions.way, motions.results()), 0u);
  return motions.all();
}

template <class M>
void expect_steps(Stepper stepper) {
  Motions<M> motions(5);
  motions.way.stepper = stepper;
  one_by_one(motions);
  for (std::size_t s = 0; s < 5; ++s) {
    alembert::CoordinateVector<M> q =
        Eigen::Map<alembert::CoordinateVector<M>>(motions.q.data() + s * M::kNq);
    alembert::SpeedVector<M> u = Eigen::Map<alembert::SpeedVector<M>>(motions.qd.data() + s * M::kNv);
    ASSERT_EQ(alembert::normalize_quaternions<M>(q), Status::ok);
    typename M::Inputs in;
    in.t = 0.5;
    const auto status = alembert::repeat_step(in.t, 0.01, 23, [&] {
      switch (stepper) {
        case Stepper::semi_implicit_euler:
          return alembert::semi_implicit_euler_step<M>(q, u, in, 0.01, models::no_force<M>);
        case Stepper::rk4:
          return alembert::rk4_step<M>(q, u, in, 0.01, models::no_force<M>);
        case Stepper::linearly_implicit_euler:
          return alembert::linearly_implicit_euler_step<M>(q, u, in, 0.01, models::no_force<M>);
        case Stepper::implicit_euler:
          return alembert::implicit_euler_step<M>(q, u, in, 0.01, models::no_force<M>);
      }
      return Status::no_convergence;
    });
    EXPECT_EQ(status, Status::ok);
    EXPECT_EQ(motions.steps[s], 23);
    for (int i = 0; i < M::kNq; ++i) EXPECT_EQ(motions.row(s, 5)[i], q(i)) << "motion " << s;
  }
}

TEST(Rollout, MakesTheStepsOfOneState) {
  for (const Stepper stepper : {Stepper::semi_implicit_euler, Stepper::rk4, Stepper::linearly_implicit_euler,
                                Stepper::implicit_euler}) {
    expect_steps<models::SpinningBody<>>(stepper);
    expect_steps<models::Pendulum<>>(stepper);
    expect_steps<LaggingBlock>(stepper);
  }
}

/// To the bit: the packs here have the rounding of one state.
template <class M>
void expect_same_in_packs() {
  for (const Stepper stepper : {Stepper::semi_implicit_euler, Stepper::rk4, Stepper::linearly_implicit_euler})
    for (const std::size_t n : {1, 7, 64, 150}) {
      Motions<M> motions(n);
      motions.way.stepper = stepper;
      const std::vector<double> expected = one_by_one(motions);
      for (const int threads : {1, 2, 3, 0}) {
        motions.way.threads = threads;
        EXPECT_EQ(in_packs(motions), expected) << n << " motions, " << threads << " threads";
        EXPECT_EQ(one_by_one(motions), expected);
      }
    }
}

TEST(Rollout, IsTheSameInPacksAndThreads) {
  expect_same_in_packs<models::SpinningBody<>>();
  expect_same_in_packs<LaggingBlock>();
}

TEST(Rollout, DependsOnNoNeighbour) {
  using M = models::SpinningBody<>;
  Motions<M> all(100), few(9);
  in_packs(all);
  std::copy_n(all.q.begin() + 37 * 4, 36, few.q.begin());
  std::copy_n(all.qd.begin() + 37 * 3, 27, few.qd.begin());
  in_packs(few);
  EXPECT_TRUE(std::equal(few.out_q.begin(), few.out_q.end(), all.out_q.begin() + 37 * 6 * 4));
}

TEST(Rollout, TakesControlsParametersAndWrenchesOfEach) {
  using M = LaggingBlock;
  constexpr std::size_t kCount = 11;
  std::vector<double> parameters, wrenches, controls, held;
  for (std::size_t s = 0; s < kCount; ++s) {
    parameters.insert(parameters.end(), {5.0 + double(s), 1, 0.1 * double(s)});
    wrenches.insert(wrenches.end(), {0.2 * double(s), 0, 0, 0, 0, 0});
    for (int k = 0; k < 5; ++k) controls.push_back(double(s) - k);
    held.push_back(double(s));
  }
  Motions<M> motions(kCount);
  motions.way.stepper = Stepper::rk4;
  motions.way.parameters = parameters.data();
  motions.way.parameters_step = 3;
  motions.way.wrenches = wrenches.data();
  motions.way.wrenches_step = 6;
  motions.way.kind = alembert::Controls::inputs;
  motions.way.controls = controls.data();
  motions.way.controls_step = 5;
  motions.way.controls_next = 1;
  motions.way.hold = 5;
  const std::vector<double> expected = one_by_one(motions);
  EXPECT_EQ(in_packs(motions), expected);
  for (std::size_t s = 0; s < kCount; ++s) {
    M::Inputs in;
    std::copy_n(parameters.begin() + static_cast<std::ptrdiff_t>(3 * s), 3, in.parameters.begin());
    in.wrenches[0] = 0.2 * double(s);
    M::Vector q(motions.q[s]), u(motions.qd[s]);
    for (int k = 0; k < 23; ++k) {
      in.t = 0.5 + k * 0.01;
      in.parameters[1] = double(s) - k / 5;
      ASSERT_EQ(alembert::rk4_step<M>(q, u, in, 0.01, models::no_force<M>), Status::ok);
    }
    EXPECT_EQ(motions.row(s, 5)[0], q(0));
    EXPECT_EQ(motions.out_states[s * 6 + 5], in.parameters[2]);
    EXPECT_EQ(motions.out_states[s * 6], 0.1 * double(s));
  }
  // A policy that gives the same, for all at once, is no other thing.
  motions.way.controls = nullptr;
  int calls = 0;
  const auto policy = [&](const RolloutMoment<double>& at) {
    EXPECT_EQ(at.count, kCount);
    EXPECT_EQ(at.step, 5 * calls);
    EXPECT_EQ(at.t, 0.5 + double(at.step) * 0.01);
    for (std::size_t s = 0; s < at.count; ++s) at.controls[s] = double(s) - calls;
    ++calls;
  };
  alembert::rollout_in_packs<M>(motions.way, motions.results(), PackedDynamics(&Batch<M>::forward_dynamics),
                                policy);
  EXPECT_EQ(motions.all(), expected);
  EXPECT_EQ(calls, 5);
}

/// What is left of a motion that ends is its last state, in packs as one by one.
TEST(Rollout, StopsEarly) {
  using M = models::Pendulum<>;
  const auto past = [](std::size_t, double, const double* q, const double*) { return std::abs(q[0]) > 0.7; };
  Motions<M> packed(70), single(70);
  for (Motions<M>* motions : {&packed, &single}) {
    motions->way.steps = 200;
    motions->way.every = 1;
    motions->way.threads = 2;
  }
  alembert::rollout_in_packs<M>(packed.way, packed.results(), PackedDynamics(&Batch<M>::forward_dynamics),
                                alembert::NoPolicy(), past);
  alembert::rollout<M>(single.way, single.results(), alembert::NoPolicy(), past);
  EXPECT_EQ(packed.all(), single.all());
  EXPECT_EQ(packed.steps, single.steps);
  int ended = 0;
  for (std::size_t s = 0; s < 70; ++s) {
    EXPECT_EQ(packed.status[s], Status::ok);
    EXPECT_EQ(packed.stopped[s], packed.steps[s] < 200 || std::abs(packed.row(s, 200)[0]) > 0.7);
    for (std::size_t k = 1; k <= 200; ++k) {
      const std::size_t last = static_cast<std::size_t>(packed.steps[s]);
      if (k < last) {
        EXPECT_LE(std::abs(packed.row(s, k)[0]), 0.7);
      }
      if (k > last) {
        EXPECT_EQ(packed.row(s, k)[0], packed.row(s, last)[0]);
      }
    }
    ended += packed.stopped[s] ? 1 : 0;
  }
  EXPECT_GT(ended, 5);
  EXPECT_LT(ended, 70);
}

TEST(Rollout, PoliciesStopMotions) {
  using M = models::Pendulum<>;
  Motions<M> motions(3);
  motions.way.hold = 10;
  const auto policy = [](const RolloutMoment<double>& at) {
    if (at.step == 10) at.ended[1] = true;
    if (at.step == 20) at.ended[1] = false;  // what has ended stays so
  };
  EXPECT_EQ(alembert::rollout<M>(motions.way, motions.results(), policy), 0u);
  EXPECT_EQ(motions.steps, (std::vector<std::int64_t>{23, 10, 23}));
  EXPECT_TRUE(motions.stopped[1]);
  EXPECT_FALSE(motions.stopped[0]);
}

/// Packs ask M, too, where the generated function has rates of zero at a singular mass matrix.
TEST(Rollout, SaysThatMIsSingularWhereNothingDrives) {
  using M = models::HingesInLine;
  using In = Batch<M>::Inputs;
  const PackedDynamics<In> written(+[](std::size_t n, std::size_t stride, const double*, const double*,
                                       const double* tau, const In&, double* qdd,
                                       const alembert::BatchOptions&) -> std::size_t {
    for (std::size_t s = 0; s < n; ++s) {
      const M::Vector rate = M::forward_dynamics({}, {}, {tau[s], tau[stride + s]}, {});
      for (int i = 0; i < M::kNv; ++i) qdd[static_cast<std::size_t>(i) * stride + s] = rate(i);
    }
    return 0;
  });
  const double ordinary = M::inner;
  for (const double inner : {1e-17, ordinary}) {
    M::inner = inner;
    Motions<M> motions(9);
    const std::size_t failed = alembert::rollout_in_packs<M>(motions.way, motions.results(), written);
    EXPECT_EQ(failed, inner == ordinary ? 0U : 9U);
    EXPECT_EQ(motions.status[4], inner == ordinary ? Status::ok : Status::not_positive_definite);
  }
}

/// A mass matrix 1 / (1 + i + j) + t on the diagonal: singular for t = -1 at first, and never in what packs give.
TEST(Rollout, SaysWhyThereIsNoStep) {
  using M = models::Dense<1>;
  Motions<M> motions(9);
  motions.way.t = -1.05;
  motions.way.h = 0.01;
  motions.way.every = 1;
  EXPECT_EQ(alembert::rollout_in_packs<M>(motions.way, motions.results(),
                                          PackedDynamics(&Batch<M>::forward_dynamics)),
            9u);
  EXPECT_EQ(motions.status[4], Status::not_positive_definite);
  EXPECT_EQ(motions.steps[4], 0);
  EXPECT_EQ(motions.row(4, 23)[0], motions.q[4]);

  // From a mass of 0.02 on, which falls to nothing in two steps back.
  motions.way.t = -0.98;
  motions.way.h = -0.01;
  EXPECT_EQ(alembert::rollout<M>(motions.way, motions.results()), 9u);
  const auto steps = motions.steps;
  EXPECT_GE(steps[4], 1);
  EXPECT_LE(steps[4], 3);
  for (const double x : motions.all()) EXPECT_TRUE(std::isfinite(x));
  alembert::rollout_in_packs<M>(motions.way, motions.results(), PackedDynamics(&Batch<M>::forward_dynamics));
  EXPECT_EQ(motions.steps, steps);

  // Bad starts, controls and steps end the motions that they are of.
  Motions<models::SpinningBody<>> bodies(3);
  std::fill_n(bodies.q.begin(), 4, 0.0);
  bodies.qd[3] = kNoResult;
  EXPECT_EQ(alembert::rollout<models::SpinningBody<>>(bodies.way, bodies.results()), 2u);
  EXPECT_EQ(bodies.status, (std::vector<Status>{Status::not_finite, Status::not_finite, Status::ok}));
  EXPECT_EQ(bodies.steps, (std::vector<std::int64_t>{0, 0, 23}));
  std::vector<double> controls(3 * 3, 0.0);
  controls[8] = kNoResult;
  Motions<models::SpinningBody<>> driven(3);
  driven.way.controls = controls.data();
  driven.way.controls_step = 3;
  for (const bool packs : {false, true}) {
    if (packs)
      alembert::rollout_in_packs<models::SpinningBody<>>(
          driven.way, driven.results(), PackedDynamics(&Batch<models::SpinningBody<>>::forward_dynamics));
    else
      alembert::rollout<models::SpinningBody<>>(driven.way, driven.results());
    EXPECT_EQ(driven.status, (std::vector<Status>{Status::ok, Status::ok, Status::not_finite}));
    for (const double x : driven.all()) EXPECT_TRUE(std::isfinite(x));
  }
  driven.way.h = kNoResult;
  EXPECT_EQ(alembert::rollout<models::SpinningBody<>>(driven.way, driven.results()), 3u);
  // Dense has no derivatives.
  Motions<M> implicit(1);
  implicit.way.stepper = Stepper::implicit_euler;
  alembert::rollout<M>(implicit.way, implicit.results());
  EXPECT_EQ(implicit.status[0], Status::missing_function);
}

/// What packs have no accelerations for, one state has.
TEST(Rollout, AsksAgainWherePacksFail) {
  using M = models::Pendulum<>;
  Motions<M> motions(10);
  motions.q[3] = 2e6;
  const std::vector<double> expected = one_by_one(motions);
  EXPECT_EQ(in_packs(motions), expected);
}

TEST(Rollout, KeepsConstraints) {
  using M = models::PointOnRod<>;
  Motions<M> motions(6);
  for (std::size_t s = 0; s < 6; ++s) {
    const double angle = 0.3 * double(s);
    motions.q[2 * s] = M::l * std::sin(angle);
    motions.q[2 * s + 1] = -M::l * std::cos(angle);
    motions.qd[2 * s] = motions.qd[2 * s + 1] = 0;
  }
  motions.way.threads = 2;
  EXPECT_EQ(alembert::rollout<M>(motions.way, motions.results()), 0u);
  for (std::size_t s = 0; s < 6; ++s)
    EXPECT_NEAR(std::hypot(motions.row(s, 5)[0], motions.row(s, 5)[1]), M::l, 1e-9);
  // Starts are brought to where constraints are kept before anything else: the first row has them so, and a policy sees them so.
  for (std::size_t s = 0; s < 6; ++s) {
    motions.q[2 * s] *= 1.1;
    motions.q[2 * s + 1] *= 1.1;
    motions.qd[2 * s + 1] = 0.5;
  }
  bool seen = false;
  const auto policy = [&](const alembert::RolloutMoment<double>& now) {
    for (std::size_t s = 0; s < 6; ++s) {
      EXPECT_NEAR(std::hypot(now.q[2 * s], now.q[2 * s + 1]), M::l, 1e-9);
      EXPECT_NEAR(now.q[2 * s] * now.qd[2 * s] + now.q[2 * s + 1] * now.qd[2 * s + 1], 0, 1e-9);
    }
    seen = true;
  };
  EXPECT_EQ(alembert::rollout<M>(motions.way, motions.results(), policy), 0u);
  EXPECT_TRUE(seen);
  for (std::size_t s = 0; s < 6; ++s) {
    EXPECT_NEAR(std::hypot(motions.row(s, 0)[0], motions.row(s, 0)[1]), M::l, 1e-9);
    EXPECT_NEAR(std::atan2(motions.row(s, 0)[0], -motions.row(s, 0)[1]), 0.3 * double(s), 1e-9);
  }
}

TEST(Rollout, NothingIsNothing) {
  using M = models::Pendulum<>;
  Motions<M> none(0), still(2);
  EXPECT_EQ(alembert::rollout<M>(none.way, none.results()), 0u);
  EXPECT_EQ(
      alembert::rollout_in_packs<M>(none.way, none.results(), PackedDynamics(&Batch<M>::forward_dynamics)),
      0u);
  still.way.steps = 0;
  in_packs(still);
  EXPECT_EQ(still.out_q, still.q);
  still.way.every = 0;
  one_by_one(still);
  EXPECT_EQ(still.out_q, still.q);
  still.way.steps = 23;
  one_by_one(still);
  EXPECT_EQ(still.out_q.size(), 2u);
}

}  // namespace
