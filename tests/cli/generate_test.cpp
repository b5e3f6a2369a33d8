// `generate`: what it writes, lists, checks and leaves alone.
#include <gmock/gmock.h>

#include "cli/command.hpp"

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

TEST(Generate, UnknownFunctionNamesTheNearest) {
  const TemporaryFolder folder;
  const CommandResult result = alembert(folder, "generate " + mechanism_file("pendulum") +
                                                    " --functions mass_matrx --out-dir " + (folder / "out"));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("mass_matrix"));
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
