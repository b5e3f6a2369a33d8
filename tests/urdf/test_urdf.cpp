// URDF files in, descriptions out: whole texts to the letter, names, angles, and what each bad file is told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "import/common/fit_names.hpp"
#include "import/common/snapped_angle.hpp"
#include "import/urdf/describe.hpp"
#include "import/urdf/robot.hpp"
#include "mechanism/source.hpp"
#include "urdf/imported.hpp"

namespace alembert {
namespace {

namespace fs = std::filesystem;
using test::import, test::Imported, test::same, test::warnings_of;

std::shared_ptr<const SourceText> source_of(std::string text) {
  return std::make_shared<const SourceText>(SourceText{"robot.urdf", std::move(text)});
}

class UrdfFile : public testing::TestWithParam<fs::path> {};

TEST_P(UrdfFile, BecomesTheDescriptionBesideIt) {
  const Imported imported = import(read_source(GetParam()));
  test::expect_golden(imported.text, fs::path(GetParam()).replace_extension(".yaml"));
  test::expect_golden(warnings_of(imported, GetParam()), fs::path(GetParam()).replace_extension(".err"));
}

TEST_P(UrdfFile, IsReadBackFromItsText) {
  for (const bool floating : {false, true}) {
    const auto source = read_source(GetParam());
    Warnings warnings;
    const DescribedRobot described = describe_robot(read_urdf(source, warnings), source, {floating, 1e-10});
    const Document again(source_of(yaml_text(described.document.root())));
    EXPECT_TRUE(same(described.document.root(), again.root()));
  }
}

INSTANTIATE_TEST_SUITE_P(All, UrdfFile, testing::ValuesIn(test::files_in("tests/urdf/robots", ".urdf")),
                         [](const auto& test) { return test.param.stem().string(); });

/// What does not change the equations: one file a class.
class DoubtfulUrdf : public testing::TestWithParam<fs::path> {};

TEST_P(DoubtfulUrdf, IsReadWithAWarning) {
  const Imported imported = import(read_source(GetParam()));
  const std::string warnings = warnings_of(imported, GetParam());
  EXPECT_NE(warnings, "");
  test::expect_golden(warnings, fs::path(GetParam()).replace_extension(".err"));
  const Document again(source_of(imported.text));
  ExprGraph graph;
  EXPECT_NO_THROW(load_mechanism(again, graph));
}

INSTANTIATE_TEST_SUITE_P(All, DoubtfulUrdf, testing::ValuesIn(test::files_in("tests/urdf/doubtful", ".urdf")),
                         [](const auto& test) { return test.param.stem().string(); });

class BadUrdf : public testing::TestWithParam<fs::path> {};

TEST_P(BadUrdf, IsToldWhatIsWrong) {
  const fs::path& path = GetParam();
  try {
    import(read_source(path));
    FAIL() << "is read without an error";
  } catch (const InputError& error) {
    const std::string found = test::without_folder(error.what(), path) + "\n";
    EXPECT_TRUE(found.starts_with(path.filename().string() + ":")) << found;
    test::expect_golden(found, fs::path(path).replace_extension(".err"));
  }
}

INSTANTIATE_TEST_SUITE_P(All, BadUrdf, testing::ValuesIn(test::files_in("tests/urdf/errors", ".urdf")),
                         [](const auto& test) { return test.param.stem().string(); });

constexpr const char* kInertial =
    "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial>";

/// Two links, the second with mass.
std::string with_joint(const std::string& inner, const std::string& type = "revolute") {
  return "<robot name='r'><link name='a'/><link name='b'><inertial><mass value='1'/><inertia ixx='1' iyy='1' "
         "izz='1' ixy='0' ixz='0' iyz='0'/></inertial></link><joint name='j' type='" +
         type + "'><parent link='a'/><child link='b'/><axis xyz='1 0 0'/>" + inner + "</joint></robot>";
}

TEST(UrdfRoot, FloatsByAFreeJoint) {
  const std::string text = import(source_of(with_joint("")), {true, 1e-10}).text;
  EXPECT_NE(text.find("  - {name: a_rotation, type: quaternion}\n"), std::string::npos) << text;
  EXPECT_NE(text.find("      - joint: {type: free, coordinates: [a_x, a_y, a_z, a_rotation]}\n"),
            std::string::npos)
      << text;
}

/// A wheel without mass between two arms, and a joint that follows it at an offset.
const std::string kMassless =
    "<robot name='r'><link name='a'/><link name='b'>" + std::string(kInertial) +
    "</link><link name='c'/><link name='d'/><link name='e'>" + kInertial +
    "</link>"
    "<joint name='arm' type='continuous'><parent link='a'/><child link='b'/><axis xyz='1 0 0'/></joint>"
    "<joint name='wheel' type='prismatic'><parent link='b'/><child link='c'/><axis xyz='1 0 0'/>"
    "<limit lower='-1' upper='1'/></joint>"
    "<joint name='other' type='continuous'><parent link='c'/><child link='d'/><axis xyz='1 0 0'/>"
    "<mimic joint='wheel' multiplier='2' offset='0.5'/></joint>"
    "<joint name='hand' type='continuous'><parent link='b'/><child link='e'/><axis xyz='1 0 "
    "0'/></joint></robot>";

std::string massless(Massless what, bool floating = false) {
  const Imported imported = import(source_of(kMassless), {floating, 1e-10, what, 0.25});
  EXPECT_EQ(imported.warnings.size(), what == Massless::keep ? 1u : 0u);
  return imported.text.substr(imported.text.find("coordinates:"));
}

TEST(UrdfMassless, JointsStayWithAWarning) {
  EXPECT_THAT(massless(Massless::keep),
              testing::StartsWith("coordinates:\n  - arm\n  - {name: wheel, limits: [-1, 1]}\n  - hand\n"));
}

/// The robot above with drives.
Imported with_drives(const std::string& drives) {
  std::string text = kMassless;
  return import(source_of(text.insert(text.rfind("</robot>"), drives)));
}
std::string drive(const std::string& joint, const std::string& actuator) {
  return "<transmission name='t'><joint name='" + joint + "'/><actuator name='m'>" + actuator +
         "</actuator></transmission>";
}

TEST(UrdfTransmission, RotorIsAnArmature) {
  const std::string rotor = "<drake:rotor_inertia value='0.5'/>";
  EXPECT_THAT(with_drives(drive("arm", rotor + "<drake:gear_ratio value='-4'/>") +
                          drive("hand", rotor + "<mechanicalReduction>2</mechanicalReduction>"))
                  .text,
              testing::AllOf(testing::HasSubstr("{name: arm, armature: 8}"),
                             testing::HasSubstr("{name: hand, armature: 2}")));
}

TEST(UrdfTransmission, RotorOfAJointThatMimicsTurnsWithTheOther) {
  const std::string rotor = "<drake:rotor_inertia value='0.5'/><drake:gear_ratio value='3'/>";
  const Imported imported = with_drives(drive("wheel", rotor) + drive("other", rotor));
  EXPECT_THAT(imported.text,
              testing::HasSubstr("{name: wheel, limits: [-1, 1], armature: 22.5}"));  // 0.5*3^2*(1 + 2^2)
  EXPECT_THAT(imported.warnings, testing::IsEmpty());
}

TEST(UrdfMassless, JointsGetAnArmature) {
  EXPECT_THAT(massless(Massless::armature),
              testing::StartsWith(
                  "coordinates:\n  - arm\n  - {name: wheel, limits: [-1, 1], armature: 0.25}\n  - hand\n"));
}

TEST(UrdfMassless, JointsFreezeWithThoseThatFollowThem) {
  const std::string text = massless(Massless::freeze);
  EXPECT_THAT(text, testing::StartsWith("coordinates: [arm, hand]\ndefinitions:\n  other: 0.5\n"));
  EXPECT_THAT(text, testing::HasSubstr("- {name: c, parent: b}\n  - name: d\n    parent: c\n    "
                                       "transform:\n      - rotate: {axis: x, angle: other}\n"));
}

TEST(UrdfMassless, JointsGoWithWhatTheyMove) {
  const std::string text = massless(Massless::drop);
  EXPECT_THAT(text, testing::StartsWith("coordinates: [arm, hand]\nbodies:\n"));
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("name: c\n")));
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("name: d\n")));
  EXPECT_THAT(text, testing::HasSubstr("- name: e\n    parent: b\n"));
}

