// Armatures: what they add to each function, by both formulations, and how many operations it takes.
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/checks/plain_equations.hpp"
#include "dynamics/function_builders.hpp"
#include "dynamics/mechanism_file.hpp"
#include "dynamics/tree/symbols.hpp"
#include "symbolic/count_operations.hpp"

namespace alembert::test {
namespace {

constexpr double kGearedTolerance = 1e-11;
constexpr double kFirstRotor = 0.75;  // of speed 0, a runtime parameter; more for each further one

/// A mechanism of the catalogue, and its copy with armatures.
struct Geared {
  explicit Geared(const std::string& name)
      : plain(LoadedMechanism::file(std::string(ALEMBERT_SOURCE_DIR) + "/mechanisms/" + name + ".yaml")),
        geared(*plain.mechanism) {
    geared.parameters.push_back({"rotor", kFirstRotor, true, geared.where});
    const Expr first = plain.graph->symbol("rotor");
    for (Coordinate& coordinate : geared.coordinates) {
      const auto k = coordinate.first_speed;
      coordinate.armature = k == 0 ? first : plain.graph->rational(Rational(3 + k, 4));
      inertias.insert(inertias.end(), static_cast<std::size_t>(coordinate.nv()), kFirstRotor + k / 4.0);
    }
  }
  std::vector<double> at(const std::vector<Expr>& values, unsigned seed) const {
    return evaluate(values, state_values(geared, *plain.graph, seed));
  }
  LoadedMechanism plain;
  Mechanism geared;
  std::vector<double> inertias;  // by speed
};

std::vector<Expr> results(const Kinematics& kinematics, const EquationsOfMotion& equations,
                          FunctionKind kind) {
  std::vector<Expr> flat;
  for (const OutputExpressions& output : function_outputs(kinematics, equations, kind))
    flat.insert(flat.end(), output.values.begin(), output.values.end());
  return flat;
}

void expect_near(const std::vector<double>& found, const std::vector<double>& expected, const char* what) {
  ASSERT_EQ(found.size(), expected.size());
  double scale = 1;
  for (const double x : expected) scale = std::max(scale, std::abs(x));
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], kGearedTolerance * scale) << what << ' ' << i;
}

class Armature : public testing::TestWithParam<const char*> {};

TEST_P(Armature, AddsWhatItMust) {
  const Geared mechanism(GetParam());
  const std::vector<double>& a = mechanism.inertias;
  const std::size_t n = a.size();
  const Kinematics plain = mechanism.plain.kinematics(),
                   geared = symbolic_kinematics(mechanism.geared, *mechanism.plain.graph);
  std::vector<Expr> rates, speeds;
  for (std::size_t k = 0; k < n; ++k) {
    rates.push_back(plain.derivatives.rate(static_cast<int>(k)));
    speeds.push_back(plain.derivatives.speed(static_cast<int>(k)));
  }
  for (const Formulation formulation : {Formulation::reduced, Formulation::factored}) {
    const EquationsOfMotion without = equations_of_motion(plain, formulation),
                            with = equations_of_motion(geared, formulation);
    for (const unsigned seed : {1U, 2U, 3U}) {
      std::vector<double> Q = mechanism.at(without.Q, seed), M = mechanism.at(without.M, seed);
      const std::vector<double> ud = mechanism.at(rates, seed), u = mechanism.at(speeds, seed);
      double kinetic = 0;
      for (std::size_t k = 0; k < n; ++k) {
        Q[k] += a[k] * ud[k];
        M[k * n + k] += a[k];
        kinetic += a[k] * u[k] * u[k] / 2;
      }
      const std::vector<double> c = mechanism.at(without.c, seed);
      expect_near(mechanism.at(with.Q, seed), Q, "Q");
      expect_near(mechanism.at(with.M, seed), M, "M");
      expect_near(mechanism.at(with.c, seed), c, "c");
      std::vector<double> energy = mechanism.at(results(plain, without, FunctionKind("energy")), seed);
      energy[0] += kinetic;
      expect_near(mechanism.at(results(geared, with, FunctionKind("energy")), seed), energy, "energy");
      // M qdd + c = tau, whose symbols have values at a random state as all others have.
      std::vector<Expr> tau;
      for (const OutputExpressions& output : function_outputs(geared, with, FunctionKind("forward_dynamics")))
        tau = output.values;
      const std::vector<double> qdd = mechanism.at(tau, seed);
      std::vector<double> force(n, 0.0), given;
      for (std::size_t i = 0; i < n; ++i) {
        force[i] = c[i];
        for (std::size_t k = 0; k < n; ++k) force[i] += M[i * n + k] * qdd[k];
      }
      for (const SymbolBinding& binding : symbol_bindings(mechanism.geared, *mechanism.plain.graph))
        if (binding.slot.kind == ArgumentKind::tau) given.push_back(mechanism.at({binding.symbol}, seed)[0]);
      expect_near(force, given, "tau");
    }
    const auto operations = [](const std::vector<Expr>& values) { return count_operations(values).total(); };
    EXPECT_LE(operations(with.Q), operations(without.Q) + 2 * n);
    EXPECT_LE(operations(with.M), operations(without.M) + n);
    EXPECT_EQ(operations(with.c), operations(without.c));
  }
}

INSTANTIATE_TEST_SUITE_P(Some, Armature,
                         testing::Values("double_pendulum", "chain6r", "tree_every_joint", "bead_on_helix",
                                         "moving_base", "free_body"),
                         [](const auto& test) { return test.param; });

TEST(Armature, MovesWhatHasNoMass) {
  const auto loaded = LoadedMechanism::text(
      "alembert: 1\nname: test\ncoordinates: [q, {name: s, armature: 0.5}]\nbodies:\n"
      "  - {name: arm, transform: [{rotate: {axis: z, angle: q}}], mass: 1, com: [1, 0, 0]}\n"
      "  - {name: tip, parent: arm, transform: [{rotate: {axis: x, angle: s}}]}\n");
  const Kinematics kinematics = loaded.kinematics();
  const EquationsOfMotion equations = equations_of_motion(kinematics, Formulation::reduced);
  EXPECT_NO_THROW(check_mass_matrix(kinematics, PlainEquations(kinematics)));
  EXPECT_EQ(loaded.values(equations.M, 1), (std::vector<double>{1, 0, 0, 0.5}));
}

}  // namespace
}  // namespace alembert::test
