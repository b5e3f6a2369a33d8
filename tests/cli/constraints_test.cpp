// `simulate` and `evaluate` of mechanisms with constraints: closed forms, states brought onto constraints,
// and what stops a motion along the way.
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/csv.hpp"

namespace alembert::test {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kRod = R"(alembert: 1
name: rod
coordinates: [{name: x, initial: 0.3}, {name: z, initial: -0.4}]
bodies:
  - {name: bob, transform: [{translate: [x, 0, z]}], mass: 2}
constraints:
  - {name: rod, type: holonomic, equations: ["x^2 + z^2 - 1/4"]}
)";

/// Worst residual and relative drift of the energy over the rows.
void expect_kept(const Csv& csv, double residual, double drift) {
  const std::size_t energy = csv.column("energy"), off = csv.column("residual");
  for (const auto& row : csv.rows) {
    ASSERT_LT(row[off], residual) << "t = " << row[0];
    ASSERT_LT(std::abs(row[energy] - csv.rows[0][energy]), drift * std::abs(csv.rows[0][energy]))
        << "t = " << row[0];
  }
}

TEST(SimulateConstrained, SleighFollowsItsClosedForm) {
  const TemporaryFolder folder;
  const std::string csv = folder / "out.csv";
  const CommandResult result = alembert(folder, "simulate " + mechanism_file("paper/chaplygin_sleigh") +
                                                    " --qd 0,0,2 --duration 60 --step 0.01 --csv " + csv);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Csv table(read_text(csv));
  expect_kept(table, 1e-8, 1e-5);
  // v = V tanh(k t), w = 2 / cosh(k t), from rest along the edge; k = m a V / J, V = 2 sqrt(J / m).
  const double m = 1.4, a = 0.35, J = 0.11 + m * a * a, V = 2 * std::sqrt(J / m), k = m * a * V / J;
  for (const auto& row : table.rows) {
    const double heading = row[3], v = row[4] * std::cos(heading) + row[5] * std::sin(heading);
    ASSERT_NEAR(v, V * std::tanh(k * row[0]), 1e-6);
    ASSERT_NEAR(row[6], 2 / std::cosh(k * row[0]), 1e-6);
  }
}

TEST(SimulateConstrained, ImplicitStepsComeToTheSleighsClosedFormByOrderOne) {
  const TemporaryFolder folder;
  const double m = 1.4, a = 0.35, J = 0.11 + m * a * a, V = 2 * std::sqrt(J / m), k = m * a * V / J;
  for (const std::string integrator : {"linearly-implicit", "implicit"}) {
    const auto error = [&](const std::string& step) {
      const CommandResult result =
          alembert(folder, "simulate " + mechanism_file("paper/chaplygin_sleigh") +
                               " --qd 0,0,2 --duration 0.5 --integrator " + integrator + " --step " + step);
      EXPECT_EQ(result.exit_code, 0) << result.err;
      const Csv table(result.out);
      const std::vector<double>& row = table.rows.back();
      EXPECT_LT(row[table.column("residual")], 1e-9);
      return row[6] - 2 / std::cosh(k * row[0]);
    };
    const double coarse = error("0.005");
    EXPECT_LT(std::abs(coarse), 0.02);
    EXPECT_NEAR(coarse / error("0.0025"), 2, 0.1) << integrator;
  }
}

TEST(SimulateConstrained, ClosesALoopAndKeepsItClosed) {
  const TemporaryFolder folder;
  const std::string csv = folder / "out.csv";
  const std::string command = "simulate " + mechanism_file("paper/five_bar") + " --duration 20 --csv " + csv;
  const CommandResult result = alembert(folder, command);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err,
              HasSubstr("note: the initial state did not keep the constraints (row loop[0] was off by 0.19"));
  EXPECT_THAT(result.err, HasSubstr("left_elbow -1 -> "));
  const Csv table(read_text(csv));
  EXPECT_THAT(table.header, testing::EndsWith("energy,lambda(loop[0]),lambda(loop[1]),residual"));
  expect_kept(table, 1e-8, 1e-5);
}

