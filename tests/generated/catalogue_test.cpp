// Laws of the compiled catalogue, for every mechanism in it: what a user's program sees.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <alembert/forward_dynamics.hpp>
#include <alembert/integrate.hpp>
#include <bead_on_helix/bead_on_helix.hpp>
#include <body_on_torus/body_on_torus.hpp>
#include <cart_pole/cart_pole.hpp>
#include <chain6r/chain6r.hpp>
#include <chain6r_90/chain6r_90.hpp>
#include <cmath>
#include <double_pendulum/double_pendulum.hpp>
#include <four_bar_knee/four_bar_knee.hpp>
#include <free_body/free_body.hpp>
#include <moving_base/moving_base.hpp>
#include <pendulum/pendulum.hpp>
#include <puma560/puma560.hpp>
#include <random>
#include <rolling_wheels/rolling_wheels.hpp>
#include <runtime_parameters/runtime_parameters.hpp>
#include <spherical_pendulum/spherical_pendulum.hpp>
#include <stanford/stanford.hpp>
#include <tori_mated/tori_mated.hpp>
#include <tree_every_joint/tree_every_joint.hpp>

namespace alembert::test {
namespace {

namespace m = mechanisms;

template <class M>
struct State {
  typename M::CoordinateVector q;
  typename M::SpeedVector u, rates;
};

/// Random states around the initial one; quaternions of unit length.
template <class M>
State<M> random_state(unsigned seed, double spread = 0.5) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  State<M> s{M::initial_coordinates(), {}, {}};
  for (int i = 0; i < M::kNq; ++i) s.q[i] += spread * uniform(random);
  for (const int offset : M::kQuaternionOffsets) s.q.template segment<4>(offset).normalize();
  for (int i = 0; i < M::kNv; ++i) {
    s.u[i] = uniform(random);
    s.rates[i] = uniform(random);
  }
  return s;
}

/// Mechanisms of which nothing moves by itself, and further ones.
template <class... Further>
using UnmovedAnd =
    testing::Types<m::bead_on_helix::Mechanism<>, m::body_on_torus::Mechanism<>, m::cart_pole::Mechanism<>,
                   m::chain6r::Mechanism<>, m::chain6r_90::Mechanism<>, m::double_pendulum::Mechanism<>,
                   m::four_bar_knee::Mechanism<>, m::free_body::Mechanism<>, m::pendulum::Mechanism<>,
                   m::puma560::Mechanism<>, m::rolling_wheels::Mechanism<>,
                   m::runtime_parameters::Mechanism<>, m::spherical_pendulum::Mechanism<>,
                   m::stanford::Mechanism<>, m::tori_mated::Mechanism<>, m::tree_every_joint::Mechanism<>,
                   Further...>;

template <class M>
class Catalogue : public testing::Test {};
using Mechanisms = UnmovedAnd<m::moving_base::Mechanism<>>;
TYPED_TEST_SUITE(Catalogue, Mechanisms);

template <class M>
class UnmovedCatalogue : public testing::Test {};
TYPED_TEST_SUITE(UnmovedCatalogue, UnmovedAnd<>);

TYPED_TEST(Catalogue, ForceIsMassTimesAccelerationPlusBias) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto s = random_state<TypeParam>(seed);
    typename TypeParam::SpeedMatrix M;
    typename TypeParam::SpeedVector c;
    TypeParam::mass_matrix_and_bias(s.q, s.u, {}, M, c);
    const auto tau = TypeParam::inverse_dynamics(s.q, s.u, s.rates);
    const double scale = std::max(1.0, tau.cwiseAbs().maxCoeff());
    EXPECT_LT((M * s.rates + c - tau).cwiseAbs().maxCoeff(), 1e-11 * scale);
    EXPECT_LT((TypeParam::mass_matrix(s.q) - M).cwiseAbs().maxCoeff(),
              1e-12 * std::max(1.0, M.cwiseAbs().maxCoeff()));
    EXPECT_LT((TypeParam::bias(s.q, s.u) - c).cwiseAbs().maxCoeff(), 1e-12 * scale);
    EXPECT_EQ(M, M.transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(M);
    EXPECT_GT(solver.eigenvalues()(0), 0);
  }
}

