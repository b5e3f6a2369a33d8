// Whole descriptions: what the model holds.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "catalogue.hpp"
#include "mechanism/loaded.hpp"
#include "mechanism/source.hpp"
#include "processor_time.hpp"

namespace alembert {
namespace {

using test::error_of;
using test::Loaded;

constexpr const char* kRollingCam = R"(alembert: 1
name: rolling_cam
description: free text
gravity: [0, 0, -9.81]
parameters:
  R: 1.0
  r: 0.25
  m: {value: 2.0, runtime: true}
coordinates:
  - q1
  - {name: q2, initial: 0.1, limits: [-pi, pi]}
  - {name: base, type: quaternion}
definitions:
  phi: R/r*q1
bodies:
  - name: wheel
    parent: world
    transform:
      - translate: [R*cos(q1), R*sin(q1), 0]
      - rotate: {axis: z, angle: phi}
    mass: m
    com: [0, 0, 0]
    inertia: {xx: 1, yy: 1, zz: 2, xy: 0, xz: 0, yz: 0}
    external_wrench: true
  - name: ball
    parent: wheel
    transform:
      - translate: [q2, 0, 0]
      - rotate: {quaternion: base}
    mass: 1
    inertia: {xx: 1, yy: 1, zz: 1}
frames:
  - {name: rim, body: wheel, transform: [{translate: [r, 0, 0]}]}
)";

TEST(Load, ReadsTheExampleOfTheLanguage) {
  Loaded loaded(kRollingCam);
  const Mechanism& m = loaded.mechanism;
  EXPECT_EQ(m.name, "rolling_cam");
  EXPECT_EQ(m.description, "free text");
  EXPECT_EQ(m.where.line, 2);
  EXPECT_EQ(m.time, loaded.symbol("t"));
  EXPECT_EQ(m.nq, 6);
  EXPECT_EQ(m.nv, 5);
  EXPECT_EQ(m.gravity[0], loaded.graph.zero());
  EXPECT_EQ(m.gravity[2], loaded.number(-981, 100));
  ASSERT_EQ(m.bodies.size(), 2u);
  const Body& wheel = m.bodies[0];
  EXPECT_EQ(wheel.name, "wheel");
  EXPECT_EQ(wheel.parent, -1);
  EXPECT_TRUE(wheel.external_wrench);
  EXPECT_EQ(wheel.mass_properties.mass, loaded.symbol("m"));
  EXPECT_EQ(wheel.mass_properties.inertia(2, 2), loaded.number(2));
  EXPECT_EQ(wheel.mass_properties.inertia(0, 1), loaded.graph.zero());
  EXPECT_EQ(wheel.where.line, 16);
  ASSERT_EQ(wheel.transform.factors.size(), 2u);
  EXPECT_EQ(std::get<Translation>(wheel.transform.factors[0].value).offset[0], cos(loaded.symbol("q1")));
  const auto& rotation = std::get<AxisRotation>(wheel.transform.factors[1].value);
  EXPECT_EQ(rotation.axis, 2);
  EXPECT_EQ(rotation.angle, loaded.number(4) * loaded.symbol("q1"));
  EXPECT_EQ(wheel.transform.factors[1].where.line, 20);
  EXPECT_EQ(m.bodies[1].parent, 0);
  EXPECT_FALSE(m.bodies[1].external_wrench);
  ASSERT_EQ(m.frames.size(), 1u);
  EXPECT_EQ(m.frames[0].name, "rim");
  EXPECT_EQ(m.frames[0].body, 0);
  EXPECT_EQ(std::get<Translation>(m.frames[0].transform.factors.at(0).value).offset[0], loaded.number(1, 4));
}

TEST(Load, ReadsParameters) {
  Loaded loaded(kRollingCam);
  const auto& parameters = loaded.mechanism.parameters;
  ASSERT_EQ(parameters.size(), 3u);
  EXPECT_EQ(parameters[1].name, "r");
  EXPECT_EQ(parameters[1].value, 0.25);
  EXPECT_FALSE(parameters[1].runtime);
  EXPECT_EQ(parameters[2].name, "m");
  EXPECT_EQ(parameters[2].value, 2.0);
  EXPECT_TRUE(parameters[2].runtime);
  EXPECT_EQ(parameters[2].where.line, 8);
  EXPECT_EQ(parameters[2].where.column, 3);
}

TEST(Load, ReadsCoordinates) {
  Loaded loaded(kRollingCam);
  const auto& c = loaded.mechanism.coordinates;
  ASSERT_EQ(c.size(), 3u);
  EXPECT_EQ(c[0].initial, std::vector<double>{0});
  EXPECT_FALSE(c[0].limits.has_value());
  EXPECT_EQ(c[0].symbols, std::vector<Expr>{loaded.symbol("q1")});
  EXPECT_EQ(c[0].speed_symbols, std::vector<Expr>{loaded.symbol("d(q1)")});
  EXPECT_EQ(c[0].rate_symbols, std::vector<Expr>{loaded.symbol("dd(q1)")});
  EXPECT_EQ(c[1].initial, std::vector<double>{0.1});
  ASSERT_TRUE(c[1].limits.has_value());
  EXPECT_DOUBLE_EQ(c[1].limits->second, 3.14159265358979323846);
  EXPECT_EQ(c[1].first_q, 1);
  EXPECT_EQ(c[1].first_speed, 1);
  EXPECT_EQ(c[2].type, CoordinateType::quaternion);
  EXPECT_EQ(c[2].first_q, 2);
  EXPECT_EQ(c[2].first_speed, 2);
  EXPECT_EQ(c[2].initial, (std::vector<double>{0, 0, 0, 1}));
  EXPECT_EQ(c[2].symbols, (std::vector<Expr>{loaded.symbol("base.x"), loaded.symbol("base.y"),
                                             loaded.symbol("base.z"), loaded.symbol("base.w")}));
  EXPECT_EQ(c[2].speed_symbols, (std::vector<Expr>{loaded.symbol("d(base).x"), loaded.symbol("d(base).y"),
                                                   loaded.symbol("d(base).z")}));
  EXPECT_EQ(c[2].rate_symbols, (std::vector<Expr>{loaded.symbol("dd(base).x"), loaded.symbol("dd(base).y"),
                                                  loaded.symbol("dd(base).z")}));
  EXPECT_EQ(c[2].where.line, 12);
}

TEST(Load, ReadsInitialSpeeds) {
  Loaded loaded(R"(alembert: 1
name: speeds
parameters: {v: 2}
coordinates:
  - q
  - {name: s, initial_speed: 3*v}
  - {name: base, type: quaternion, initial_speed: [1, -v, 0.5]}
bodies:
  - {name: a, transform: [{translate: [q, s, 0]}, {rotate: {quaternion: base}}], mass: 1, inertia: {xx: 1, yy: 1, zz: 1}}
)");
  const auto& c = loaded.mechanism.coordinates;
  EXPECT_EQ(c[0].initial_speed, std::vector<double>{0});
  EXPECT_EQ(c[1].initial_speed, std::vector<double>{6});
  EXPECT_EQ(c[2].initial_speed, (std::vector<double>{1, -2, 0.5}));
}

TEST(Load, NormalisesInitialQuaternions) {
  Loaded loaded(
      test::with_transform("[{rotate: {quaternion: b}}]",
                           "[{name: b, type: quaternion, initial: [0, 0, sqrt(1/2), 0.70710678]}]"));
  const std::vector<double>& q = loaded.mechanism.coordinates[0].initial;
  EXPECT_NEAR(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1, 1e-15);
  EXPECT_NEAR(q[3], 0.70710678, 1e-8);
}

TEST(Load, AppliesDefaults) {
  Loaded loaded(
      "alembert: 1\nname: one\ncoordinates: [q]\nbodies:\n  - {name: a, transform: [{translate: [q, 0, "
      "0]}]}\n");
  const Mechanism& m = loaded.mechanism;
  EXPECT_EQ(m.gravity[0], loaded.graph.zero());
  EXPECT_EQ(m.gravity[1], loaded.graph.zero());
  EXPECT_EQ(m.gravity[2], loaded.number(-981, 100));
  EXPECT_EQ(m.bodies[0].parent, -1);
  EXPECT_TRUE(m.bodies[0].mass_properties.mass.is_zero());
  for (const Expr& e : m.bodies[0].mass_properties.com.entries) EXPECT_TRUE(e.is_zero());
  for (const Expr& e : m.bodies[0].mass_properties.inertia.entries) EXPECT_TRUE(e.is_zero());
  EXPECT_TRUE(m.description.empty());
  EXPECT_TRUE(m.frames.empty());
}

TEST(Load, LetsParametersUseEarlierOnes) {
  Loaded loaded(
      "alembert: 1\nname: one\nparameters: {a: 2, k: {value: 3*a, runtime: true}, b: a*k}\ncoordinates: [q]\n"
      "bodies:\n  - {name: arm, mass: b, transform: [{translate: [q, 0, 0]}]}\n");
  EXPECT_EQ(loaded.mechanism.parameters[1].value, 6.0);
  EXPECT_EQ(loaded.mechanism.parameters[2].value, 12.0);
  EXPECT_EQ(loaded.mechanism.bodies[0].mass_properties.mass, loaded.number(2) * loaded.symbol("k"));
}

TEST(Load, LetsDefinitionsOfParametersBeMasses) {
  Loaded loaded(
      "alembert: 1\nname: one\ncoordinates: [q]\ndefinitions: {m: 2*3}\n"
      "bodies:\n  - {name: arm, mass: m, transform: [{translate: [q, 0, 0]}]}\n");
  EXPECT_EQ(loaded.mechanism.bodies[0].mass_properties.mass, loaded.number(6));
}

TEST(Load, MakesInertiaSymmetric) {
  Loaded loaded(
      "alembert: 1\nname: one\ncoordinates: [q]\nbodies:\n  - {name: arm, mass: 1, inertia: {xx: 3, yy: 4, "
      "zz: 5, xy: 0.1, "
      "xz: 0.2, yz: 0.3}, transform: [{translate: [q, 0, 0]}]}\n");
  const Mat3& inertia = loaded.mechanism.bodies[0].mass_properties.inertia;
  EXPECT_EQ(inertia, transpose(inertia));
  EXPECT_EQ(inertia(1, 2), loaded.number(3, 10));
  EXPECT_EQ(inertia(0, 1), loaded.number(1, 10));
}

TEST(Load, WarnsOfInertiasBeyondTheEdgeOfTheTriangleInequality) {
  const auto warnings = [](const std::string& zz) {
    return Loaded(
               "alembert: 1\nname: one\ncoordinates: [q]\nbodies:\n  - {name: arm, mass: 1, inertia: "
               "{xx: 0.1, yy: 0.2, zz: " +
               zz + "}, transform: [{translate: [q, 0, 0]}]}\n")
        .mechanism.warnings.size();
  };
  // A flat plate, turned: rounding puts its largest moment 1e-16 above the sum of the others.
  EXPECT_EQ(warnings("0.30000000000000004"), 0u);
  EXPECT_EQ(warnings("0.3001"), 1u);
}

TEST(Load, ReadsArmatures) {
  Loaded loaded(
      "alembert: 1\nname: one\nparameters: {a: {value: 2, runtime: true}, b: 3}\n"
      "coordinates: [p, {name: q, armature: a/2}, {name: r, type: quaternion, armature: b}]\nbodies:\n"
      "  - {name: arm, mass: 1, transform: [{translate: [p, q, 0]}, {rotate: {quaternion: r}}]}\n");
  const auto& c = loaded.mechanism.coordinates;
  EXPECT_TRUE(c[0].armature.is_zero());
  EXPECT_EQ(c[1].armature, loaded.number(1, 2) * loaded.symbol("a"));
  EXPECT_EQ(c[2].armature, loaded.number(3));
}

TEST(Load, TakesBooleansInAnyCase) {
  Loaded loaded(
      "alembert: 1\nname: one\nparameters: {a: {value: 2, runtime: True}}\ncoordinates: [q]\nbodies:\n"
      "  - {name: arm, mass: a, external_wrench: FALSE, transform: [{translate: [q, 0, 0]}]}\n");
  EXPECT_TRUE(loaded.mechanism.parameters[0].runtime);
  EXPECT_FALSE(loaded.mechanism.bodies[0].external_wrench);
}

TEST(Load, OrdersBodiesParentsFirst) {
  Loaded loaded(
      "alembert: 1\nname: one\ncoordinates: [q]\nbodies:\n"
      "  - {name: c, parent: b}\n  - {name: d, parent: a}\n  - {name: a}\n"
      "  - {name: b, parent: a, mass: 1, transform: [{translate: [q, 0, 0]}]}\n  - {name: e, parent: c}\n"
      "frames: [{name: f, body: d}, {name: g, body: world}]\n");
  std::string order;
  const auto& bodies = loaded.mechanism.bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    order += bodies[i].name +
             (bodies[i].parent < 0 ? "- " : bodies[static_cast<std::size_t>(bodies[i].parent)].name + " ");
    EXPECT_LT(bodies[i].parent, static_cast<int>(i));
  }
  EXPECT_EQ(order, "a- ba cb da ec ");
  EXPECT_EQ(bodies[static_cast<std::size_t>(loaded.mechanism.frames[0].body)].name, "d");
  EXPECT_EQ(loaded.mechanism.frames[1].body, -1);
}

