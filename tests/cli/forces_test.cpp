// Forces and inputs on the command line: closed forms of what moves, states with inputs, bad inputs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/command.hpp"
#include "cli/csv.hpp"

namespace alembert::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// A block of 2 kg on a spring of 50 N/m with a damper of 4 N s/m, and an input that pulls it.
const char* const kOscillator = R"(alembert: 1
name: oscillator
parameters:
  b: {value: 4, runtime: true}
inputs:
  - {name: pull, initial: 1}
coordinates:
  - {name: x, initial: 0.3, stiffness: 50, damping: b}
bodies:
  - {name: block, transform: [{translate: [x, 0, 0]}], mass: 2}
forces:
  - {name: rope, on: x, value: 10*pull}
)";

double damped(double t) {  // without pull
  const double d = 1, w = std::sqrt(25 - d * d);
  return 0.3 * std::exp(-d * t) * (std::cos(w * t) + d / w * std::sin(w * t));
}

TEST(Forces, ADampedOscillatorMovesAsItShould) {
  const TemporaryFolder folder;
  const std::string file = folder.write("oscillator.yaml", kOscillator);
  const CommandResult result =
      alembert(folder, "simulate " + file + " --duration 2 --every 100 --input pull=0");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Csv table(result.out);
  ASSERT_GT(table.rows.size(), 10U);
  for (const std::vector<double>& row : table.rows) EXPECT_NEAR(row[1], damped(row[0]), 1e-10) << row[0];
}

TEST(Forces, AnInputMayDependOnTimeAndState) {
  const TemporaryFolder folder;
  const std::string file = folder.write("oscillator.yaml", kOscillator);
  // It takes spring and damper away and gives a constant acceleration.
  const CommandResult result = alembert(
      folder, "simulate " + file + " --duration 1 --every 1000 --input 'pull=5*x + 0.4*d(x) + 0.6*t'");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Csv table(result.out);
  EXPECT_NEAR(table.rows.back()[1], 0.3 + 3.0 / 6, 1e-12);
  EXPECT_NEAR(table.rows.back()[2], 1.5, 1e-12);
}

/// A block of 2 kg on a rope that pulls like a spring of 50 N/m, with a damper of 4 N s/m.
const char* const kRope = R"(alembert: 1
name: rope_block
inputs: [push, share, extra]
coordinates: [{name: x, initial: 0.3, damping: 4}]
bodies: [{name: block, transform: [{translate: [x, 0, 0]}], mass: 2}]
frames: [{name: tip, body: block}, {name: wall, body: world}]
forces:
  - {name: rope, between: [wall, tip], tension: 50*length(rope)}
  - {name: hand, on: x, value: push}
outputs:
  - {name: reach, value: position(tip).x}
  - {name: pushed, value: 2*push}
)";

TEST(Forces, AnInputMayDependOnFramesPathsOutputsAndOtherInputs) {
  const TemporaryFolder folder;
  const std::string file = folder.write("rope_block.yaml", kRope);
  // Spring and damper are taken away; what is left is an acceleration of 6 t.
  const CommandResult result = alembert(
      folder, "simulate " + file +
                  " --duration 1 --every 1000 --input 'push=share + tension(rope)/2 + 4*velocity(tip).x'"
                  " --input 'share=20*reach + 5*length(rope) + extra' --input 'extra=12*t'");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Csv table(result.out);
  const std::vector<double>& last = table.rows.back();
  EXPECT_NEAR(last[1], 0.3 + 1, 1e-12);
  EXPECT_NEAR(last[2], 3, 1e-12);
  EXPECT_NEAR(last[table.column("pushed")], 2 * (50 * 1.3 + 4 * 3 + 12), 1e-10);
  const auto said = [&](const std::string& inputs) {
    const CommandResult refused = alembert(folder, "simulate " + file + " --duration 0.1 " + inputs);
    EXPECT_EQ(refused.exit_code, 1) << inputs;
    return refused.err;
  };
  EXPECT_THAT(said("--input push=share --input share=2*push"),
              HasSubstr("--input:1:1: error: input 'push' is given by itself"));
  EXPECT_THAT(said("--input push=pushed"), HasSubstr("--input:1:1: error: input 'push' is given by itself"));
  EXPECT_THAT(said("--input push=1 --input push=2"),
              HasSubstr("--input:1:1: error: a second expression of input 'push'"));
  EXPECT_THAT(said("--input 'push=position(tap).x'"), HasSubstr("--input:1:15: error: unknown frame 'tap'"));
}

