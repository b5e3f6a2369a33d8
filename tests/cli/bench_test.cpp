// `bench`: what is compiled and timed, and that nothing stays behind. Times themselves are the machine's affair.
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "commands/bench_states.hpp"
#include "emit/bench_program.hpp"
#include "functions/array_shape.hpp"
#include "mechanism/load.hpp"
#include "mechanism/source.hpp"

namespace alembert::test {
namespace {

using testing::HasSubstr;

/// Runs `bench` with temporary files in a folder of its own, which has to be empty afterwards.
CommandResult bench(const TemporaryFolder& folder, const std::string& arguments,
                    const std::string& input = "", int seconds = 60) {
  const std::string temporary = folder / "temporary";
  std::filesystem::create_directories(temporary);
  setenv("TMPDIR", temporary.c_str(), 1);
  CommandResult result = alembert(folder, "bench " + arguments, input, seconds);
  unsetenv("TMPDIR");
  EXPECT_TRUE(std::filesystem::is_empty(temporary)) << arguments;
  return result;
}

TEST(Bench, EveryFunctionHasOperationsCodeAndTime) {
  const TemporaryFolder folder;
  const CommandResult result = bench(
      folder,
      mechanism_file("double_pendulum") +
          " --functions inverse_dynamics,forward_dynamics --batch inverse_dynamics --states 8,100 --json");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const nlohmann::json out = nlohmann::json::parse(result.out);
  EXPECT_EQ(out["mechanism"], "double_pendulum");
  ASSERT_EQ(out["functions"].size(), 2u);
  const CommandResult report =
      alembert(folder, "report --json --functions inverse_dynamics,forward_dynamics " +
                           mechanism_file("double_pendulum"));
  const nlohmann::json counts = nlohmann::json::parse(report.out)["functions"];
  for (const auto& [name, row] : out["functions"].items()) {
    EXPECT_GT(row["median_ns"], 0) << name;
    EXPECT_GT(row["code_bytes"], 50) << name;
    for (const char* count : {"mul", "add", "div", "trig"})
      EXPECT_EQ(row[count], counts[name][count]) << name;
    double sum = 0;
    for (const auto& [what, share] : row["estimated_shares"].items()) sum += share.get<double>();
    EXPECT_NEAR(sum, 1, 1e-12) << name;
    EXPECT_GT(row["estimated_shares"]["trig"], 0) << name;
  }
  EXPECT_GT(out["functions"]["forward_dynamics"]["estimated_shares"]["division"], 0);
  EXPECT_EQ(out["functions"]["inverse_dynamics"]["estimated_shares"]["division"], 0);
  EXPECT_FALSE(out["functions"]["forward_dynamics"].contains("batch"));
  EXPECT_EQ(out["states"], (std::vector<int>{8, 100}));
  for (const char* times : {"median_ns", "one_by_one_ns"}) {
    const nlohmann::json& of_states = out["functions"]["inverse_dynamics"]["batch"][times];
    ASSERT_EQ(of_states.size(), 2u);
    for (const nlohmann::json& time : of_states) EXPECT_GT(time, 0);
  }
  EXPECT_GT(out["functions"]["inverse_dynamics"]["batch"]["code_bytes"], 50);
  EXPECT_THAT(out["instructions"].get<std::string>(), testing::MatchesRegex("baseline|avx2|avx512"));

  // The flags are those that CMake compiles with.
  const std::string cmake = read_text(ALEMBERT_SOURCE_DIR "/cmake/AlembertAddMechanism.cmake");
  for (const auto& flag : out["flags"])
    EXPECT_THAT(cmake,
                HasSubstr(flag.get<std::string>().substr(flag.get<std::string>().starts_with("-D") ? 2 : 0)));
}

TEST(Bench, ARobotInAnotherFormatIsImported) {
  const TemporaryFolder folder;
  const std::string arm = ALEMBERT_SOURCE_DIR "/mechanisms/examples/controller/arm.urdf";
  const CommandResult named = bench(folder, arm + " --functions gravity");
  ASSERT_EQ(named.exit_code, 0) << named.err;
  EXPECT_THAT(named.out, HasSubstr("arm: 3 coordinates, 3 speeds"));
  EXPECT_THAT(named.out,
              testing::ContainsRegex("\ngravity +[0-9]+ +[0-9]+ +[0-9]+ +[0-9]+ +[0-9]+ +[0-9]+ +[0-9.e+]+ +"
                                     "[0-9]+%"));
  EXPECT_THAT(named.out, HasSubstr("ESTIMATE"));
}

TEST(Bench, ACompilerThatFailsIsAnErrorAndNoShellReadsItsName) {
  const TemporaryFolder folder;
  const std::string start = mechanism_file("pendulum") + " --functions gravity --compiler ";
  const CommandResult missing = bench(folder, start + "'no_such_compiler -x; touch " + folder / "made" + "'");
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_THAT(missing.err, HasSubstr("--compiler:1:1: error: cannot compile C++: no_such_compiler"));
  EXPECT_FALSE(std::filesystem::exists(folder / "made"));
  const CommandResult failing = bench(folder, start + "'c++ --no-such-flag'");
  EXPECT_EQ(failing.exit_code, 1);
  EXPECT_THAT(failing.err, HasSubstr("no-such-flag"));
  EXPECT_EQ(bench(folder, start + "true").exit_code, 1) << "compiles nothing";
  setenv("CXX", "false", 1);
  const CommandResult variable = bench(folder, mechanism_file("pendulum") + " --functions gravity");
  unsetenv("CXX");
  EXPECT_EQ(variable.exit_code, 1);
  EXPECT_THAT(variable.err, HasSubstr("CXX:1:1: error: cannot compile C++"));
}

TEST(Bench, ShowsTheFlagsInTheirOrder) {
  const TemporaryFolder folder;
  const std::string compiler = folder.write(
      "compiler", "#!/bin/sh\necho \"$0 $*\" >> '" + folder / "commands" + "'\nexec c++ \"$@\"\n");
  std::filesystem::permissions(compiler, std::filesystem::perms::owner_all);
  const CommandResult shown =
      bench(folder, mechanism_file("pendulum") + " --functions gravity --compiler '" + compiler + " -O1'");
  ASSERT_EQ(shown.exit_code, 0) << shown.err;
  const std::size_t begin = shown.out.find(compiler);
  ASSERT_NE(begin, std::string::npos);
  const std::string command = shown.out.substr(begin, shown.out.find('\n', begin) - begin);
  EXPECT_THAT(command, testing::EndsWith(" -O1"));
  EXPECT_THAT(read_text(folder / "commands"), HasSubstr("\n" + command + " -std=c++17 "));
}

TEST(Bench, NothingStaysWhenItIsAskedToEnd) {
  const TemporaryFolder folder;
  const std::string compiler =
      folder.write("compiler", "#!/bin/sh\necho started > '" + folder / "started" + "'\nsleep 100\n");
  std::filesystem::permissions(compiler, std::filesystem::perms::owner_all);
  const CommandResult ended =
      bench(folder, mechanism_file("pendulum") + " --functions gravity --compiler '" + compiler + "'", "", 2);
  EXPECT_EQ(ended.exit_code, 124);
  EXPECT_TRUE(std::filesystem::exists(folder / "started"));
}

TEST(Bench, StatesAreWithinLimitsAndQuaternionsHaveNorm1) {
  constexpr std::size_t kStates = 100;
  for (const char* name : {"tree_every_joint", "puma560", "free_body"}) {
    ExprGraph graph;
    const Mechanism mechanism = load_mechanism(read_source(mechanism_file(name)), graph);
    const std::vector<std::vector<double>> arrays = bench_states(mechanism, kStates);
    const std::vector<ArgumentKind> kinds = bench_arguments();
    ASSERT_EQ(arrays.size(), kinds.size());
    const auto nq = static_cast<std::size_t>(mechanism.nq);
    for (std::size_t a = 0; a < kinds.size(); ++a) {
      EXPECT_EQ(arrays[a].size(), kStates * argument_size(kinds[a], mechanism)) << name;
      for (const double x : arrays[a]) EXPECT_TRUE(std::isfinite(x)) << name;
    }
    ASSERT_EQ(kinds[0], ArgumentKind::q);
    for (const Coordinate& coordinate : mechanism.coordinates) {
      double smallest = 0, largest = 0;
      for (std::size_t s = 0; s < kStates; ++s) {
        const double* const q = arrays[0].data() + s * nq + coordinate.first_q;
        if (coordinate.type == CoordinateType::quaternion) {
          EXPECT_NEAR(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1, 1e-14) << name;
        } else if (coordinate.limits) {
          EXPECT_GE(*q, coordinate.limits->first) << name;
          EXPECT_LE(*q, coordinate.limits->second) << name;
        }
        smallest = s == 0 ? *q : std::min(smallest, *q);
        largest = s == 0 ? *q : std::max(largest, *q);
      }
      EXPECT_LT(smallest, largest) << name << ": " << coordinate.name;
    }
  }
}

}  // namespace
}  // namespace alembert::test
