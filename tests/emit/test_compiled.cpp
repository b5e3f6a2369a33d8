// What was emitted, compiled without contraction, against the interpreter, bit for bit; then through every
// layer.
#include <gtest/gtest.h>
#include <sample_all/sample_all.h>
#include <sample_big/sample_big.h>
#include <sample_evil/sample_evil.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <sample_all/sample_all.hpp>
#include <sample_big/sample_big.hpp>
#include <sample_evil/sample_evil.hpp>
#include <sample_loops/sample_loops_impl.hpp>
#include <sample_steps/sample_steps.hpp>
#include <span>

#include "alembert/energy.hpp"
#include "alembert/mechanism.hpp"
#include "emit/sample.hpp"
#include "functions/function_table.hpp"
#include "program/interpret.hpp"
#include "program/loops/dot_products.hpp"
#include "runtime/allocation_counter.hpp"

namespace {

namespace all = alembert::mechanisms::sample_all;
namespace big = alembert::mechanisms::sample_big;
using Model = all::Mechanism<>;

static_assert(all::kNq == 7 && all::kNv == 6 && all::kBodyCount == 3 && all::kWrenchCount == 2);
static_assert(all::kCoordinateNames[4] == "base.w" && all::kSpeedNames[1] == "d(base).x" &&
              all::kSpeedNames[5] == "d(wrist)");
static_assert(all::kQuaternionOffsets.size() == 1 && all::kQuaternionOffsets[0] == 1);
static_assert(all::kParameterNames[1] == "length" && all::kWrenchBodyNames[0] == "hand" &&
              all::kFrameNames[0] == "tip");
static_assert(all::kInitialCoordinates[4] == 1.0 && all::kInitialCoordinates[0] == 0.25);
static_assert(all::kInitialSpeeds.size() == 6 && all::kInitialSpeeds[0] == 2.5 &&
              all::kInitialSpeeds[1] == 0.0 && all::kInitialSpeeds[3] == -1.0);
static_assert(all::kLowerLimits[5] == -1.5 && all::kUpperLimits[5] == 2.0);
static_assert(all::kUpperLimits[6] == std::numeric_limits<double>::infinity());
static_assert(alembert::has_energy_v<Model> && alembert::has_energy_v<all::Mechanism<float>>);
static_assert(!alembert::is_mechanism_v<big::Mechanism<>>, "it has no mass_matrix_and_bias");

struct Arguments {
  std::vector<double> q, qd, qdd, tau, mu;
  all::Inputs<double> in;
};

Arguments random_arguments(int nq, int nv, std::uint64_t seed) {
  sample::Random random(seed);
  const auto vector = [&](int n) {
    std::vector<double> out(static_cast<std::size_t>(n));
    for (double& x : out) x = random.uniform(-2, 2);
    return out;
  };
  Arguments a{vector(nq), vector(nv), vector(nv), vector(nv), vector(nv), {}};
  a.in.t = random.uniform(0, 3);
  for (double& x : a.in.parameters) x = random.uniform(0.5, 2);
  for (double& x : a.in.wrenches) x = random.uniform(-5, 5);
  return a;
}

std::vector<double> interpreted(const alembert::Program& program, const Arguments& a) {
  std::vector<double> inputs;
  for (const alembert::InputSlot& slot : program.inputs) {
    switch (slot.kind) {
      case alembert::ArgumentKind::q:
        inputs.push_back(a.q[slot.index]);
        break;
      case alembert::ArgumentKind::qd:
        inputs.push_back(a.qd[slot.index]);
        break;
      case alembert::ArgumentKind::qdd:
        inputs.push_back(a.qdd[slot.index]);
        break;
      case alembert::ArgumentKind::tau:
        inputs.push_back(a.tau[slot.index]);
        break;
      case alembert::ArgumentKind::mu:
        inputs.push_back(a.mu[slot.index]);
        break;
      case alembert::ArgumentKind::time:
        inputs.push_back(a.in.t);
        break;
      case alembert::ArgumentKind::parameter:
        inputs.push_back(a.in.parameters[slot.index]);
        break;
      case alembert::ArgumentKind::wrench:
        inputs.push_back(a.in.wrenches[slot.index]);
        break;
    }
  }
  std::size_t size = 0;
  for (const alembert::OutputArray& output : program.outputs) size += output.values.size();
  std::vector<double> outputs(size), scratch;
  alembert::interpret(program, inputs, outputs, scratch);
  return outputs;
}

/// Equal as bits; NaNs of any payload are one, as their sign and payload are not specified.
void expect_same_bits(std::span<const double> compiled, std::span<const double> expected,
                      const std::string& what) {
  ASSERT_EQ(compiled.size(), expected.size()) << what;
  for (std::size_t i = 0; i < compiled.size(); ++i) {
    if (std::isnan(compiled[i]) && std::isnan(expected[i])) continue;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(compiled[i]), std::bit_cast<std::uint64_t>(expected[i]))
        << what << "[" << i << "]: " << compiled[i] << " and " << expected[i];
  }
}

