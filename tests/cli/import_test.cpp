// `import`: URDF in, a description out, on standard output or in a file; what is wrong leaves nothing behind.
#include <gmock/gmock.h>

#include "cli/command.hpp"

namespace alembert::test {
namespace {

const std::string kRobot = ALEMBERT_SOURCE_DIR "/tests/urdf/robots/every_joint.urdf";
const std::string kModel = ALEMBERT_SOURCE_DIR "/tests/mjcf/models/tendons.xml";

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

TEST(Import, IsWhatOtherCommandsDoBeforeTheyBegin) {
  const TemporaryFolder folder;
  const std::string file = folder / "robot.yaml";
  for (const std::string& robot : {kRobot, kModel}) {
    ASSERT_EQ(alembert(folder, "import " + robot + " --out " + file).exit_code, 0);
    for (const std::string command : {"report --functions mass_matrix ", "check "}) {
      const CommandResult direct = alembert(folder, command + robot);
      EXPECT_EQ(direct.exit_code, 0) << direct.err;
      EXPECT_EQ(direct.out, alembert(folder, command + file).out);
    }
  }
}

TEST(Import, SaysWhatItTookAndLeft) {
  const TemporaryFolder folder;
  const std::string tests = ALEMBERT_SOURCE_DIR "/tests/";
  for (const auto& [file, said] :
       {std::pair(kModel,
                  "note: taken: 2 bodies, 4 frames, 3 coordinates, 2 inputs, 9 forces, 2 outputs; left out: "
                  "contacts,"),
        std::pair(
            kRobot,
            "note: taken: 9 bodies, 1 frame, 10 coordinates, 2 definitions; left out: 1 collision, 1 gazebo"),
        std::pair(tests + "sdf/models/frames.sdf",
                  "note: taken: 5 bodies, 2 frames, 7 coordinates, 1 definition, 2 forces\n"),
        std::pair(tests + "osim/doubtful/left_out.osim",
                  "4 forces, 1 output; approximated: 1 ConditionalPathPoint, 1 PathActuator; left out: 1 "
                  "CoordinateActuator, 2 Hunt")}) {
    const CommandResult result = alembert(folder, "import " + file);
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.err, testing::HasSubstr(said));
  }
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

const std::string kDoubtful = ALEMBERT_SOURCE_DIR "/tests/urdf/doubtful/";

TEST(Import, TakesWarningsForErrorsIfItIsStrict) {
  const TemporaryFolder folder;
  const std::string bad = kDoubtful + "zero_sizes.urdf", file = folder / "robot.yaml";
  EXPECT_EQ(alembert(folder, "import " + bad + " --out " + file).exit_code, 0);
  std::filesystem::remove(file);
  const CommandResult result = alembert(folder, "import " + bad + " --strict --out " + file);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, testing::StartsWith(bad + ":5:39: error: expected a positive number"));
  EXPECT_THAT(result.err, testing::HasSubstr(bad + ":7:34: error: expected 3 numbers"));
  EXPECT_THAT(result.err, testing::Not(testing::HasSubstr("warning:")));
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_EQ(alembert(folder, "import " + kRobot + " --strict").exit_code, 1);  // an axis of length 3
  EXPECT_EQ(alembert(folder, "import " + std::string(ALEMBERT_SOURCE_DIR) +
                                 "/tests/urdf/robots/headers.urdf --strict")
                .exit_code,
            0);
}

TEST(Import, ItsWarningsOfInertiasComeBackWithTheDescription) {
  const TemporaryFolder folder;
  const std::string file = folder / "robot.yaml", out = " --out-dir " + folder / "out";
  ASSERT_EQ(alembert(folder, "import " + kDoubtful + "impossible_inertia.urdf --out " + file).exit_code, 0);
  for (const std::string& command :
       {"check " + file, "report " + file + " --functions mass_matrix", "generate " + file + out,
        "simulate " + file + " --duration 0.01", "evaluate " + file}) {
    const CommandResult result = alembert(folder, command);
    EXPECT_EQ(result.exit_code, 0) << command << result.err;
    EXPECT_THAT(result.err, testing::StartsWith(file)) << command;
    EXPECT_THAT(result.err,
                testing::HasSubstr(": warning: no mass distribution has the inertia of body 'b'"));
    const CommandResult strict = alembert(folder, command + " --strict");
    EXPECT_EQ(strict.exit_code, 1) << command;
    EXPECT_THAT(strict.err, testing::HasSubstr(": error: no mass distribution has the inertia of body 'b'"));
  }
}

TEST(Import, OffersThreeWaysOutWhereJointsMoveNoMass) {
  const TemporaryFolder folder;
  const std::string robot = kDoubtful + "massless_tip.urdf", file = folder / "robot.yaml";
  const CommandResult kept = alembert(folder, "import " + robot + " --out " + file);
  EXPECT_EQ(kept.exit_code, 0);
  EXPECT_THAT(kept.err, testing::HasSubstr("2 joints move no mass (wheel, ball)"));
  for (const char* way : {"armature=1e-4", "freeze", "drop"}) {
    EXPECT_THAT(kept.err, testing::HasSubstr(way));
    const CommandResult other = alembert(folder, "import " + robot + " --massless " + way);
    EXPECT_EQ(other.exit_code, 0) << other.err;
    EXPECT_THAT(other.err, testing::Not(testing::HasSubstr("warning")));
    const std::string changed = folder.write("changed.yaml", other.out);
    EXPECT_EQ(alembert(folder, "simulate " + changed + " --duration 0.01 --strict").exit_code, 0);
    EXPECT_EQ(alembert(folder, "check " + changed + " --strict").exit_code, 0);
  }
  for (const char* bad : {"armature=0", "armature=-1", "armature=x", "armature", "no"})
    EXPECT_EQ(alembert(folder, "import " + robot + " --massless " + bad).exit_code, 1) << bad;
}

TEST(Import, JointsThatMoveNoMassMatterOnlyWhereAccelerationsAreSolvedFor) {
  const TemporaryFolder folder;
  const std::string file = folder / "robot.yaml";
  ASSERT_EQ(alembert(folder, "import " + kDoubtful + "moves_no_mass.urdf --out " + file).exit_code, 0);
  const std::string out = " --out-dir " + folder / "out";
  for (const std::string& command : {"generate " + file + out, "check " + file, "report " + file}) {
    const CommandResult result = alembert(folder, command);
    EXPECT_EQ(result.exit_code, 0) << command << result.err;
    EXPECT_THAT(result.err, testing::HasSubstr("warning: the mass matrix is singular"));
  }
  EXPECT_THAT(alembert(folder, "report " + file).out, testing::Not(testing::HasSubstr("forward_dynamics")));
  const CommandResult evaluated = alembert(folder, "evaluate " + file + " --json", "{\"qdd\": [1]}\n");
  EXPECT_EQ(evaluated.exit_code, 0) << evaluated.err;
  EXPECT_THAT(evaluated.out, testing::HasSubstr("\"tau\": [0], \"M\": [[0]], \"c\": [0], \"qdd\": null"));
  for (const std::string& command :
       {"simulate " + file, "report " + file + " --functions forward_dynamics"}) {
    const CommandResult result = alembert(folder, command);
    EXPECT_EQ(result.exit_code, 1) << command;
    EXPECT_THAT(result.err, testing::HasSubstr("error: the mass matrix is singular"));
    EXPECT_THAT(result.err, testing::HasSubstr("coordinate 'j'"));
    for (const char* way : {"armature", "constant", "leave it out", "--massless"})
      EXPECT_THAT(result.err, testing::HasSubstr(way));
  }
}

TEST(Import, LeavesNothingOfWhatIsWrong) {
  const TemporaryFolder folder;
  const std::string bad = ALEMBERT_SOURCE_DIR "/tests/urdf/errors/bad_cycle.urdf",
                    file = folder / "robot.yaml";
  const CommandResult result = alembert(folder, "import " + bad + " --out " + file);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, testing::HasSubstr(bad + ":7:16: error: "));
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_EQ(alembert(folder, "import " + bad).out, "");
}

