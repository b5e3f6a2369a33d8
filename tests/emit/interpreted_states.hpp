// Random states of a compiled mechanism, and what the interpreter makes of them.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "emit/sample.hpp"
#include "program/interpret.hpp"

namespace sample {

template <class M>
struct State {
  typename M::CoordinateVector q;
  typename M::SpeedVector qd, qdd;
  typename M::Inputs in;
};

template <class M>
State<M> random_state(std::uint64_t seed) {
  Random random(seed);
  State<M> s;
  s.q = M::initial_coordinates();
  for (int i = 0; i < M::kNq; ++i) s.q(i) += random.uniform(-0.5, 0.5);
  for (const int first : M::kQuaternionOffsets) s.q.template segment<4>(first).normalize();
  for (int i = 0; i < M::kNv; ++i) s.qd(i) = random.uniform(-2, 2);
  for (int i = 0; i < M::kNv; ++i) s.qdd(i) = random.uniform(-2, 2);
  s.in.t = random.uniform(0, 2);
  for (double& p : s.in.parameters) p *= random.uniform(0.9, 1.1);
  for (double& w : s.in.wrenches) w = random.uniform(-3, 3);
  return s;
}

template <class M>
std::vector<double> interpreted(const alembert::Program& program, const State<M>& s) {
  std::vector<double> inputs, scratch;
  for (const alembert::InputSlot& slot : program.inputs) {
    const auto i = static_cast<Eigen::Index>(slot.index);
    switch (slot.kind) {
      case alembert::ArgumentKind::q:
        inputs.push_back(s.q(i));
        break;
      case alembert::ArgumentKind::qd:
        inputs.push_back(s.qd(i));
        break;
      case alembert::ArgumentKind::qdd:
      case alembert::ArgumentKind::tau:  // the numbers of the state's qdd
      case alembert::ArgumentKind::mu:
        inputs.push_back(s.qdd(i));
        break;
      case alembert::ArgumentKind::time:
        inputs.push_back(s.in.t);
        break;
      case alembert::ArgumentKind::parameter:
        inputs.push_back(s.in.parameters.at(slot.index));
        break;
      case alembert::ArgumentKind::wrench:
        inputs.push_back(s.in.wrenches.at(slot.index));
        break;
    }
  }
  std::size_t size = 0;
  for (const alembert::OutputArray& output : program.outputs) size += output.values.size();
  std::vector<double> outputs(size);
  alembert::interpret(program, inputs, outputs, scratch);
  return outputs;
}

inline void expect_same_bits(std::span<const double> compiled, std::span<const double> expected,
                             std::string_view what) {
  ASSERT_EQ(compiled.size(), expected.size()) << what;
  for (std::size_t i = 0; i < compiled.size(); ++i) {
    EXPECT_TRUE(std::isfinite(expected[i])) << what << "[" << i << "]";
    EXPECT_EQ(std::bit_cast<std::uint64_t>(compiled[i]), std::bit_cast<std::uint64_t>(expected[i]))
        << what << "[" << i << "]: " << compiled[i] << " and " << expected[i];
  }
}

}  // namespace sample