const alembert::Program& program_of(const sample::Sample& s, const std::string& function) {
  for (const alembert::Program& program : s.programs)
    if (program.function == function) return program;
  throw std::out_of_range(function);
}

TEST(Compiled, EqualsTheInterpreterBitForBit) {
  const sample::Sample s = sample::every_function();
  std::size_t finite = 0, values = 0, calls = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Arguments a = random_arguments(all::kNq, all::kNv, seed);
    const double *q = a.q.data(), *qd = a.qd.data(), *qdd = a.qdd.data(), *tau = a.tau.data(),
                 *mu = a.mu.data();
    const all::Inputs<double>& in = a.in;
    namespace m = alembert::mechanisms::sample_all;
    const auto visit = [&](const std::string& function, const auto& call) {
      const std::vector<double> expected = interpreted(program_of(s, function), a);
      std::vector<double> out(expected.size());
      call(out.data());
      expect_same_bits(out, expected, function);
      values += expected.size();
      for (const double x : expected) finite += std::isfinite(x) ? 1 : 0;
      ++calls;
    };
#include "sample_calls.inc"
  }
  EXPECT_EQ(calls, 50 * std::size(alembert::kOutputFunctions));
  EXPECT_GT(finite, values / 2) << "the samples test little: too many values are not finite";
}

TEST(Compiled, BlocksEqualTheInterpreterBitForBit) {
  const sample::Sample s = sample::big();
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Arguments a = random_arguments(big::kNq, big::kNv, seed);
    big::Inputs<double> in;
    in.t = a.in.t;
    std::vector<double> tau(big::kNv), M(big::kNv * big::kNv);
    big::inverse_dynamics(a.q.data(), a.qd.data(), a.qdd.data(), in, tau.data());
    expect_same_bits(tau, interpreted(s.programs[0], a), "inverse_dynamics");
    big::mass_matrix(a.q.data(), in, M.data());
    expect_same_bits(M, interpreted(s.programs[1], a), "mass_matrix");
  }
}

