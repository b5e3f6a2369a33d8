// The JSON contracts of `report` and `evaluate`, on which scripts rely.
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"

namespace alembert::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

const char* const kPendulum = R"(alembert: 1
name: pendulum
coordinates: [q]
parameters: {l: {value: 0.5, runtime: true}}
bodies:
  - {name: bob, transform: [{rotate: {axis: y, angle: q}}, {translate: [0, 0, -l]}], mass: 2, external_wrench: true}
)";

TEST(Report, HasTheFieldsOfTheContract) {
  const TemporaryFolder folder;
  const CommandResult result = alembert(folder, "report --json " + folder.write("pendulum.yaml", kPendulum));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json report = json::parse(result.out);
  EXPECT_EQ(report["mechanism"], "pendulum");
  EXPECT_EQ(report["coordinates"], 1);
  EXPECT_EQ(report["speeds"], 1);
  for (const char* function :
       {"inverse_dynamics", "mass_matrix", "bias", "mass_matrix_and_bias", "forward_dynamics"}) {
    for (const char* field : {"mul", "add", "div", "trig", "other"}) {
      EXPECT_TRUE(report["functions"][function][field].is_number_integer()) << function << ' ' << field;
    }
    EXPECT_THAT((std::vector<std::string>{"reduced", "factored"}),
                testing::Contains(report["functions"][function]["formulation"]));
  }
  EXPECT_EQ(report["functions"]["forward_dynamics"]["div"], 1);
}

TEST(Report, FormulationCanBeChosen) {
  const TemporaryFolder folder;
  const std::string file = folder.write("pendulum.yaml", kPendulum);
  for (const char* formulation : {"factored", "reduced"}) {
    const CommandResult result =
        alembert(folder, "report --json --formulation " + std::string(formulation) + " " + file);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(json::parse(result.out)["functions"]["inverse_dynamics"]["formulation"], formulation);
  }
}

// A point on a ball joint, with decimals that do not cancel to the last digit: forward dynamics has no digits.
TEST(Report, SaysThatTheMassMatrixIsNearlySingular) {
  const TemporaryFolder folder;
  const std::string file = folder.write("ball.yaml", R"(alembert: 1
name: ball
coordinates: [{name: spin, type: quaternion}]
bodies:
  - {name: bob, transform: [{joint: {type: spherical, coordinates: [spin]}}, {translate: [-0.3682814349173409, 8.985427233295437e-08, 8.806301437759541e-05]}], mass: 0.5974296991789654, com: [0, 0, -0.6860673730765727], inertia: {xx: 1e-32, yy: 1e-32, zz: 1e-32}}
)");
  const CommandResult refused = alembert(folder, "report " + file + " --functions forward_dynamics");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, HasSubstr("ball.yaml:3:22: error: the mass matrix is singular"));
  EXPECT_THAT(refused.err, HasSubstr("'spin' alone (what is left of its inertia"));
  const CommandResult others = alembert(folder, "report " + file + " --functions all");
  EXPECT_EQ(others.exit_code, 0) << others.err;
  EXPECT_THAT(others.err, HasSubstr("warning: the mass matrix is singular"));
  EXPECT_THAT(others.out, HasSubstr("mass_matrix_and_bias"));
}