TEST(SimulateConstrained, HeldCoordinatesStay) {
  const TemporaryFolder folder;
  const std::string command = "simulate " + mechanism_file("paper/five_bar") + " --duration 0 --hold ";
  const CommandResult result = alembert(folder, command + "left_shoulder,right_shoulder");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Csv table(result.out);
  EXPECT_EQ(table.rows[0][1], 0.7);
  EXPECT_EQ(table.rows[0][3], -0.5);
  EXPECT_LT(table.rows[0].back(), 1e-12);
  const CommandResult unknown = alembert(folder, command + "left_sholder");
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_THAT(unknown.err, HasSubstr("did you mean 'left_shoulder'?"));
}

TEST(SimulateConstrained, WithoutAssemblingTheStateMustBeRight) {
  const TemporaryFolder folder;
  const CommandResult result =
      alembert(folder, "simulate " + mechanism_file("paper/five_bar") + " --duration 0 --no-assemble");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, testing::ContainsRegex("five_bar.yaml:[0-9]+:11: error"));
  EXPECT_THAT(result.err, HasSubstr("the initial state does not keep row loop[0]: it is off by 0.19"));
  const CommandResult right =
      alembert(folder, "simulate " + folder.write("rod.yaml", kRod) + " --duration 0 --no-assemble");
  EXPECT_EQ(right.exit_code, 0) << right.err;
  EXPECT_EQ(right.err, "");
}

TEST(SimulateConstrained, RedundantRowsAreNotedOnceAndChangeNothing) {
  const TemporaryFolder folder;
  const std::string options = " --duration 2";
  const CommandResult once = alembert(folder, "simulate " + folder.write("rod.yaml", kRod) + options);
  const CommandResult twice = alembert(
      folder,
      "simulate " +
          folder.write("spare.yaml",
                       std::string(kRod) +
                           "  - {name: spare, type: holonomic, equations: [\"3*x^2 + 3*z^2 - 3/4\"]}\n") +
          options);
  ASSERT_EQ(once.exit_code, 0) << once.err;
  ASSERT_EQ(twice.exit_code, 0) << twice.err;
  EXPECT_EQ(once.err, "");
  EXPECT_EQ(
      twice.err,
      "note: rows of the constraints that follow from the others at t = 0: spare (their lambda is 0)\n");
  const Csv a(once.out), b(twice.out);
  ASSERT_EQ(a.rows.size(), b.rows.size());
  for (std::size_t i = 0; i < a.rows.size(); ++i)
    for (std::size_t j = 0; j < 5; ++j) ASSERT_NEAR(a.rows[i][j], b.rows[i][j], 1e-11);
}

TEST(SimulateConstrained, ContradictionsAreNamed) {
  const TemporaryFolder folder;
  const std::string at_once = folder.write(
      "at_once.yaml",
      std::string(kRod) + "  - {name: longer, type: holonomic, equations: [\"x^2 + z^2 - 1\"]}\n");
  const CommandResult first = alembert(folder, "simulate " + at_once);
  EXPECT_EQ(first.exit_code, 1);
  EXPECT_THAT(
      first.err,
      HasSubstr("at_once.yaml:8:12: error: no state near the initial one keeps the constraints: row longer"));
  // `generate` warns: whoever knows a better state may still use the code.
  const auto generate = [&](const std::string& file) {
    const CommandResult result = alembert(folder, "generate " + file + " --out-dir " + (folder / "out"));
    EXPECT_EQ(result.exit_code, 0);
    return result.err;
  };
  EXPECT_THAT(generate(at_once),
              HasSubstr("at_once.yaml:8:12: warning: no state near the initial one keeps the constraints: "
                        "row longer contradicts those that it depends on"));
  EXPECT_EQ(generate(folder.write("rod.yaml", kRod)), "");
  EXPECT_EQ(generate(mechanism_file("paper/five_bar")), "");  // its initial state is not closed
  // d(x) = 0 and d(x) = t^3 agree at t = 0 only.
  const std::string later = folder.write("later.yaml", R"yaml(alembert: 1
name: later
coordinates: [x, y]
bodies:
  - {name: bob, transform: [{translate: [x, 0, y]}], mass: 1}
constraints:
  - {name: still, type: pfaffian, rows: ["d(x)"]}
  - {name: moving, type: pfaffian, rows: ["d(x) - t^3"]}
)yaml");
  const CommandResult second = alembert(folder, "simulate " + later);
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_THAT(
      second.err,
      HasSubstr("later.yaml:8:12: error: the constraints contradict each other at t = 0: row moving"));
  EXPECT_EQ(Csv(second.out).rows.size(), 1u);  // what there was
}

