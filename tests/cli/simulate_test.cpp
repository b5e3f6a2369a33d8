// `simulate`, `check`, and the options all commands share.
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <string>

#include "cli/command.hpp"
#include "cli/csv.hpp"

namespace alembert::test {
namespace {

using testing::HasSubstr;

TEST(Simulate, ConservesTheEnergyOfADoublePendulum) {
  const TemporaryFolder folder;
  const std::string csv = folder / "out.csv";
  const CommandResult result = alembert(folder, "simulate " + mechanism_file("double_pendulum") +
                                                    " --duration 5 --step 0.001 --q 1,0.5 --csv " + csv);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(read_text(csv), testing::StartsWith("t,"));
  const auto rows = Csv(read_text(csv)).rows;
  ASSERT_EQ(rows.size(), 501u);
  EXPECT_DOUBLE_EQ(rows.back()[0], 5.0);
  EXPECT_NE(rows.back()[1], 1.0);
  for (const auto& row : rows) EXPECT_NEAR(row.back(), rows[0].back(), 1e-7 * std::abs(rows[0].back()));
}

TEST(Simulate, SaysWhichExpressionHasNoValueAtAGivenState) {
  const TemporaryFolder folder;
  const std::string knee = mechanism_file("paper/knee");
  const CommandResult result = alembert(folder, "simulate " + knee + " --duration 0.1 --q 9,9");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, testing::StartsWith(knee + ":27:15: error: "));
  EXPECT_THAT(result.err,
              HasSubstr("acos of a number outside [-1, 1]: '(c^2 + diagonal^2 - b^2)/(2*c*diagonal)' "
                        "is 1.0084"));
  EXPECT_THAT(result.err,
              HasSubstr("--q starts at q = 9, ankle = 9: the mechanism cannot be put together there"));
  // Outside the limits is no error where the mechanism exists.
  EXPECT_EQ(alembert(folder, "simulate " + knee + " --duration 0.1 --q 1.25,3").exit_code, 0);
}

// A limit on the size of files makes writing fail midway, as a full disk does.
TEST(Simulate, AFullDiskLeavesTheTableFromBefore) {
  const TemporaryFolder folder;
  const std::string csv = folder.write("out.csv", "before");
  const CommandResult result =
      run_command(folder,
                  "bash -c 'trap \"\" XFSZ; ulimit -f 8; " ALEMBERT_EXECUTABLE " simulate " +
                      mechanism_file("pendulum") + " --q 1 --every 1 --csv " + csv + "'",
                  "", 20);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, testing::StartsWith(csv + ":1:1: error: cannot write it: "));
  EXPECT_EQ(read_text(csv), "before");
  EXPECT_FALSE(std::filesystem::exists(csv + ".alembert-new"));
}

TEST(Simulate, KeepsQuaternionsOfUnitLength) {
  const TemporaryFolder folder;
  const CommandResult result =
      alembert(folder, "simulate " + mechanism_file("free_body") +
                           " --duration 1 --integrator euler --qd 0.1,0.2,0.3,1,2,3");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  for (const auto& row : Csv(result.out).rows) {
    double norm = 0;
    for (std::size_t i = 4; i < 8; ++i) norm += row[i] * row[i];
    EXPECT_NEAR(norm, 1, 1e-14);
  }
}

TEST(Simulate, SaysWhereItCannotGoOn) {
  const TemporaryFolder folder;
  const std::string file = folder.write("pole.yaml", R"(alembert: 1
name: pole
coordinates: [azimuth, polar]
bodies:
  - {name: bob, transform: [{rotate: {axis: z, angle: azimuth}}, {rotate: {axis: y, angle: polar}}], mass: 1, com: [0, 0, -1]}
)");
  const CommandResult result = alembert(folder, "simulate " + file);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("t = 0"));
  EXPECT_THAT(result.out, HasSubstr("\n0,"));  // the rows so far are kept
}

TEST(Simulate, RejectsWhatMakesNoSense) {
  const TemporaryFolder folder;
  const std::string file = mechanism_file("pendulum");
  for (const char* options : {" --step 0", " --step -1", " --duration nan", " --q 1,2,3",
                              " --integrator magic", " --csv /nowhere/x.csv", " --step 1e-300"}) {
    const CommandResult result = alembert(folder, "simulate " + file + options);
    EXPECT_EQ(result.exit_code, 1) << options;
    EXPECT_NE(result.err, "") << options;
  }
}

