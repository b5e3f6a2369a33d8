// No input crashes, hangs or leaves anything half-written: one error that begins FILE:LINE:COL, exit code 1.
#include <gmock/gmock.h>

#include <functional>

#include "cli/command.hpp"

namespace alembert::test {
namespace {

struct BadFile {
  const char* name;
  std::function<std::string()> text;
  const char* place;  ///< LINE:COL, or LINE: alone
};

void PrintTo(const BadFile& file, std::ostream* out) {
  *out << file.name;
}

std::string repeat(const std::string& text, std::size_t times) {
  std::string out;
  out.reserve(text.size() * times);
  for (std::size_t i = 0; i < times; ++i) out += text;
  return out;
}

std::string named(const std::string& name) {
  return "alembert: 1\nname: " + name +
         "\ncoordinates: [q]\nbodies:\n  - {name: a, transform: [{rotate: {axis: z, angle: q}}], mass: 1, "
         "inertia: {xx: 1, yy: 1, zz: 1}}\n";
}
std::string with_mass(const std::string& mass) {
  return "alembert: 1\nname: m\ncoordinates: [q]\nbodies:\n  - {name: a, transform: [{rotate: {axis: z, "
         "angle: q}}], mass: " +
         mass + ", inertia: {xx: 1, yy: 1, zz: 1}}\n";
}

class BadInput : public testing::TestWithParam<BadFile> {};

TEST_P(BadInput, IsOnePlacedErrorAndLeavesNothing) {
  const TemporaryFolder folder;
  const std::string file = folder.write("bad.yaml", GetParam().text());
  const std::string out = folder / "out";
  const CommandResult result = alembert(folder, "generate " + file + " --out-dir " + out);
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_THAT(result.err, testing::StartsWith(file + ":" + GetParam().place));
  EXPECT_THAT(result.err, testing::HasSubstr(": error: "));
  EXPECT_LT(result.err.size(), 4000u);
  EXPECT_EQ(result.out, "");
  EXPECT_FALSE(std::filesystem::exists(out) && !std::filesystem::is_empty(out));
}

INSTANTIATE_TEST_SUITE_P(
    Files, BadInput,
    testing::Values(
        BadFile{"empty", [] { return std::string(); }, "1:1:"},
        BadFile{"blank", [] { return std::string("\n\n"); }, "1:1:"},
        BadFile{"huge", [] { return "# " + std::string(100'000'000, 'x'); }, "1:1:"},
        BadFile{"deep_flow", [] { return "a: " + repeat("[", 10'000) + repeat("]", 10'000); }, "1:"},
        BadFile{"deep_block",
                [] {
                  std::string text;
                  for (int i = 0; i < 10'000; ++i)
                    text += std::string(static_cast<std::size_t>(i % 200), ' ') + "- \n";
                  return text;
                },
                ""},
        BadFile{"deep_expression",
                [] { return with_mass("\"" + repeat("(", 10'000) + "1" + repeat(")", 10'000) + "\""); },
                "5:"},
        BadFile{"long_sum", [] { return with_mass("\"-" + repeat("1+", 200'000) + "1 - 1e9\""); }, "5:"},
        BadFile{"binary",
                [] {
                  return std::string(
                      "\x7f"
                      "ELF\x00\x01\x02\xff\xfe",
                      10);
                },
                "1:"},
        BadFile{"keyword", [] { return named("class"); }, "2:7:"},
        BadFile{"quote", [] { return named("'a\"b'"); }, "2:7:"},
        BadFile{"newline", [] { return named("\"a\\nb\""); }, "2:7:"},
        BadFile{"comment", [] { return named("'a*/b'"); }, "2:7:"},
        BadFile{"comma", [] { return with_mass("\"1,5\""); }, "5:"},
        BadFile{"infinite", [] { return with_mass("1e999"); }, "5:"},
        BadFile{"nan", [] { return with_mass("nan"); }, "5:"},
        BadFile{"negative", [] { return with_mass("-1"); }, "5:"},
        BadFile{"bomb",
                [] {
                  std::string text = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
                  for (int i = 1; i < 12; ++i) {
                    text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" +
                            repeat("*a" + std::to_string(i - 1) + ", ", 9) + "*a" + std::to_string(i - 1) +
                            "]\n";
                  }
                  return text;
                },
                ""}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(StandardOutput, ThatCannotBeWrittenIsAnError) {
  const TemporaryFolder folder;
  const std::string file = mechanism_file("pendulum");
  for (const std::string& arguments :
       {"report " + file, "evaluate " + file, "check " + file, "simulate " + file,
        "generate --print-outputs --out-dir out " + file, "report --dump equations " + file,
        std::string("import " ALEMBERT_SOURCE_DIR "/tests/urdf/robots/every_joint.urdf"),
        std::string("--help")}) {
    const CommandResult result =
        run_command(folder, "sh -c '" ALEMBERT_EXECUTABLE " " + arguments + " > /dev/full'", "{}\n", 10);
    EXPECT_EQ(result.exit_code, 1) << arguments;
    EXPECT_THAT(result.err, testing::HasSubstr("error: cannot write")) << arguments;
  }
}

// Exit codes are the same where nobody listens: standard error on a full disk, closed, or a pipe without
// reader.
TEST(StandardError, ThatCannotBeWrittenChangesNoExitCode) {
  const TemporaryFolder folder;
  const std::string file = mechanism_file("pendulum"), missing = folder / "missing.yaml";
  const std::string noted = mechanism_file("paper/five_bar"), out = folder / "out";
  const struct {
    std::string arguments;
    int exit_code;
  } cases[] = {{"generate " + missing + " --out-dir " + out, 1},
               {"report " + missing, 1},
               {"evaluate " + missing, 1},
               {"simulate " + missing, 1},
               {"check " + missing, 1},
               {"import " + missing, 1},
               {"report --effort nan " + file, 1},
               {"generate --verbose " + file + " --out-dir " + out, 0},
               {"generate --dry-run " + file + " --out-dir " + out, 0},
               {"generate --check " + file + " --out-dir " + folder / "other", 1},
               {"simulate --duration 0.01 " + noted, 0},
               {"check " + noted, 0}};
  for (const auto& [arguments, exit_code] : cases) {
    for (const std::string stream : {"2> /dev/full", "2>&-", "2> >(true)"}) {
      const CommandResult result = run_command(
          folder, "bash -c '" ALEMBERT_EXECUTABLE " " + arguments + " > /dev/null " + stream + "'", "{}\n",
          10);
      EXPECT_EQ(result.exit_code, exit_code) << arguments << ' ' << stream;
    }
  }
  // A file that is written never becomes standard error.
  EXPECT_EQ(run_command(folder,
                        "bash -c '" ALEMBERT_EXECUTABLE " simulate --duration 0.01 --csv " +
                            folder / "a.csv" + " " + noted + " 2>&-'",
                        "", 10)
                .exit_code,
            0);
  EXPECT_THAT(read_text(folder / "a.csv"), testing::StartsWith("t,"));
}

TEST(StandardOutput, ThatIsClosedIsAnError) {
  const TemporaryFolder folder;
  const CommandResult result = run_command(
      folder, "bash -c '" ALEMBERT_EXECUTABLE " report " + mechanism_file("pendulum") + " >&-'", "", 10);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, testing::HasSubstr("error: cannot write"));
}

TEST(BadFile, MissingFileAndFolder) {
  const TemporaryFolder folder;
  for (const std::string& file : {folder / "missing.yaml", std::string("/tmp")}) {
    const CommandResult result = alembert(folder, "report " + file);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, testing::StartsWith(file + ":1:1: error: "));
  }
}

}  // namespace
}  // namespace alembert::test