TEST(Compiled, EigenAndCLayersPassEverythingOn) {
  const Arguments a = random_arguments(all::kNq, all::kNv, 7);
  const Eigen::Map<const Model::CoordinateVector> q(a.q.data());
  const Eigen::Map<const Model::SpeedVector> qd(a.qd.data()), qdd(a.qdd.data()), tau(a.tau.data());
  const double *p = a.in.parameters.data(), *w = a.in.wrenches.data();
  std::vector<double> raw(200), c(200), c2(200);
  const auto same = [&](const auto& eigen, const char* what) {
    const auto n = static_cast<std::size_t>(eigen.size());
    expect_same_bits(std::span(eigen.data(), n), std::span(raw).first(n), what);
    expect_same_bits(std::span(c).first(n), std::span(raw).first(n), what);
  };
  all::inverse_dynamics(a.q.data(), a.qd.data(), a.qdd.data(), a.in, raw.data());
  ASSERT_EQ(sample_all_inverse_dynamics(a.q.data(), a.qd.data(), a.qdd.data(), a.in.t, p, w, c.data()), 0);
  same(Model::inverse_dynamics(q, qd, qdd, a.in), "inverse_dynamics");
  all::bias(a.q.data(), a.qd.data(), a.in, raw.data());
  ASSERT_EQ(sample_all_bias(a.q.data(), a.qd.data(), a.in.t, p, w, c.data()), 0);
  same(Model::bias(q, qd, a.in), "bias");
  all::forward_dynamics(a.q.data(), a.qd.data(), a.tau.data(), a.in, raw.data());
  ASSERT_EQ(sample_all_forward_dynamics(a.q.data(), a.qd.data(), a.tau.data(), a.in.t, p, w, c.data()), 0);
  same(Model::forward_dynamics(q, qd, tau, a.in), "forward_dynamics");
  all::coordinate_rates(a.q.data(), a.qd.data(), raw.data());
  ASSERT_EQ(sample_all_coordinate_rates(a.q.data(), a.qd.data(), c.data()), 0);
  same(Model::coordinate_rates(q, qd), "coordinate_rates");
  all::energy(a.q.data(), a.qd.data(), a.in, raw.data());
  ASSERT_EQ(sample_all_energy(a.q.data(), a.qd.data(), a.in.t, p, w, c.data()), 0);
  same(Model::energy(q, qd, a.in), "energy");

  all::mass_matrix_and_bias(a.q.data(), a.qd.data(), a.in, raw.data(), raw.data() + 36);
  ASSERT_EQ(sample_all_mass_matrix_and_bias(a.q.data(), a.qd.data(), a.in.t, p, w, c.data(), c2.data()), 0);
  Model::SpeedMatrix M;
  Model::SpeedVector bias;
  Model::mass_matrix_and_bias(q, qd, a.in, M, bias);
  same(M, "M");
  expect_same_bits(std::span(bias.data(), 6), std::span(raw).subspan(36, 6), "c");
  expect_same_bits(std::span(c2).first(6), std::span(raw).subspan(36, 6), "c");

  // Poses and Jacobians are rows in plain arrays.
  all::body_poses(a.q.data(), a.in, raw.data());
  const auto poses = Model::body_poses(q, a.in);
  ASSERT_EQ(sample_all_body_poses(a.q.data(), a.in.t, p, w, c.data()), 0);
  expect_same_bits(std::span(c).first(36), std::span(raw).first(36), "body_poses");
  for (int b = 0; b < 3; ++b)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 4; ++j) {
        const double entry = poses[static_cast<std::size_t>(b)](i, j),
                     expected = raw[static_cast<std::size_t>(12 * b + 4 * i + j)];
        expect_same_bits({&entry, 1}, {&expected, 1}, "body_poses");
      }
  all::frame_jacobians(a.q.data(), a.in, raw.data());
  const auto jacobian = Model::frame_jacobians(q, a.in)[0];
  for (int r = 0; r < 6; ++r)
    for (int k = 0; k < 6; ++k) {
      const double entry = jacobian(r, k), expected = raw[static_cast<std::size_t>(6 * r + k)];
      expect_same_bits({&entry, 1}, {&expected, 1}, "frame_jacobians");
    }
}

