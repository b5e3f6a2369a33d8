// Equations of motion that textbooks print.
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/mechanism_file.hpp"

namespace alembert::test {
namespace {

/// Values of Q at a state given as name/value pairs of symbols.
std::vector<double> forces(const LoadedMechanism& loaded,
                           const std::vector<std::pair<std::string, double>>& state,
                           Formulation formulation) {
  const Kinematics kinematics = loaded.kinematics();
  const EquationsOfMotion equations = equations_of_motion(kinematics, formulation);
  std::vector<double> values(loaded.graph->symbol_count(), 0.0);
  for (const auto& [name, value] : state) {
    const Expr symbol = loaded.graph->symbol(name);
    const std::uint32_t index = loaded.graph->symbol_index(symbol.ref().node());
    if (index >= values.size()) values.resize(index + 1, 0.0);
    values[index] = value;
  }
  return evaluate(equations.Q, values);
}

class ClosedForm : public testing::TestWithParam<Formulation> {};

TEST_P(ClosedForm, DoublePendulumOfPointMasses) {
  const auto loaded = LoadedMechanism::text(R"(alembert: 1
name: double_pendulum
gravity: [0, -9.81, 0]
coordinates: [a, b]
bodies:
  - {name: upper, transform: [{rotate: {axis: z, angle: a}}], mass: 2, com: [0, -0.7, 0]}
  - {name: lower, parent: upper, transform: [{translate: [0, -0.7, 0]}, {rotate: {axis: z, angle: b}}], mass: 3, com: [0, -1.1, 0]}
)");
  const double m1 = 2, m2 = 3, l1 = 0.7, l2 = 1.1, g = 9.81;
  const double a = 0.4, b = -1.2, da = 0.9, db = -0.3, dda = 1.7, ddb = 0.6;
  const std::vector<double> Q = forces(
      loaded, {{"a", a}, {"b", b}, {"d(a)", da}, {"d(b)", db}, {"dd(a)", dda}, {"dd(b)", ddb}}, GetParam());
  // Absolute angles a and a + b; Lagrange's equations of the planar double pendulum, b relative.
  const double k = m2 * l1 * l2 * std::cos(b), s = m2 * l1 * l2 * std::sin(b);
  const double second = m2 * l2 * l2;
  const double lower = (second + k) * dda + second * ddb + s * da * da + m2 * g * l2 * std::sin(a + b);
  const double upper = ((m1 + m2) * l1 * l1 + second + 2 * k) * dda + (second + k) * ddb -
                       s * (2 * da * db + db * db) + (m1 + m2) * g * l1 * std::sin(a) +
                       m2 * g * l2 * std::sin(a + b);
  EXPECT_NEAR(Q[0], upper, 1e-12 * std::abs(upper));
  EXPECT_NEAR(Q[1], lower, 1e-12 * std::abs(lower));
}

TEST_P(ClosedForm, CartPole) {
  const auto loaded = LoadedMechanism::text(R"(alembert: 1
name: cart_pole
coordinates: [x, th]
bodies:
  - {name: cart, transform: [{translate: [x, 0, 0]}], mass: 1.5}
  - {name: pole, parent: cart, transform: [{rotate: {axis: y, angle: th}}], mass: 0.4, com: [0, 0, 0.6], inertia: {xx: 0.05, yy: 0.05, zz: 0.001}}
)");
  const double th = 0.7, dth = 1.3, ddx = -0.4, ddth = 2.1, m = 0.4, l = 0.6;
  const std::vector<double> Q =
      forces(loaded, {{"th", th}, {"d(th)", dth}, {"dd(x)", ddx}, {"dd(th)", ddth}}, GetParam());
  EXPECT_NEAR(Q[0], (1.5 + m) * ddx + m * l * (std::cos(th) * ddth - std::sin(th) * dth * dth), 1e-13);
  EXPECT_NEAR(Q[1], m * l * std::cos(th) * ddx + (0.05 + m * l * l) * ddth - m * 9.81 * l * std::sin(th),
              1e-13);
}

TEST_P(ClosedForm, BeadOnHelix) {
  const auto loaded = LoadedMechanism::text(R"(alembert: 1
name: helix
coordinates: [s]
bodies:
  - {name: bead, transform: [{translate: [2*cos(s), 2*sin(s), s/2]}], mass: 3}
)");
  const std::vector<double> Q = forces(loaded, {{"s", 0.9}, {"d(s)", 1.4}, {"dd(s)", -0.8}}, GetParam());
  EXPECT_NEAR(Q[0], 3 * (4 + 0.25) * -0.8 + 3 * 9.81 * 0.5, 1e-13);
}

/// Euler's equations of a free rigid body in body axes: I al + om x I om.
TEST_P(ClosedForm, SphericalJointGivesEulersEquations) {
  const auto loaded = LoadedMechanism::text(R"(alembert: 1
name: top
coordinates: [{name: r, type: quaternion}]
bodies:
  - {name: top, transform: [{rotate: {quaternion: r}}], mass: 2, inertia: {xx: 1, yy: 2, zz: 2.5}}
)");
  const double h = 0.5;  // quaternion of four equal parts
  const std::vector<double> Q = forces(loaded,
                                       {{"r.x", h},
                                        {"r.y", h},
                                        {"r.z", h},
                                        {"r.w", h},
                                        {"d(r).x", 0.3},
                                        {"d(r).y", -0.7},
                                        {"d(r).z", 1.1},
                                        {"dd(r).x", 0.2},
                                        {"dd(r).y", 0.5},
                                        {"dd(r).z", -0.4}},
                                       GetParam());
  EXPECT_NEAR(Q[0], 1 * 0.2 + (2.5 - 2) * -0.7 * 1.1, 1e-13);
  EXPECT_NEAR(Q[1], 2 * 0.5 + (1 - 2.5) * 1.1 * 0.3, 1e-13);
  EXPECT_NEAR(Q[2], 2.5 * -0.4 + (2 - 1) * 0.3 * -0.7, 1e-13);
}

/// A shared coordinate: two bodies turn with one angle; the forces of both act on it.
TEST_P(ClosedForm, SharedCoordinate) {
  const auto loaded = LoadedMechanism::text(R"(alembert: 1
name: geared
gravity: [0, 0, 0]
coordinates: [q]
bodies:
  - {name: a, transform: [{rotate: {axis: z, angle: q}}], mass: 1, inertia: {xx: 1, yy: 1, zz: 1}}
  - {name: b, parent: a, transform: [{rotate: {axis: z, angle: 2*q}}], mass: 1, inertia: {xx: 1, yy: 1, zz: 1}}
  - {name: c, transform: [{rotate: {axis: x, angle: -3*q}}], mass: 1, inertia: {xx: 2, yy: 2, zz: 2}}
)");
  const std::vector<double> Q = forces(loaded, {{"q", 0.3}, {"d(q)", 2}, {"dd(q)", 1.5}}, GetParam());
  EXPECT_NEAR(Q[0], (1 + 9 + 2 * 9) * 1.5, 1e-13);
}

/// Bodies without mass, fixed to the world.
TEST_P(ClosedForm, SceneryChangesNothing) {
  const std::string head = "alembert: 1\nname: m\ncoordinates: [q]\nbodies:\n";
  const std::string bob = "mass: 2, transform: [{rotate: {axis: y, angle: q}}, {translate: [0, 0, -1]}]}\n";
  const auto plain = test::LoadedMechanism::text(head + "  - {name: bob, " + bob);
  const auto scene = test::LoadedMechanism::text(
      head +
      "  - {name: ground, geometry: [{box: [1, 1, 1]}]}\n"
      "  - {name: post, parent: ground, geometry: [{sphere: 1}], transform: [{translate: [0, 0, 1]}]}\n"
      "  - {name: sky}\n  - {name: bob, parent: post, " +
      bob);
  const auto equations = [&](const test::LoadedMechanism& loaded) {
    return loaded.values(equations_of_motion(loaded.kinematics(), GetParam()).Q, 7);
  };
  const std::vector<double> with = equations(scene), without = equations(plain);
  ASSERT_EQ(with.size(), 1u);
  EXPECT_NE(without[0], 0.0);
  EXPECT_NEAR(with[0], without[0], 1e-14);
}

/// A pendulum hung from a prescribed motion x = t^2: an inertia force -m 2 l cos(q).
TEST_P(ClosedForm, PrescribedMotion) {
  const auto loaded = LoadedMechanism::text(R"(alembert: 1
name: shaken
gravity: [0, -9.81, 0]
coordinates: [q]
bodies:
  - {name: bob, transform: [{translate: [t^2, 0, 0]}, {rotate: {axis: z, angle: q}}], mass: 2, com: [0, -0.5, 0]}
)");
  const std::vector<double> Q =
      forces(loaded, {{"q", 0.6}, {"d(q)", 1.1}, {"dd(q)", 0.7}, {"t", 0.9}}, GetParam());
  EXPECT_NEAR(Q[0], 2 * 0.25 * 0.7 + 2 * 9.81 * 0.5 * std::sin(0.6) + 2 * 2 * 0.5 * std::cos(0.6), 1e-13);
}

TEST_P(ClosedForm, ExternalWrenchActsAtTheCenterOfMass) {
  const auto loaded = LoadedMechanism::text(R"(alembert: 1
name: pushed
gravity: [0, 0, 0]
coordinates: [q]
bodies:
  - {name: arm, transform: [{rotate: {axis: z, angle: q}}], mass: 1, com: [2, 0, 0], inertia: {xx: 1, yy: 1, zz: 1}, external_wrench: true}
)");
  const std::vector<double> Q =
      forces(loaded, {{"q", 0.4}, {"wrench(arm).fx", 3}, {"wrench(arm).fy", -5}, {"wrench(arm).tz", 0.7}},
             GetParam());
  EXPECT_NEAR(Q[0], -(2 * std::cos(0.4) * -5 - 2 * std::sin(0.4) * 3) - 0.7, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(BothForms, ClosedForm, testing::Values(Formulation::reduced, Formulation::factored),
                         [](const auto& test) { return std::string(to_string(test.param)); });

}  // namespace
}  // namespace alembert::test