TEST(Report, TellsWhereFewDigitsAreRight) {
  const TemporaryFolder folder;
  const auto report = [&](const std::string& inertia, const std::string& options) {
    const std::string file =
        folder.write("ball.yaml", R"(alembert: 1
name: ball
coordinates: [{name: spin, type: quaternion}]
bodies:
  - {name: bob, transform: [{joint: {type: spherical, coordinates: [spin]}}, {translate: [-0.3682814349173409, 8.985427233295437e-08, 8.806301437759541e-05]}], mass: 0.5974296991789654, com: [0, 0, -0.6860673730765727], inertia: {xx: )" +
                                      inertia + ", yy: " + inertia + ", zz: " + inertia + "}}\n");
    return alembert(folder, "report " + file + " --functions inverse_dynamics,forward_dynamics" + options);
  };
  const CommandResult told = report("1e-18", "");
  EXPECT_EQ(told.exit_code, 0) << told.err;
  EXPECT_THAT(
      told.err,
      HasSubstr("ball.yaml:2:7: warning: double precision leaves few right digits, in the plain equations "
                "too: errors are 1.6e-02 in forward_dynamics, relative to the largest entry"));
  EXPECT_THAT(told.err, HasSubstr("of the inertia along 'spin' 2e-17 is left while the others move"));
  EXPECT_THAT(told.out, HasSubstr("forward_dynamics"));
  EXPECT_EQ(report("1e-18", " --strict").exit_code, 1);
  EXPECT_EQ(report("1e-3", " --strict").err, "");
}

TEST(Evaluate, TellsOfStatesWithoutValues) {
  const TemporaryFolder folder;
  const std::string file = folder.write("growing.yaml", R"(alembert: 1
name: growing
coordinates: [x, y]
bodies:
  - {name: bob, transform: [{translate: [x, 'exp(y)', 0]}], mass: 1}
)");
  const std::string states = R"({"q": [1, 2]}
{"q": [1, 800]}
{"q": [1, 801]}
{"q": [1, 3]}
)";
  const CommandResult some =
      alembert(folder, "evaluate " + file + " --functions body_poses,mass_matrix,gravity --json", states);
  EXPECT_EQ(some.exit_code, 0);
  EXPECT_THAT(some.err, HasSubstr("<stdin>:2:1: warning: no finite value at this state: "));
  EXPECT_THAT(some.err, HasSubstr("W of body_poses"));
  EXPECT_THAT(some.err, HasSubstr("note: 2 states in all have results without a finite value"));
  EXPECT_THAT(alembert(folder, "evaluate " + file, states).err,
              HasSubstr("<stdin>:2:1: warning: no finite value at this state: tau, M, c, poses"));
  EXPECT_EQ(alembert(folder, "evaluate " + file, "{}").err, "");
}

TEST(Report, TellsWhichFunctionsHaveLoops) {
  const TemporaryFolder folder;
  const auto report = [&](const std::string& options) {
    const CommandResult result =
        alembert(folder, "report --without scaling --functions inverse_dynamics,mass_matrix " + options +
                             " " ALEMBERT_SOURCE_DIR "/tests/emit/chain.yaml");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.out;
  };
  const json looped = json::parse(report("--json --loop-operations 300"))["functions"];
  EXPECT_FALSE(looped["inverse_dynamics"].contains("dot_products"));
  EXPECT_GT(looped["inverse_dynamics"].value("in_loops", 0), 1000);
  const int found = looped["mass_matrix"].value("dot_products", 0);
  EXPECT_GT(found, 60);
  const std::string text = report("--loop-operations 300");
  EXPECT_THAT(text, HasSubstr("dot products in loops (--loop-results 30)"));
  EXPECT_THAT(text, HasSubstr("operations in loops over steps (--loop-operations 300)"));

  const auto straight = [&](const std::string& loop_results) {
    const json functions = json::parse(report("--json --loop-results " + loop_results))["functions"];
    EXPECT_FALSE(functions["inverse_dynamics"].contains("dot_products"));
    return functions;
  };
  EXPECT_EQ(straight(std::to_string(found))["mass_matrix"].value("dot_products", 0), found);
  EXPECT_FALSE(straight("0")["mass_matrix"].contains("dot_products"));
  const json none = straight(std::to_string(found + 1));
  EXPECT_FALSE(none["mass_matrix"].contains("dot_products"));
  EXPECT_FALSE(none["inverse_dynamics"].contains("in_loops"));
}