TEST(Compiled, ConstraintsAndBodiesGoThroughTheLayers) {
  static_assert(Model::kNc == 3 && Model::kNbodies == 3);
  static_assert(big::Mechanism<double>::kNc == 0 && big::Mechanism<double>::kConstraintNames.empty());
  const Arguments a = random_arguments(all::kNq, all::kNv, 11);
  const Eigen::Map<const Model::CoordinateVector> q(a.q.data());
  const Eigen::Map<const Model::SpeedVector> qd(a.qd.data());
  const double *p = a.in.parameters.data(), *w = a.in.wrenches.data();
  std::vector<double> raw(200), c(200);
  const auto same = [&](const auto& eigen, std::size_t first, const char* what) {
    for (Eigen::Index r = 0; r < eigen.rows(); ++r)
      for (Eigen::Index k = 0; k < eigen.cols(); ++k) {
        const double entry = eigen(r, k);
        const std::size_t i = first + static_cast<std::size_t>(r * eigen.cols() + k);
        expect_same_bits({&entry, 1}, {&raw[i], 1}, what);
        expect_same_bits({&c[i], 1}, {&raw[i], 1}, what);
      }
  };
  Model::ConstraintMatrix P;
  Model::ConstraintVector gamma, velocity, position;
  Model::constraints(q, qd, a.in, P, gamma, velocity, position);
  all::constraints(a.q.data(), a.qd.data(), a.in, raw.data(), raw.data() + 18, raw.data() + 21,
                   raw.data() + 24);
  ASSERT_EQ(sample_all_constraints(a.q.data(), a.qd.data(), a.in.t, p, w, c.data(), c.data() + 18,
                                   c.data() + 21, c.data() + 24),
            0);
  same(P, 0, "P");
  same(gamma, 18, "gamma");
  same(velocity, 21, "velocity");
  same(position, 24, "position");
  all::body_jacobians(a.q.data(), a.in, raw.data());
  ASSERT_EQ(sample_all_body_jacobians(a.q.data(), a.in.t, p, w, c.data()), 0);
  same(Model::body_jacobians(q, a.in), 0, "body_jacobians");
  all::body_inertias(a.in, raw.data());
  ASSERT_EQ(sample_all_body_inertias(a.in.t, p, w, c.data()), 0);
  same(Model::body_inertias(a.in), 0, "body_inertias");
  const Eigen::Map<const Model::SpeedVector> qdd(a.qdd.data());
  Model::SpeedMatrix tau_q, tau_qd;
  const std::size_t by_speeds = static_cast<std::size_t>(tau_q.size());
  all::inverse_dynamics_derivatives(a.q.data(), a.qd.data(), a.qdd.data(), a.in, raw.data(),
                                    raw.data() + by_speeds);
  ASSERT_EQ(sample_all_inverse_dynamics_derivatives(a.q.data(), a.qd.data(), a.qdd.data(), a.in.t, p, w,
                                                    c.data(), c.data() + by_speeds),
            0);
  Model::inverse_dynamics_derivatives(q, qd, qdd, a.in, tau_q, tau_qd);
  same(tau_q, 0, "tau_q");
  same(tau_qd, by_speeds, "tau_qd");

  EXPECT_STREQ(Model::kConstraintNames[0], "no_slip[0]");
  EXPECT_STREQ(Model::kConstraintNames[1], "no_slip[1]");
  EXPECT_STREQ(Model::kConstraintNames[2], "closed");
  EXPECT_EQ(Model::kHolonomic, (std::array<bool, 3>{false, false, true}));
  EXPECT_EQ(sample_all_nc, 3);
  EXPECT_STREQ(sample_all_constraint_names[2], "closed");
  EXPECT_EQ(sample_all_constraint_names[3], nullptr);
  EXPECT_EQ(sample_all_holonomic[1], 0);
  EXPECT_EQ(sample_all_holonomic[2], 1);
  EXPECT_EQ(sample_big_nc, 0);
  EXPECT_EQ(sample_big_constraint_names[0], nullptr);
  EXPECT_STREQ(alembert::mechanisms::sample_evil::kConstraintNames[2], sample::kEvilText);
}

TEST(Compiled, LoopsOverStepsGiveTheBitsOfTheInterpreter) {
  namespace steps = alembert::mechanisms::sample_steps;
  constexpr int n = 24;
  const sample::Sample s = sample::stepping();
  for (const alembert::Program& program : s.programs) EXPECT_GE(program.loops.size(), 2u);
  EXPECT_GT(alembert::dot_products(s.programs[1]), 100u);
  std::size_t finite = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Arguments a = random_arguments(n, n, seed);
    std::vector<double> tau(n), M_and_c(n * n + n);
    steps::inverse_dynamics(a.q.data(), a.qd.data(), a.qdd.data(), {}, tau.data());
    expect_same_bits(tau, interpreted(s.programs[0], a), "inverse_dynamics");
    steps::mass_matrix_and_bias(a.q.data(), a.qd.data(), {}, M_and_c.data(), M_and_c.data() + n * n);
    expect_same_bits(M_and_c, interpreted(s.programs[1], a), "mass_matrix_and_bias");
    for (const double x : tau) finite += std::isfinite(x) ? 1 : 0;
  }
  EXPECT_EQ(finite, 50u * n);
}

TEST(Compiled, LoopsGiveTheBitsOfTheInterpreter) {
  namespace loops = alembert::mechanisms::sample_loops;
  const sample::Sample s = sample::looping();
  EXPECT_GT(alembert::dot_products(s.programs[0]), 60u);
  EXPECT_GT(alembert::dot_products(s.programs[1]), 120u);
  std::size_t finite = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Arguments a = random_arguments(14, 14, seed);
    loops::Inputs<double> in;
    in.t = a.in.t;
    std::vector<double> M(196);
    loops::mass_matrix(a.q.data(), in, M.data());
    expect_same_bits(M, interpreted(s.programs[0], a), "symmetric");
    for (const double x : M) finite += std::isfinite(x) ? 1 : 0;
    M.resize(196 + 14);
    loops::mass_matrix_and_bias(a.q.data(), a.qd.data(), in, M.data(), M.data() + 196);
    expect_same_bits(M, interpreted(s.programs[1], a), "in blocks");
    for (const double x : M) finite += std::isfinite(x) ? 1 : 0;
  }
  EXPECT_GT(finite, 10000u);
}

