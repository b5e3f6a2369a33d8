// Rows of constraints that follow from others are known as such in every scalar type: what rounding leaves of them is a
// billion times as much in float.
#include <gtest/gtest.h>

#include <closed_twice/closed_twice.hpp>
#include <closed_twice/closed_twice_impl.hpp>

namespace {

template <class S>
Eigen::Matrix<double, 7, 1> rates_and_reactions(double along) {
  using M = alembert::mechanisms::closed_twice::Mechanism<S>;
  typename M::CoordinateVector q;
  typename M::SpeedVector u, tau, rates;
  typename M::ConstraintVector reactions;
  q << S(0.4 + along), S(-0.9 + 2 * along), S(0.7 - along * along);
  u << S(0.3), S(-1), S(0.5);
  tau << S(1), S(2), S(-1);
  M::constrained_forward_dynamics(q, u, tau, {}, rates, reactions);
  Eigen::Matrix<double, 7, 1> all;
  all << rates.template cast<double>(), reactions.template cast<double>();
  return all;
}

TEST(ClosedTwice, RowsThatFollowFromOthersAreKnownInEveryPrecision) {
  for (int i = 0; i < 1000; ++i) {
    const auto exact = rates_and_reactions<long double>(0.01 * i),
               in_double = rates_and_reactions<double>(0.01 * i),
               in_float = rates_and_reactions<float>(0.01 * i);
    EXPECT_EQ(in_double(5), 0) << i;
    EXPECT_EQ(in_double(6), 0) << i;
    EXPECT_LE((in_double - exact).norm(), 1e-12 * exact.norm()) << i;
    EXPECT_LE((in_float - exact).norm(), 1e-4 * exact.norm()) << i;
  }
}

}  // namespace
