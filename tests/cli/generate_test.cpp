// `generate`: what it writes, lists, checks and leaves alone.
#include <gmock/gmock.h>

#include <map>

#include "cli/command.hpp"
#include "rounds.hpp"

namespace alembert::test {
namespace {

using testing::HasSubstr;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(Generate, WritesWhatItLists) {
  const TemporaryFolder folder;
  const std::string arguments = "generate " + mechanism_file("pendulum") + " --out-dir " + (folder / "out");
  const CommandResult list = alembert(folder, arguments + " --print-outputs");
  ASSERT_EQ(list.exit_code, 0) << list.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  ASSERT_EQ(alembert(folder, arguments).exit_code, 0);
  const std::vector<std::string> files = lines_of(list.out);
  ASSERT_FALSE(files.empty());
  std::size_t on_disk = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "out"))
    on_disk += entry.is_regular_file() ? 1 : 0;
  EXPECT_EQ(on_disk, files.size());
  for (const std::string& file : files) EXPECT_TRUE(std::filesystem::exists(file)) << file;
}

TEST(Generate, CIsOneHeaderAndOneSource) {
  const TemporaryFolder folder;
  const std::string arguments =
      "generate " + mechanism_file("pendulum") + " --language c --out-dir " + (folder / "out");
  const CommandResult list = alembert(folder, arguments + " --print-outputs");
  EXPECT_EQ(list.out, (folder / "out/include/pendulum/pendulum.h\n") + (folder / "out/src/pendulum.c\n"));
  ASSERT_EQ(alembert(folder, arguments).exit_code, 0);
  EXPECT_EQ(alembert(folder, arguments + " --check").exit_code, 0);
  EXPECT_THAT(read_text(folder / "out/src/pendulum.c"), HasSubstr("const double* restrict q"));
  EXPECT_EQ(alembert(folder, arguments + " --scalars float --check").exit_code, 1);
  for (const char* option : {"--namespace a", "--batch default", "--batch-instructions avx2", "--parts 2"}) {
    const CommandResult refused = alembert(folder, arguments + " " + option);
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_THAT(refused.err, HasSubstr("--language c"));
  }
  const CommandResult both = alembert(folder, arguments + " --scalars double,float");
  EXPECT_EQ(both.exit_code, 1);
  EXPECT_THAT(both.err, HasSubstr("C is written for one scalar type"));
  EXPECT_EQ(alembert(folder, arguments + " --language pascal").exit_code, 1);
}

TEST(Generate, JavaScriptIsOneModule) {
  const TemporaryFolder folder;
  const std::string arguments =
      "generate " + mechanism_file("pendulum") + " --language javascript --out-dir " + (folder / "out");
  EXPECT_EQ(alembert(folder, arguments + " --print-outputs").out, (folder / "out/javascript/pendulum.mjs\n"));
  ASSERT_EQ(alembert(folder, arguments).exit_code, 0);
  EXPECT_EQ(alembert(folder, arguments + " --check").exit_code, 0);
  EXPECT_THAT(read_text(folder / "out/javascript/pendulum.mjs"),
              HasSubstr("\nexport {\n  name, version, nq"));
  for (const char* option : {"--scalars float", "--batch default", "--parts 2", "--namespace a"})
    EXPECT_EQ(alembert(folder, arguments + " " + option).exit_code, 1) << option;
}

TEST(Generate, TouchesNothingThatIsUpToDate) {
  const TemporaryFolder folder;
  const std::string arguments = "generate " + mechanism_file("pendulum") + " --out-dir " + (folder / "out");
  ASSERT_EQ(alembert(folder, arguments).exit_code, 0);
  const std::string header = folder / "out/include/pendulum/pendulum.hpp";
  const auto before = std::filesystem::last_write_time(header);
  ASSERT_EQ(alembert(folder, arguments).exit_code, 0);
  EXPECT_EQ(std::filesystem::last_write_time(header), before);
}

TEST(Generate, CheckReportsDrift) {
  const TemporaryFolder folder;
  const std::string arguments = "generate " + mechanism_file("pendulum") + " --out-dir " + (folder / "out");
  EXPECT_EQ(alembert(folder, arguments + " --check").exit_code, 1);
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  ASSERT_EQ(alembert(folder, arguments).exit_code, 0);
  EXPECT_EQ(alembert(folder, arguments + " --check").exit_code, 0);
  const std::string header = folder / "out/include/pendulum/pendulum.hpp";
  std::ofstream(header, std::ios::app) << "// edited\n";
  const CommandResult drift = alembert(folder, arguments + " --check");
  EXPECT_EQ(drift.exit_code, 1);
  EXPECT_THAT(drift.err, HasSubstr("pendulum.hpp:1:1: error:"));
  EXPECT_THAT(read_text(header), HasSubstr("// edited"));
}

