// What is written is measured: right programs are near the plain equations, and one that is wrong in any
// constant by a hundred-millionth is not. Forms that lose digits are told by their bounds.
#include "dynamics/checks/certificate.hpp"

#include <gtest/gtest.h>

#include "dynamics/choice/conditioning.hpp"
#include "dynamics/function_builders.hpp"
#include "dynamics/mechanism_file.hpp"
#include "dynamics/recursions/reduced.hpp"
#include "dynamics/tree/symbols.hpp"
#include "program/lower.hpp"
#include "program/optimized.hpp"
#include "symbolic/identity.hpp"

namespace alembert::test {
namespace {

class Certified : public testing::TestWithParam<FunctionKind> {};

TEST_P(Certified, ProgramsAreMeasured) {
  const auto loaded = LoadedMechanism::file(std::string(ALEMBERT_SOURCE_DIR) + "/mechanisms/puma560.yaml");
  const Kinematics kinematics = loaded.kinematics();
  const EquationsOfMotion equations = equations_of_motion(kinematics, Formulation::reduced);
  const std::vector<SymbolBinding> bindings = symbol_bindings(*loaded.mechanism, *loaded.graph);
  const Certificate certificate(kinematics, bindings);
  Program program =
      lower("function", optimized(function_outputs(kinematics, equations, GetParam())), bindings);
  const MeasuredError right = certificate.measure(program, GetParam());
  EXPECT_EQ(right.states, 10);
  EXPECT_LT(right.relative, 1e-13);
  ASSERT_FALSE(program.constants.empty());
  // Of the constants the one that matters most.
  double worst = 0;
  for (double& constant : program.constants) {
    const double given = constant;
    constant *= 1 + 1e-8;
    worst = std::max(worst, certificate.measure(program, GetParam()).relative);
    constant = given;
  }
  EXPECT_GT(worst, kLargestError);
}

INSTANTIATE_TEST_SUITE_P(Functions, Certified,
                         testing::Values(FunctionKind("inverse_dynamics"), FunctionKind("mass_matrix"),
                                         FunctionKind("bias"), FunctionKind("forward_dynamics"),
                                         FunctionKind("energy"), FunctionKind("body_poses"),
                                         FunctionKind("inverse_dynamics_derivatives"),
                                         FunctionKind("forward_dynamics_derivatives"),
                                         FunctionKind("inverse_dynamics_second_derivatives")),
                         [](const auto& test) { return std::string(to_string(test.param)); });

/// Matrices are measured by their products with random signs: every entry counts, in its row and column.
TEST(Certificate, SeesAWrongEntryOfAnyMatrix) {
  const auto loaded = LoadedMechanism::text(R"(alembert: 1
name: thrown
coordinates: [{name: turn, type: quaternion}, arm]
bodies:
  - {name: base, transform: [{joint: {type: spherical, coordinates: [turn]}}], mass: 2, com: [0.1, 0.2, 0.05],
     inertia: {xx: 0.3, yy: 0.4, zz: 0.5, xy: 0.02}}
  - {name: rod, parent: base, transform: [{translate: [0.3, 0, 0.1]}, {rotate: {axis: [1, 2, 3], angle: arm}}], mass: 0.7,
     com: [0.2, -0.1, 0.3], inertia: {xx: 0.03, yy: 0.02, zz: 0.01}}
)");
  const Kinematics kinematics = loaded.kinematics();
  const EquationsOfMotion equations = equations_of_motion(kinematics, Formulation::reduced);
  const std::vector<SymbolBinding> bindings = symbol_bindings(*loaded.mechanism, *loaded.graph);
  const Certificate certificate(kinematics, bindings, 1);
  for (const FunctionKind kind :
       {FunctionKind("mass_matrix"), FunctionKind("inverse_dynamics_derivatives"),
        FunctionKind("forward_dynamics_derivatives"), FunctionKind("inverse_dynamics_second_derivatives")}) {
    Program program = lower("function", optimized(function_outputs(kinematics, equations, kind)), bindings);
    EXPECT_LT(certificate.measure(program, kind).relative, 1e-12) << to_string(kind);
    for (OutputArray& output : program.outputs) {
      for (std::size_t i = 0; i < output.values.size(); ++i) {
        const auto given = output.values[i];
        const auto other = output.values[(i + output.columns + 1) % output.values.size()];
        if (other == given) continue;
        output.values[i] = other;
        EXPECT_GT(certificate.measure(program, kind).relative, kLargestError)
            << to_string(kind) << output.name << i;
        output.values[i] = given;
      }
    }
  }
}

/// It goes by the description, not by what was made of it first.
TEST(Certificate, SeesAWrongTreeOfMotions) {
  const auto loaded =
      LoadedMechanism::file(std::string(ALEMBERT_SOURCE_DIR) + "/mechanisms/double_pendulum.yaml");
  Kinematics kinematics = loaded.kinematics();
  const std::vector<SymbolBinding> bindings = symbol_bindings(*loaded.mechanism, *loaded.graph);
  const FunctionKind function("inverse_dynamics");
  const auto error = [&] {
    const EquationsOfMotion equations = equations_of_motion(kinematics, Formulation::reduced);
    const Program program =
        lower("function", optimized(function_outputs(kinematics, equations, function)), bindings);
    return Certificate(kinematics, bindings).measure(program, function).relative;
  };
  EXPECT_LT(error(), 1e-14);
  for (MotionNode& node : kinematics.tree.nodes)
    for (Expr& entry : node.motion.offset.entries) {
      if (entry.valid() && !entry.is_zero()) entry *= loaded.graph->real(1 + 1e-8);
    }
  EXPECT_GT(error(), kLargestError);
}

/// A choice that rounding decides at every state leaves the rest to be measured.
TEST(Certificate, MeasuresWhereChoicesAreUndecided) {
  const auto loaded = LoadedMechanism::text(R"(alembert: 1
name: block
coordinates: [{name: x, limits: [-1, 1]}]
bodies: [{name: block, transform: [{translate: [x, 0, 0]}], mass: 2}]
forces: [{name: spring, on: x, value: '-3*x + max(0, asin(sin(x)) - x)'}]
)");
  const Kinematics kinematics = loaded.kinematics();
  const EquationsOfMotion equations = equations_of_motion(kinematics, Formulation::reduced);
  const std::vector<SymbolBinding> bindings = symbol_bindings(*loaded.mechanism, *loaded.graph);
  const Certificate certificate(kinematics, bindings);
  const FunctionKind bias("bias");
  Program program = lower("bias", optimized(function_outputs(kinematics, equations, bias)), bindings);
  EXPECT_EQ(certificate.measure(program, bias).states, 10);
  EXPECT_LT(certificate.measure(program, bias).relative, 1e-13);
  double worst = 0;
  for (double& constant : program.constants) {
    const double given = constant;
    constant *= 1 + 1e-8;
    worst = std::max(worst, certificate.measure(program, bias).relative);
    constant = given;
  }
  EXPECT_GT(worst, kLargestError);
}

TEST(Conditioning, SumsOfWhatCancelsAreTold) {
  const auto loaded =
      LoadedMechanism::file(std::string(ALEMBERT_SOURCE_DIR) + "/mechanisms/double_pendulum.yaml");
  const Kinematics kinematics = loaded.kinematics();
  ExprGraph& graph = *loaded.graph;
  const std::vector<Expr> plain = reduced_inverse_dynamics(*loaded.mechanism, kinematics.tree, graph);
  const Conditioning conditioning(kinematics, plain);
  EXPECT_TRUE(conditioning.is_good(plain));
  // The same values by way of others that are a million times as large.
  std::vector<Expr> roundabout = plain;
  const Expr far = graph.integer(1000000) * cos(loaded.mechanism->coordinates[0].symbols[0]);
  roundabout[1] = sqrt((roundabout[1] + far) * (roundabout[1] + far)) - far;
  EXPECT_FALSE(conditioning.is_good(roundabout));
}

TEST(Identity, IsProvedAndNotSampled) {
  ExprGraph graph;
  const Expr q = graph.symbol("q");
  EXPECT_TRUE(vanishes(sin(q) * sin(q) + cos(q) * cos(q) - graph.one(), 1));
  // Zero to rounding wherever q is small, and zero nowhere.
  EXPECT_FALSE(vanishes(graph.one() + tanh(graph.integer(20) * (q - graph.rational(Rational(9, 2)))), 1));
  EXPECT_FALSE(vanishes(exp(graph.integer(-1000) * (q - graph.integer(5)) * (q - graph.integer(5))), 1));
  // The sign of a root is unknown.
  EXPECT_FALSE(vanishes(sqrt(q * q + graph.integer(2) * q + graph.one()) - q - graph.one(), 1));
  // Numbers that differ in the 17th digit differ.
  EXPECT_TRUE(vanishes(sqrt(graph.integer(2)) * sqrt(graph.integer(2)) - graph.integer(2), 1));
  EXPECT_FALSE(vanishes(sqrt(graph.integer(2)) - graph.real(1.4142135623730951), 1));
}

}  // namespace
}  // namespace alembert::test