TEST(Simulate, SaysHowManyValuesAnOptionTakes) {
  const TemporaryFolder folder;
  EXPECT_THAT(alembert(folder, "simulate " + mechanism_file("pendulum") + " --q 1,2").err,
              HasSubstr("--q takes 1 value, not 2\n"));
  EXPECT_THAT(alembert(folder, "simulate " + mechanism_file("double_pendulum") + " --qd 1").err,
              HasSubstr("--qd takes 2 values, not 1\n"));
}

TEST(Simulate, NumbersThatAreNoneAreNamedInALine) {
  const TemporaryFolder folder;
  const std::string file = mechanism_file("double_pendulum");
  const struct {
    const char* options;
    const char* message;
  } cases[] = {{" --step -1", "--step: expected a finite number above 0, not '-1'"},
               {" --step inf", "--step: expected"},
               {" --duration -0.1", "--duration: expected a finite number that is not negative, not '-0.1'"},
               {" --duration 1e400", "--duration: expected"},
               {" --fps nan", "--fps: expected"},
               {" --effort nan", "--effort: expected a finite number that is not negative, not 'nan'"},
               {" --loop-results -3", "--loop-results: expected"},
               {" --q 0,nan", "--q: expected a finite number, not 'nan'"},
               {" --qd inf,0", "--qd: expected a finite number, not 'inf'"}};
  for (const auto& [options, message] : cases) {
    const CommandResult result = alembert(folder, "simulate " + file + options);
    EXPECT_EQ(result.exit_code, 1) << options;
    EXPECT_THAT(result.err, testing::StartsWith(message));
    EXPECT_LT(result.err.size(), 200u) << result.err;
  }
}

TEST(Simulate, ScalesGivenQuaternionsToUnitLength) {
  const TemporaryFolder folder;
  const std::string command = "simulate " + mechanism_file("free_body") + " --duration 0 --q ";
  const CommandResult result = alembert(folder, command + "0,0,0,3,0,0,4");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, alembert(folder, command + "0,0,0,0.6,0,0,0.8").out);
  EXPECT_NEAR(Csv(result.out).rows.at(0).back(), -0.2323008, 1e-12);
  const CommandResult none = alembert(folder, command + "0,0,0,0,0,0,0");
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_THAT(none.err, HasSubstr("--q gives the quaternion 'turn' no direction: its length is 0"));
}

TEST(Simulate, TakesRuntimeParameters) {
  const TemporaryFolder folder;
  const std::string file = folder.write("pendulum.yaml", R"(alembert: 1
name: pendulum
gravity: [0, 0, -9.81]
parameters: {length: {value: 0.5, runtime: true}, load: {value: 1, runtime: true}}
inputs: [push]
coordinates: [q]
bodies:
  - {name: bob, transform: [{rotate: {axis: y, angle: q}}, {translate: [0, 0, -length]}], mass: load}
forces: [{name: motor, potential: "push*q"}]
)");
  const std::string command = "simulate " + file + " --duration 0 --q 0.3";
  const auto energy = [&](const std::string& options) {
    const CommandResult result = alembert(folder, command + options);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const Csv csv(result.out);
    return csv.rows.at(0).at(csv.column("energy"));
  };
  EXPECT_NEAR(energy(""), -9.81 * 0.5 * std::cos(0.3), 1e-12);
  EXPECT_NEAR(energy(" --parameter length=2"), -9.81 * 2 * std::cos(0.3), 1e-12);
  EXPECT_NEAR(energy(" --parameter load=3e-1,length=2"), -9.81 * 0.3 * 2 * std::cos(0.3), 1e-12);
  for (const auto& [given, message] : std::map<std::string, std::string>{
           {"lenght=2", "--parameter: there is no runtime parameter 'lenght' (did you mean 'length'?)"},
           {"push=2", "--parameter: there is no runtime parameter 'push'"},
           {"length", "--parameter takes NAME=VALUE, not 'length'"},
           {"length=2m", "--parameter: '2m' is no value for 'length': expected a number"},
           {"length=inf", "--parameter: 'inf' is no value for 'length': expected a number"}}) {
    const CommandResult result = alembert(folder, command + " --parameter " + given);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, HasSubstr(message));
  }
}