TEST(Forces, AreColumnsOfAMotion) {
  const TemporaryFolder folder;
  const std::string file = folder.write("oscillator.yaml", kOscillator);
  const CommandResult result = alembert(folder, "simulate " + file + " --duration 1 --every 200 --qd 0.5");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Csv table(result.out);
  const std::size_t rope = table.column("force(rope)"), spring = table.column("force(stiffness of x)"),
                    damper = table.column("force(damping of x)");
  ASSERT_GT(table.rows.size(), 4U);
  for (const std::vector<double>& row : table.rows) {
    EXPECT_EQ(row[rope], 10);
    EXPECT_NEAR(row[damper], -4 * row[2], 1e-13);
    EXPECT_NEAR(row[spring], 25 * row[1] * row[1], 1e-13);  // a potential: its energy
  }
}

TEST(Forces, OfAPotentialLeaveInputsAsTheyAre) {
  const TemporaryFolder folder;
  const std::string file = folder.write("block.yaml", R"(alembert: 1
name: block
inputs: [u]
coordinates: [{name: x, initial: 1}]
bodies: [{name: block, transform: [{translate: [x, 0, 0]}], mass: 2}]
forces: [{name: field, potential: u*log(x)}]
outputs: [{name: set, value: u}]
)");
  const auto last = [&](const std::string& input) {
    const CommandResult result =
        alembert(folder, "simulate " + file + " --duration 1 --every 1000 --qd 1 --input 'u=" + input + "'");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const Csv table(result.out);
    EXPECT_EQ(table.column("set"), 6U);
    return table.rows.back();  // t, x, d(x), kinetic, potential, total energy, set
  };
  // A constant force of 2.
  const std::vector<double> pushed = last("-2*x");
  EXPECT_NEAR(pushed[1], 1 + 1 + 0.5, 1e-12);
  EXPECT_NEAR(pushed[2], 2, 1e-12);
  EXPECT_NEAR(pushed[4], -2 * 2.5 * std::log(2.5), 1e-11);
  EXPECT_NEAR(pushed[6], -2 * 2.5, 1e-11);
  // An acceleration that is the speed.
  EXPECT_NEAR(last("-2*x*d(x)")[1], std::exp(1), 1e-11);
}

TEST(Forces, StatesGiveInputsByName) {
  const TemporaryFolder folder;
  const std::string file = folder.write("oscillator.yaml", kOscillator);
  const CommandResult result = alembert(
      folder,
      "evaluate --json --functions applied_forces,bias,inverse_dynamics,forward_dynamics,energy " + file,
      R"({"q": [0.1], "qd": [2], "qdd": [3], "inputs": {"pull": 7}, "parameters": {"b": 5}})"
      "\n{}\n");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json first = json::parse(result.out.substr(0, result.out.find('\n')));
  EXPECT_DOUBLE_EQ(first["applied_forces"]["Q"][0].get<double>(), 70 - 5 - 10);
  EXPECT_DOUBLE_EQ(first["bias"]["c"][0].get<double>(), -55);
  EXPECT_DOUBLE_EQ(first["inverse_dynamics"]["tau"][0].get<double>(), 6 - 55);
  EXPECT_DOUBLE_EQ(first["forward_dynamics"]["qdd"][0].get<double>(), 27.5);
  EXPECT_DOUBLE_EQ(first["energy"]["e"][1].get<double>(), 0.25);
  const json second = json::parse(result.out.substr(result.out.find('\n') + 1));
  EXPECT_DOUBLE_EQ(second["applied_forces"]["Q"][0].get<double>(), 10 - 15) << "initial values";
}

