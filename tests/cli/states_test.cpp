// States on the command line: closed forms and orders of what is integrated beside coordinates and speeds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "cli/command.hpp"
#include "cli/csv.hpp"

namespace alembert::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// A cart of 2 kg on a line, with states and what pulls it.
std::string cart(const std::string& states, const std::string& pull) {
  return "alembert: 1\nname: cart\ninputs: [{name: u, initial: 0.8}]\nstates:\n" + states +
         "coordinates: [x]\nbodies: [{name: cart, transform: [{translate: [x, 0, 0]}], mass: 2}]\n"
         "forces: [{name: engine, on: x, value: \"" +
         pull + "\"}]\n";
}

const char* const kLag = "  - {name: a, rate: (u - a)/0.2, initial: 0.1}\n";
const char* const kGrowth = "  - {name: s, rate: s*(1 - s), initial: 0.2}\n";

Csv simulated(const std::string& text, const std::string& options) {
  const TemporaryFolder folder;
  const CommandResult result =
      alembert(folder, "simulate " + folder.write("cart.yaml", text) + " " + options);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return Csv(result.out);
}

TEST(States, OfFirstOrderFollowTheirExponential) {
  const Csv table = simulated(cart(kLag, "2*a"), "--duration 1 --every 100");
  ASSERT_EQ(table.rows.size(), 11U);
  for (const std::vector<double>& row : table.rows) {
    const double t = row[0], fall = std::exp(-t / 0.2);
    EXPECT_NEAR(row[table.column("a")], 0.8 - 0.7 * fall, 1e-10) << t;
    // What the force that it is moves.
    EXPECT_NEAR(row[table.column("d(x)")], 0.8 * t - 0.7 * 0.2 * (1 - fall), 1e-10) << t;
  }
}

TEST(States, FollowInputsOfTime) {
  const Csv table = simulated(cart(kLag, "2*a"), "--duration 1 --every 1000 --input u=3*t");
  EXPECT_NEAR(table.rows.back()[table.column("a")], 3 - 0.6 + 0.7 * std::exp(-5), 1e-10);
}

/// Errors of a logistic state and of the speed that it causes, at t = 2 by steps of `step`.
std::vector<double> growth_errors(const std::string& integrator, double step) {
  const Csv table = simulated(cart(kGrowth, "2*s"), "--duration 2 --every 1000 --integrator " + integrator +
                                                        " --step " + std::to_string(step));
  const double grown = 1 - 0.2 + 0.2 * std::exp(2.0);
  const std::vector<double>& row = table.rows.back();
  return {std::abs(row[table.column("s")] - 0.2 * std::exp(2.0) / grown),
          std::abs(row[table.column("d(x)")] - std::log(grown))};
}

TEST(States, AreOfTheOrderOfTheirIntegrator) {
  for (const auto& [integrator, order, step] : {std::tuple("rk4", 4, 0.1), std::tuple("euler", 1, 0.01)}) {
    const std::vector<double> coarse = growth_errors(integrator, step),
                              fine = growth_errors(integrator, step / 2);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_GT(fine[i], 1e-10) << integrator;
      EXPECT_NEAR(std::log2(coarse[i] / fine[i]), order, 0.15) << integrator << " " << i;
    }
  }
}

// Explicit steps of a state that follows within 10 us overflow.
TEST(States, ThatAreTooStiffForExplicitStepsTakeImplicitOnes) {
  const TemporaryFolder folder;
  const std::string file = folder.write("cart.yaml", cart("  - {name: s, rate: 1e5*(u*t - s)}\n", "2*s"));
  const CommandResult chosen = alembert(folder, "simulate " + file + " --duration 1 --every 1000");
  EXPECT_EQ(chosen.exit_code, 0);
  EXPECT_EQ(chosen.err,
            "note: explicit steps of 0.001 s diverge at once: these are implicit (--integrator chooses)\n");
  const Csv table(chosen.out);
  EXPECT_NEAR(table.rows.back()[table.column("s")], 0.8, 2e-5);
  EXPECT_NEAR(table.rows.back()[table.column("d(x)")], 0.4, 1e-3);
  const CommandResult given = alembert(folder, "simulate " + file + " --integrator rk4");
  EXPECT_EQ(given.exit_code, 1);
  EXPECT_THAT(given.err, HasSubstr("no finite step from t = "));
}