TEST(Import, SaysWhatIsDoubtfulWhereTheRestIsWrong) {
  const TemporaryFolder folder;
  const std::string bad = ALEMBERT_SOURCE_DIR "/tests/urdf/errors/bad_only_xacro.urdf";
  const CommandResult result = alembert(folder, "import " + bad);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, testing::StartsWith(bad + ":2:3: warning: <xacro:macro> is of xacro"));
  EXPECT_THAT(result.err, testing::HasSubstr(bad + ":1:1: error: no <link> in the robot"));
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
  EXPECT_EQ(alembert(folder, "import " + folder.write("wide.urdf", wide + "</robot>")).exit_code, 0);
  const CommandResult result = alembert(folder, "import " + folder.write("deep.urdf", deep));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, testing::HasSubstr(": error: "));
}

/// Stands in for xacro, which few machines have: takes <xacro:nothing/> out, or fails.
class Xacro : public testing::Test {
 protected:
  void SetUp() override {
    const char* const path = std::getenv("PATH");
    before_ = path == nullptr ? "" : path;
    std::filesystem::create_directories(folder_ / "bin");
    const std::string program =
        folder_.write("bin/xacro",
                      "#!/bin/sh\nif grep -q wrong \"$1\"; then echo \"no macro wrong\" >&2; exit 2; fi\n"
                      "echo \"$#\" > \"$(dirname \"$0\")/arguments\"\nsed 's:<xacro.nothing/>::' \"$1\"\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  }
  void TearDown() override { setenv("PATH", before_.c_str(), 1); }
  void put_on_path() const { setenv("PATH", ((folder_ / "bin") + ":" + before_).c_str(), 1); }

  static std::string robot(const std::string& inner) {
    return "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'><link name='a'/><link "
           "name='b'><inertial><mass "
           "value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial></link><joint "
           "name='j' "
           "type='continuous'><parent link='a'/><child link='b'/><axis xyz='0 0 1'/></joint>" +
           inner + "</robot>";
  }

  TemporaryFolder folder_;

 private:
  std::string before_;
};

TEST_F(Xacro, ExpandsWhatUsesIt) {
  put_on_path();
  // No shell reads the name.
  const std::string name = "x; touch gone $(touch gone) .xacro";
  const std::string file = folder_.write(name, robot("<xacro:nothing/>"));
  const CommandResult result = alembert(folder_, "import '" + file + "'");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, testing::HasSubstr("coordinates: [j]"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "gone"));
  EXPECT_EQ(read_text(folder_ / "bin/arguments"), "1\n");
  const std::string urdf = folder_.write("r.urdf", robot("<xacro:nothing/>"));
  EXPECT_EQ(alembert(folder_, "report " + urdf + " --functions energy").exit_code, 0);
  // What it made needs it no more.
  std::filesystem::remove(folder_ / "bin/arguments");
  EXPECT_EQ(alembert(folder_, "import " + folder_.write("s.urdf", robot(""))).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "bin/arguments"));
}