TEST(Forces, ATableGivesInputsOverTime) {
  const TemporaryFolder folder;
  const std::string file = folder.write("cart.yaml", R"(alembert: 1
name: cart
inputs: [brake, push]
coordinates: [x]
bodies: [{name: cart, transform: [{translate: [x, 0, 0]}], mass: 2}]
forces: [{name: engine, on: x, value: push - brake*d(x)}]
)");
  const std::string table = folder.write("inputs.csv", "t, push\n0,0\n 1 , 4\n\n2,4\n");
  const CommandResult result =
      alembert(folder, "simulate " + file + " --duration 3 --every 1000 --inputs " + table);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Csv rows(result.out);
  EXPECT_NEAR(rows.rows[1][2], 1, 1e-9) << "a ramp for a second";
  EXPECT_NEAR(rows.rows[1][1], 1.0 / 3, 1e-9);
  EXPECT_NEAR(rows.rows[2][2], 3, 1e-9);
  EXPECT_NEAR(rows.rows[3][2], 5, 1e-9) << "the last row holds on";
  const auto said = [&](const std::string& text) {
    const CommandResult wrong =
        alembert(folder, "simulate " + file + " --duration 0.1 --inputs " + folder.write("wrong.csv", text));
    EXPECT_EQ(wrong.exit_code, 1) << text;
    return wrong.err;
  };
  EXPECT_THAT(said("t,pusch\n0,1\n"),
              HasSubstr("wrong.csv:1:3: error: there is no input 'pusch' (did you mean 'push'?)"));
  EXPECT_THAT(said("time,push\n0,1\n"), HasSubstr("wrong.csv:1:1: error: expected t as the first column"));
  EXPECT_THAT(said("t,push\n0,1\n0,2\n"), HasSubstr("wrong.csv:3:1: error: the time 0 does not follow 0"));
  EXPECT_THAT(said("t,push\n0,much\n"), HasSubstr("wrong.csv:2:3: error: expected a number, found 'much'"));
  EXPECT_THAT(said("t,push\n0\n"), HasSubstr("wrong.csv:2:1: error: expected 2 numbers, found 1"));
  EXPECT_THAT(said("t,push,push\n"), HasSubstr("wrong.csv:1:8: error: a second column 'push'"));
  EXPECT_THAT(said("t,push\n"), HasSubstr("no rows of numbers"));
}

TEST(Forces, InputsThatAreWrongAreToldAtTheirPlace) {
  const TemporaryFolder folder;
  const std::string file = folder.write("oscillator.yaml", kOscillator);
  const auto said = [&](const std::string& input) {
    const CommandResult result =
        alembert(folder, "simulate " + file + " --duration 0.1 --input '" + input + "'");
    EXPECT_EQ(result.exit_code, 1) << input;
    return result.err;
  };
  EXPECT_THAT(said("pul=1"), HasSubstr("--input:1:1: error: there is no input 'pul' (did you mean 'pull'?)"));
  EXPECT_THAT(said("b=1"), HasSubstr("--input:1:1: error: there is no input 'b'"));
  EXPECT_THAT(said("pull"), HasSubstr("expected NAME=EXPRESSION"));
  EXPECT_THAT(said("pull=1 + xx"), HasSubstr("--input:1:10: error: unknown name 'xx'"));
  EXPECT_THAT(said("pull=2*(x"), HasSubstr("--input:1:10: error: expected"));
  const CommandResult state = alembert(folder, "evaluate " + file,
                                       R"({"inputs": {"push": 1}})"
                                       "\n");
  EXPECT_EQ(state.exit_code, 1);
  EXPECT_THAT(state.err, HasSubstr("there is no input 'push'"));
}

