// Forces of descriptions: closed forms, virtual work of each kind, and what they change in other functions.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "dynamics/function_builders.hpp"
#include "dynamics/mechanism_file.hpp"
#include "dynamics/recursions/outputs.hpp"
#include "symbolic/count_operations.hpp"

namespace alembert::test {
namespace {

/// A function of a mechanism, at given values of some of its symbols; the others are 0.
class Forced {
 public:
  explicit Forced(const std::string& text)
      : loaded_(LoadedMechanism::text(text)), kinematics_(loaded_.kinematics()) {}

  std::vector<double> operator()(std::string_view function,
                                 const std::map<std::string, double>& state) const {
    const EquationsOfMotion equations =
        equations_of_motion(kinematics_, Formulation::reduced, plain_passes());
    std::vector<Expr> flat;
    for (const OutputExpressions& output :
         function_outputs(kinematics_, equations, FunctionKind(*find_function(function))))
      flat.insert(flat.end(), output.values.begin(), output.values.end());
    std::vector<double> values(loaded_.graph->symbol_count(), 0.0);
    for (const auto& [name, value] : state)
      values[loaded_.graph->symbol_index(loaded_.graph->symbol(name).ref().node())] = value;
    values.resize(loaded_.graph->symbol_count(), 0.0);
    return evaluate(flat, values);
  }
  std::size_t operations(std::string_view function) const {
    const EquationsOfMotion equations =
        equations_of_motion(kinematics_, Formulation::reduced, plain_passes());
    return count_operations(
               function_outputs(kinematics_, equations, FunctionKind(*find_function(function)))[0].values)
        .total();
  }

