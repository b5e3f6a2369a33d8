// URDF files in, descriptions out: whole texts to the letter, names, angles, and what each bad file is told.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "golden/golden_file.hpp"
#include "mechanism/load.hpp"
#include "urdf/describe.hpp"
#include "urdf/names.hpp"
#include "urdf/robot.hpp"
#include "urdf/snapped_angle.hpp"
#include "urdf/yaml.hpp"

namespace alembert {
namespace {

namespace fs = std::filesystem;

struct Imported {
  std::string text;
  std::vector<std::string> warnings;
};

Imported import(std::shared_ptr<const SourceText> source, const DescribeOptions& options = {}) {
  const DescribedRobot described = describe_robot(read_urdf(source), source, options);
  ExprGraph graph;
  load_mechanism(described.document, graph);
  return {yaml_text(described.document.root()), described.warnings};
}

std::shared_ptr<const SourceText> source_of(std::string text) {
  return std::make_shared<const SourceText>(SourceText{"robot.urdf", std::move(text)});
}

/// Whether both trees have the same kinds and texts.
bool same(const YamlNode& a, const YamlNode& b) {
  if (a.kind != b.kind || a.text != b.text || a.items.size() != b.items.size()) return false;
  for (std::size_t i = 0; i < a.items.size(); ++i)
    if (!same(*a.items[i], *b.items[i])) return false;
  return true;
}

class UrdfFile : public testing::TestWithParam<fs::path> {};

TEST_P(UrdfFile, BecomesTheDescriptionBesideIt) {
  const Imported imported = import(read_source(GetParam()));
  test::expect_golden(imported.text, fs::path(GetParam()).replace_extension(".yaml"));
  std::string warnings;
  for (const std::string& warning : imported.warnings)
    warnings += test::without_folder(warning, GetParam()) + "\n";
  test::expect_golden(warnings, fs::path(GetParam()).replace_extension(".err"));
}

TEST_P(UrdfFile, IsReadBackFromItsText) {
  for (const bool floating : {false, true}) {
    const auto source = read_source(GetParam());
    const DescribedRobot described = describe_robot(read_urdf(source), source, {floating, 1e-10});
    const Document again(source_of(yaml_text(described.document.root())));
    EXPECT_TRUE(same(described.document.root(), again.root()));
  }
}

INSTANTIATE_TEST_SUITE_P(All, UrdfFile, testing::ValuesIn(test::files_in("tests/urdf/robots", ".urdf")),
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

/// Two links, the second with mass.
std::string with_joint(const std::string& inner, const std::string& type = "revolute") {
  return "<robot name='r'><link name='a'/><link name='b'><inertial><mass value='1'/><inertia ixx='1' iyy='1' "
         "izz='1' ixy='0' ixz='0' iyz='0'/></inertial></link><joint name='j' type='" +
         type + "'><parent link='a'/><child link='b'/>" + inner + "</joint></robot>";
}

TEST(UrdfRoot, FloatsByAFreeJoint) {
  const std::string text = import(source_of(with_joint("")), {true, 1e-10}).text;
  EXPECT_NE(text.find("  - {name: a_rotation, type: quaternion}\n"), std::string::npos) << text;
  EXPECT_NE(text.find("      - joint: {type: free, coordinates: [a_x, a_y, a_z, a_rotation]}\n"),
            std::string::npos)
      << text;
}

TEST(UrdfRoot, MustMoveMassToFloat) {
  const std::string massless = "<robot name='r'><link name='a'/></robot>";
  EXPECT_THROW(import(source_of(massless), {true, 1e-10}), InputError);
}

TEST(UrdfAngles, AreSnappedAsFarAsIsAllowed) {
  const std::string robot = with_joint("<origin rpy='1.5708 0 0'/>");
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

TEST(UrdfLimits, StartInside) {
  const auto coordinate = [](const std::string& limit) {
    const std::string text = import(source_of(with_joint(limit))).text;
    const std::size_t begin = text.find("coordinates:\n") + 13;
    return text.substr(begin, text.find('\n', begin) - begin);
  };
  EXPECT_EQ(coordinate("<limit lower='-1' upper='1'/>"), "  - {name: j, limits: [-1, 1]}");
  EXPECT_EQ(coordinate("<limit lower='-2' upper='-1'/>"), "  - {name: j, initial: -1, limits: [-2, -1]}");
}

TEST(UrdfNames, AreFit) {
  EXPECT_EQ(fit_name("/wam__1", "link"), "wam_1");
  EXPECT_EQ(fit_name("1st", "joint"), "joint_1st");
  EXPECT_EQ(fit_name("sin", "joint"), "sin_joint");
  EXPECT_EQ(fit_name("world", "link"), "world_link");
  EXPECT_EQ(fit_name("//", "link"), "link");
}

}  // namespace
}  // namespace alembert