TYPED_TEST(Catalogue, ForwardDynamicsInvertsInverseDynamics) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto s = random_state<TypeParam>(seed);
    const auto tau = TypeParam::inverse_dynamics(s.q, s.u, s.rates);
    typename TypeParam::SpeedVector rates = TypeParam::SpeedVector::Zero();
    ASSERT_EQ(forward_dynamics<TypeParam>(s.q, s.u, tau, {}, rates), Status::ok);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(TypeParam::mass_matrix(s.q));
    const double condition = solver.eigenvalues().tail(1)(0) / solver.eigenvalues()(0);
    EXPECT_LT((rates - s.rates).cwiseAbs().maxCoeff(), 1e-14 * condition + 1e-11);
  }
}

TYPED_TEST(UnmovedCatalogue, FreeMotionConservesEnergy) {
  auto s = random_state<TypeParam>(3, 0.1);
  const auto energy = [&] {
    const auto e = TypeParam::energy(s.q, s.u);
    return e[0] + e[1];
  };
  const double start = energy(), kinetic = TypeParam::energy(s.q, s.u)[0];
  const auto no_force = [](const auto&...) ->
      typename TypeParam::SpeedVector { return TypeParam::SpeedVector::Zero(); };
  typename TypeParam::Inputs in;
  for (int i = 0; i < 2000; ++i) ASSERT_EQ(rk4_step<TypeParam>(s.q, s.u, in, 1e-4, no_force), Status::ok);
  EXPECT_NEAR(energy(), start, 1e-8 * std::max({1.0, std::abs(start), kinetic}));
  for (const int offset : TypeParam::kQuaternionOffsets)
    EXPECT_NEAR(s.q.template segment<4>(offset).norm(), 1, 1e-14);
}

/// What solvers leave out is zero at all states.
TYPED_TEST(Catalogue, MassMatrixIsZeroBetweenBranches) {
  const auto& parents = TypeParam::kSpeedParents;
  for (unsigned seed = 0; seed < 10; ++seed) {
    const typename TypeParam::SpeedMatrix M = TypeParam::mass_matrix(random_state<TypeParam>(seed, 5).q);
    for (int k = 0; k < TypeParam::kNv; ++k) {
      int carrier = parents[static_cast<std::size_t>(k)];
      ASSERT_LT(carrier, k);
      for (int i = k - 1; i >= 0; --i) {
        if (i == carrier)
          carrier = parents[static_cast<std::size_t>(i)];
        else
          EXPECT_EQ(M(i, k), 0) << i << " " << k;
      }
    }
  }
}

/// The rate of change of the kinetic energy's momentum form: kinetic energy is u.M u / 2 where nothing is
/// prescribed.
TYPED_TEST(UnmovedCatalogue, KineticEnergyIsTheQuadraticFormOfTheMassMatrix) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const auto s = random_state<TypeParam>(seed);
    const double expected = 0.5 * s.u.dot(TypeParam::mass_matrix(s.q) * s.u);
    EXPECT_NEAR(TypeParam::energy(s.q, s.u)[0], expected, 1e-12 * std::max(1.0, expected));
  }
}

/// float gives what double gives, to single precision.
TEST(Scalars, FloatAgreesWithDouble) {
  using D = m::puma560::Mechanism<double>;
  using F = m::puma560::Mechanism<float>;
  const auto s = random_state<D>(5);
  const auto tau = D::inverse_dynamics(s.q, s.u, s.rates);
  const F::SpeedVector in_float =
      F::inverse_dynamics(s.q.cast<float>(), s.u.cast<float>(), s.rates.cast<float>());
  EXPECT_LT((in_float.cast<double>() - tau).cwiseAbs().maxCoeff(), 1e-4 * tau.cwiseAbs().maxCoeff());
}

}  // namespace
}  // namespace alembert::test
