// Which mechanisms are trees of axes, and that what generated code is told of them is measured.
#include "dynamics/choice/axis_form.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "dynamics/checks/axis_check.hpp"
#include "dynamics/mechanism_file.hpp"
#include "dynamics/random_trees.hpp"
#include "dynamics/tree/symbols.hpp"
#include "program/lower.hpp"

namespace alembert::test {
namespace {

/// A spine of eight joints, the last of which is `joint`, with two fingers on the fourth.
std::string spine(const std::string& joint, const std::string& more = "", const std::string& mass = "1.5") {
  std::string bodies, names;
  for (int i = 0; i < 10; ++i) {
    names += fmt::format("{}q{}", i > 0 ? ", " : "", i);
    const int parent = i == 8 ? 3 : i - 1;
    bodies += fmt::format(
        "  - name: b{0}\n{1}    transform:\n      - translate: [0.{0}1, 0.2, -0.1]\n      - {2}\n    mass: "
        "{3}\n"
        "    com: [0.1, 0.0{0}, 0.05]\n    inertia: {{xx: 0.02, yy: 0.03, zz: 0.04, xy: 0.001}}\n",
        i, i > 0 ? fmt::format("    parent: b{}\n", parent) : "",
        i == 7 ? joint
               : fmt::format("joint: {{type: revolute, axis: [1, 0.{}, 0.5], coordinates: [q{}]}}", i, i),
        i == 5 ? mass : "1.2");
  }
  return fmt::format("alembert: 1\nname: spine\ncoordinates: [{}]\n{}bodies:\n{}", names, more, bodies);
}
const std::string kHinge = "joint: {type: revolute, axis: y, coordinates: [q7]}";

struct Found {
  LoadedMechanism loaded;
  std::optional<AxisForm> form;
  std::optional<AxisPrograms> programs;

  explicit Found(LoadedMechanism given) : loaded(std::move(given)) {
    const Kinematics kinematics = loaded.kinematics();
    form = axis_form(kinematics);
    if (!form) return;
    const std::vector<SymbolBinding> bindings = symbol_bindings(*loaded.mechanism, *loaded.graph);
    const auto n = static_cast<std::uint32_t>(loaded.mechanism->nv);
    programs = AxisPrograms{
        form->table,
        lower("axis_frames", std::vector<OutputExpressions>{{"frames", 12, n, form->frames}}, bindings),
        {}};
    if (!form->Q.empty())
      programs->forces =
          lower("axis_forces",
                std::vector<OutputExpressions>{
                    {"Q", n, 1, form->Q},
                    {"changes", static_cast<std::uint32_t>(form->changes.size()), 1, form->changes}},
                bindings);
  }
  std::optional<double> error() const {
    const Kinematics kinematics = loaded.kinematics();
    const std::vector<SymbolBinding> bindings = symbol_bindings(*loaded.mechanism, *loaded.graph);
    return axis_error(Certificate(kinematics, bindings), bindings, *programs);
  }
};
Found found_in(const std::string& text) {
  return Found(LoadedMechanism::text(text));
}

TEST(AxisForm, RowsStandBranchByBranch) {
  const Found found = found_in(spine(kHinge));
  ASSERT_TRUE(found.form);
  const AxisTable& table = found.form->table;
  ASSERT_EQ(table.speeds.size(), 10u);
  for (std::size_t row = 0; row < table.speeds.size(); ++row) {
    const int speed = table.speeds[row], carrier = speed == 8 ? 3 : speed - 1;
    const int parent = table.parents[row];
    EXPECT_EQ(parent < 0 ? -1 : table.speeds[static_cast<std::size_t>(parent)], carrier);
    EXPECT_EQ(table.masses[row], speed == 5 ? 1.5 : 1.2);
    EXPECT_TRUE(table.turns[row]);
  }
  EXPECT_LT(found.error().value(), 1e-12);
}

TEST(AxisForm, ErrorSeesEachNumber) {
  Found found =
      found_in(spine(kHinge, "forces:\n  - {name: drag, on: q4, value: -0.3*d(q4)*d(q4) - 2*q4}\n"));
  ASSERT_TRUE(found.form);
  EXPECT_LT(found.error().value(), 1e-12);
  AxisTable& table = found.programs->table;
  const auto expect_seen = [&](double& number) {
    const double given = number;
    number += 1e-6;
    const std::optional<double> error = found.error();
    EXPECT_TRUE(!error || *error > kLargestAxisError);
    number = given;
  };
  expect_seen(table.masses[4]);
  expect_seen(table.armatures[2]);
  expect_seen(table.gravity[1]);
  for (std::vector<double>& entries : table.centers) expect_seen(entries[5]);
  for (std::vector<double>& entries : table.inertias) expect_seen(entries[6]);
  for (std::vector<double>& entries : table.directions) expect_seen(entries[7]);
  expect_seen(found.programs->frames.constants.front());
  expect_seen(found.programs->forces->constants.front());
}

TEST(AxisForm, OtherMechanismsHaveNone) {
  const auto has_form = [](const std::string& text) { return found_in(text).form.has_value(); };
  EXPECT_TRUE(has_form(spine("joint: {type: prismatic, axis: [1, 2, 0], coordinates: [q7]}")));
  EXPECT_TRUE(has_form(
      spine("translate: [l, 0, 0]\n      - " + kHinge, "parameters: {l: {value: 0.3, runtime: true}}\n")));
  // One speed that turns and slides, or moves two bodies.
  EXPECT_FALSE(has_form(spine("joint: {type: helical, axis: z, pitch: 0.1, coordinates: [q7]}")));
  EXPECT_FALSE(has_form(spine("rotate: {axis: z, angle: q7 + 0.5*q6}")));
  // A way that is no line, an axis that turns with time.
  EXPECT_FALSE(has_form(spine("translate: [sin(q7), cos(q7), 0]")));
  EXPECT_FALSE(has_form(spine("rotate: {axis: z, angle: q7 + 0.3*sin(t)}")));
  // Numbers that are not known.
  EXPECT_FALSE(has_form(spine(kHinge, "parameters: {load: {value: 2, runtime: true}}\n", "load")));
  EXPECT_FALSE(
      has_form(spine(kHinge, "gravity: [0, 0, -g]\nparameters: {g: {value: 9.81, runtime: true}}\n")));
  EXPECT_FALSE(has_form(spine(kHinge, "", "1.5\n    external_wrench: true")));
}

TEST(AxisForm, RandomTrees) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    TreeWriter writer(seed);
    const Found found =
        found_in(writer.description(10 + static_cast<int>(seed), 1 + static_cast<int>(seed % 4), true));
    ASSERT_TRUE(found.form) << "seed " << seed;
    EXPECT_LT(found.error().value_or(1), 1e-12) << "seed " << seed;
  }
}

}  // namespace
}  // namespace alembert::test