TEST(Evaluate, GivesForcesMassBiasAndAccelerations) {
  const TemporaryFolder folder;
  const CommandResult result = alembert(
      folder, "evaluate --json " + folder.write("pendulum.yaml", kPendulum),
      R"({"q": [0.3], "qd": [0.7], "qdd": [1.1], "t": 0})"
      "\n\n"
      R"({"q": [0.3], "qdd": [1.1], "wrenches": {"bob": [1, 0, 0, 0, 0.25, 0]}, "parameters": {"l": 2}})"
      "\n");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  std::istringstream lines(result.out);
  std::string line;
  ASSERT_TRUE(std::getline(lines, line));
  const json first = json::parse(line);
  const double mass = 2 * 0.25, bias = 2 * 9.81 * 0.5 * std::sin(0.3);
  EXPECT_NEAR(first["M"][0][0].get<double>(), mass, 1e-15);
  EXPECT_NEAR(first["c"][0].get<double>(), bias, 1e-14);
  EXPECT_NEAR(first["tau"][0].get<double>(), mass * 1.1 + bias, 1e-14);
  EXPECT_NEAR(first["qdd"][0].get<double>(), 1.1, 1e-14);
  EXPECT_EQ(first["qdot"][0].get<double>(), 0.7);
  ASSERT_EQ(first["poses"].size(), 1u);
  EXPECT_NEAR(first["poses"][0][3].get<double>(), -0.5 * std::sin(0.3), 1e-15);
  EXPECT_NEAR(first["poses"][0][11].get<double>(), -0.5 * std::cos(0.3), 1e-15);
  ASSERT_TRUE(std::getline(lines, line));
  const json second = json::parse(line);
  // The bob is at (-l sin q, 0, -l cos q): dx/dq = -l cos q.
  EXPECT_NEAR(second["tau"][0].get<double>(),
              8 * 1.1 + 2 * 9.81 * 2 * std::sin(0.3) + 2 * std::cos(0.3) - 0.25, 1e-13);
  EXPECT_FALSE(std::getline(lines, line));
}

TEST(Evaluate, GivesTheResultsOfFunctionsAskedFor) {
  const TemporaryFolder folder;
  const std::string command =
      "evaluate " + folder.write("pendulum.yaml", kPendulum) +
      " --functions energy,inverse_dynamics_derivatives,forward_dynamics,body_jacobians,frame_poses";
  const std::string state = R"({"q": [0.3], "qd": [0.7], "tau": [2]})";
  const CommandResult result = alembert(folder, command + " --json", state + "\n{}\n");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  std::istringstream lines(result.out);
  std::string line;
  ASSERT_TRUE(std::getline(lines, line));
  const json first = json::parse(line);
  EXPECT_EQ(first.size(), 5u);
  const double mass = 2 * 0.25, torque = 2 * 9.81 * 0.5;  // of gravity at a right angle
  const auto expect_near = [](const json& value, double expected) {
    EXPECT_NEAR(value.get<double>(), expected, 1e-14);
  };
  expect_near(first["energy"]["e"][0], mass * 0.7 * 0.7 / 2);
  expect_near(first["energy"]["e"][1], -torque * std::cos(0.3));
  expect_near(first["inverse_dynamics_derivatives"]["tau_q"][0][0], torque * std::cos(0.3));
  expect_near(first["inverse_dynamics_derivatives"]["tau_qd"][0][0], 0);
  expect_near(first["forward_dynamics"]["qdd"][0], (2 - torque * std::sin(0.3)) / mass);
  ASSERT_EQ(first["body_jacobians"]["J"].size(), 6u);
  expect_near(first["body_jacobians"]["J"][1][0], 1);
  expect_near(first["body_jacobians"]["J"][3][0], -0.5 * std::cos(0.3));
  EXPECT_EQ(first["frame_poses"]["F"], json::array());
  // At the initial state, without forces.
  ASSERT_TRUE(std::getline(lines, line));
  EXPECT_EQ(json::parse(line)["forward_dynamics"]["qdd"][0], 0);
  EXPECT_FALSE(std::getline(lines, line));

  const CommandResult text = alembert(folder, command, state);
  EXPECT_THAT(text.out, StartsWith("energy\ne "));
  EXPECT_THAT(text.out, HasSubstr("\ninverse_dynamics_derivatives\ntau_q "));
}

TEST(Evaluate, ScalesQuaternionsToUnitLength) {
  const TemporaryFolder folder;
  const std::string command = "evaluate --json " + mechanism_file("free_body");
  const CommandResult result = alembert(folder, command,
                                        R"({"q": [0,0,0,0.6000003,0,0,0.8000004]})"
                                        "\n"
                                        R"({"q": [0,0,0,0.6,0,0,0.8]})"
                                        "\n");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  std::istringstream lines(result.out);
  std::string near, exact;
  ASSERT_TRUE(std::getline(lines, near) && std::getline(lines, exact));
  const json a = json::parse(near)["c"], b = json::parse(exact)["c"];
  for (std::size_t i = 0; i < b.size(); ++i) EXPECT_NEAR(a[i].get<double>(), b[i].get<double>(), 1e-14) << i;

  const CommandResult far = alembert(folder, command, R"({"q": [0,0,0,3,0,0,4]})");
  EXPECT_EQ(far.exit_code, 1);
  EXPECT_THAT(far.err, StartsWith("<stdin>:1:14: error: quaternion 'turn' is not of unit length"));
}

