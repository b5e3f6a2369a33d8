// Models of OpenSim in, descriptions out: whole texts to the letter, what is left out, and what each bad file is told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>

#include "golden/golden_file.hpp"
#include "import/common/yaml.hpp"
#include "import/importers.hpp"
#include "import/opensim/describe_osim.hpp"
#include "mechanism/load.hpp"
#include "mechanism/source.hpp"

namespace alembert {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct Described {
  std::string text, warnings;
};

Described described(const std::shared_ptr<const SourceText>& source, const fs::path& path = {}) {
  Warnings warnings;
  const DescribedRobot robot = describe_osim(source, {}, warnings);
  ExprGraph graph;
  const Mechanism mechanism = load_mechanism(robot.document, graph);
  warnings.insert(warnings.end(), robot.warnings.begin(), robot.warnings.end());
  warnings.insert(warnings.end(), mechanism.warnings.begin(), mechanism.warnings.end());
  Described out{yaml_text(robot.document.root()), {}};
  for (const Warning& w : one_of_each_kind(warnings))
    out.warnings += test::without_folder(warning_text(w.where, w.message, w.note), path) + "\n";
  return out;
}

class OsimFile : public testing::TestWithParam<fs::path> {};

TEST_P(OsimFile, BecomesTheDescriptionBesideIt) {
  const fs::path& path = GetParam();
  const Described found = described(read_source(path.string()), path);
  test::expect_golden(found.text, fs::path(path).replace_extension(".yaml"));
  test::expect_golden(found.warnings, fs::path(path).replace_extension(".err"));
  // What was understood once is understood from its text.
  ExprGraph graph;
  EXPECT_NO_THROW(load_mechanism(std::make_shared<const SourceText>(SourceText{"again", found.text}), graph));
}

INSTANTIATE_TEST_SUITE_P(All, OsimFile, testing::ValuesIn(test::files_in("tests/osim/models", ".osim")),
                         [](const auto& test) { return test.param.stem().string(); });

INSTANTIATE_TEST_SUITE_P(Doubtful, OsimFile,
                         testing::ValuesIn(test::files_in("tests/osim/doubtful", ".osim")),
                         [](const auto& test) { return test.param.stem().string(); });

class BadOsim : public testing::TestWithParam<fs::path> {};

TEST_P(BadOsim, IsToldWhatIsWrong) {
  const fs::path& path = GetParam();
  try {
    described(read_source(path.string()), path);
    FAIL() << "is read without an error";
  } catch (const InputError& error) {
    const std::string found = test::without_folder(error.what(), path) + "\n";
    EXPECT_TRUE(found.starts_with(path.filename().string() + ":")) << found;
    test::expect_golden(found, fs::path(path).replace_extension(".err"));
  }
}

INSTANTIATE_TEST_SUITE_P(All, BadOsim, testing::ValuesIn(test::files_in("tests/osim/errors", ".osim")),
                         [](const auto& test) { return test.param.stem().string(); });

std::shared_ptr<const SourceText> pendulum(const std::string& body, const std::string& more = "") {
  return std::make_shared<const SourceText>(SourceText{
      "model.osim",
      "<OpenSimDocument Version='40500'><Model name='m'>" + more + "<BodySet><objects><Body name='b'>" +
          body +
          "</Body></objects></BodySet><JointSet><objects><PinJoint name='p'>"
          "<socket_parent_frame>/m/ground</socket_parent_frame><socket_child_frame>b</socket_child_frame>"
          "<coordinates><Coordinate name='q'/></coordinates></PinJoint></objects></JointSet>"
          "</Model></OpenSimDocument>"});
}

TEST(Osim, IsChosenByExtensionAndByText) {
  EXPECT_EQ(importer_of({"model.osim", ""}).format, "OpenSim");
  EXPECT_EQ(importer_of({"<stdin>", "<?xml version='1.0'?><OpenSimDocument Version='40000'/>"}).format,
            "OpenSim");
}

TEST(Osim, TakesPathsThatBeginWithTheModelsName) {
  EXPECT_THAT(described(pendulum("<mass>1</mass><inertia>1 1 1 0 0 0</inertia>")).text,
              HasSubstr("name: b\n"));
}

TEST(Osim, WarnsOfUnknownPropertiesAndRefusesMisspeltOnes) {
  const std::string good = "<mass>1</mass><inertia>1 1 1 0 0 0</inertia>";
  EXPECT_THAT(described(pendulum(good + "<colour>red</colour>")).warnings,
              HasSubstr("warning: unknown element <colour> in Body 'b'"));
  EXPECT_THROW(described(pendulum("<mas>1</mas><inertia>1 1 1 0 0 0</inertia>")), InputError);
  EXPECT_THROW(described(pendulum(good, "<Gravity>0 0 0</Gravity>")), InputError);
  EXPECT_THROW(
      described(pendulum(good,
                         "<ForceSet><objects><SpringGeneralizedForce name='s'><coordinate>q</coordinate>"
                         "<stifness>1</stifness></SpringGeneralizedForce></objects></ForceSet>")),
      InputError);
}

TEST(Osim, TakesWhatTheDefaultsOfATypeSay) {
  const std::string text =
      described(pendulum("<inertia>1 1 1 0 0 0</inertia>",
                         "<defaults><Body name='default'><mass>3</mass></Body></defaults>"))
          .text;
  EXPECT_THAT(text, HasSubstr("mass: 3\n"));
}

TEST(Osim, TakesFlagsOfDefaultsAndSetsOfItsOwnFile) {
  const std::string good = "<mass>1</mass><inertia>1 1 1 0 0 0</inertia>";
  const std::string force =
      "<ForceSet file=''><objects><CoordinateActuator name='a'><coordinate>q</coordinate>"
      "</CoordinateActuator></objects></ForceSet>";
  EXPECT_THAT(described(pendulum(good, force)).text, HasSubstr("forces:"));
  const std::string disabled =
      "<defaults><CoordinateActuator "
      "name='default'><isDisabled>true</isDisabled></CoordinateActuator></defaults>";
  EXPECT_THAT(described(pendulum(good, disabled + force)).text, testing::Not(HasSubstr("forces:")));
}

TEST(Osim, TakesTextsWithCommentsInThem) {
  EXPECT_THAT(
      described(
          pendulum(
              "<mass><!-- in kg -->3<!-- as weighed --></mass><inertia>1 2 <!-- z --> 2 0 0 0</inertia>"))
          .text,
      testing::AllOf(HasSubstr("mass: 3\n"), HasSubstr("yy: 2")));
}

/// A model whose body has `frames` and whose constraints are `constraints`, with coordinates q0 to q<count>.
std::shared_ptr<const SourceText> chain_of(int count, const std::string& frames,
                                           const std::string& constraints) {
  std::string bodies, joints;
  for (int i = 0; i <= count; ++i) {
    const std::string k = std::to_string(i);
    bodies += "<Body name='b" + k + "'><mass>1</mass><inertia>1 1 1 0 0 0</inertia>" +
              (i == 0 ? frames : std::string()) + "</Body>";
    joints += "<PinJoint name='j" + k +
              "'><socket_parent_frame>/ground</socket_parent_frame><socket_child_frame>b" + k +
              "</socket_child_frame><coordinates><Coordinate name='q" + k + "'/></coordinates></PinJoint>";
  }
  return std::make_shared<const SourceText>(
      SourceText{"model.osim", "<OpenSimDocument Version='40500'><Model name='m'><BodySet><objects>" +
                                   bodies + "</objects></BodySet><JointSet><objects>" + joints +
                                   "</objects></JointSet><ConstraintSet><objects>" + constraints +
                                   "</objects></ConstraintSet></Model></OpenSimDocument>"});
}

// Each follows the next one: as deep as there are coordinates.
TEST(Osim, CoordinatesFollowOneAnotherInChainsOfAnyLength) {
  constexpr int kCount = 4000;
  std::string constraints;
  for (int i = 0; i < kCount; ++i)
    constraints +=
        "<CoordinateCouplerConstraint name='c" + std::to_string(i) +
        "'><coupled_coordinates_function><LinearFunction><coefficients>1 0</coefficients></LinearFunction>"
        "</coupled_coordinates_function><independent_coordinate_names>q" +
        std::to_string(i + 1) + "</independent_coordinate_names><dependent_coordinate_name>q" +
        std::to_string(i) + "</dependent_coordinate_name></CoordinateCouplerConstraint>";
  const std::string text = described(chain_of(kCount, "", constraints)).text;
  EXPECT_NE(text.find("coordinates:\n  - name: q4000\ndefinitions:\n  q3999: q4000\n"), std::string::npos);
  EXPECT_NE(text.find("\n  q0: q1\n"), std::string::npos);
}

// The last one listed is what the others stand on.
TEST(Osim, FramesStandOnLaterOnesUpToADepth) {
  const auto frames = [](int count) {
    std::string out = "<components>";
    for (int i = 0; i < count; ++i)
      out += "<PhysicalOffsetFrame name='f" + std::to_string(i) + "'><socket_parent>" +
             (i + 1 < count ? "../f" + std::to_string(i + 1) : std::string("..")) +
             "</socket_parent><translation>0.1 0 0</translation></PhysicalOffsetFrame>";
    return out + "</components>";
  };
  EXPECT_THAT(described(chain_of(0, frames(200), "")).text, HasSubstr("name: f0"));
  try {
    described(chain_of(0, frames(3000), ""));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.message(), HasSubstr("stands on more than 200 others"));
  }
}

// A hundred thousand elements within each other.
TEST(Osim, IsNotDeeperThanTheStack) {
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  for (int i = 0; i < 100000; ++i) deep += "</a>";
  EXPECT_THAT(described(pendulum("<mass>1</mass><inertia>1 1 1 0 0 0</inertia>" + deep)).warnings,
              HasSubstr("unknown element <a>"));
}

}  // namespace
}  // namespace alembert
