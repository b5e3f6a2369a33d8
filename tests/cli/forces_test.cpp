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

}  // namespace
}  // namespace alembert::test
