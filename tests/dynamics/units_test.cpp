// A mechanism written in other units is the same mechanism: forces of one that is L times as long, M times as
// heavy and under L times the gravity are M L^2 times as large, however small or large L and M are.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "dynamics/mechanism_file.hpp"
#include "dynamics/tree/symbols.hpp"

namespace alembert::test {
namespace {

/// Three generic links in a row and one beside them; the last in the row carries a load of runtime
/// parameters.
std::string arm(double L, double M) {
  const double I = M * L * L;
  const auto vector = [L](double x, double y, double z) {
    return fmt::format("[{}, {}, {}]", L * x, L * y, L * z);
  };
  std::string text = fmt::format(
      "alembert: 1\nname: arm\ngravity: {}\nparameters:\n  load: {{value: {}, runtime: true}}\n"
      "  reach: {{value: {}, runtime: true}}\ncoordinates: [a, b, c, d]\nbodies:\n",
      vector(0.4, -1.1, -9.7), 0.8 * M, 0.3 * L);
  const auto link = [&](const char* name, const char* parent, const char* q, double k) {
    text += fmt::format(
        "  - name: {}\n    parent: {}\n    transform:\n      - translate: {}\n"
        "      - rotate: {{axis: x, angle: {}}}\n      - joint: {{type: revolute, axis: z, coordinates: "
        "[{}]}}\n"
        "      - translate: {}\n    mass: {}\n    com: {}\n"
        "    inertia: {{xx: {}, yy: {}, zz: {}, xy: {}, xz: {}, yz: {}}}\n",
        name, parent, vector(0.31 * k, 0, 0), 0.7 + 0.2 * k, q, vector(0, 0, 0.17 + 0.1 * k), M * (1.3 + k),
        vector(0.11, -0.07 * k, 0.23), 0.21 * I, 0.32 * I * k, 0.27 * I, 0.02 * I, -0.03 * I * k, 0.05 * I);
  };
  link("first", "world", "a", 1);
  link("second", "first", "b", 0.6);
  link("third", "second", "c", 0.9);
  link("beside", "first", "d", 1.2);
  text += "  - {name: held, parent: third, transform: [{translate: [reach, 0, 0]}], mass: load}\n";
  return text;
}

/// tau of both formulations and what regrouping makes of it.
std::vector<double> forces(double L, double M) {
  const LoadedMechanism loaded = LoadedMechanism::text(arm(L, M));
  const Kinematics kinematics = loaded.kinematics();
  std::vector<double> state = state_values(*loaded.mechanism, *loaded.graph, 0);
  // The same angles, speeds and rates whatever the units are.
  for (std::uint32_t i = 0; i < loaded.graph->symbol_count(); ++i) {
    const std::string& name = loaded.graph->symbol_name(i);
    if (name != "load" && name != "reach") state[i] = std::sin(1.0 + i);
  }
  std::vector<double> all;
  for (const Formulation formulation : {Formulation::factored, Formulation::reduced}) {
    const EquationsOfMotion equations = equations_of_motion(kinematics, formulation);
    for (const std::vector<Expr>& values : {equations.Q, equations.M, equations.c})
      for (const double x : evaluate(values, state)) all.push_back(x / (M * L * L));
  }
  return all;
}

TEST(Units, DoNotMatter) {
  const std::vector<double> usual = forces(1, 1);
  for (const auto& [L, M] : {std::pair{1e-3, 1e-3},
                             {1e-4, 1e-9},
                             {1e-6, 1e-12},
                             {1.0, 1e-12},
                             {1e3, 1e3},
                             {1e6, 1.0},
                             {1e6, 1e9}}) {
    SCOPED_TRACE(fmt::format("{} m, {} kg", L, M));
    const std::vector<double> other = forces(L, M);
    ASSERT_EQ(other.size(), usual.size());
    for (std::size_t i = 0; i < usual.size(); ++i)
      EXPECT_NEAR(other[i], usual[i], 1e-12 * (1 + std::abs(usual[i])));
  }
}

// Programs are verified with parameters about as large as their defaults.
TEST(Units, OfRuntimeParametersAreTheirDefaults) {
  const auto loaded = LoadedMechanism::text(
      "alembert: 1\nname: test\nparameters:\n  I: {value: 1.6e-25, runtime: true}\n"
      "  far: {value: -3e7, runtime: true}\n  m: {value: 0.02, runtime: true}\n"
      "  off: {value: 0, runtime: true}\ncoordinates: [q]\nbodies:\n  - name: a\n"
      "    transform: [{translate: [far, off, 0]}, {rotate: {axis: z, angle: q}}]\n    mass: m\n"
      "    inertia: {xx: I, yy: I, zz: I}\n");
  std::map<std::string, double> units;
  for (const SymbolBinding& binding : symbol_bindings(*loaded.mechanism, *loaded.graph))
    units[binding.slot.name] = binding.unit;
  EXPECT_EQ(units.at("I"), 1.6e-25);
  EXPECT_EQ(units.at("far"), 3e7);
  EXPECT_EQ(units.at("m"), 0.02);
  for (const char* any : {"off", "q"}) EXPECT_EQ(units.at(any), 1) << any;
}

}  // namespace
}  // namespace alembert::test
