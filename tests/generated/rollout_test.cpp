// Rollouts over generated functions in packs: as one state at a time up to rounding, and to the bit the same whatever the number of
// motions, their places and the threads are, with each set of instructions.
#include <gtest/gtest.h>

#include <cmath>
#include <puma560/puma560.hpp>
#include <puma560/puma560_batch.hpp>
#include <vector>

#include "alembert/rollout_packs.hpp"

namespace {

namespace puma560 = alembert::mechanisms::puma560;
using Puma = puma560::Mechanism<>;

struct Arms {
  explicit Arms(std::size_t n) : q(6 * n), qd(6 * n), tau(6 * n), end_q(6 * n), end_qd(6 * n) {
    for (std::size_t i = 0; i < 6 * n; ++i) {
      q[i] = std::sin(1.0 + static_cast<double>(i));
      qd[i] = std::cos(3.0 * static_cast<double>(i));
      tau[i] = std::sin(0.1 * static_cast<double>(i));
    }
    way.count = n;
    way.steps = 40;
    way.h = 2e-3;
    way.stepper = alembert::Stepper::rk4;
    take(0);
  }
  void take(std::size_t first) {
    way.q = q.data() + 6 * first;
    way.qd = qd.data() + 6 * first;
    way.controls = tau.data() + 6 * first;
    way.controls_step = 6;
  }
  const std::vector<double>& go(bool packs) {
    alembert::RolloutResults<double> out;
    out.q = end_q.data();
    out.qd = end_qd.data();
    const std::size_t failed = packs
                                   ? alembert::rollout_in_packs<Puma>(
                                         way, out, alembert::PackedDynamics(puma560::forward_dynamics_batch))
                                   : alembert::rollout<Puma>(way, out);
    EXPECT_EQ(failed, 0u);
    return end_q;
  }
  std::vector<double> q, qd, tau, end_q, end_qd;
  alembert::Rollout<double> way;
};

TEST(GeneratedRollout, InPacks) {
  Arms arms(131);
  const std::vector<double> one_by_one = arms.go(false);
  for (const auto set :
       {alembert::Instructions::baseline, alembert::Instructions::avx2, alembert::Instructions::avx512}) {
    arms.way.instructions = set;
    arms.way.threads = 1;
    const std::vector<double> expected = arms.go(true);
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(expected[i], one_by_one[i], 1e-9);
    arms.way.threads = 3;
    EXPECT_EQ(arms.go(true), expected);
    for (const std::size_t first : {1, 66, 130}) {
      Arms one(131);
      one.way.instructions = set;
      one.way.count = first == 66 ? 17 : 1;
      one.take(first);
      one.go(true);
      EXPECT_TRUE(std::equal(one.end_q.begin(),
                             one.end_q.begin() + static_cast<std::ptrdiff_t>(6 * one.way.count),
                             expected.begin() + static_cast<std::ptrdiff_t>(6 * first)));
    }
  }
}

}  // namespace