 private:
  LoadedMechanism loaded_;
  Kinematics kinematics_;
};

std::string slider(const std::string& coordinate, const std::string& forces, const std::string& before = "") {
  return "alembert: 1\nname: slider\n" + before + "coordinates: [" + coordinate + R"(]
bodies: [{name: block, transform: [{translate: [x, 0, 0]}], mass: 2}]
frames:
  - {name: tip, body: block}
  - {name: wall, body: world, transform: [{translate: [3, 4, 0]}]}
  - {name: corner, body: world, transform: [{translate: [0, 2, 0]}]}
)" + (forces.empty() ? "" : "forces:\n" + forces);
}

TEST(AppliedForces, OfCoordinates) {
  const Forced damped(slider("{name: x, damping: 3}", ""));
  EXPECT_DOUBLE_EQ(damped("applied_forces", {{"d(x)", 2}})[0], -6);
  EXPECT_DOUBLE_EQ(damped("bias", {{"d(x)", 2}})[0], 6);
  EXPECT_DOUBLE_EQ(damped("inverse_dynamics", {{"d(x)", 2}, {"dd(x)", 5}})[0], 16);
  EXPECT_DOUBLE_EQ(damped("forward_dynamics", {{"d(x)", 2}, {"tau(x)", 10}})[0], 2);
  EXPECT_DOUBLE_EQ(damped("inverse_dynamics_derivatives", {})[1], 3);
  const Forced sprung(slider("{name: x, stiffness: 8, rest: 0.5}", ""));
  EXPECT_DOUBLE_EQ(sprung("applied_forces", {{"x", 2}})[0], -12);
  EXPECT_DOUBLE_EQ(sprung("energy", {{"x", 2}})[1], 9);
  EXPECT_DOUBLE_EQ(sprung("inverse_dynamics_derivatives", {})[0], 8);
  EXPECT_DOUBLE_EQ(sprung("gravity", {{"x", 2}})[0], 0);
  const Forced rubbed(slider("{name: x, friction: {force: 5, velocity: 0.1}}", ""));
  EXPECT_DOUBLE_EQ(rubbed("applied_forces", {{"d(x)", 0.05}})[0], -5 * std::tanh(0.5));
}

TEST(AppliedForces, WhatIsNotChosenSpoilsNoDerivative) {
  const Forced forced(slider("x", R"yaml(  - {name: f, on: x, value: "select(x, d(x)*(sqrt(x) + x*d(x)), 0)"}
  - {name: g, on: x, value: "select(x, (x + d(x))*(sqrt(x) + log(x)*d(x))^2, 0)"}
)yaml"));
  for (const double value : forced("inverse_dynamics_derivatives", {{"x", -0.3}, {"d(x)", 0.2}}))
    EXPECT_EQ(value, 0);
  for (const double value :
       forced("inverse_dynamics_second_derivatives", {{"x", -0.3}, {"d(x)", 0.2}, {"mu(x)", 1}}))
    EXPECT_EQ(value, 0);
}

TEST(AppliedForces, AlongPathsPullTheirEndsTogether) {
  const Forced rubber(slider("x", "  - {name: rubber, between: [wall, tip], tension: 10*length + 7*rate}"));
  // From x = 0: the line is (3, 4), 5 long.
  EXPECT_DOUBLE_EQ(rubber("applied_forces", {})[0], 50 * 0.6);
  EXPECT_DOUBLE_EQ(rubber("applied_forces", {{"d(x)", 1}})[0], (50 - 7 * 0.6) * 0.6);
  const Forced cable(slider("x",
                            "  - {name: cable, path: [wall, tip, corner], tension: 1}\n"
                            "  - {name: reader, on: x, value: 100*length(cable)}"));
  EXPECT_DOUBLE_EQ(cable("applied_forces", {})[0], 0.6 + 100 * 7);
}

TEST(AppliedForces, AtFramesActInTheirAxesOrTheWorlds) {
  const std::string arm = R"(alembert: 1
name: arm
inputs: [u]
coordinates: [q]
bodies:
  - {name: arm, transform: [{rotate: {axis: z, angle: q}}], mass: 1, com: [1, 0, 0]}
frames:
  - {name: tip, body: arm, transform: [{translate: [2, 0, 0]}]}
gravity: [0, 0, 0]
forces:
  - )";
  const Forced own(arm + "{name: jet, at: tip, force: [7, u, 1], torque: [1, 1, 0.5]}");
  EXPECT_DOUBLE_EQ(own("applied_forces", {{"u", 3}, {"q", 0.4}})[0], 6.5);
  const Forced world(arm + "{name: wind, at: tip, axes: world, force: [0, u, 1]}");
  EXPECT_NEAR(world("applied_forces", {{"u", 3}, {"q", 0.4}})[0], 6 * std::cos(0.4), 1e-14);
  const Forced drag(arm +
                    "{name: drag, at: tip, axes: world, "
                    "force: [-u*velocity(tip).x, -u*velocity(tip).y, 0]}");
  EXPECT_NEAR(drag("applied_forces", {{"u", 3}, {"q", 0.4}, {"d(q)", 5}})[0], -3 * 5 * 4, 1e-13);
}

TEST(AppliedForces, ChooseWithoutBranches) {
  const auto value = [](const std::string& expression, double x, double speed = 0) {
    const Forced block(
        slider("{name: x, initial: 1}", "  - {name: f, on: x, value: \"" + expression + "\"}"));
    return block("applied_forces", {{"x", x}, {"d(x)", speed}})[0];
  };
  EXPECT_EQ(value("max(x, 2)", 1), 2);
  EXPECT_EQ(value("max(x, 2)", 3), 3);
  EXPECT_EQ(value("min(x, 2)", 1), 1);
  EXPECT_EQ(value("min(x, 2)", 3), 2);
  EXPECT_EQ(value("clamp(x, -1, 2)", -5), -1);
  EXPECT_EQ(value("clamp(x, -1, 2)", 0.5), 0.5);
  EXPECT_EQ(value("clamp(x, -1, 2)", 5), 2);
  EXPECT_EQ(value("step(x)", 0), 0);
  EXPECT_EQ(value("step(x)", 1e-300), 1);
  EXPECT_EQ(value("sign(d(x))", 0, -3), -1);
  EXPECT_EQ(value("sign(d(x))", 0, 0), 0);
  EXPECT_EQ(value("smoothstep(x)", 0.25), 3.0 / 16 - 2.0 / 64);
  EXPECT_EQ(value("smoothstep(x)", 7), 1);
  EXPECT_EQ(value("select(x, sqrt(abs(x)), 4)", 9), 3);
  EXPECT_EQ(value("select(x, 1/x, 4)", 0), 4) << "what is not chosen has no value";
  EXPECT_EQ(value("linear(x; [0, 1, 3]; [0, 2, 0])", -1), -2);
  EXPECT_EQ(value("linear(x; [0, 1, 3]; [0, 2, 0])", 0.5), 1);
  EXPECT_EQ(value("linear(x; [0, 1, 3]; [0, 2, 0])", 2), 1);
  EXPECT_EQ(value("linear(x; [0, 1, 3]; [0, 2, 0])", 5), -2);
}

/// What moves both ends of a path alike is no part of its length.
TEST(AppliedForces, AlongAPathBetweenNeighboursDependOnTheJointBetweenThem) {
  const auto chain = [](const char* base) {
    return std::string("alembert: 1\nname: chain\ncoordinates: [q1, q2, ") + base + R"(]
bodies:
  - {name: trunk, transform: [{translate: [q1, 0, 0]}, {rotate: {)" +
           (std::string(base) == "q3" ? "axis: x, angle: q3" : "quaternion: base") +
           R"(}}], mass: 1, inertia: {xx: 1, yy: 2, zz: 2}}
  - {name: arm, parent: trunk, transform: [{rotate: {axis: y, angle: q2}}], mass: 1, inertia: {xx: 1, yy: 1, zz: 1}}
frames:
  - {name: from, body: trunk, transform: [{translate: [0.1, 0, 0.3]}]}
  - {name: to, body: arm, transform: [{translate: [0.2, 0, 0.1]}]}
forces:
  - {name: spring, between: [from, to], tension: 10*length}
)";
  };
  const Forced free(chain("{name: base, type: quaternion}"));
  EXPECT_EQ(free.operations("applied_forces"), Forced(chain("q3")).operations("applied_forces"));
  EXPECT_LE(free.operations("applied_forces"), 12U);
}

}  // namespace
}  // namespace alembert::test