/// A ball of 1 kg and 0.1 m above a floor.
std::string ball(const std::string& contact) {
  return R"(alembert: 1
name: ball
coordinates: [x, {name: z, initial: 0.5}, spin]
bodies:
  - name: ball
    transform: [{translate: [x, 0, z]}, {rotate: {axis: y, angle: spin}}]
    mass: 1
    inertia: {xx: 0.004, yy: 0.004, zz: 0.004}
frames: [{name: center, body: ball}, {name: ground, body: world}]
forces:
  - {name: floor, contact: {frame: center, radius: 0.1, )" +
         contact + "}}\n";
}

/// The last row of a motion.
std::vector<double> moved(const std::string& text, const std::string& options) {
  const TemporaryFolder folder;
  const CommandResult result = alembert(
      folder, "simulate " + folder.write("moved.yaml", text) + " --step 2e-5 --every 100000 " + options);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return Csv(result.out).rows.back();
}

TEST(Contacts, ABallBouncesWithTheRestitutionOfHuntAndCrossley) {
  const double fall = std::sqrt(2 * 9.81 * 0.4), a = 1.5 * 0.08;
  // From the state without gravity: an impact of speed v ends with e v, ln((1 + a v)/(1 - a e v)) = a v (1 + e).
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double e = (low + high) / 2;
    (std::log((1 + a * fall) / (1 - a * e * fall)) < a * fall * (1 + e) ? low : high) = e;
  }
  const std::string text =
      ball("plane: {normal: [0, 0, 3]}, stiffness: 1e6, dissipation: 0.08") + "gravity: [0, 0, 0]\n";
  const std::vector<double> row = moved(text, "--duration 0.3 --qd 0,-" + std::to_string(fall) + ",0");
  EXPECT_NEAR(row[5], low * fall, 1e-4);
  EXPECT_NEAR(row[6], 0, 1e-12);
}

TEST(Contacts, ABallThatSlidesRollsInTheEnd) {
  const std::string text = ball(
      "plane: {frame: ground, normal: [0, 0, 1]}, stiffness: 1e5, dissipation: 1, "
      "friction: 0.5, slip_velocity: 0.001");
  const std::vector<double> row = moved(text, "--duration 1 --q 0,0.1,0 --qd 1,0,0");
  EXPECT_NEAR(row[4], 5.0 / 7, 1e-4);
  EXPECT_NEAR(row[6], 50.0 / 7, 1e-3);
}

TEST(Contacts, StiffnessMayBeZeroAtFirst) {
  const std::string text = R"(alembert: 1
name: soft
parameters: {k: {value: 0, runtime: true}}
coordinates: [{name: z, initial: 0.01}]
bodies: [{name: ball, transform: [{translate: [0, 0, z]}], mass: 1}]
frames: [{name: center, body: ball}]
forces: [{name: floor, contact: {frame: center, radius: 0.02, plane: {normal: [0, 0, 1]}, stiffness: k}}]
)";
  EXPECT_NEAR(moved(text, "--duration 0.1")[2], -9.81 * 0.1, 1e-12);
}

TEST(Contacts, SpheresExchangeMomentum) {
  const std::string text = R"(alembert: 1
name: spheres
gravity: [0, 0, 0]
coordinates: [a, {name: b, initial: 0.5}]
bodies:
  - {name: one, transform: [{translate: [a, 0, 0]}], mass: 2}
  - {name: two, transform: [{translate: [b, 0, 0]}], mass: 2}
frames: [{name: p, body: one}, {name: q, body: two}]
forces:
  - {name: hit, contact: {frame: p, radius: 0.1, sphere: {frame: q, radius: 0.2}, stiffness: 1e6}}
)";
  const std::vector<double> row = moved(text, "--duration 0.5 --qd 1,0");
  EXPECT_NEAR(row[3], 0, 1e-6);
  EXPECT_NEAR(row[4], 1, 1e-6);
}

TEST(Contacts, APlaneThatMovesIsPushedBack) {
  const std::string text = R"(alembert: 1
name: plate
gravity: [0, 0, 0]
coordinates: [a, {name: b, initial: 0.3}, turn]
bodies:
  - {name: plate, transform: [{translate: [0, 0, a]}, {rotate: {axis: z, angle: turn}}], mass: 3, inertia: {xx: 1, yy: 1, zz: 1}}
  - {name: ball, transform: [{translate: [0.2, 0, b]}], mass: 1}
frames: [{name: p, body: plate}, {name: q, body: ball}]
forces:
  - {name: hit, contact: {frame: q, radius: 0.1, plane: {frame: p, point: [0, 0, 0.05], normal: [0, 0, 1]}, stiffness: 1e6,
                          dissipation: 0.1, friction: 0.3, slip_velocity: 0.01}}
)";
  const std::vector<double> row = moved(text, "--duration 0.5 --qd 0,-1,2");
  EXPECT_NEAR(3 * row[4] + row[5], -1, 1e-9);
  EXPECT_GT(row[5], row[4]);
  EXPECT_LT(row[6], 2) << "friction brakes the plate";
}

}  // namespace
}  // namespace alembert::test