TEST_F(Xacro, SaysWhatIsWrong) {
  put_on_path();
  const CommandResult result =
      alembert(folder_, "import " + folder_.write("r.xacro", robot("<xacro:wrong/>")));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, testing::HasSubstr("r.xacro:1:1: error: xacro failed with exit code 2"));
  EXPECT_THAT(result.err, testing::HasSubstr("no macro wrong"));
}

TEST_F(Xacro, IsMissed) {
  setenv("PATH", "/usr/bin:/bin", 1);
  const std::string expanded =
      folder_.write("expanded.urdf", "<!-- <robot> -->" + robot("<!--xacro:a/><xacro:b/-->"));
  const CommandResult passed = alembert(folder_, "import " + expanded);
  EXPECT_EQ(passed.exit_code, 0) << passed.err;
  if (std::filesystem::exists("/usr/bin/xacro") || std::filesystem::exists("/bin/xacro"))
    GTEST_SKIP() << "this machine has xacro";
  const CommandResult result = alembert(folder_, "import " + folder_.write("r.xacro", robot("")));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, testing::HasSubstr("this needs the program xacro, which is not on PATH"));
  EXPECT_THAT(result.err, testing::HasSubstr("expand it first: xacro FILE > robot.urdf"));
}

TEST(Import, TakesSdfInEveryCommand) {
  const TemporaryFolder folder;
  const std::string file = ALEMBERT_SOURCE_DIR "/tests/sdf/models/gears.sdf";
  EXPECT_EQ(alembert(folder, "report " + file + " --functions energy").exit_code, 0);
  EXPECT_EQ(alembert(folder, "check " + file + " --states 3").exit_code, 0);
  const CommandResult result = alembert(folder, "import " + file + " --massless freeze --root floating");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err, testing::HasSubstr("warning: --root, --massless have no meaning for SDF"));
}

TEST(Import, GivesTheMechanismTheNameThatIsAskedFor) {
  const TemporaryFolder folder;
  const std::string models = ALEMBERT_SOURCE_DIR "/tests/";
  for (const std::string robot : {"urdf/robots/drives.urdf", "mjcf/models/joints.xml",
                                  "sdf/doubtful/decay.sdf", "osim/doubtful/empty_numbers.osim"}) {
    const CommandResult result = alembert(folder, "import " + models + robot + " --name 'left arm'");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, testing::StartsWith("alembert: 1\nname: left_arm\n")) << robot;
  }
  const std::string file = folder / "robot.yaml";
  ASSERT_EQ(alembert(folder, "import " + models + "urdf/robots/drives.urdf --out " + file).exit_code, 0);
  EXPECT_THAT(alembert(folder, "report " + file + " --functions energy --name arm").err,
              testing::HasSubstr("warning: --name has no meaning for a description"));
}

TEST(Import, HasItsOptionsInEveryCommand) {
  const TemporaryFolder folder;
  const std::string robot = ALEMBERT_SOURCE_DIR "/tests/urdf/robots/drives.urdf";
  const std::string file = folder / "robot.yaml";
  const std::string options = " --root floating --massless armature=1e-3";
  ASSERT_EQ(alembert(folder, "import " + robot + options + " --out " + file).exit_code, 0);
  for (const std::string command : {"report --formulation reduced ", "simulate --duration 0.002 "}) {
    const CommandResult described = alembert(folder, command + file);
    const CommandResult direct = alembert(folder, command + robot + options);
    EXPECT_EQ(described.exit_code, 0) << described.err;
    EXPECT_EQ(direct.out, described.out) << command;
    EXPECT_NE(direct.out, alembert(folder, command + robot).out) << command;
  }
  const CommandResult unused = alembert(folder, "report " + file + " --functions energy --root floating");
  EXPECT_EQ(unused.exit_code, 0);
  EXPECT_THAT(unused.err, testing::HasSubstr("warning: --root has no meaning for a description"));
}

}  // namespace
}  // namespace alembert::test
