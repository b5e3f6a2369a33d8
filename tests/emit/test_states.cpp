// States of a description in generated code: names, limits, and every step of the runtime against closed forms. The
// input drives the state a, and a drives the block; the state way is what the block has moved.
#include <gtest/gtest.h>

#include <cmath>
#include <driven_block/driven_block.hpp>
#include <functional>
#include <limits>
#include <string>

#include "alembert/implicit_step.hpp"
#include "alembert/integrate.hpp"

namespace {

using M = bits::driven_block::Mechanism<>;

double a_at(double t) {
  return 1 - 0.75 * std::exp(-t / 0.05);
}
double speed_at(double t) {
  return 2 * (t - 0.75 * 0.05 * (1 - std::exp(-t / 0.05)));
}

struct Motion {
  M::CoordinateVector q = M::initial_coordinates();
  M::SpeedVector qd = M::initial_speeds();
  M::Inputs in;
};
M::SpeedVector none(double, const M::CoordinateVector&, const M::SpeedVector&) {
  return M::SpeedVector::Zero();
}
using Step = std::function<alembert::Status(Motion&, double)>;

/// Largest error of a and of the speed after 0.3 s.
double error_of(const Step& step, double h) {
  Motion motion;
  const auto count = std::llround(0.3 / h);
  for (long long k = 0; k < count; ++k) {
    if (step(motion, h) != alembert::Status::ok) return std::numeric_limits<double>::infinity();
  }
  EXPECT_NEAR(motion.in.t, 0.3, 1e-12);
  EXPECT_NEAR(motion.in.parameters[M::State::way], motion.q(0), h);
  return std::max(std::abs(motion.in.parameters[M::State::a] - a_at(0.3)),
                  std::abs(motion.qd(0) - speed_at(0.3)));
}

TEST(States, StandBehindInputs) {
  EXPECT_EQ(M::kNstates, 2);
  EXPECT_EQ(static_cast<int>(M::Input::drive), 0);
  EXPECT_EQ(static_cast<int>(M::State::a), 1);
  EXPECT_EQ(static_cast<int>(M::State::way), 2);
  const M::Inputs in;
  EXPECT_EQ(in.parameters[M::State::a], 0.25);
  const Motion start;
  EXPECT_EQ(M::state_rates(start.q, start.qd, in)(0), (1 - 0.25) / 0.05);
  EXPECT_EQ(M::force_contributions(start.q, start.qd, in)(M::Force::motor, 0), 1);
  EXPECT_EQ(bits::driven_block::kEffortLimits[0], std::numeric_limits<double>::infinity());
}

TEST(States, AreIntegratedToTheOrderOfTheStep) {
  struct {
    Step step;
    double order, most;
  } const methods[] = {
      {[](Motion& m, double h) { return alembert::rk4_step<M>(m.q, m.qd, m.in, h, none); }, 4, 1e-6},
      {[](Motion& m, double h) { return alembert::semi_implicit_euler_step<M>(m.q, m.qd, m.in, h, none); }, 1,
       0.01},
      {[](Motion& m, double h) {
         return alembert::linearly_implicit_euler_step<M>(m.q, m.qd, m.in, h, none);
       },
       1, 0.01},
      {[](Motion& m, double h) { return alembert::implicit_euler_step<M>(m.q, m.qd, m.in, h, none); }, 1,
       0.01}};
  for (const auto& method : methods) {
    const double error = error_of(method.step, 0.005), half = error_of(method.step, 0.0025);
    EXPECT_LT(error, method.most);
    EXPECT_NEAR(std::log2(error / half), method.order, 0.25);
  }
}

TEST(States, OfLongTimesFadeInOneImplicitStep) {
  Motion motion;
  ASSERT_EQ(alembert::linearly_implicit_euler_step<M>(motion.q, motion.qd, motion.in, 50.0, none),
            alembert::Status::ok);
  EXPECT_NEAR(motion.in.parameters[M::State::a], 1, 1e-3);
}

TEST(States, AreAsTheyWereWhereAStepFails) {
  Motion motion;
  motion.in.parameters[M::Input::drive] = std::numeric_limits<double>::quiet_NaN();
  for (const Step& step :
       {Step([](Motion&m, double h) { return alembert::rk4_step<M>(m.q, m.qd, m.in, h, none); }),
        Step([](Motion&m, double h) {
          return alembert::semi_implicit_euler_step<M>(m.q, m.qd, m.in, h, none);
        }),
        Step([](Motion&m, double h) {
          return alembert::linearly_implicit_euler_step<M>(m.q, m.qd, m.in, h, none);
        })}) {
    EXPECT_EQ(step(motion, 0.01), alembert::Status::not_finite);
    EXPECT_EQ(motion.in.parameters[M::State::a], 0.25);
    EXPECT_EQ(motion.in.t, 0);
  }
}

}  // namespace