TEST(SimulateConstrained, RowsWithoutAValueAreNotContradictions) {
  const TemporaryFolder folder;
  const std::string file = folder.write("edge.yaml", R"yaml(alembert: 1
name: edge
gravity: [0, 0, 0]
coordinates: [{name: x, initial: 1}, {name: y, initial: 1}, z]
bodies:
  - {name: bob, transform: [{translate: [x, y, z]}], mass: 1}
constraints:
  - {name: first, type: pfaffian, rows: ["d(z)"]}
  - {name: root, type: pfaffian, rows: ["d(y) - sqrt(x)*d(x)"]}
  - {name: second, type: pfaffian, rows: ["2*d(z)"]}
)yaml");
  const CommandResult at_once = alembert(folder, "simulate " + file + " --q=-1,1,0");
  EXPECT_EQ(at_once.exit_code, 1);
  EXPECT_THAT(at_once.err, HasSubstr("edge.yaml:9:12: error: row root has no value at the initial state"));
  const CommandResult later = alembert(folder, "simulate " + file + " --qd=-1,-1,0 --no-assemble");
  EXPECT_EQ(later.exit_code, 1);
  EXPECT_THAT(later.err, Not(HasSubstr("contradict")));
  EXPECT_THAT(later.err, HasSubstr("no finite step from t = "));
  const CommandResult state =
      alembert(folder, "evaluate --json " + file, R"({"q": [-1, 1, 0], "qd": [1, 1, 1]})");
  ASSERT_EQ(state.exit_code, 0) << state.err;
  EXPECT_EQ(nlohmann::json::parse(state.out)["status"], "a value is not finite");
}

TEST(SimulateSingular, AnInflectionAlongTheWayIsNamed) {
  const TemporaryFolder folder;
  const std::string file = folder.write("wave.yaml", R"(alembert: 1
name: wave
coordinates: [{name: s, initial: 0.3}]
bodies:
  - name: car
    transform: [{curve: {point: [s, 0, cos(s)], along: s, frame: frenet}}]
    mass: 1
    inertia: {xx: 0.01, yy: 0.01, zz: 0.01}
)");
  const CommandResult result = alembert(folder, "simulate " + file + " --qd 1");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err,
              HasSubstr("wave.yaml:6:25: error: the Frenet frame of a curve of body 'car' is singular"));
  EXPECT_THAT(result.err, HasSubstr("t = 0.64, s = 1.57"));
  EXPECT_THAT(result.err, HasSubstr("frame: {reference: [x, y, z]}"));
  const Csv table(result.out);
  EXPECT_NEAR(table.rows.back()[0], 0.639, 1e-12);  // the last good state is there
  EXPECT_LT(table.rows.back()[1], std::acos(0));
  // Exactly there from the start:
  const CommandResult at_once = alembert(folder, "simulate " + file + " --q 1.5707963267948966");
  EXPECT_EQ(at_once.exit_code, 1);
  EXPECT_THAT(at_once.err, HasSubstr("singular"));
}

TEST(SimulateSingular, APoleOfASurfaceIsNamed) {
  const TemporaryFolder folder;
  const CommandResult result = alembert(folder, "simulate " + folder.write("ant.yaml", R"(alembert: 1
name: ant
gravity: [0, 0, 0]
coordinates: [lon, {name: lat, initial: 0.1}]
bodies:
  - name: ant
    transform: [{surface: {point: [cos(lat)*cos(lon), cos(lat)*sin(lon), sin(lat)], along: [lon, lat]}}]
    mass: 1
    inertia: {xx: 0.01, yy: 0.01, zz: 0.01}
)") + " --qd 0,1");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(
      result.err,
      HasSubstr(
          "the frame of a surface of body 'ant' is singular just before t = 1.471, lon = 0, lat = 1.571"));
}