// A fall from rest: both methods are exact in the speed.
TEST(Simulate, EndsWhenItIsAskedTo) {
  const TemporaryFolder folder;
  const std::string file = folder.write("stone.yaml", R"(alembert: 1
name: stone
coordinates: [z]
bodies:
  - {name: stone, transform: [{translate: [0, 0, z]}], mass: 1}
)");
  const auto rows = [&](const std::string& options) {
    const CommandResult result = alembert(folder, "simulate " + file + options);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return Csv(result.out).rows;
  };
  for (const std::string method : {"", " --integrator euler"}) {
    const auto cut = rows(" --duration 1 --step 0.3 --every 1" + method);
    ASSERT_EQ(cut.size(), 5u);
    EXPECT_DOUBLE_EQ(cut[3][0], 0.9);
    EXPECT_EQ(cut[4][0], 1);
    EXPECT_NEAR(cut[4][2], -9.81, 1e-13);
    const auto single = rows(" --duration 1 --step 10" + method);
    ASSERT_EQ(single.size(), 2u);
    EXPECT_EQ(single[1][0], 1);
    EXPECT_NEAR(single[1][2], -9.81, 1e-13);
  }
  EXPECT_EQ(rows(" --duration 0.3 --step 0.1 --every 1").size(), 4u);
  EXPECT_EQ(rows(" --duration 1 --step 0.3 --every 3").size(), 3u);
  EXPECT_EQ(rows(" --duration 0").size(), 1u);
}

// 10 s at 60 frames a second, which RK4 does not survive where there are contacts.
TEST(Simulate, TakesStiffForcesAtTheStepOfAFrame) {
  const TemporaryFolder folder;
  const auto moved = [&](const std::string& name, const std::string& integrator) {
    return alembert(folder, "simulate --effort 0 " + mechanism_file("forces/" + name) +
                                " --duration 10 --step 0.016666666666666666 --every 1 --integrator " +
                                integrator);
  };
  for (const std::string name : {"hopping_leg", "rolling_balls"})
    EXPECT_EQ(moved(name, "rk4").exit_code, 1) << name;
  for (const std::string integrator : {"linearly-implicit", "implicit"}) {
    for (const std::string name : {"hopping_leg", "rolling_balls", "soft_pendulum", "car_suspension", "elbow",
                                   "geared_motor", "quadrotor", "cable_over_pulleys"}) {
      const CommandResult result = moved(name, integrator);
      ASSERT_EQ(result.exit_code, 0) << name << " " << integrator << result.err;
      const Csv table(result.out);
      ASSERT_EQ(table.rows.size(), 601U) << name;
      for (const double x : table.rows.back()) EXPECT_TRUE(std::isfinite(x)) << name << " " << integrator;
      if (integrator != "implicit" ||
          (name != "hopping_leg" && name != "rolling_balls" && name != "soft_pendulum"))
        continue;
      // Nothing drives these. What a contact stores is not in their energy.
      const std::size_t energy = table.column("energy");
      for (const std::vector<double>& row : table.rows)
        EXPECT_LT(row[energy], table.rows.front()[energy] + 0.01) << name << " " << row[0];
    }
  }
}

// A head that is a point mass, as humanoids are published: at the start two of its three axes move it the same way, and M is
// singular. Its damping makes an implicit step regular. Only the first axis moves, as a damped pendulum does.
TEST(Simulate, ImplicitStepsGoThroughASingularMassMatrix) {
  const TemporaryFolder folder;
  const std::string file = ALEMBERT_SOURCE_DIR "/tests/cli/neck.yaml";
  const CommandResult result =
      alembert(folder, "simulate " + file + " --duration 1 --step 0.001 --integrator implicit");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  double pitch = 0, speed = 0;  // by steps of the semi-implicit Euler method
  const double inertia = 0.1 * 0.0095 * 0.0095 + 1.3 * (0.028 * 0.028 + 0.11 * 0.11);
  for (int k = 0; k < 100000; ++k) {
    const double moment =
        9.81 * ((0.1 * 0.0095 + 1.3 * 0.028) * std::cos(pitch) + 1.3 * 0.11 * std::sin(pitch));
    speed += 1e-5 * (moment - speed) / inertia;
    pitch += 1e-5 * speed;
  }
  const Csv table(result.out);
  EXPECT_NEAR(table.rows.back()[table.column("pitch")], pitch, 2e-3);
  EXPECT_NEAR(table.rows.back()[table.column("roll")], 0, 1e-9);
  EXPECT_NEAR(table.rows.back()[table.column("yaw")], 0, 1e-9);
}

