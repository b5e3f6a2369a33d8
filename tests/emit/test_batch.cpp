// Functions over many states that take time, parameters and wrenches of each, against the functions over one.
#include <batch_sample/batch_sample.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <batch_sample/batch_sample_batch.hpp>
#include <chain/chain_batch.hpp>
#include <cmath>
#include <cstddef>
#include <double_pendulum/double_pendulum_batch.hpp>
#include <random>
#include <vector>

namespace {

namespace one = alembert::mechanisms::batch_sample;
using alembert::BatchOptions;
using alembert::Instructions;

constexpr std::size_t kQ = one::kNq, kV = one::kNv, kStates = 150, kStride = 153;
constexpr std::size_t kP = one::kParameterCount, kW = 6 * one::kWrenchCount;

std::vector<double> random_rows(std::size_t rows, unsigned seed, double low, double high) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(low, high);
  std::vector<double> x(rows * kStride);
  for (double& value : x) value = uniform(random);
  return x;
}

template <std::size_t N>
std::array<double, N> column(const std::vector<double>& x, std::size_t s) {
  std::array<double, N> out;
  for (std::size_t i = 0; i < N; ++i) out[i] = x[i * kStride + s];
  return out;
}

class BatchSample : public testing::TestWithParam<Instructions> {
 protected:
  void SetUp() override {
    if (!alembert::has_instructions(GetParam())) GTEST_SKIP() << "this machine does not have them";
    options_.instructions = GetParam();
    in_.t = t_.data();
    in_.parameters = parameters_.data();
    in_.wrenches = wrenches_.data();
  }
  one::Inputs<double> inputs(std::size_t s) const {
    one::Inputs<double> in;
    in.t = t_[s];
    in.parameters = column<kP>(parameters_, s);
    in.wrenches = column<kW>(wrenches_, s);
    return in;
  }
  /// Rows of results of all states against f(q, qd, inputs, result) of one.
  template <std::size_t N, class F>
  void expect_equal(const std::vector<double>& batch, F function) {
    double largest = 0;
    for (std::size_t s = 0; s < kStates; ++s) {
      const auto q = column<kQ>(q_, s);
      const auto qd = column<kV>(qd_, s), rates = column<kV>(rates_, s);
      std::array<double, N> expected;
      function(q.data(), qd.data(), rates.data(), inputs(s), expected.data());
      double scale = 1;
      for (const double e : expected) scale = std::max(scale, std::abs(e));
      for (std::size_t i = 0; i < N; ++i) {
        EXPECT_NEAR(batch[i * kStride + s], expected[i], 1e-12 * scale) << i << " of state " << s;
        largest = std::max(largest, std::abs(expected[i]));
      }
    }
    EXPECT_GT(largest, 0.01);
  }

  std::vector<double> q_ = random_rows(kQ, 1, -1, 1), qd_ = random_rows(kV, 2, -2, 2),
                      rates_ = random_rows(kV, 3, -2, 2), t_ = random_rows(1, 4, 0, 5),
                      parameters_ = random_rows(kP, 5, 0.5, 2), wrenches_ = random_rows(kW, 6, -3, 3);
  one::BatchInputs in_;
  BatchOptions options_;
};