TEST(States, ThatIntegrateSpeedAndPowerAreDisplacementAndWork) {
  const Csv table = simulated(R"(alembert: 1
name: pendulum
states:
  - {name: way, rate: d(q), initial: 0.7}
  - {name: heat, rate: 0.4*d(q)^2}
coordinates: [{name: q, initial: 0.7, initial_speed: 1, damping: 0.4}]
bodies: [{name: bob, transform: [{rotate: {axis: y, angle: q}}, {translate: [0, 0, -0.5]}], mass: 2}]
)",
                              "--duration 2 --every 200");
  const std::vector<double>& first = table.rows.front();
  for (const std::vector<double>& row : table.rows) {
    EXPECT_NEAR(row[table.column("way")], row[table.column("q")], 1e-14) << row[0];
    EXPECT_NEAR(row[table.column("energy")] + row[table.column("heat")], first[table.column("energy")], 1e-9)
        << row[0];
  }
  EXPECT_GT(table.rows.back()[table.column("heat")], 1);
}

TEST(States, OfAControllerTakeTheErrorAway) {
  // A load of 3 N that the controller does not know: only the integral can carry it.
  const Csv table = simulated(cart("  - {name: sum, rate: u - x}\n", "40*(u - x) - 14*d(x) + 20*sum - 3"),
                              "--duration 25 --step 0.01 --every 10000");
  const std::vector<double>& row = table.rows.back();
  EXPECT_NEAR(row[table.column("x")], 0.8, 1e-6);
  EXPECT_NEAR(row[table.column("sum")], 3.0 / 20, 1e-6);
}

TEST(States, AreGivenByName) {
  const TemporaryFolder folder;
  const std::string file = folder.write("cart.yaml", cart("  - {name: a, rate: 3*u - a*d(x), initial: 0.25}\n"
                                                          "  - {name: b, rate: a^2 + x}\n",
                                                          "2*a*u + b"));
  const CommandResult result =
      alembert(folder,
               "evaluate --json --functions "
               "state_rates,applied_forces,state_jacobian,state_rates_derivatives,state_input_jacobian " +
                   file,
               R"({"q": [0.5], "qd": [2], "inputs": {"u": 7}, "states": {"a": 3}})"
               "\n{}\n");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json first = json::parse(result.out.substr(0, result.out.find('\n')));
  EXPECT_EQ(first["state_rates"]["sdot"], json({21.0 - 6, 9.5}));
  EXPECT_EQ(first["applied_forces"]["Q"], json({42.0})) << "b has its initial value";
  EXPECT_EQ(first["state_jacobian"]["Q_s"], json::parse("[[14.0, 1.0]]"));
  EXPECT_EQ(first["state_rates_derivatives"]["r_q"], json::parse("[[0.0], [1.0]]"));
  EXPECT_EQ(first["state_rates_derivatives"]["r_qd"], json::parse("[[-3.0], [0.0]]"));
  EXPECT_EQ(first["state_rates_derivatives"]["r_s"], json::parse("[[-2.0, 0.0], [6.0, 0.0]]"));
  EXPECT_EQ(first["state_input_jacobian"]["r_inputs"], json::parse("[[3.0], [0.0]]"));
  const json second = json::parse(result.out.substr(result.out.find('\n') + 1));
  EXPECT_EQ(second["applied_forces"]["Q"], json({2 * 0.25 * 0.8})) << "initial values";
  const CommandResult wrong = alembert(folder, "evaluate " + file,
                                       R"({"states": {"c": 1}})"
                                       "\n");
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_THAT(wrong.err, HasSubstr("there is no state 'c'"));
}

}  // namespace
}  // namespace alembert::test