TEST(Load, OrdersDeepChainsWithoutRecursion) {
  std::string text = "alembert: 1\nname: one\ncoordinates: [q]\nbodies:\n";
  for (int i = 20000; i > 0; --i)
    text += "  - {name: b" + std::to_string(i) + ", parent: b" + std::to_string(i - 1) + "}\n";
  text += "  - {name: b0, mass: 1, transform: [{translate: [q, 0, 0]}]}\n";
  Loaded loaded(text);
  EXPECT_EQ(loaded.mechanism.bodies.front().name, "b0");
  EXPECT_EQ(loaded.mechanism.bodies.back().name, "b20000");
}

TEST(Load, AcceptsSixSpeedsInATransform) {
  EXPECT_EQ(error_of(test::with_transform(
                "[{translate: [a, b, c]}, {rotate: {axis: z, angle: d}}, {rotate: {axis: y, angle: "
                "e}}, {rotate: {axis: x, angle: f}}]",
                "[a, b, c, d, e, f]")),
            "");
}

TEST(Load, LetsBodiesShareCoordinates) {
  EXPECT_EQ(error_of("alembert: 1\nname: one\ncoordinates: [q]\nbodies:\n"
                     "  - {name: a, mass: 1, transform: [{rotate: {axis: z, angle: q}}]}\n"
                     "  - {name: b, parent: a, mass: 1, transform: [{rotate: {axis: z, angle: -2*q}}]}\n"),
            "");
}