// RK4 leaves this wheel turning at 0.8 rad/s for ever, where friction stops it within 2 ms: its stages cancel.
TEST(Simulate, TellsOfStepsThatAreTooLong) {
  const TemporaryFolder folder;
  const std::string file = folder.write("wheel.yaml", R"(alembert: 1
name: wheel
coordinates: [{name: q1, initial_speed: 10, friction: {force: 0.5, velocity: 0.01}}]
bodies:
  - name: wheel
    transform: [{joint: {type: revolute, axis: z, coordinates: [q1]}}]
    mass: 1
    inertia: {xx: 1e-4, yy: 1e-4, zz: 1e-4}
)");
  const auto told = [&](const std::string& options) {
    const CommandResult result =
        alembert(folder, "simulate " + file + " --csv " + (folder / "out.csv") + " " + options);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.err;
  };
  EXPECT_EQ(
      told("--duration 1"),
      "note: steps of 0.001 s are too long for coordinate 'q1': 100 of 100 that were tried change its "
      "speed otherwise than shorter ones do; choose a shorter --step or, for stiff forces, --integrator "
      "implicit\n");
  EXPECT_EQ(told("--duration 1 --integrator implicit"), "");
  EXPECT_EQ(told("--duration 0.01 --step 1e-6"), "");
}

// Steps are counted: a sum of 10^5 steps of 1e-3 is off by 1.4e-10 and more.
TEST(Simulate, TimeDoesNotDrift) {
  const TemporaryFolder folder;
  const CommandResult result = alembert(
      folder, "simulate " + mechanism_file("pendulum") + " --duration 100 --every 1000 --integrator euler");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto rows = Csv(result.out).rows;
  ASSERT_EQ(rows.size(), 101u);
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i][0], double(i));
}

TEST(Check, HasTheOptionsThatItObeys) {
  const TemporaryFolder folder;
  const std::string file = mechanism_file("double_pendulum");
  EXPECT_EQ(alembert(folder, "check --without placement --effort 0 " + file).exit_code, 0);
  const std::string help = alembert(folder, "check --help").out;
  for (const std::string option : {"formulation", "loop-operations", "loop-results", "verbose", "dump"}) {
    EXPECT_THAT(help, testing::Not(HasSubstr("--" + option)));
    EXPECT_EQ(alembert(folder, "check --" + option + " 1 " + file).exit_code, 1);
  }
}

TEST(Check, MeasuresEveryFunctionAtAsManyStatesAsAreAskedFor) {
  const TemporaryFolder folder;
  const std::string file = mechanism_file("double_pendulum");
  const CommandResult result = alembert(folder, "check --states 57 " + file);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  for (const std::string function : {"inverse_dynamics", "forward_dynamics", "inverse_dynamics_derivatives"})
    EXPECT_THAT(result.out,
                testing::ContainsRegex(function + ": relative error [0-9.]+e-1[4-7] at 57 states"));
  EXPECT_EQ(alembert(folder, "check --states 0 " + file).exit_code, 1);
}

TEST(Check, ReportsTheLaws) {
  const TemporaryFolder folder;
  const CommandResult result = alembert(folder, "check " + mechanism_file("tree_every_joint"));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("Q = M qdd + c"));
  EXPECT_THAT(result.out, testing::Not(HasSubstr("FAILS")));
}

// At the number that is likely at fault.
TEST(Check, EquationsWithoutAValueAreAnErrorOfTheDescription) {
  const TemporaryFolder folder;
  const std::string file = folder.write("far.yaml", R"(alembert: 1
name: far
coordinates: [q]
bodies:
  - {name: arm, transform: [{rotate: {axis: y, angle: q}}], mass: 1, com: [1e300, 0, 0]}
)");
  for (const std::string command : {"check ", "report "}) {
    const CommandResult result = alembert(folder, command + file);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err,
                testing::StartsWith(file + ":5:76: error: the equations of this mechanism have no value"));
    EXPECT_THAT(result.err,
                HasSubstr("note: a product of numbers is out of range; this one is the farthest"));
  }
}