TEST(UrdfMassless, AJointThatMovesOneWhichOthersNeedIsFixed) {
  // The link of `first` has no mass, nor has that of `second`, but what mimics `second` moves mass.
  const std::string robot =
      "<robot name='r'><link name='a'/><link name='b'/><link name='c'/><link name='d'>" +
      std::string(kInertial) +
      "</link>"
      "<joint name='first' type='continuous'><parent link='a'/><child link='b'/><axis xyz='1 0 0'/></joint>"
      "<joint name='second' type='continuous'><parent link='b'/><child link='c'/><axis xyz='1 0 0'/></joint>"
      "<joint name='third' type='continuous'><parent link='a'/><child link='d'/><axis xyz='1 0 0'/>"
      "<mimic joint='second'/></joint></robot>";
  const std::string text = import(source_of(robot), {false, 1e-10, Massless::drop}).text;
  EXPECT_THAT(text, testing::HasSubstr("coordinates: [second]\ndefinitions:\n  third: second\n"));
}

TEST(UrdfMassless, ARobotWithoutMassFloatsOnlyIfItIsKept) {
  const std::string robot = "<robot name='r'><link name='a'/></robot>";
  EXPECT_EQ(import(source_of(robot), {true, 1e-10}).warnings.size(), 1u);
  EXPECT_THAT(import(source_of(robot), {true, 1e-10, Massless::armature}).text,
              testing::HasSubstr("{name: a_rotation, type: quaternion, armature: 0.0001}"));
  EXPECT_THROW(import(source_of(robot), {true, 1e-10, Massless::freeze}), InputError);
}