TEST(Load, AcceptsAliases) {
  Loaded loaded(
      "alembert: 1\nname: one\ncoordinates: [q]\nbodies:\n"
      "  - {name: a, mass: 1, transform: &turn [{rotate: {axis: z, angle: q}}]}\n"
      "  - {name: b, parent: a, mass: 1, transform: *turn}\n");
  EXPECT_EQ(loaded.mechanism.bodies[1].transform.factors.size(), 1u);
}

TEST(Load, KeepsDescriptionsAsTheyAre) {
  Loaded loaded(
      "alembert: 1\nname: one\ndescription: \"a */ 'b'\\n\\\\c\"\ncoordinates: [q]\nbodies:\n"
      "  - {name: a, mass: 1, transform: [{translate: [q, 0, 0]}]}\n");
  EXPECT_EQ(loaded.mechanism.description, "a */ 'b'\n\\c");
}

TEST(Load, GivesTheSameModelForTheSameText) {
  Loaded one(kRollingCam), two(kRollingCam);
  ASSERT_EQ(one.graph.size(), two.graph.size());
  for (std::uint32_t id = 0; id < one.graph.size(); ++id) EXPECT_EQ(one.graph.key(id), two.graph.key(id));
}

TEST(Load, AcceptsTheExampleOfTheReference) {
  std::ifstream file(std::filesystem::path(ALEMBERT_SOURCE_DIR) / "mechanisms/README.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::string fence = "```yaml\n";
  const std::size_t begin = text.find(fence);
  ASSERT_NE(begin, std::string::npos);
  Loaded loaded(
      text.substr(begin + fence.size(), text.find("```", begin + fence.size()) - begin - fence.size()));
  EXPECT_EQ(loaded.mechanism.bodies.size(), 2u);
  EXPECT_EQ(loaded.mechanism.nv, 5);
}

TEST(Load, AcceptsTheSeedsOfTheFuzzer) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(ALEMBERT_SOURCE_DIR) /
                                                               "tests/fuzz/corpus")) {
    ExprGraph graph;
    EXPECT_NO_THROW(load_mechanism(read_source(entry.path()), graph)) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 3);
}