TEST(SimulateSingular, APoleOfTheCoordinatesIsNamed) {
  const TemporaryFolder folder;
  const CommandResult result = alembert(folder, "simulate " + folder.write("pole.yaml", R"(alembert: 1
name: pole
coordinates: [azimuth, polar]
bodies:
  - {name: bob, transform: [{rotate: {axis: z, angle: azimuth}}, {rotate: {axis: y, angle: polar}}], mass: 1, com: [0, 0, -1]}
)"));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("pole.yaml:3:15: error: the mass matrix is singular at t = 0"));
  EXPECT_THAT(result.err, HasSubstr("'azimuth'"));
}

TEST(SimulateSingular, AStepTooLongEndsWithWhatThereWas) {
  const TemporaryFolder folder;
  const CommandResult diverging =
      alembert(folder, "simulate " + mechanism_file("double_pendulum") + " --step 5 --duration 1e4 --q 1,1");
  EXPECT_EQ(diverging.exit_code, 1);
  EXPECT_THAT(diverging.err, HasSubstr("no finite step from t = "));
  const Csv table(diverging.out);
  ASSERT_FALSE(table.rows.empty());
  for (const auto& row : table.rows)
    for (const double value : row) EXPECT_TRUE(std::isfinite(value)) << "t = " << row[0];
  const CommandResult torn =
      alembert(folder, "simulate " + mechanism_file("paper/five_bar") + " --step 0.2 --duration 60");
  EXPECT_EQ(torn.exit_code, 1);
  EXPECT_THAT(torn.err, HasSubstr("finds no way back to the constraints: try a shorter --step"));
  EXPECT_GT(Csv(torn.out).rows.size(), 1u);
}

TEST(EvaluateConstrained, ReactionsAndRows) {
  const TemporaryFolder folder;
  const std::string file = folder.write("rod.yaml", kRod);
  // The hanging bob: the rod bears its weight, lambda * 2 z = m g - tau_z.
  const std::string states = R"({"q": [0, -0.5], "qd": [0.2, 0]}
{"q": [0, -0.5], "qd": [0, 0], "tau": [0, 5]}
{"q": [0, 0], "qd": [1, 0]}
)";
  const CommandResult result = alembert(folder, "evaluate --json " + file, states);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  std::istringstream lines(result.out);
  std::vector<nlohmann::json> answers;
  for (std::string line; std::getline(lines, line);) answers.push_back(nlohmann::json::parse(line));
  ASSERT_EQ(answers.size(), 3u);
  EXPECT_EQ(answers[0]["P"], nlohmann::json({{0.0, -1.0}}));
  EXPECT_NEAR(answers[0]["gamma"][0].get<double>(), 0.08, 1e-15);
  EXPECT_NEAR(answers[0]["velocity"][0].get<double>(), 0, 1e-15);
  EXPECT_NEAR(answers[0]["position"][0].get<double>(), 0, 1e-15);
  // Without forces of its own the first state has tau = M 0 + c: the rod bears what is left, m v^2 / l.
  EXPECT_NEAR(answers[0]["lambda"][0].get<double>(), -2 * 0.04 / 0.5, 1e-12);
  EXPECT_NEAR(answers[0]["qdd"][1].get<double>(), 0.08, 1e-12);
  EXPECT_EQ(answers[0]["status"], "ok");
  EXPECT_NEAR(answers[1]["lambda"][0].get<double>(), -(2 * 9.81 - 5), 1e-12);
  EXPECT_NEAR(answers[1]["qdd"][1].get<double>(), 0, 1e-12);
  // At the pivot the row is empty and cannot be kept.
  EXPECT_TRUE(answers[2]["qdd"].is_null());
  EXPECT_TRUE(answers[2]["lambda"].is_null());
  EXPECT_EQ(answers[2]["redundant"], nlohmann::json({"rod"}));
  EXPECT_EQ(answers[2]["status"], "the constraints contradict each other");
  const CommandResult text = alembert(folder, "evaluate " + file, states);
  EXPECT_THAT(text.out, HasSubstr("lambda"));
  EXPECT_THAT(text.out, HasSubstr("rod follows from the other rows"));
  EXPECT_THAT(alembert(folder, "evaluate --json " + mechanism_file("pendulum"), "{}\n").out,
              Not(HasSubstr("lambda")));
}

}  // namespace
}  // namespace alembert::test
