// Constraints: what the model holds, and that its rows are linear in the speeds.
#include <gtest/gtest.h>

#include "mechanism/loaded.hpp"
#include "mechanism/mate.hpp"
#include "symbolic/coefficient.hpp"
#include "symbolic/evaluate.hpp"
#include "symbolic/substitute.hpp"

namespace alembert {
namespace {

using test::error_of;
using test::Loaded;

/// Two real coordinates, a quaternion, a frame `tip`, and the constraints given (a block list).
std::string constrained(const std::string& constraints) {
  return "alembert: 1\nname: one\nparameters: {r: 0.25, k: {value: 3, runtime: true}}\n"
         "coordinates: [q1, arm, {name: base, type: quaternion}]\ngravity: [r, k, 0]\n"
         "bodies:\n"
         "  - {name: one, mass: 1, transform: [{translate: [q1, arm, 0]}]}\n"
         "  - {name: two, parent: one, mass: 1, transform: [{rotate: {quaternion: base}}]}\n"
         "frames:\n"
         "  - {name: heel, body: one}\n"
         "  - {name: tip, body: two, transform: [{translate: [1, 0, 0]}]}\n"
         "constraints:\n" +
         constraints;
}
std::string with_row(const std::string& row) {
  return constrained("  - {name: c, type: pfaffian, rows: [\"" + row + "\"]}\n");
}
std::string with_equation(const std::string& equation) {
  return constrained("  - {name: c, type: holonomic, equations: [\"" + equation + "\"]}\n");
}
Expr equation(const Loaded& loaded) {
  return loaded.mechanism.constraints.at(0).equations.at(0);
}

TEST(Constraints, AreAbsentUnlessGiven) {
  Loaded loaded(test::with_transform("[{translate: [q, 0, 0]}]"));
  EXPECT_TRUE(loaded.mechanism.constraints.empty());
  EXPECT_TRUE(loaded.mechanism.frame_symbols.empty());
  EXPECT_EQ(error_of(constrained("  []\n")), "");
}

TEST(Constraints, KeepTheOrderOfTheFile) {
  Loaded loaded(
      constrained("  - {name: z, type: pfaffian, rows: [d(q1), d(arm)]}\n"
                  "  - {name: a, type: holonomic, equations: [q1 - arm]}\n"));
  const auto& constraints = loaded.mechanism.constraints;
  ASSERT_EQ(constraints.size(), 2u);
  EXPECT_EQ(constraints[0].name, "z");
  EXPECT_EQ(constraints[0].type, ConstraintType::pfaffian);
  EXPECT_EQ(constraints[0].rows(), 2u);
  EXPECT_EQ(constraints[0].equations.at(1), loaded.symbol("d(arm)"));
  EXPECT_EQ(constraints[0].where.line, 13);
  EXPECT_EQ(constraints[1].name, "a");
  EXPECT_EQ(constraints[1].type, ConstraintType::holonomic);
  EXPECT_EQ(constraints[1].rows(), 1u);
  EXPECT_EQ(constraints[1].equations.at(0), loaded.symbol("q1") - loaded.symbol("arm"));
}

TEST(Constraints, NameSpeedsInThreeWays) {
  for (const char* name : {"d(q1)", "d ( q1 )", "qd_q1", "qd1"}) {
    Loaded loaded(with_row(name));
    EXPECT_EQ(equation(loaded), loaded.symbol("d(q1)")) << name;
  }
  for (const char* name : {"d(arm)", "qd_arm"}) {
    Loaded loaded(with_row(name));
    EXPECT_EQ(equation(loaded), loaded.symbol("d(arm)")) << name;
  }
  for (const char* part : {".x", ".y", ".z"}) {
    Loaded loaded(with_row(std::string("d(base)") + part));
    EXPECT_EQ(equation(loaded), loaded.symbol(std::string("d(base)") + part));
  }
}

TEST(Constraints, TakeTheRowsOfTheFormatsExample) {
  Loaded loaded(
      "alembert: 1\nname: one\nparameters: {R: 1, r: 0.25}\ncoordinates: [q1, q2]\n"
      "bodies: [{name: arm, mass: 1, transform: [{translate: [q1, q2, 0]}]}]\n"
      "constraints:\n  - {name: no_slip, type: pfaffian, rows: [\"qd1*r - qd2*R\"]}\n");
  EXPECT_EQ(equation(loaded), loaded.number(1, 4) * loaded.symbol("d(q1)") - loaded.symbol("d(q2)"));
}

TEST(Constraints, PreferDeclaredNamesToSpeeds) {
  // A parameter called like the speed of q1, and one called like the function of speeds.
  Loaded loaded(
      "alembert: 1\nname: one\nparameters: {qd1: 5, d: 7}\ncoordinates: [q1]\n"
      "bodies: [{name: arm, mass: 1, transform: [{translate: [q1, 0, 0]}]}]\n"
      "constraints:\n  - {name: c, type: pfaffian, rows: [\"d(q1)*d - qd1\"]}\n");
  EXPECT_EQ(equation(loaded), loaded.number(7) * loaded.symbol("d(q1)") - loaded.number(5));
}

TEST(Constraints, HaveRowsThatAreLinearInTheSpeeds) {
  Loaded loaded(with_row("(d(q1)*sin(q1) - k*(d(arm) - d(base).z*q1^2))/(2 + cos(arm)) + 0.1*cos(t)"));
  std::vector<Expr> coefficients;
  const Expr row[] = {equation(loaded)};
  Expr rest = row[0];
  for (const Coordinate& coordinate : loaded.mechanism.coordinates)
    for (const Expr& speed : coordinate.speed_symbols) {
      const Expr c = coefficient(row, speed)[0];
      const Expr old_rest[] = {rest};
      const std::pair<Expr, Expr> to_zero[] = {{speed, loaded.graph.zero()}};
      rest = substitute(old_rest, to_zero)[0];
      coefficients.push_back(c);
    }
  const Expr divisor = loaded.number(2) + cos(loaded.symbol("arm"));
  const Expr expected[] = {sin(loaded.symbol("q1")) / divisor, -loaded.symbol("k") / divisor,
                           loaded.graph.zero(), loaded.graph.zero(),
                           loaded.symbol("k") * loaded.symbol("q1") * loaded.symbol("q1") / divisor};
  ASSERT_EQ(coefficients.size(), 5u);
  std::vector<double> point(loaded.graph.symbol_count());
  for (std::size_t i = 0; i < point.size(); ++i) point[i] = 0.3 + 0.1 * static_cast<double>(i);
  const std::vector<double> found = evaluate(coefficients, point), wanted = evaluate(expected, point);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(found[i], wanted[i], 1e-14) << i;
  EXPECT_EQ(rest, loaded.number(1, 10) * cos(loaded.symbol("t")));
}

TEST(Constraints, RefuseEveryFormThatIsNotLinear) {
  for (const char* row :
       {"d(q1)*d(q1)", "d(q1)*d(arm)", "1/d(q1)", "d(q1)/d(q1)", "d(q1)^2", "2^d(q1)", "d(q1)^1",
        "abs(d(q1))", "atan2(d(q1), 1)", "atan2(1, d(q1))", "-(-d(q1))*(q1 + d(arm))"}) {
    const std::string error = error_of(with_row(row));
    EXPECT_NE(error.find("is not linear in the speeds"), std::string::npos) << row << "\n" << error;
  }
}

TEST(Constraints, CollectPositionsOfFramesInOrderOfUse) {
  Loaded loaded(
      constrained("  - {name: a, type: holonomic, equations: [\"position(tip).x - q1\", "
                  "\"position( heel ) . z - position(tip).y\"]}\n"));
  const Mechanism& m = loaded.mechanism;
  ASSERT_EQ(m.frame_symbols.size(), 2u);
  EXPECT_EQ(m.frame_symbols[0].frame, 1);
  EXPECT_EQ(m.frame_symbols[1].frame, 0);
  EXPECT_EQ(m.frame_symbols[1].symbols[2], loaded.symbol("position(heel).z"));
  EXPECT_EQ(m.constraints[0].equations[0], m.frame_symbols[0].symbols[0] - loaded.symbol("q1"));
  EXPECT_EQ(m.constraints[0].equations[1], m.frame_symbols[1].symbols[2] - m.frame_symbols[0].symbols[1]);
}

TEST(Constraints, DoNotJudgeValuesThatOnlyTheKinematicsKnow) {
  EXPECT_EQ(error_of(with_equation("sqrt(position(tip).x^2 + position(tip).y^2)/position(tip).z - k")), "");
  EXPECT_EQ(error_of(with_equation("atan2(position(tip).y, position(tip).x) - q1")), "");
  EXPECT_NE(error_of(with_equation("position(tip).x + 1/q1")), "");
  EXPECT_NE(error_of(with_equation("position(tip).x + sqrt(q1 - 1)")), "");
}

TEST(Constraints, CountAsUses) {
  const std::string head =
      "alembert: 1\nname: one\nparameters: {r: 1}\ncoordinates: [q]\ndefinitions: {phi: 2*q}\n"
      "bodies: [{name: arm, mass: 1, transform: [{translate: [q, 0, 0]}]}]\n";
  const auto unused = [&](const std::string& constraints) {
    return Loaded(head + constraints).mechanism.warnings.size();
  };
  EXPECT_EQ(unused(""), 2u);
  EXPECT_EQ(unused("constraints: [{name: c, type: holonomic, equations: [phi - r]}]\n"), 0u);
  EXPECT_EQ(unused("constraints: [{name: c, type: pfaffian, rows: [\"phi*d(q) - r\"]}]\n"), 0u);
}

/// Ball and ground mated; the mate's transform is `before`, mate, `after`, in the ball's body or, if
/// `inverted`, in the ground's.
std::string rolling(const std::string& constraint, bool inverted = false, const std::string& before = "") {
  const std::string ground = "{surface: {point: [u2, v2, 0], along: [u2, v2]}}";
  const std::string ball =
      "{surface: {point: [cos(u1)*cos(v1), sin(u1)*cos(v1), k*sin(v1)], along: [u1, v1], flip: true}}";
  return "alembert: 1\nname: one\nparameters: {k: {value: 2, runtime: true}}\n"
         "coordinates: [u1, v1, u2, v2, s, x]\nbodies:\n"
         "  - {name: " +
         std::string(inverted ? "ground" : "ball") + ", parent: " + (inverted ? "ball" : "ground") +
         ", mass: 1, inertia: {xx: 1, yy: 1, zz: 1}, transform: [" + before + "{mate: [" +
         (inverted ? ball + ", " + ground : ground + ", " + ball) + "], spin: s + x^2}]}\n" +
         "  - {name: " + (inverted ? "ball" : "ground") +
         ", mass: 1, transform: [{translate: [x, 0, 0]}]}\n" +
         "constraints:\n  - {name: roll, type: rolling, " + constraint + "}\n";
}

TEST(Constraints, FindTheMateThatRolls) {
  for (const bool inverted : {false, true})
    for (const bool exchanged : {false, true}) {
      const std::string ball = "[ball, u1, v1]", ground = "[ground, u2, v2]";
      Loaded loaded(rolling(exchanged ? "of: " + ground + ", on: " + ball : "of: " + ball + ", on: " + ground,
                            inverted, "{translate: [k, 0, 1]}, {rotate: {axis: x, angle: pi/2}}, "));
      const Constraint& constraint = loaded.mechanism.constraints.at(0);
      EXPECT_EQ(constraint.type, ConstraintType::rolling);
      EXPECT_EQ(constraint.rows(), 2u);
      const Body& body = loaded.mechanism.bodies.at(static_cast<std::size_t>(constraint.body));
      EXPECT_EQ(body.name, inverted ? "ground" : "ball");
      EXPECT_EQ(constraint.factor, 2u);
      EXPECT_TRUE(mate_at(body.transform, constraint.factor).has_value());
    }
}

TEST(Constraints, RollOnTheWorld) {
  Loaded loaded(
      "alembert: 1\nname: one\ncoordinates: [u1, v1, u2, v2]\nbodies:\n"
      "  - {name: ball, mass: 1, transform: [{mate: [{surface: {point: [u2, v2, 0], along: [u2, v2]}}, "
      "{surface: {point: [u1, v1, u1*v1], along: [u1, v1]}}]}]}\n"
      "constraints:\n  - {name: roll, type: rolling, of: [ball, u1, v1], on: [world, u2, v2]}\n");
  EXPECT_EQ(loaded.mechanism.constraints.at(0).body, 0);
  EXPECT_EQ(loaded.mechanism.constraints.at(0).factor, 0u);
}

TEST(Constraints, FindAMateThatIsWrittenOut) {
  Loaded loaded(
      "alembert: 1\nname: one\ncoordinates: [u1, v1, u2, v2, s]\nbodies:\n"
      "  - {name: ball, mass: 1, transform: [{surface: {point: [u2, v2, 0], along: [u2, v2]}}, "
      "{rotate: {axis: z, angle: s}}, {inverse: [{surface: {point: [u1, v1, u1*v1], along: [u1, v1]}}]}]}\n"
      "constraints:\n  - {name: roll, type: rolling, of: [ball, u1, v1], on: [world, u2, v2]}\n");
  const Mate mate = mate_at(loaded.mechanism.bodies.at(0).transform, 0).value();
  EXPECT_EQ(mate.spin, loaded.symbol("s"));
  EXPECT_EQ(mate.second.u, loaded.symbol("u1"));
}

TEST(Constraints, RefuseMatesThatMoveOtherwise) {
  EXPECT_NE(error_of(rolling("of: [ball, u1, v1], on: [ground, u2, v2]", false, "{translate: [t, 0, 0]}, "))
                .find("moves apart from the mate"),
            std::string::npos);
  EXPECT_NE(error_of(rolling("of: [ball, u1, v1], on: [ground, u2, v2]", false,
                             "{inverse: [{rotate: {axis: z, angle: x}}]}, "))
                .find("moves apart from the mate"),
            std::string::npos);
}

}  // namespace
}  // namespace alembert