TEST(Load, DoubtsNothingInTheCatalogue) {
  for (const std::string& path : test::catalogue()) {
    ExprGraph graph;
    EXPECT_TRUE(load_mechanism(read_source(path), graph).warnings.empty()) << path;
  }
}

TEST(Load, ChecksManyMatricesTogether) {
  std::string text = "alembert: 1\nname: one\ncoordinates: [q]\ndefinitions:\n  d0: q\n";
  for (int i = 1; i < 2000; ++i)
    text += "  d" + std::to_string(i) + ": sin(d" + std::to_string(i - 1) + ") + q\n";
  text += "bodies:\n";
  for (int i = 0; i < 2000; ++i)
    text += "  - {name: b" + std::to_string(i) +
            ", transform: [{matrix: [[cos(d1999), -sin(d1999), 0, 0], [sin(d1999), cos(d1999), 0, 0], [0, 0, "
            "1, 0]]}]}\n";
  const test::ProcessorTime time;
  EXPECT_EQ(error_of(text), "");
  EXPECT_LT(time.seconds(), 10);
}

TEST(Load, IsFast) {
  std::string text = "alembert: 1\nname: chain\ncoordinates:\n";
  for (int i = 0; i < 100; ++i) text += "  - q" + std::to_string(i) + "\n";
  text += "bodies:\n";
  for (int i = 0; i < 100; ++i) {
    const std::string n = std::to_string(i);
    text += "  - name: b" + n + "\n" + (i > 0 ? "    parent: b" + std::to_string(i - 1) + "\n" : "") +
            "    transform: [{rotate: {axis: x, angle: 0.3}}, {translate: [0.1, 0.2, 0.3]}, {joint: {type: "
            "revolute, "
            "coordinates: [q" +
            n +
            "]}}]\n    mass: 1.5\n    com: [0.1, 0.2, 0.3]\n"
            "    inertia: {xx: 1, yy: 1.1, zz: 1.2, xy: 0.01, xz: 0.02, yz: 0.03}\n";
  }
  const test::ProcessorTime time;
  EXPECT_EQ(error_of(text), "");
  EXPECT_LT(time.seconds(), 2);
}

}  // namespace
}  // namespace alembert