template <class S>
void expect_sums_in_order() {
  sample::Random random(5);
  constexpr int kRows = 11;
  std::vector<S> left(3), right(3 * kRows);
  for (std::vector<S>* entries : {&left, &right})
    for (S& x : *entries) x = static_cast<S>(random.uniform(-1, 1));
  for (int first = 0; first < kRows; ++first)
    for (int count = 0; first + count <= kRows; ++count) {
      std::vector<S> along(kRows, S(7)), across(2 * kRows, S(7));
      alembert::mechanisms::sample_loops::detail::dot_products<3>(left.data(), right.data() + first, kRows,
                                                                  count, along.data(), across.data(), 2);
      for (int i = 0; i < kRows; ++i) {
        const S* row = right.data() + first + i;
        const S sum = i < count ? left[0] * row[0] + left[1] * row[kRows] + left[2] * row[2 * kRows] : S(7);
        EXPECT_EQ(along[static_cast<std::size_t>(i)], sum);
        EXPECT_EQ(across[static_cast<std::size_t>(2 * i)], sum);
        EXPECT_EQ(across[static_cast<std::size_t>(2 * i + 1)], S(7));
      }
    }
}

TEST(Compiled, LoopsAddTheirTermsInOrderForEveryScalar) {
  expect_sums_in_order<float>();
  expect_sums_in_order<double>();
  expect_sums_in_order<long double>();
}

TEST(Compiled, RepeatedBlocksHaveEveryFunctionAndOperation) {
  namespace evil = alembert::mechanisms::sample_evil;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Arguments a = random_arguments(all::kNq, all::kNv, seed);
    const double *q = a.q.data(), *qd = a.qd.data(), *qdd = a.qdd.data(), *tau = a.tau.data(),
                 *mu = a.mu.data();
    std::map<std::string, std::vector<double>> plain;
    {
      namespace m = alembert::mechanisms::sample_all;
      const all::Inputs<double>& in = a.in;
      const auto visit = [&](const char* function, const auto& call) {
        call(plain.try_emplace(function, 200).first->second.data());
      };
#include "sample_calls.inc"
    }
    namespace m = evil;
    evil::Inputs<double> in;
    in.t = a.in.t;
    in.parameters = a.in.parameters;
    in.wrenches = a.in.wrenches;
    const auto visit = [&](const char* function, const auto& call) {
      std::vector<double> same(200);
      call(same.data());
      expect_same_bits(same, plain.at(function), function);
    };
#include "sample_calls.inc"
  }
}

TEST(Compiled, TextOfTheUserComesThroughAsItIs) {
  namespace evil = alembert::mechanisms::sample_evil;
  EXPECT_EQ(evil::kBodyNames[1], sample::kEvilText);
  EXPECT_EQ(evil::kFrameNames[0], sample::kEvilText);
  EXPECT_STREQ(sample_evil_body_names[1], sample::kEvilText);
  EXPECT_STREQ(sample_evil_coordinate_names[0], sample::kEvilText);
  const Arguments a = random_arguments(all::kNq, all::kNv, 9);
  std::vector<double> plain(36), same(36);
  all::mass_matrix(a.q.data(), {}, plain.data());
  evil::mass_matrix(a.q.data(), {}, same.data());
  expect_same_bits(same, plain, "mass_matrix");
}