TEST_P(BatchSample, TakesWhatDiffersFromStateToState) {
  std::vector<double> tau(kV * kStride), c(kV * kStride), M(kV * kV * kStride), e(2 * kStride),
      W(12 * one::kBodyCount * kStride), rates(kQ * kStride);
  EXPECT_EQ(one::inverse_dynamics_batch(kStates, kStride, q_.data(), qd_.data(), rates_.data(), in_,
                                        tau.data(), options_),
            0U);
  expect_equal<kV>(tau, [](auto q, auto qd, auto qdd, const auto& in, double* out) {
    one::inverse_dynamics<double>(q, qd, qdd, in, out);
  });
  EXPECT_EQ(one::bias_batch(kStates, kStride, q_.data(), qd_.data(), in_, c.data(), options_), 0U);
  expect_equal<kV>(
      c, [](auto q, auto qd, auto, const auto& in, double* out) { one::bias<double>(q, qd, in, out); });
  EXPECT_EQ(one::mass_matrix_and_bias_batch(kStates, kStride, q_.data(), qd_.data(), in_, M.data(), c.data(),
                                            options_),
            0U);
  expect_equal<kV * kV>(
      M, [](auto q, auto, auto, const auto& in, double* out) { one::mass_matrix<double>(q, in, out); });
  EXPECT_EQ(one::energy_batch(kStates, kStride, q_.data(), qd_.data(), in_, e.data(), options_), 0U);
  expect_equal<2>(
      e, [](auto q, auto qd, auto, const auto& in, double* out) { one::energy<double>(q, qd, in, out); });
  EXPECT_EQ(one::body_poses_batch(kStates, kStride, q_.data(), in_, W.data(), options_), 0U);
  expect_equal<12 * one::kBodyCount>(
      W, [](auto q, auto, auto, const auto& in, double* out) { one::body_poses<double>(q, in, out); });
  EXPECT_EQ(one::coordinate_rates_batch(kStates, kStride, q_.data(), qd_.data(), in_, rates.data(), options_),
            0U);
  expect_equal<kQ>(rates, [](auto q, auto qd, auto, const auto&, double* out) {
    one::coordinate_rates<double>(q, qd, out);
  });
}

TEST_P(BatchSample, SolvesForTheRates) {
  std::vector<double> tau(kV * kStride), back(kV * kStride);
  // Unit quaternions, with which M is positive definite.
  for (std::size_t s = 0; s < kStates; ++s) {
    double norm = 0;
    for (std::size_t i = 2; i < 6; ++i) norm += q_[i * kStride + s] * q_[i * kStride + s];
    for (std::size_t i = 2; i < 6; ++i) q_[i * kStride + s] /= std::sqrt(norm);
  }
  ASSERT_EQ(one::inverse_dynamics_batch(kStates, kStride, q_.data(), qd_.data(), rates_.data(), in_,
                                        tau.data(), options_),
            0U);
  EXPECT_EQ(one::forward_dynamics_batch(kStates, kStride, q_.data(), qd_.data(), tau.data(), in_, back.data(),
                                        options_),
            0U);
  for (std::size_t i = 0; i < kV; ++i)
    for (std::size_t s = 0; s < kStates; ++s)
      EXPECT_NEAR(back[i * kStride + s], rates_[i * kStride + s], 1e-9);
  // Without mass M is singular: no state has a result, and none is passed off as one.
  for (std::size_t s = 0; s < kStates; ++s) parameters_[s] = s == 7 ? -1.0 : parameters_[s];
  EXPECT_EQ(one::forward_dynamics_batch(kStates, kStride, q_.data(), qd_.data(), tau.data(), in_, back.data(),
                                        options_),
            1U);
  for (std::size_t i = 0; i < kV; ++i)
    for (std::size_t s = 0; s < kStates; ++s) EXPECT_EQ(std::isfinite(back[i * kStride + s]), s != 7);
}