// States are drawn a unit or so around the initial one.
TEST(Check, WhatHasNoValueThereIsNotMeasuredAndNoFailure) {
  const TemporaryFolder folder;
  const std::string beads = folder.write("beads.yaml", R"(alembert: 1
name: beads
coordinates: [a, b, c]
bodies:
  - {name: first, transform: [{translate: [a, 0, 'sqrt(1e-6 - a^2)']}], mass: 1}
  - {name: second, transform: [{translate: [b, 0, 'sqrt(1e-6 - b^2)']}], mass: 1}
  - {name: third, transform: [{translate: [c, 0, 'sqrt(1e-6 - c^2)']}], mass: 1}
)");
  CommandResult result = alembert(folder, "check " + beads);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, testing::ContainsRegex("Q = M qdd [+] c +- not measured\n"));
  EXPECT_THAT(result.out, testing::Not(HasSubstr(" ok")));

  const std::string lens = folder.write("lens.yaml", R"(alembert: 1
name: lens
coordinates: [{name: x, initial: 0.0005}, y]
bodies:
  - {name: bead, transform: [{translate: [x, y, 0]}], mass: 1}
constraints:
  - {name: lens, type: holonomic, equations: ['y - sqrt(1e-6 - x^2)']}
)");
  result = alembert(folder, "check " + lens);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, testing::ContainsRegex("Q = M qdd [+] c +[0-9.e+-]+ ok\n"));
  EXPECT_THAT(result.out, testing::ContainsRegex("d/dt position = velocity +- not measured\n"));
}

TEST(Check, WhatRoundingExplainsIsNoFailure) {
  const TemporaryFolder folder;
  const std::string file = folder.write("reducer.yaml", R"(alembert: 1
name: reducer
coordinates: [q]
bodies:
  - {name: rotor, transform: [{rotate: {axis: z, angle: 2.5e7*q}}], mass: 1, com: [0.1, 0, 0]}
  - {name: rod, parent: rotor, transform: [{rotate: {axis: x, angle: q}}], mass: 1, com: [0.1, 0.2, 0]}
)");
  const CommandResult result = alembert(folder, "check " + file);
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
}

TEST(Check, WarnsOfRedundantAndUnmetConstraints) {
  const TemporaryFolder folder;
  const std::string file = folder.write("loops.yaml", R"(alembert: 1
name: loops
coordinates: [x, {name: y, initial: 0.25}, z]
bodies:
  - {name: a, transform: [{translate: [x, y, z]}], mass: 1}
constraints:
  - {name: plane, type: holonomic, equations: ["x - sin(y)*z"]}
  - {name: line, type: holonomic, equations: ["x + y", "2*x + 2*y - 1/2"]}
)");
  const CommandResult result = alembert(folder, "check " + file);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("d/dt position = velocity"));
  EXPECT_THAT(result.out, HasSubstr("d/dt velocity = P qdd + gamma"));
  EXPECT_THAT(result.out, HasSubstr("rows 3, rank 2 at the initial state, free speeds 1"));
  EXPECT_THAT(result.out, testing::Not(HasSubstr("FAILS")));
  EXPECT_THAT(result.err, HasSubstr("loops.yaml:8:"));
  EXPECT_THAT(result.err, HasSubstr("warning: row 'line[1]' is redundant at the initial state"));
  EXPECT_THAT(result.err,
              HasSubstr("warning: row 'line[0]' does not hold at the initial state: it is off by 0.25"));
  EXPECT_THAT(result.err, testing::Not(HasSubstr("'plane'")));
}

TEST(Report, CountsConstraints) {
  const TemporaryFolder folder;
  const CommandResult result = alembert(folder, "report " + mechanism_file("paper/five_bar"));
  EXPECT_THAT(result.out, HasSubstr("2 rows of constraints"));
  EXPECT_THAT(result.out, testing::ContainsRegex("\nconstraints +[0-9]+"));
  EXPECT_THAT(alembert(folder, "report " + mechanism_file("pendulum")).out,
              testing::Not(HasSubstr("constraints")));
}

