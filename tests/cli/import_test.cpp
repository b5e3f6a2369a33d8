// `import`: URDF in, a description out, on standard output or in a file; what is wrong leaves nothing behind.
#include <gmock/gmock.h>

#include "cli/command.hpp"

namespace alembert::test {
namespace {

const std::string kRobot = ALEMBERT_SOURCE_DIR "/tests/urdf/robots/every_joint.urdf";

TEST(Import, WritesADescriptionThatOtherCommandsRead) {
  const TemporaryFolder folder;
  const std::string file = folder / "robot.yaml";
  EXPECT_EQ(alembert(folder, "import " + kRobot + " --out " + file).exit_code, 0);
  const CommandResult printed = alembert(folder, "import " + kRobot);
  EXPECT_EQ(printed.exit_code, 0);
  EXPECT_EQ(printed.out, read_text(file));
  EXPECT_EQ(alembert(folder, "import -", read_text(kRobot)).out, printed.out);
  const CommandResult checked = alembert(folder, "check " + file);
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  EXPECT_THAT(checked.out, testing::HasSubstr("every_joint: 13 coordinates, 12 speeds, 9 bodies"));
}

TEST(Import, TakesAFloatingRoot) {
  const TemporaryFolder folder;
  const CommandResult result = alembert(folder, "import " + kRobot + " --root floating");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, testing::HasSubstr("{name: base_rotation, type: quaternion}"));
}

TEST(Import, SnapsAngles) {
  const TemporaryFolder folder;
  const std::string names = ALEMBERT_SOURCE_DIR "/tests/urdf/robots/names.urdf";
  const CommandResult result = alembert(folder, "import --snap-angles 1e-3 " + names);
  EXPECT_THAT(result.out, testing::HasSubstr("rotate: {axis: z, angle: pi/2}"));
}

TEST(Import, SaysWhatIsDoubtful) {
  const TemporaryFolder folder;
  const std::string names = ALEMBERT_SOURCE_DIR "/tests/urdf/robots/names.urdf";
  const CommandResult result = alembert(folder, "import " + names);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err, testing::HasSubstr("names.urdf:16:5: warning: 1 angle is nearly a right angle"));
}

TEST(Import, LeavesNothingOfWhatIsWrong) {
  const TemporaryFolder folder;
  const std::string bad = ALEMBERT_SOURCE_DIR "/tests/urdf/errors/bad_cycle.urdf",
                    file = folder / "robot.yaml";
  const CommandResult result = alembert(folder, "import " + bad + " --out " + file);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, testing::StartsWith(bad + ":7:16: error: "));
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_EQ(alembert(folder, "import " + bad).out, "");
}

TEST(Import, IsDoneInSecondsWhateverIsNested) {
  const TemporaryFolder folder;
  std::string deep = "<robot name='r'>", wide = deep;
  for (int i = 0; i < 200'000; ++i) deep += "<link name='a'>";
  for (int i = 0; i < 20'000; ++i) {
    const std::string n = std::to_string(i);
    wide += "<link name='l" + n + "'/>";
    if (i > 0)
      wide += "<joint name='j" + n + "' type='revolute'><parent link='l" + std::to_string(i - 1) +
              "'/><child link='l" + n + "'/><mimic joint='j" + std::to_string(i - 1) + "'/></joint>";
  }
  for (const std::string& text : {deep, wide + "</robot>"}) {
    const CommandResult result = alembert(folder, "import " + folder.write("deep.urdf", text));
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, testing::HasSubstr(": error: "));
  }
}

}  // namespace
}  // namespace alembert::test