TEST(Compiled, CInterfaceDefaultsNullsAndNames) {
  const Arguments a = random_arguments(all::kNq, all::kNv, 8);
  all::Inputs<double> in;
  in.t = 0.5;
  EXPECT_EQ(in.parameters[0], 2.5);
  EXPECT_EQ(in.parameters[1], 1e-3);
  std::vector<double> expected(6), tau(6, 99.0);
  all::inverse_dynamics(a.q.data(), a.qd.data(), a.qdd.data(), in, expected.data());
  ASSERT_EQ(
      sample_all_inverse_dynamics(a.q.data(), a.qd.data(), a.qdd.data(), 0.5, nullptr, nullptr, tau.data()),
      0);
  expect_same_bits(tau, expected, "defaults");
  tau.assign(6, 99.0);
  EXPECT_NE(sample_all_inverse_dynamics(nullptr, a.qd.data(), a.qdd.data(), 0, nullptr, nullptr, tau.data()),
            0);
  EXPECT_NE(sample_all_inverse_dynamics(a.q.data(), nullptr, a.qdd.data(), 0, nullptr, nullptr, tau.data()),
            0);
  EXPECT_NE(sample_all_inverse_dynamics(a.q.data(), a.qd.data(), nullptr, 0, nullptr, nullptr, tau.data()),
            0);
  EXPECT_NE(sample_all_inverse_dynamics(a.q.data(), a.qd.data(), a.qdd.data(), 0, nullptr, nullptr, nullptr),
            0);
  EXPECT_EQ(tau, std::vector<double>(6, 99.0));

  EXPECT_EQ(sample_all_nq, 7);
  EXPECT_EQ(sample_all_nv, 6);
  EXPECT_STREQ(sample_all_coordinate_names[0], "shoulder");
  EXPECT_STREQ(sample_all_coordinate_names[6], "wrist");
  EXPECT_EQ(sample_all_coordinate_names[7], nullptr);
  EXPECT_STREQ(sample_all_speed_names[3], "d(base).z");
  EXPECT_STREQ(sample_all_body_names[2], "tool");
  EXPECT_STREQ(sample_all_parameter_names[1], "length");
  EXPECT_STREQ(sample_all_parameter_names[2], "heat");
  EXPECT_EQ(sample_all_parameter_names[3], nullptr);
  EXPECT_EQ(sample_all_input_count, 1);
  EXPECT_EQ(sample_all_state_count, 1);
  EXPECT_STREQ(sample_all_force_names[1], "friction of wrist");
  EXPECT_STREQ(sample_all_wrench_body_names[0], "hand");
  EXPECT_EQ(sample_all_default_parameters[1], 1e-3);
  EXPECT_EQ(sample_all_initial_coordinates[4], 1.0);
  EXPECT_EQ(sample_all_initial_speeds[3], -1.0);
  EXPECT_EQ(Model::initial_speeds()(0), 2.5);
  EXPECT_EQ(sample_big_parameter_count, 0);
  EXPECT_EQ(sample_big_parameter_names[0], nullptr);
}

TEST(Compiled, RealCoordinatesGetTheirRatesWithoutAProgram) {
  using Big = big::Mechanism<float>;
  Big::SpeedVector qd;
  qd << 1, 2, 3, 4, 5, 6;
  EXPECT_EQ(Big::coordinate_rates(Big::initial_coordinates(), qd), qd);
  EXPECT_EQ(Big::initial_coordinates()(5), 0.5f);
}

TEST(Compiled, FloatFollowsDouble) {
  const Arguments a = random_arguments(all::kNq, all::kNv, 3);
  Model::CoordinateVector q = Eigen::Map<const Model::CoordinateVector>(a.q.data());
  q = q.cast<float>().cast<double>();
  const Model::SpeedMatrix M = Model::mass_matrix(q);
  const Eigen::Matrix<float, 6, 6> Mf = all::Mechanism<float>::mass_matrix(q.cast<float>());
  for (int i = 0; i < 36; ++i)
    EXPECT_NEAR(static_cast<double>(Mf(i)), M(i), 1e-4 * (1 + std::abs(M(i)))) << i;
}

TEST(Compiled, NoHeapInAnyCall) {
  const Arguments a = random_arguments(all::kNq, all::kNv, 4);
  const Model::CoordinateVector q = Eigen::Map<const Model::CoordinateVector>(a.q.data());
  const Model::SpeedVector qd = Eigen::Map<const Model::SpeedVector>(a.qd.data());
  std::vector<double> tau(6), M(36);
  const std::size_t before = allocation_count();
  double sum = Model::inverse_dynamics(q, qd, qd, a.in).sum() + Model::mass_matrix(q, a.in).sum() +
               Model::bias(q, qd).sum() + Model::energy(q, qd)(0) + Model::body_poses(q)[0](0) +
               Model::frame_jacobians(q)[0](0);
  sum += sample_all_inverse_dynamics(q.data(), qd.data(), qd.data(), 0, nullptr, nullptr, tau.data());
  sum += sample_big_mass_matrix(q.data(), 0, nullptr, nullptr, M.data());
  EXPECT_EQ(allocation_count(), before) << sum;
}

}  // namespace