TEST(Generate, CheckDoesNotListInstead) {
  const TemporaryFolder folder;
  const CommandResult result = alembert(folder, "generate " + mechanism_file("pendulum") +
                                                    " --check --print-outputs --out-dir " + (folder / "out"));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, HasSubstr("--print-outputs excludes --check"));
}

TEST(Generate, DryRunWritesNothing) {
  const TemporaryFolder folder;
  const CommandResult result =
      alembert(folder, "generate " + mechanism_file("pendulum") + " --dry-run --out-dir " + (folder / "out"));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err, HasSubstr("created"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST(Generate, SameBytesWhereverAndWheneverItRuns) {
  const TemporaryFolder folder;
  const std::string copy = folder.write("other name.yaml", read_text(mechanism_file("tree_every_joint")));
  ASSERT_EQ(
      alembert(folder, "generate " + mechanism_file("tree_every_joint") + " --out-dir " + (folder / "a"))
          .exit_code,
      0);
  ASSERT_EQ(alembert(folder, "generate '" + copy + "' --out-dir " + (folder / "b")).exit_code, 0);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "a")) {
    if (!entry.is_regular_file()) continue;
    const std::string other =
        folder / ("b/" + std::filesystem::relative(entry.path(), folder / "a").string());
    EXPECT_EQ(read_text(entry.path().string()), read_text(other)) << other;
  }
}

TEST(Generate, DepfileNamesTheStampAndTheDescription) {
  const TemporaryFolder folder;
  const std::string stamp = folder / "s.stamp";
  const CommandResult result =
      alembert(folder, "generate " + mechanism_file("pendulum") + " --out-dir " + (folder / "out") +
                           " --depfile " + (folder / "s.d") + " --stamp " + stamp);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(std::filesystem::exists(stamp));
  EXPECT_THAT(read_text(folder / "s.d"), testing::StartsWith(stamp + ":"));
  EXPECT_THAT(read_text(folder / "s.d"), HasSubstr("pendulum.yaml"));
}

TEST(Generate, DepfileNamesWhatARobotIsReadFrom) {
  const TemporaryFolder folder;
  const auto dependencies = [&](const std::string& file) {
    const CommandResult result = alembert(
        folder, "generate " ALEMBERT_SOURCE_DIR "/tests/" + file + " --functions body_poses --out-dir " +
                    (folder / "out") + " --depfile " + (folder / "s.d") + " --stamp " + (folder / "s"));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return read_text(folder / "s.d");
  };
  EXPECT_THAT(dependencies("mjcf/models/classes.xml"),
              testing::AllOf(HasSubstr("mjcf/models/classes.xml"), HasSubstr("mjcf/models/parts/leg.xml")));
  EXPECT_THAT(dependencies("mjcf/models/inertia.xml"), HasSubstr("mjcf/models/meshes/block.stl"));
  EXPECT_THAT(dependencies("sdf/models/middle.sdf"), HasSubstr("sdf/models/parts/wheel.sdf"));
}

TEST(Generate, DepfileOfStandardInputNamesNoFile) {
  const TemporaryFolder folder;
  const CommandResult result = alembert(folder,
                                        "generate - --out-dir " + (folder / "out") + " --depfile " +
                                            (folder / "s.d") + " --stamp " + (folder / "s"),
                                        read_text(mechanism_file("pendulum")));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(read_text(folder / "s.d"), (folder / "s") + ":\n");
}

TEST(Generate, WithoutDepfileOrStampThereIsNoCodeEither) {
  const TemporaryFolder folder;
  const std::string command = "generate " + mechanism_file("pendulum") + " --out-dir " + (folder / "out");
  for (const std::string& options : {" --stamp " + (folder / "s") + " --depfile " + (folder / "none/s.d"),
                                     " --depfile " + (folder / "s.d") + " --stamp " + (folder / "none/s"),

                                     " --stamp " + (folder / "s") + " --depfile /dev/full",
                                     " --depfile " + (folder / "s") + " --stamp " + (folder / "s")}) {
    const CommandResult result = alembert(folder, command + options);
    EXPECT_EQ(result.exit_code, 1) << options;
    for (const char* file : {"out", "s", "s.d"})
      EXPECT_FALSE(std::filesystem::exists(folder / file)) << options;
  }
  const std::string copy = folder.write("copy.yaml", read_text(mechanism_file("pendulum")));
  EXPECT_THAT(
      alembert(folder, "generate " + copy + " --out-dir " + (folder / "out") + " --stamp " + copy).err,
      HasSubstr("the description and --stamp are the same file"));
  EXPECT_NE(read_text(copy), "");
}

