// Functions over many states against those over one: the same results to rounding, with every set of
// instructions that this machine has, and to the last bit for any number of states, place and threads.
#include "alembert/batch.hpp"

#include <chain6r/chain6r.h>
#include <gtest/gtest.h>
#include <puma560/puma560.h>

#include <algorithm>
#include <array>
#include <chain6r/chain6r_batch.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <puma560/puma560_batch.hpp>
#include <random>
#include <vector>

namespace {

using alembert::BatchOptions;
using alembert::Instructions;
namespace chain = alembert::mechanisms::chain6r;
namespace puma = alembert::mechanisms::puma560;

constexpr std::size_t kSize = 6;
constexpr double kMark = 12345.0;

/// n states one beside the other, the space between them marked.
struct States {
  States(std::size_t count, std::size_t distance) : n(count), stride(distance) {
    for (std::vector<double>* x : {&q, &qd, &qdd, &tau}) x->assign(kSize * stride, kMark);
    M.assign(kSize * kSize * stride, kMark);
    c = back = tau;
    // The state at a place depends on the place only, not on n.
    for (std::size_t s = 0; s < n; ++s) {
      std::mt19937_64 random(s);
      std::uniform_real_distribution<double> uniform(-3, 3);
      for (std::size_t i = 0; i < kSize; ++i)
        for (std::vector<double>* x : {&q, &qd, &qdd}) (*x)[i * stride + s] = uniform(random);
    }
  }
  std::array<double, kSize> state(const std::vector<double>& x, std::size_t s) const {
    std::array<double, kSize> out;
    for (std::size_t i = 0; i < kSize; ++i) out[i] = x[i * stride + s];
    return out;
  }
  std::size_t n, stride;
  std::vector<double> q, qd, qdd, tau, M, c, back;
};

void run_chain(States& x, const BatchOptions& options) {
  const chain::BatchInputs in;
  EXPECT_EQ(chain::inverse_dynamics_batch(x.n, x.stride, x.q.data(), x.qd.data(), x.qdd.data(), in,
                                          x.tau.data(), options),
            0U);
  EXPECT_EQ(chain::mass_matrix_and_bias_batch(x.n, x.stride, x.q.data(), x.qd.data(), in, x.M.data(),
                                              x.c.data(), options),
            0U);
  EXPECT_EQ(chain::forward_dynamics_batch(x.n, x.stride, x.q.data(), x.qd.data(), x.tau.data(), in,
                                          x.back.data(), options),
            0U);
}

std::vector<Instructions> all_instructions() {
  std::vector<Instructions> list{Instructions::best, Instructions::baseline};
  for (const Instructions set : {Instructions::avx2, Instructions::avx512})
    if (alembert::has_instructions(set)) list.push_back(set);
  return list;
}

TEST(Batch, GivesWhatTheFunctionsOverOneStateGive) {
  for (const Instructions instructions : all_instructions()) {
    for (const std::size_t n : {1U, 2U, 3U, 4U, 7U, 8U, 9U, 15U, 16U, 17U, 31U, 40U}) {
      States x(n, n + 3);
      BatchOptions options;
      options.instructions = instructions;
      run_chain(x, options);
      double largest = 0;
      for (std::size_t s = 0; s < n; ++s) {
        const auto q = x.state(x.q, s), qd = x.state(x.qd, s), qdd = x.state(x.qdd, s);
        std::array<double, kSize> tau, c;
        std::array<double, kSize * kSize> M;
        chain::inverse_dynamics<double>(q.data(), qd.data(), qdd.data(), {}, tau.data());
        chain::mass_matrix_and_bias<double>(q.data(), qd.data(), {}, M.data(), c.data());
        for (std::size_t i = 0; i < kSize; ++i) {
          const double scale = std::abs(tau[i]) + 10;
          EXPECT_NEAR(x.tau[i * x.stride + s], tau[i], 1e-13 * scale);
          EXPECT_NEAR(x.c[i * x.stride + s], c[i], 1e-13 * scale);
          EXPECT_NEAR(x.back[i * x.stride + s], qdd[i], 1e-10);
          for (std::size_t j = 0; j < kSize; ++j)
            EXPECT_NEAR(x.M[(i * kSize + j) * x.stride + s], M[i * kSize + j], 1e-13 * 10);
          largest = std::max(largest, std::abs(tau[i]));
        }
      }
      EXPECT_GT(largest, 1e-3);
      for (const std::vector<double>* array : {&x.tau, &x.c, &x.back, &x.M})
        for (std::size_t i = 0; i < array->size(); ++i)
          EXPECT_EQ((*array)[i] == kMark, i % x.stride >= n) << "written beyond the states";
    }
  }
}

TEST(Batch, DoesNotDependOnNumberPlaceOrThreads) {
  for (const Instructions instructions : all_instructions()) {
    BatchOptions options;
    options.instructions = instructions;
    States all(300, 300);
    run_chain(all, options);
    for (const std::size_t n : {1U, 5U, 8U, 13U, 16U, 27U, 64U, 65U, 129U, 300U}) {
      for (const int threads : {1, 2, 3, 7, 0}) {
        options.threads = threads;
        States some(n, n);
        run_chain(some, options);
        for (std::size_t s = 0; s < n; ++s)
          for (std::size_t i = 0; i < kSize; ++i) {
            EXPECT_EQ(some.tau[i * n + s], all.tau[i * all.stride + s]);
            EXPECT_EQ(some.c[i * n + s], all.c[i * all.stride + s]);
            EXPECT_EQ(some.back[i * n + s], all.back[i * all.stride + s]);
          }
      }
    }
    options.threads = 1;
    // One state in all places.
    States moved(300, 300);
    for (std::size_t i = 0; i < kSize; ++i)
      for (std::vector<double>* x : {&moved.q, &moved.qd, &moved.qdd})
        std::fill_n(x->begin() + static_cast<std::ptrdiff_t>(i * 300), 300, (*x)[i * 300 + 11]);
    run_chain(moved, options);
    for (std::size_t i = 0; i < kSize * 300; ++i) EXPECT_EQ(moved.back[i], moved.back[i / 300 * 300]);
  }
}

/// So many results that they go past the caches; the shares of many threads do not.
TEST(Batch, OfManyStatesIsThatOfFew) {
  for (const Instructions instructions : all_instructions()) {
    BatchOptions options;
    options.instructions = instructions;
    States all(8003, 8005), shared(8003, 8005);
    run_chain(all, options);
    options.threads = 40;
    run_chain(shared, options);
    EXPECT_EQ(all.M, shared.M);
    EXPECT_EQ(all.c, shared.c);
    EXPECT_EQ(all.tau, shared.tau);
  }
}

TEST(Batch, ReportsStatesWithoutAResultAndOnlyThose) {
  for (const Instructions instructions : all_instructions()) {
    BatchOptions options;
    options.instructions = instructions;
    for (const std::size_t n : {3U, 16U, 37U, 200U}) {
      States good(n, n), bad(n, n);
      run_chain(good, options);
      bad.tau = good.tau;
      bad.q[n + 2] = std::numeric_limits<double>::quiet_NaN();
      bad.qd[n - 1] = std::numeric_limits<double>::infinity();
      for (const int threads : {1, 3}) {
        options.threads = threads;
        const std::size_t failed =
            chain::forward_dynamics_batch(n, n, bad.q.data(), bad.qd.data(), bad.tau.data(),
                                          chain::BatchInputs(), bad.back.data(), options);
        EXPECT_EQ(failed, n == 3 ? 1U : 2U);
        for (std::size_t s = 0; s < n; ++s)
          for (std::size_t i = 0; i < kSize; ++i) {
            if (s == 2 || s == n - 1)
              EXPECT_FALSE(std::isfinite(bad.back[i * n + s]));
            else
              EXPECT_EQ(bad.back[i * n + s], good.back[i * n + s]);
          }
      }
      options.threads = 1;
    }
  }
}

TEST(Batch, OfNoStatesDoesNothing) {
  EXPECT_EQ(puma::inverse_dynamics_batch(0, 0, nullptr, nullptr, nullptr, puma::BatchInputs(), nullptr), 0U);
}

TEST(Batch, LargeAnglesAreThoseOfTheLibrary) {
  States x(20, 20);
  x.q[20 + 3] = 1e7;
  x.q[40 + 4] = -3e22;
  run_chain(x, BatchOptions());
  for (std::size_t s = 0; s < 20; ++s) {
    const auto q = x.state(x.q, s), qd = x.state(x.qd, s), qdd = x.state(x.qdd, s);
    std::array<double, kSize> tau;
    chain::inverse_dynamics<double>(q.data(), qd.data(), qdd.data(), {}, tau.data());
    for (std::size_t i = 0; i < kSize; ++i)
      EXPECT_NEAR(x.tau[i * 20 + s], tau[i], 1e-13 * (std::abs(tau[i]) + 10));
  }
}

TEST(Batch, IsTheSameInC) {
  States x(21, 24);
  run_chain(x, BatchOptions());
  std::vector<double> tau(kSize * 24), back(kSize * 24);
  ASSERT_EQ(chain6r_inverse_dynamics_batch(21, 24, x.q.data(), x.qd.data(), x.qdd.data(), 0, nullptr, nullptr,
                                           tau.data(), 2),
            0);
  ASSERT_EQ(chain6r_forward_dynamics_batch(21, 24, x.q.data(), x.qd.data(), tau.data(), 0, nullptr, nullptr,
                                           back.data(), 1),
            0);
  for (std::size_t i = 0; i < kSize; ++i)
    for (std::size_t s = 0; s < 21; ++s) {
      EXPECT_EQ(tau[i * 24 + s], x.tau[i * 24 + s]);
      EXPECT_EQ(back[i * 24 + s], x.back[i * 24 + s]);
    }
  EXPECT_EQ(chain6r_inverse_dynamics_batch(21, 20, x.q.data(), x.qd.data(), x.qdd.data(), 0, nullptr, nullptr,
                                           tau.data(), 1),
            1);
  EXPECT_EQ(puma560_inverse_dynamics_batch(21, 24, nullptr, x.qd.data(), x.qdd.data(), 0, nullptr, nullptr,
                                           tau.data(), 1),
            1);
  x.q[24 + 5] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(chain6r_inverse_dynamics_batch(21, 24, x.q.data(), x.qd.data(), x.qdd.data(), 0, nullptr, nullptr,
                                           tau.data(), 1),
            2);
}

}  // namespace
