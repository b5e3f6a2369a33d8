// The C interface gives what C++ gives, and rejects null pointers.
#include <gtest/gtest.h>
#include <puma560/puma560.h>
#include <runtime_parameters/runtime_parameters.h>

#include <puma560/puma560.hpp>
#include <runtime_parameters/runtime_parameters.hpp>

namespace alembert::test {
namespace {

TEST(CInterface, GivesTheSameBits) {
  using M = mechanisms::puma560::Mechanism<>;
  const double q[] = {0.1, 0.2, -0.3, 0.4, 0.5, -0.6}, qd[] = {1, -1, 0.5, 0.2, 0.3, 0.7},
               qdd[] = {0.3, 0.1, 0.2, -0.5, 0.9, 1.1};
  double tau[6], mass[36], bias[6];
  ASSERT_EQ(puma560_inverse_dynamics(q, qd, qdd, 0, nullptr, nullptr, tau), 0);
  ASSERT_EQ(puma560_mass_matrix_and_bias(q, qd, 0, nullptr, nullptr, mass, bias), 0);
  const M::CoordinateVector Q = Eigen::Map<const M::CoordinateVector>(q);
  const M::SpeedVector u = Eigen::Map<const M::SpeedVector>(qd),
                       rates = Eigen::Map<const M::SpeedVector>(qdd);
  M::SpeedMatrix expected_mass;
  M::SpeedVector expected_bias;
  M::mass_matrix_and_bias(Q, u, {}, expected_mass, expected_bias);
  const M::SpeedVector expected = M::inverse_dynamics(Q, u, rates);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(tau[i], expected[i]);
    EXPECT_EQ(bias[i], expected_bias[i]);
    for (int j = 0; j < 6; ++j) EXPECT_EQ(mass[6 * i + j], expected_mass(i, j));
  }
}

TEST(CInterface, ParametersHaveDefaults) {
  using M = mechanisms::runtime_parameters::Mechanism<>;
  const M::Inputs defaults;
  double q[M::kNq] = {}, by_default[M::kNv * M::kNv], given[M::kNv * M::kNv], other[M::kNv * M::kNv];
  for (double& x : q) x = 0.4;
  ASSERT_EQ(runtime_parameters_mass_matrix(q, 0, nullptr, nullptr, by_default), 0);
  ASSERT_EQ(runtime_parameters_mass_matrix(q, 0, defaults.parameters.data(), nullptr, given), 0);
  auto heavier = defaults.parameters;
  for (double& p : heavier) p *= 1.5;
  ASSERT_EQ(runtime_parameters_mass_matrix(q, 0, heavier.data(), nullptr, other), 0);
  EXPECT_EQ(by_default[0], given[0]);
  EXPECT_NE(by_default[0], other[0]);
}

TEST(CInterface, NullPointersAreRefused) {
  double q[6] = {}, tau[6];
  EXPECT_NE(puma560_inverse_dynamics(nullptr, q, q, 0, nullptr, nullptr, tau), 0);
  EXPECT_NE(puma560_inverse_dynamics(q, q, q, 0, nullptr, nullptr, nullptr), 0);
  EXPECT_NE(puma560_mass_matrix_and_bias(q, q, 0, nullptr, nullptr, nullptr, tau), 0);
}

}  // namespace
}  // namespace alembert::test