TEST(UrdfAngles, AreSnappedAsFarAsIsAllowed) {
  const std::string robot = with_joint("<origin rpy='1.5708 0 0'/>", "continuous");
  const Imported exact = import(source_of(robot)), snapped = import(source_of(robot), {false, 1e-4});
  EXPECT_NE(exact.text.find("angle: 1.5708"), std::string::npos) << exact.text;
  EXPECT_EQ(exact.warnings.size(), 1u);
  EXPECT_NE(snapped.text.find("angle: pi/2"), std::string::npos) << snapped.text;
  EXPECT_TRUE(snapped.warnings.empty());
}

TEST(UrdfAngles, AreWrittenAsMultiplesOfPi) {
  using std::numbers::pi;
  EXPECT_EQ(SnappedAngle(0, 0).text(), "0");
  EXPECT_EQ(SnappedAngle(-pi, 1e-12).text(), "-pi");
  EXPECT_EQ(SnappedAngle(2 * pi, 1e-12).text(), "2*pi");
  EXPECT_EQ(SnappedAngle(-5 * pi / 12, 1e-12).text(), "-5*pi/12");
  EXPECT_EQ(SnappedAngle(0.1, 1e-12).text(), "0.1");
  EXPECT_EQ(SnappedAngle(1e9, 1e-12).text(), "1000000000");
}

TEST(UrdfAngles, TurnByExactQuarters) {
  using std::numbers::pi;
  using Pair = std::array<double, 2>;
  EXPECT_EQ(SnappedAngle(pi / 2, 1e-12).cosine_and_sine(), (Pair{0, 1}));
  EXPECT_EQ(SnappedAngle(-pi / 2, 1e-12).cosine_and_sine(), (Pair{0, -1}));
  EXPECT_EQ(SnappedAngle(3 * pi, 1e-12).cosine_and_sine(), (Pair{-1, 0}));
  EXPECT_EQ(SnappedAngle(0.3, 1e-12).cosine_and_sine(), (Pair{std::cos(0.3), std::sin(0.3)}));
}

TEST(UrdfLengths, AreOfAnySize) {
  test::expect_the_same_however_small("robot.urdf", R"(<robot name='r'>
    <link name='base'><visual><origin xyz='@0.1 0 @0.2'/><geometry><box size='@0.1 @0.2 @0.3'/></geometry></visual>
    </link>
    <link name='arm'><inertial><origin xyz='@0.1 @0.05 0' rpy='0.1 0.2 0.3'/><mass value='2'/>
      <inertia ixx='@@0.02' iyy='@@0.02' izz='@@0.03' ixy='0' ixz='0' iyz='0'/></inertial></link>
    <joint name='j' type='continuous'><parent link='base'/><child link='arm'/><axis xyz='0 0 1'/>
      <origin xyz='@0.1 @0.2 @0.3' rpy='0 0.5 0'/></joint></robot>)");
}