/// A mechanism whose every file depends on the mass, and everything that is generated of it.
struct Version {
  std::string file;
  std::map<std::string, std::string> texts;
};
std::map<std::string, std::string> texts_below(const std::string& path) {
  std::map<std::string, std::string> out;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path))
    if (entry.is_regular_file())
      out[std::filesystem::relative(entry.path(), path).string()] = read_text(entry.path().string());
  return out;
}
std::vector<Version> two_versions(const TemporaryFolder& folder) {
  std::vector<Version> out;
  for (const std::string mass : {"2", "3"}) {
    const std::string file = folder.write("arm" + mass + ".yaml", R"(alembert: 1
name: arm
coordinates: [{name: q, initial: )" + mass + R"(}]
parameters: {k: {value: 1, runtime: true}}
bodies:
  - {name: bob)" + mass + R"(, transform: [{rotate: {axis: y, angle: q}}], mass: )" +
                                                                      mass + R"(, com: [k, 0, 0]}
)");
    const std::string fresh = folder / ("fresh" + mass);
    EXPECT_EQ(alembert(folder, "generate " + file + " --parts 4 --out-dir " + fresh).exit_code, 0);
    out.push_back({file, texts_below(fresh)});
  }
  EXPECT_NE(out[0].texts, out[1].texts);
  return out;
}

// tests/emit/test_locked_folder.cpp kills at every system call; here the program as it is used.
TEST(Generate, KilledRunsLeaveNothingToTheNext) {
  const TemporaryFolder folder;
  const std::vector<Version> versions = two_versions(folder);
  const std::string out = folder / "out", command = ALEMBERT_EXECUTABLE " generate ";
  const int trials = rounds(120);
  // Killed at any time of a run, however long runs take here.
  const std::string script = folder.write("killed.sh", R"(
start=$(date +%s%N)
)" + command + versions[0].file + " --parts 4 --out-dir " + (folder / "timed") +
                                                           R"(
span=$(((($(date +%s%N) - start) / 1000000 + 2) * 3 / 2))
for i in $(seq )" + std::to_string(trials) + R"(); do
  )" + command + "$(if [ $((i % 2)) = 0 ]; then echo " + versions[0].file +
                                                           "; else echo " + versions[1].file +
                                                           "; fi) --parts 4 --out-dir " + out + R"( &
  delay=$((RANDOM % span))
  sleep $((delay / 1000)).$(printf %03d $((delay % 1000)))
  kill -KILL $! 2> /dev/null
  wait $! 2> /dev/null
  )" + command + mechanism_file("pendulum") + " --out-dir " +
                                                           out + R"( || exit 1
  cp -r )" + out + " " + folder / "trial" + "$i\ndone\n");
  ASSERT_EQ(run_command(folder, "bash " + script, "", 240).exit_code, 0);
  std::size_t files = 0;
  for (int i = 1; i <= trials; ++i) {
    std::map<std::string, std::string> texts = texts_below(folder / ("trial" + std::to_string(i)));
    std::erase_if(texts, [](const auto& text) { return text.first.find("pendulum") != std::string::npos; });
    ASSERT_TRUE(texts.empty() || texts == versions[0].texts || texts == versions[1].texts) << i;
    files += texts.size();
  }
  EXPECT_GT(files, 0u);
}

TEST(Generate, RunsAtTheSameTimeDoNotMix) {
  const TemporaryFolder folder;
  const std::vector<Version> versions = two_versions(folder);
  for (int i = 0; i < rounds(40); ++i) {
    std::string both = "sh -c '";
    for (const Version& version : versions)
      both += ALEMBERT_EXECUTABLE " generate " + version.file + " --parts 4 --out-dir " + (folder / "out") +
              " & ";
    ASSERT_EQ(run_command(folder, both + "wait'", "", 20).exit_code, 0);
    const std::map<std::string, std::string> texts = texts_below(folder / "out");
    ASSERT_TRUE(texts == versions[0].texts || texts == versions[1].texts) << i;
  }
}