// Lines before a state cost nothing more once they are read.
TEST(Evaluate, TakesTimeInProportionToItsInput) {
  const TemporaryFolder folder;
  std::string input(10'000'000, '\n');
  for (int i = 0; i < 20'000; ++i) input += "{}\n";
  const CommandResult result =
      alembert(folder, "evaluate --functions energy " + mechanism_file("pendulum"), input, 8);
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

struct BadState {
  const char* name;
  const char* line;
  int column;
  const char* message;
};
void PrintTo(const BadState& state, std::ostream* out) {
  *out << state.name;
}
class EvaluateRejects : public testing::TestWithParam<BadState> {};
TEST_P(EvaluateRejects, WithPlaceAndReason) {
  const TemporaryFolder folder;
  const CommandResult result = alembert(folder, "evaluate --json " + folder.write("pendulum.yaml", kPendulum),
                                        std::string("{\"q\": [0]}\n") + GetParam().line + "\n");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, StartsWith("<stdin>:2:" + std::to_string(GetParam().column) + ": error: "));
  EXPECT_THAT(result.err, HasSubstr(GetParam().message));
}
INSTANTIATE_TEST_SUITE_P(
    States, EvaluateRejects,
    testing::Values(BadState{"cut", "{\"q\": [0", 9, "JSON"}, BadState{"array", " [1]", 2, "object"},
                    BadState{"comma", "{\"q\": [0.1 2]}", 12, "JSON"},
                    BadState{"size", "{\"qd\": [1], \"q\": [0, 1]}", 18, "1 numbers"},
                    BadState{"text", R"({"qd": [1], "q": [ "a\"]" ]})", 20, "number"},
                    BadState{"key", "{\"t\": 1e-3 , \"qdddd\": [1]}", 14, "unknown key 'qdddd'"},
                    BadState{"huge", "{\"qd\": [1], \"q\": [1e999]}", 19, "out of the range"},
                    BadState{"twice", "{\"q\": [1], \"t\": 0, \"q\": [1]}", 20, "'q' is given twice"},
                    BadState{"body", "{\"wrenches\": {\"bop\": [0,0,0,0,0,0]}}", 15, "bob"},
                    BadState{"wrench", "{\"wrenches\": {\"bob\": [0,0,true,0,0,0]}}", 27, "number"},
                    BadState{"parameter", "{\"parameters\": {\"l\": null}}", 22, "number"},
                    BadState{"deep", "[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[", 45, "JSON"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Evaluate, WithoutAMassThereIsNoMomentum) {
  const TemporaryFolder folder;
  const std::string file = folder.write("stick.yaml", R"(alembert: 1
name: stick
coordinates: [a]
bodies:
  - {name: rod, transform: [{rotate: {axis: y, angle: a}}], inertia: {xx: 1, yy: 1, zz: 1}}
)");
  const CommandResult result =
      alembert(folder, "evaluate --functions centroidal_momentum " + file, "{\"q\": [0]}");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("stick.yaml:5:"));
  EXPECT_THAT(result.err, HasSubstr("centroidal_momentum has no value: no body has a mass"));
  EXPECT_EQ(alembert(folder, "evaluate --functions all " + file, "{\"q\": [0]}").exit_code, 0);
}

TEST(Evaluate, RejectsBracketsWithoutEnd) {
  const TemporaryFolder folder;
  const std::string deep(1'000'000, '[');
  const CommandResult result =
      alembert(folder, "evaluate " + mechanism_file("pendulum"), deep + std::string(1'000'000, ']'));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, StartsWith("<stdin>:1:65: error: JSON nested more than 64 levels deep"));
}

}  // namespace
}  // namespace alembert::test
