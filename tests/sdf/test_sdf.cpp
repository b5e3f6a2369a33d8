// Files of SDF in, descriptions out: whole texts to the letter, what each bad file is told, and that none reads more than
// the folders it may.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ctime>
#include <filesystem>
#include <string>

#include "urdf/imported.hpp"

namespace alembert {
namespace {

namespace fs = std::filesystem;
using test::import, test::Imported;
using testing::HasSubstr;

std::shared_ptr<const SourceText> file_of(std::string text, std::string name = "<stdin>") {
  return std::make_shared<const SourceText>(SourceText{std::move(name), std::move(text)});
}

class SdfFile : public testing::TestWithParam<fs::path> {};

TEST_P(SdfFile, BecomesTheDescriptionBesideIt) {
  test::expect_description_beside(GetParam());
}

INSTANTIATE_TEST_SUITE_P(All, SdfFile, testing::ValuesIn(test::files_in("tests/sdf/models", ".sdf")),
                         [](const auto& test) { return test.param.stem().string(); });

class DoubtfulSdf : public testing::TestWithParam<fs::path> {};

TEST_P(DoubtfulSdf, IsReadWithAWarning) {
  test::expect_warnings_beside(GetParam());
}

INSTANTIATE_TEST_SUITE_P(All, DoubtfulSdf, testing::ValuesIn(test::files_in("tests/sdf/doubtful", ".sdf")),
                         [](const auto& test) { return test.param.stem().string(); });

class BadSdf : public testing::TestWithParam<fs::path> {};

TEST_P(BadSdf, IsToldWhatIsWrong) {
  test::expect_refusal_beside(GetParam());
}

INSTANTIATE_TEST_SUITE_P(All, BadSdf, testing::ValuesIn(test::files_in("tests/sdf/errors", ".sdf")),
                         [](const auto& test) { return test.param.stem().string(); });

const std::string kLink = "<link name='l'><inertial><mass>1</mass></inertial></link>";

std::string model(const std::string& inner) {
  return "<sdf version='1.9'><model name='m'>" + inner + "</model></sdf>";
}

TEST(Sdf, IsChosenByExtensionAndByText) {
  EXPECT_EQ(importer_of({"model.sdf", ""}).format, "SDF");
  EXPECT_EQ(importer_of({"scene.world", "<?xml version='1.0'?><sdf version='1.9'/>"}).format, "SDF");
}

TEST(Sdf, OfStandardInputHasNoFolder) {
  EXPECT_THAT(import(file_of(model(kLink))).text, HasSubstr("l_rotation"));
  EXPECT_THROW(import(file_of(model("<include><uri>model://leg</uri></include>"))), InputError);
}

TEST(Sdf, LooksForModelsInFoldersThatAreGiven) {
  const std::string text =
      "<sdf version='1.9'><world name='w'><include><uri>model://parts</uri></include></world></sdf>";
  DescribeOptions options;
  options.include_folders = {(fs::path(ALEMBERT_SOURCE_DIR) / "tests/sdf/models").string()};
  EXPECT_THAT(import(file_of(text), options).text, HasSubstr("axle"));
}

/// In a folder that is the package or holds it, and nowhere else.
TEST(Sdf, LooksForPackagesInFoldersThatAreGiven) {
  const auto text = [](const std::string& file) {
    return "<sdf version='1.9'><world name='w'><include><uri>package://parts/" + file +
           "</uri></include></world></sdf>";
  };
  for (const char* folder : {"tests/sdf/models", "tests/sdf/models/parts", "tests/sdf/models/parts/"}) {
    DescribeOptions options;
    options.include_folders = {(fs::path(ALEMBERT_SOURCE_DIR) / folder).string()};
    EXPECT_THAT(import(file_of(text("cart.sdf")), options).text, HasSubstr("name: bed")) << folder;
    EXPECT_THROW(import(file_of(text("../../errors/bad_xml.sdf")), options), InputError) << folder;
  }
}

TEST(Sdf, OptionsWithoutMeaningAreAWarning) {
  DescribeOptions options;
  options.floating = true;
  options.massless = Massless::freeze;
  const Imported imported = import(file_of(model(kLink)), options);
  ASSERT_EQ(imported.warnings.size(), 1U);
  EXPECT_THAT(imported.warnings[0], HasSubstr("--root, --massless have no meaning for SDF"));
}

TEST(Sdf, ResistanceMayBeLeftOut) {
  const std::string text =
      model(kLink +
            "<joint name='j' type='revolute'><parent>world</parent><child>l</child><axis><xyz>0 0 1</xyz>"
            "<dynamics><damping>2</damping><friction>1</friction></dynamics></axis></joint>");
  EXPECT_THAT(import(file_of(text)).text, HasSubstr("damping: 2"));
  DescribeOptions options;
  options.resistance = false;
  EXPECT_THAT(import(file_of(text), options).text, HasSubstr("coordinates: [j]"));
}

TEST(Sdf, TextsMayHaveCommentsInThem) {
  EXPECT_THAT(
      import(file_of(model("<link name='l'><pose>0 0 1 <!-- up --> 0 0 0</pose><inertial><mass><!-- kg "
                           "-->3<!-- as weighed --></mass></inertial></link>")))
          .text,
      testing::AllOf(HasSubstr("mass: 3\n"), HasSubstr("{name: l_z, initial: 1}")));
}

TEST(Sdf, LinksDoNotLeadOutOfItsFolder) {
  const test::FolderWithLinks folder("sdf", model(kLink));
  for (const char* uri : {"out.txt", "within/../out.txt", "model"}) {
    const std::string text = model(std::string("<include><uri>") + uri + "</uri></include>");
    try {
      import(file_of(text, folder.file("model.sdf")));
      ADD_FAILURE() << uri;
    } catch (const InputError& error) {
      EXPECT_THAT(error.message(), HasSubstr("lies outside"));
    }
  }
}

TEST(SdfLengths, AreOfAnySize) {
  test::expect_the_same_however_small("model.sdf", R"(<sdf version='1.10'><model name='m'>
    <pose>@0.1 @0.2 @0.3 0.3 0.2 0.1</pose>
    <link name='base'><pose>@0.7 @0.1 0 0 0 1.5707963267948966</pose>
      <inertial><pose>@0.1 @0.01 0 0.1 0.2 0.3</pose><mass>2</mass>
        <inertia><ixx>@@0.02</ixx><iyy>@@0.02</iyy><izz>@@0.03</izz></inertia></inertial>
      <visual name='v'><pose>@0.1 0 @0.1 0 0.5 0</pose><geometry><box><size>@0.1 @0.2 @0.3</size></box></geometry>
      </visual>
    </link>
    <link name='arm'><pose>@0.7 @0.3 @0.2 0.7 0.1 0</pose>
      <inertial auto='true'><mass>1</mass></inertial>
      <collision name='a'><pose>@0.1 0 0 0 0 0</pose><geometry><sphere><radius>@0.1</radius></sphere></geometry>
      </collision>
      <collision name='b'><pose>@-0.1 0 0 0 0 0</pose><geometry><sphere><radius>@0.1</radius></sphere></geometry>
      </collision>
    </link>
    <frame name='tip' attached_to='arm'><pose>@0.1 @0.2 @0.3 0 0 0</pose></frame>
    <joint name='j' type='revolute'><pose relative_to='base'>@0.1 @0.2 @0.3 0 0 0</pose>
      <parent>base</parent><child>arm</child><axis><xyz>0 1 0</xyz></axis></joint>
    <link name='hand'><pose>@0.3 @0.7 @0.1 0.7 0.1 0.4</pose></link>
    <joint name='at_hand' type='revolute'><parent>arm</parent><child>hand</child><axis/></joint>
  </model></sdf>)");
}

/// What a text is told that asks for a great deal, within some seconds of the processor.
std::string refusal(const std::string& text) {
  const std::clock_t began = std::clock();
  std::string message = "none";
  try {
    import(file_of(text));
  } catch (const InputError& error) {
    message = error.message();
  }
  EXPECT_LT(static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC, 20);
  return message;
}

TEST(SdfBombs, AreRefused) {
  std::string deep;
  for (int i = 0; i < 1000; ++i) deep += "<model name='m'>";
  deep += kLink;
  for (int i = 0; i < 1000; ++i) deep += "</model>";
  EXPECT_THAT(refusal(model(deep)), HasSubstr("nested more than"));
  std::string chain = kLink;
  for (int i = 0; i < 20000; ++i)
    chain += "<frame name='f" + std::to_string(i) + "' attached_to='" +
             (i == 19999 ? std::string("l") : "f" + std::to_string(i + 1)) + "'/>";
  EXPECT_THAT(refusal(model(chain)), HasSubstr("lie in each other more than"));
}

}  // namespace
}  // namespace alembert