TEST(Generate, UnknownFunctionNamesThoseNearAndTheList) {
  const TemporaryFolder folder;
  const auto error = [&](const std::string& function) {
    const CommandResult result = alembert(folder, "generate " + mechanism_file("pendulum") + " --functions " +
                                                      function + " --out-dir " + (folder / "out"));
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr("note: `--functions help` lists them"));
    return result.err;
  };
  EXPECT_THAT(error("mass_matrx"), HasSubstr("'mass_matrx' (did you mean 'mass_matrix'?)\n"));
  EXPECT_THAT(error("mass"), HasSubstr("'mass' (near ones: mass_matrix, mass_matrix_and_bias"));
  EXPECT_THAT(error("bogus"), HasSubstr("'bogus'\n"));
}

TEST(Generate, HeadersExplainWhatIsThere) {
  const TemporaryFolder folder;
  const std::pair<const char*, const char*> files[] = {{"c++", "include/{}/{}_raw.hpp"},
                                                       {"c", "include/{}/{}.h"},
                                                       {"python", "python/{}.py"},
                                                       {"javascript", "javascript/{}.mjs"},
                                                       {"cuda", "cuda/{}.cuh"}};
  const auto text = [&](const std::string& language, std::string path, const std::string& name,
                        const std::string& function) {
    for (std::size_t at; (at = path.find("{}")) != std::string::npos;) path.replace(at, 2, name);
    const CommandResult result =
        alembert(folder, "generate " + mechanism_file(name) + " --language " + language + " --functions " +
                             function + " --effort 0 --out-dir " + (folder / language));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return read_text(folder / language + "/" + path);
  };
  // The line of an argument of the state in comments.
  const auto line = [](const std::string& argument) {
    return testing::ContainsRegex("\n[ /*]+" + argument + " +[[(]");
  };
  using testing::Not;
  for (const auto& [language, path] : files) {
    const std::string forces = text(language, path, "pendulum", "inverse_dynamics");
    EXPECT_THAT(forces, testing::AllOf(line("q"), line("qd"), line("qdd"), line("tau"), Not(line("mu"))))
        << language;
    EXPECT_THAT(text(language, path, "pendulum", "mass_matrix"),
                testing::AllOf(line("q"), Not(line("qdd")), Not(line("tau"))))
        << language;
    EXPECT_THAT(text(language, path, "pendulum", "inverse_dynamics_second_derivatives"), line("mu"))
        << language;
    EXPECT_THAT(forces, Not(HasSubstr("::NAME), frame_poses"))) << language;
    EXPECT_THAT(forces, Not(HasSubstr("Wrench::NAME"))) << language;
  }
  EXPECT_THAT(text("c++", files[0].second, "tree_every_joint", "frame_poses"),
              testing::AllOf(HasSubstr("frame_poses(q)[Frame::NAME]"), HasSubstr("6 * Wrench::NAME"),
                             HasSubstr("Of a quaternion")));
}

TEST(Generate, AFunctionGivenTwiceIsAnError) {
  const TemporaryFolder folder;
  const CommandResult result =
      alembert(folder, "generate " + mechanism_file("pendulum") +
                           " --functions energy,bias,energy --out-dir " + (folder / "out"));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("energy is given twice"));
}

TEST(Generate, AFolderThatCannotBeMadeIsAnError) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "text");
  const CommandResult result =
      alembert(folder, "generate " + mechanism_file("pendulum") + " --out-dir " + file + "/out");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, testing::StartsWith(file + "/out"));
  EXPECT_THAT(result.err, HasSubstr(":1:1: error: "));
  EXPECT_EQ(read_text(file), "text");
}

TEST(Generate, AFullDiskLeavesNothing) {
  const TemporaryFolder folder;
  const std::string disk = folder / "disk";
  std::filesystem::create_directories(disk);
  if (std::system(("mount -t tmpfs -o size=16k tmpfs '" + disk + "' 2>/dev/null").c_str()) != 0)
    GTEST_SKIP() << "no small disk can be made here";
  const CommandResult result =
      alembert(folder, "generate " + mechanism_file("chain6r") + " --out-dir " + disk + "/out");
  std::size_t left = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(disk))
    left += entry.is_regular_file() ? 1 : 0;
  ASSERT_EQ(std::system(("umount '" + disk + "'").c_str()), 0);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr(":1:1: error: "));
  EXPECT_EQ(left, 0u);
}

}  // namespace
}  // namespace alembert::test