/// Steps along the chain and dot products are loops, over one state and over packs.
TEST_P(BatchSample, LoopsAreThoseOfOneState) {
  namespace chain = bits::chain;
  constexpr std::size_t kN = chain::kNv, kBodies = chain::kBodyNames.size();
  const std::vector<double> q = random_rows(kN, 1, -3, 3), qd = random_rows(kN, 2, -2, 2),
                            qdd = random_rows(kN, 3, -2, 2);
  std::vector<double> tau(kN * kStride), back(kN * kStride), M(kN * kN * kStride), c(kN * kStride),
      J(6 * kBodies * kN * kStride);
  EXPECT_EQ(chain::inverse_dynamics_batch(kStates, kStride, q.data(), qd.data(), qdd.data(), {}, tau.data(),
                                          options_),
            0U);
  EXPECT_EQ(chain::forward_dynamics_batch(kStates, kStride, q.data(), qd.data(), tau.data(), {}, back.data(),
                                          options_),
            0U);
  EXPECT_EQ(chain::mass_matrix_and_bias_batch(kStates, kStride, q.data(), qd.data(), {}, M.data(), c.data(),
                                              options_),
            0U);
  EXPECT_EQ(chain::body_jacobians_batch(kStates, kStride, q.data(), {}, J.data(), options_), 0U);
  const auto expect_rows = [](const auto& expected, const std::vector<double>& rows, std::size_t s) {
    double scale = 1;
    for (const double e : expected) scale = std::max(scale, std::abs(e));
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(rows[i * kStride + s], expected[i], 1e-12 * scale) << i << " of state " << s;
  };
  for (std::size_t s = 0; s < kStates; ++s) {
    const auto q_s = column<kN>(q, s), qd_s = column<kN>(qd, s);
    std::array<double, kN> one;
    chain::inverse_dynamics<double>(q_s.data(), qd_s.data(), column<kN>(qdd, s).data(), {}, one.data());
    expect_rows(one, tau, s);
    chain::bias<double>(q_s.data(), qd_s.data(), {}, one.data());
    expect_rows(one, c, s);
    std::array<double, kN * kN> matrix;
    chain::mass_matrix<double>(q_s.data(), {}, matrix.data());
    expect_rows(matrix, M, s);
    std::array<double, 6 * kBodies * kN> jacobians;
    chain::body_jacobians<double>(q_s.data(), {}, jacobians.data());
    expect_rows(jacobians, J, s);
    for (std::size_t i = 0; i < kN; ++i)
      EXPECT_NEAR(back[i * kStride + s], qdd[i * kStride + s], 1e-9) << i << " of state " << s;
  }
}

/// Where forward_dynamics is among the functions, its straight line is what runs.
TEST(BatchLine, SolvesForTheRates) {
  namespace line = line::double_pendulum;
  constexpr std::size_t kN = line::kNv;
  const std::vector<double> q = random_rows(kN, 1, -3, 3), qd = random_rows(kN, 2, -2, 2),
                            qdd = random_rows(kN, 3, -2, 2);
  for (const Instructions instructions : {Instructions::best, Instructions::baseline, Instructions::avx512}) {
    std::vector<double> tau(kN * kStride), back(kN * kStride);
    BatchOptions options;
    options.instructions = instructions;
    EXPECT_EQ(line::inverse_dynamics_batch(kStates, kStride, q.data(), qd.data(), qdd.data(), {}, tau.data(),
                                           options),
              0U);
    EXPECT_EQ(line::forward_dynamics_batch(kStates, kStride, q.data(), qd.data(), tau.data(), {}, back.data(),
                                           options),
              0U);
    for (std::size_t i = 0; i < kN; ++i)
      for (std::size_t s = 0; s < kStates; ++s)
        EXPECT_NEAR(back[i * kStride + s], qdd[i * kStride + s], 1e-11);
  }
}

TEST_P(BatchSample, TakesWhatIsCommon) {
  std::vector<double> common(kV * kStride), own(kV * kStride);
  one::BatchInputs shared;
  shared.common = inputs(3);
  for (std::size_t s = 0; s < kStride; ++s) {
    t_[s] = shared.common.t;
    for (std::size_t i = 0; i < kP; ++i) parameters_[i * kStride + s] = shared.common.parameters[i];
    for (std::size_t i = 0; i < kW; ++i) wrenches_[i * kStride + s] = shared.common.wrenches[i];
  }
  one::bias_batch(kStates, kStride, q_.data(), qd_.data(), shared, common.data(), options_);
  one::bias_batch(kStates, kStride, q_.data(), qd_.data(), in_, own.data(), options_);
  EXPECT_EQ(common, own);
  if (GetParam() != Instructions::best) return;
  std::vector<double> in_c(kV * kStride);
  ASSERT_EQ(batch_sample_bias_batch(kStates, kStride, q_.data(), qd_.data(), shared.common.t,
                                    shared.common.parameters.data(), wrenches_.data(), in_c.data(), 2),
            0);
  EXPECT_EQ(common, in_c);
}

INSTANTIATE_TEST_SUITE_P(Instructions, BatchSample,
                         testing::Values(Instructions::best, Instructions::baseline, Instructions::avx2,
                                         Instructions::avx512));

}  // namespace