TEST(Options, DumpAndVerboseShowTheStages) {
  const TemporaryFolder folder;
  const std::string file = mechanism_file("pendulum");
  for (const char* stage : {"load", "kinematics", "equations", "lower", "optimise", "schedule"}) {
    const CommandResult result = alembert(folder, "report --json --dump " + std::string(stage) + " " + file);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_GT(result.out.find('{'), 20u) << stage;
  }
  const CommandResult result = alembert(folder, "report --verbose " + file);
  for (const char* stage : {"load", "kinematics", "equations", "program"})
    EXPECT_THAT(result.err, HasSubstr(stage));
}

TEST(Options, HelpHasCommonOnesFirstAndAnExample) {
  const TemporaryFolder folder;
  for (const std::string command :
       {"generate", "report", "bench", "evaluate", "simulate", "check", "import"}) {
    const std::string help = alembert(folder, command + " --help").out;
    EXPECT_THAT(help, HasSubstr("Example:\n"));
    EXPECT_THAT(help, HasSubstr("alembert " + command + " "));
    const std::size_t optimiser = help.find("For those who look into the optimiser");
    EXPECT_EQ(optimiser == std::string::npos, command == "import");
    if (optimiser == std::string::npos) continue;
    EXPECT_LT(optimiser, help.find("--effort"));
    EXPECT_LT(help.find("--strict"), optimiser);
    for (const char* common :
         {"--out-dir", "--functions", "--json", "--duration", "--html", "--stamp", "--states"}) {
      const std::size_t place = help.find(common);
      EXPECT_TRUE(place == std::string::npos || place < optimiser) << command << common;
    }
  }
  EXPECT_THAT(alembert(folder, "--help").out, HasSubstr("alembert simulate robot.yaml --html robot.html"));
}

TEST(Options, HelpNamesFlagsAsTheyAreGiven) {
  const TemporaryFolder folder;
  for (const std::string command : {"generate", "simulate", "import"})
    EXPECT_THAT(alembert(folder, command + " --help").out,
                testing::AllOf(HasSubstr("--no-friction "), testing::Not(HasSubstr("{false}"))));
}

TEST(Options, AMisspeltOneNamesTheNearest) {
  const TemporaryFolder folder;
  const auto said = [&](const std::string& arguments) {
    const CommandResult result = alembert(folder, arguments);
    EXPECT_EQ(result.exit_code, 1) << arguments;
    EXPECT_EQ(result.out, "") << arguments;
    return result.err;
  };
  const std::string file = mechanism_file("pendulum"), generate = "generate " + file + " --out-dir o ";
  for (const char* option : {"--languge c", "--languge=c", "--strict --languge c"})
    EXPECT_EQ(said(generate + option),
              "alembert: error: there is no option '--languge' (did you mean '--language'?)\n"
              "`alembert generate --help` lists them.\n");
  EXPECT_THAT(said("import --rot floating " + file), HasSubstr("'--rot' (did you mean '--root'?)"));
  EXPECT_THAT(said("check --sates 3"), HasSubstr("'--sates' (did you mean '--states'?)"));
  EXPECT_THAT(said("report -x " + file), HasSubstr("there is no option '-x'\n"));
  EXPECT_THAT(said("chek " + file), HasSubstr("there is no command 'chek' (did you mean 'check'?)\n"
                                              "`alembert --help` lists them."));
  EXPECT_THAT(said("--verison"), HasSubstr("there is no option '--verison' (did you mean '--version'?)"));
  EXPECT_THAT(said(file), HasSubstr("there is no command '"));
  EXPECT_THAT(said("check " + file + " more"), HasSubstr("more"));
}

TEST(Options, WrongUseExitsWithOne) {
  const TemporaryFolder folder;
  for (const char* arguments : {"", "nonsense", "report", "report --nonsense x.yaml", "generate x.yaml",
                                "report --formulation best x.yaml"}) {
    EXPECT_EQ(alembert(folder, arguments).exit_code, 1) << arguments;
  }
  EXPECT_EQ(alembert(folder, "--help").exit_code, 0);
  EXPECT_THAT(alembert(folder, "--version").out, testing::StartsWith("alembert "));
}

}  // namespace
}  // namespace alembert::test
