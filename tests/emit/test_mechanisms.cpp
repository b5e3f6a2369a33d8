// The whole way for real descriptions: the library that was generated and compiled for a mechanism, against
// the interpreter running the programs it was written from, bit for bit.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <puma560/puma560.hpp>
#include <runtime_parameters/runtime_parameters.hpp>
#include <span>
#include <tree_every_joint/tree_every_joint.hpp>

#include "emit/sample.hpp"
#include "mechanism/load.hpp"
#include "pipeline.hpp"
#include "program/passes.hpp"

namespace {

using alembert::FunctionKind;

template <class M>
struct State {
  typename M::CoordinateVector q;
  typename M::SpeedVector qd, qdd;
  typename M::Inputs in;
};

template <class M>
State<M> random_state(std::uint64_t seed) {
  sample::Random random(seed);
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
        inputs.push_back(s.qdd(i));
        break;
      case alembert::ArgumentKind::tau:
        throw std::logic_error("not asked for");
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

void expect_same_bits(std::span<const double> compiled, std::span<const double> expected,
                      std::string_view what) {
  ASSERT_EQ(compiled.size(), expected.size()) << what;
  for (std::size_t i = 0; i < compiled.size(); ++i) {
    EXPECT_TRUE(std::isfinite(expected[i])) << what << "[" << i << "]";
    EXPECT_EQ(std::bit_cast<std::uint64_t>(compiled[i]), std::bit_cast<std::uint64_t>(expected[i]))
        << what << "[" << i << "]: " << compiled[i] << " and " << expected[i];
  }
}

template <class M>
void check(const std::string& name) {
  alembert::CompileOptions options;
  options.functions = {
      FunctionKind::inverse_dynamics,     FunctionKind::mass_matrix, FunctionKind::bias,
      FunctionKind::mass_matrix_and_bias, FunctionKind::energy,      FunctionKind::coordinate_rates};
  const std::string path = std::string(ALEMBERT_SOURCE_DIR) + "/mechanisms/" + name + ".yaml";
  const alembert::CompiledMechanism compiled =
      alembert::compile_mechanism(alembert::read_source(path), options);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const State<M> s = random_state<M>(seed);
    const auto compare = [&](FunctionKind kind, const auto& result) {
      const std::vector<double> expected = interpreted(compiled.function(kind).program, s);
      expect_same_bits({result.data(), static_cast<std::size_t>(result.size())}, expected, to_string(kind));
    };
    compare(FunctionKind::inverse_dynamics, M::inverse_dynamics(s.q, s.qd, s.qdd, s.in));
    compare(FunctionKind::mass_matrix, M::mass_matrix(s.q, s.in));
    compare(FunctionKind::bias, M::bias(s.q, s.qd, s.in));
    compare(FunctionKind::energy, M::energy(s.q, s.qd, s.in));
    compare(FunctionKind::coordinate_rates, M::coordinate_rates(s.q, s.qd));
    typename M::SpeedMatrix mass;
    typename M::SpeedVector bias;
    M::mass_matrix_and_bias(s.q, s.qd, s.in, mass, bias);
    std::vector<double> both(mass.data(), mass.data() + mass.size());
    both.insert(both.end(), bias.data(), bias.data() + bias.size());
    compare(FunctionKind::mass_matrix_and_bias, both);
  }
}

TEST(CompiledMechanism, Puma560) {
  check<bits::puma560::Mechanism<>>("puma560");
}
TEST(CompiledMechanism, TreeWithEveryJoint) {
  check<bits::tree_every_joint::Mechanism<>>("tree_every_joint");
}
TEST(CompiledMechanism, RuntimeParameters) {
  check<bits::runtime_parameters::Mechanism<>>("runtime_parameters");
}

}  // namespace