TEST(UrdfLengths, ThatAreRoundingAreNone) {
  const auto robot = [](const std::string& inner) {
    return import(source_of(
                      "<robot name='r'><link name='a'/><link name='b'>" + std::string(kInertial) +
                      "</link><link name='c'>" + kInertial +
                      "</link><joint name='j' type='continuous'><parent link='a'/><child link='b'/><axis "
                      "xyz='0 0 1'/><origin xyz='" +
                      inner +
                      "'/></joint><joint name='k' type='continuous'><parent link='b'/><child link='c'/><axis "
                      "xyz='0 0 1'/><origin xyz='0 4e-19 0'/></joint></robot>"))
        .text;
  };
  EXPECT_THAT(robot("0.3 0 1e-17"), testing::HasSubstr("translate: [0.3, 0, 0]"));
  EXPECT_THAT(robot("0.3 0 0"), testing::Not(testing::HasSubstr("4e-19")));
  EXPECT_THAT(robot("3e-6 0 0"), testing::HasSubstr("translate: [3e-06, 0, 0]"));
  EXPECT_THAT(robot("3e-17 0 0"), testing::HasSubstr("translate: [0, 4e-19, 0]"));
}

TEST(UrdfLimits, StartInside) {
  const auto coordinate = [](const std::string& limit) {
    const std::string text = import(source_of(with_joint(limit))).text;
    const std::size_t begin = text.find("coordinates:\n") + 13;
    return text.substr(begin, text.find('\n', begin) - begin);
  };
  EXPECT_EQ(coordinate("<limit lower='-1' upper='1'/>"), "  - {name: j, limits: [-1, 1]}");
  EXPECT_EQ(coordinate("<limit lower='-2' upper='-1'/>"), "  - {name: j, initial: -1, limits: [-2, -1]}");
}

TEST(UrdfNames, LeaveNamespacesThatAreTaken) {
  EXPECT_EQ(fit_mechanism_name("std"), "std_robot");
  EXPECT_EQ(fit_mechanism_name(std::string(80, 'r')), std::string(64, 'r'));
}

TEST(UrdfNames, DifferWhateverTheyWere) {
  Warnings warnings;
  FitNames names("joint", warnings);
  const SourceLocation here;
  for (const char* name : {"a b", "a_b", "a-b"}) names.reserve(name);
  EXPECT_EQ(names.add("a b", here), "a_b_2");  // a_b is another's
  EXPECT_EQ(names.add("a_b", here), "a_b");
  EXPECT_EQ(names.add("a-b", here), "a_b_3");
  EXPECT_EQ(names.add(std::string(70, 'x'), here), std::string(64, 'x'));
  EXPECT_EQ(names.add(std::string(71, 'x'), here), std::string(62, 'x') + "_2");
  EXPECT_EQ(names.add(std::string(70, 'x'), here, "_angle"), std::string(58, 'x') + "_angle");
  EXPECT_EQ(warnings.size(), 5u);
}

TEST(UrdfNames, AreFit) {
  EXPECT_EQ(fit_name("/wam__1", "link"), "wam_1");
  EXPECT_EQ(fit_name("1st", "joint"), "joint_1st");
  EXPECT_EQ(fit_name("sin", "joint"), "sin_joint");
  EXPECT_EQ(fit_name("world", "link"), "world_link");
  EXPECT_EQ(fit_name("//", "link"), "link");
}

TEST(Importers, AreChosenByExtensionAndByText) {
  for (const Importer& importer : importers()) {
    EXPECT_EQ(&importer_of({"file" + std::string(importer.extension), ""}), &importer) << importer.format;
    EXPECT_THAT(importable_formats(), testing::HasSubstr(std::string(importer.format)));
  }
  EXPECT_EQ(importer_of({"<stdin>", "<?xml version='1.0'?><robot name='r'/>"}).format, "URDF");
  EXPECT_EQ(importer_of({"robot.xml", "<!-- <robot> --><mujoco model='m'/>"}).format, "MJCF");
  EXPECT_EQ(importer_of({"robot.xml", "<robot name='r'><mujoco/></robot>"}).format, "URDF");
  EXPECT_EQ(importer_of({"robot.urdf", "<mujoco model='m'/>"}).format, "MJCF");
  EXPECT_EQ(importer_of({"robot.sdf", "<robot name='r'/>"}).format, "URDF");
  EXPECT_EQ(importer_of({"notes.txt", "neither"}).format, "URDF");
}

}  // namespace
}  // namespace alembert
