// MJCF files in, descriptions out: whole texts to the letter, what each bad file is told, and that none asks for more
// than its own folder.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ctime>
#include <filesystem>
#include <string>

#include "urdf/imported.hpp"

namespace alembert {
namespace {

namespace fs = std::filesystem;
using test::import;

std::shared_ptr<const SourceText> model_of(std::string text, std::string name = "<stdin>") {
  return std::make_shared<const SourceText>(SourceText{std::move(name), std::move(text)});
}

class MjcfFile : public testing::TestWithParam<fs::path> {};

TEST_P(MjcfFile, BecomesTheDescriptionBesideIt) {
  test::expect_description_beside(GetParam());
}

INSTANTIATE_TEST_SUITE_P(All, MjcfFile, testing::ValuesIn(test::files_in("tests/mjcf/models", ".xml")),
                         [](const auto& test) { return test.param.stem().string(); });

/// What does not change the equations: one file a class.
class DoubtfulMjcf : public testing::TestWithParam<fs::path> {};

TEST_P(DoubtfulMjcf, IsReadWithAWarning) {
  test::expect_warnings_beside(GetParam());
}

INSTANTIATE_TEST_SUITE_P(All, DoubtfulMjcf, testing::ValuesIn(test::files_in("tests/mjcf/doubtful", ".xml")),
                         [](const auto& test) { return test.param.stem().string(); });

class BadMjcf : public testing::TestWithParam<fs::path> {};

TEST_P(BadMjcf, IsToldWhatIsWrong) {
  test::expect_refusal_beside(GetParam());
}

INSTANTIATE_TEST_SUITE_P(All, BadMjcf, testing::ValuesIn(test::files_in("tests/mjcf/errors", ".xml")),
                         [](const auto& test) { return test.param.stem().string(); });

const std::string kBody = "<body name='b'><joint name='j'/><geom size='0.1' pos='0 0 1'/></body>";

std::string model(const std::string& inner, const std::string& around = "") {
  return "<mujoco>" + around + "<worldbody>" + inner + "</worldbody></mujoco>";
}

/// Places in the world, as models before MuJoCo 2.3.4 may have them, and the same ones in the axes of bodies: the
/// torso is turned by half a turn about z. A body without a place is where its mass is, in the axes of its only shape
/// or of its inertial.
TEST(MjcfGlobalCoordinates, AreThoseOfTheLocalModel) {
  const std::string local =
      model(R"(
    <site name='floor' pos='0 0 0.5'/>
    <body name='torso' pos='0.5 0 1.25' quat='0 0 0 1'>
      <joint name='rooty' axis='0 1 0' pos='0 0 0.25'/>
      <geom type='capsule' quat='0 0 0 -1' size='0.125 0.5'/>
      <site name='side' pos='-1 -2 0'/>
      <body name='thigh' pos='0 0 -1' quat='0 0 0 -1'>
        <joint name='hip' axis='0 -1 0' pos='0.5 0 0'/>
        <geom type='box' size='0.25 0.125 0.0625'/>
        <body name='foot' pos='0.25 0 -0.125' quat='0 1 0 0'>
          <joint name='ankle' axis='1 0 0' pos='0 0.5 0'/>
          <inertial pos='0 0 0' mass='2' diaginertia='2 3 4'/>
        </body>
      </body>
    </body>)",
            "<compiler inertiafromgeom='auto'/>"
            "<equality><connect body1='torso' body2='foot' anchor='-0.5 0.25 0.75'/></equality>");
  const std::string global =
      model(R"(
    <site name='floor' pos='0 0 0.5'/>
    <body name='torso' pos='0.5 0 1.25' quat='0 0 0 1'>
      <joint name='rooty' axis='0 -1 0' pos='0.5 0 1.5'/>
      <geom type='capsule' fromto='0.5 0 1.75 0.5 0 0.75' size='0.125'/>
      <site name='side' pos='1.5 2 1.25' quat='0 0 0 1'/>
      <body name='thigh'>
        <joint name='hip' axis='0 -1 0' pos='1 0 0.25'/>
        <geom type='box' pos='0.5 0 0.25' size='0.25 0.125 0.0625'/>
        <body name='foot'>
          <joint name='ankle' axis='1 0 0' pos='0.75 -0.5 0.125'/>
          <inertial pos='0.75 0 0.125' quat='0 1 0 0' mass='2' diaginertia='2 3 4'/>
        </body>
      </body>
    </body>)",
            "<compiler coordinate='global'/>"
            "<equality><connect body1='torso' body2='foot' anchor='1 -0.25 2'/></equality>");
  EXPECT_EQ(import(model_of(global)).text, import(model_of(local)).text);
}

/// Hopper of Gym has it. Its joints and shapes say where they are, which is what its equations depend on.
TEST(MjcfGlobalCoordinates, TolerateAPlaceThatIsNoNumber) {
  const std::string body = "><joint name='j' pos='1 0 0'/><geom size='0.1' pos='0 0 1'/></body>";
  const auto read = [&](const std::string& place) {
    return import(model_of(model("<body name='b'" + place + body, "<compiler coordinate='global'/>")));
  };
  const test::Imported odd = read(" pos='0.13/2 0 0.1'");
  EXPECT_EQ(odd.text, read("").text);
  ASSERT_EQ(odd.warnings.size(), 1u);
  EXPECT_THAT(odd.warnings[0], testing::HasSubstr("the body's frame is at its centre of mass"));
}

TEST(MjcfStdin, HasNoFolder) {
  EXPECT_THAT(import(model_of(model(kBody))).text, testing::HasSubstr("coordinates: [j]"));
  EXPECT_THROW(import(model_of(model("<include file='leg.xml'/>"))), InputError);
}

TEST(Mjcf, LinksDoNotLeadOutOfItsFolder) {
  const test::FolderWithLinks folder("mjcf", "<mujoco/>");
  for (const char* file : {"out.txt", "within/../out.txt"}) {
    const std::string text = model(kBody, std::string("<include file='") + file + "'/>");
    try {
      import(model_of(text, folder.file("model.xml")));
      ADD_FAILURE() << file;
    } catch (const InputError& error) {
      EXPECT_THAT(error.message(), testing::HasSubstr("lies outside"));
    }
  }
}

TEST(Mjcf, OtherFoldersAreReadWhereTheyAreGiven) {
  const std::string tests = ALEMBERT_SOURCE_DIR "/tests/mjcf";
  for (const char* name : {"../models/parts/leg.xml", "..\\models\\parts\\leg.xml"}) {
    const auto source = model_of(model(std::string("<include file='") + name + "'/>",
                                       "<default><geom size='0.1'/><default class='knee'/></default>"),
                                 tests + "/errors/beside.xml");
    DescribeOptions options;
    EXPECT_THROW(import(source, options), InputError) << name;
    options.include_folders = {tests + "/doubtful"};
    EXPECT_THROW(import(source, options), InputError) << name;
    options.include_folders = {tests + "/models"};
    EXPECT_THAT(import(source, options).text, testing::HasSubstr("coordinates:")) << name;
  }
}

/// What a text is told that asks for a great deal, within some seconds of the processor.
std::string refusal(const std::string& text) {
  const std::clock_t began = std::clock();
  std::string message = "none";
  try {
    import(model_of(text));
  } catch (const InputError& error) {
    message = error.message();
  }
  EXPECT_LT(static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC, 20);
  return message;
}

TEST(MjcfBombs, AreRefused) {
  // Copies of copies of copies.
  std::string copies = kBody;
  for (int i = 0; i < 4; ++i) copies = "<replicate count='1000' sep='-'>" + copies + "</replicate>";
  EXPECT_THAT(refusal(model(copies)), testing::HasSubstr("more than 200000 elements"));
  // Each body attaches the one before it twice, or deep inside.
  std::string twice = "<body name='b0'/>", inside = twice;
  for (int i = 1; i < 40; ++i) {
    const std::string begin = fmt::format("<body name='b{}'>", i),
                      of = fmt::format("<attach body='b{}' ", i - 1);
    twice += begin + of + "prefix='x'/>" + of + "prefix='y'/></body>";
    std::string frames = of + fmt::format("prefix='x{}'/>", i);
    for (int k = 0; k < 150; ++k) frames = "<frame>" + frames + "</frame>";
    inside += begin + frames + "</body>";
  }
  EXPECT_THAT(refusal(model(twice)), testing::HasSubstr("more than 200000 elements"));
  EXPECT_THAT(refusal(model(inside)), testing::HasSubstr("more than 400 deep"));
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<body>";
  EXPECT_THAT(refusal(model(deep)), testing::HasSubstr("not well-formed"));
  for (int i = 0; i < 100000; ++i) deep += "</body>";
  EXPECT_THAT(refusal(model(deep)), testing::HasSubstr("nested"));
  // Entities are not expanded.
  EXPECT_THAT(refusal("<!DOCTYPE m [<!ENTITY a 'aaaaaaaaaa'><!ENTITY b '&a;&a;&a;&a;'>]>" +
                      model("<body name='&b;'><joint/><geom size='&b;'/></body>")),
              testing::HasSubstr("expected 1 to 3 numbers"));
}

TEST(MjcfBombs, LongChainsOfFollowersAreCut) {
  constexpr int kCount = 20000;
  std::string bodies, equalities;
  for (int i = 0; i < kCount; ++i) {
    bodies += fmt::format("<body name='b{0}'><joint name='j{0}'/><geom size='0.1' pos='1 0 0'/></body>", i);
    if (i > 0) equalities += fmt::format("<joint joint1='j{}' joint2='j{}' polycoef='0 1 0.1'/>", i - 1, i);
  }
  Warnings warnings;
  const std::clock_t began = std::clock();
  const DescribedRobot described =
      describe_source(model_of("<mujoco><worldbody>" + bodies + "</worldbody><equality>" + equalities +
                               "</equality></mujoco>"),
                      {}, warnings);
  EXPECT_LT(static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC, 20);
  EXPECT_THAT(summary(described), testing::HasSubstr("19801 definitions, 198 constraints"));
}

TEST(MjcfLengths, AreOfAnySize) {
  test::expect_the_same_however_small("model.xml", R"(<mujoco><compiler angle='radian'/><worldbody>
    <frame pos='@0.1 @0.2 @-0.3' euler='0.3 0 0.5'>
      <body name='base' pos='@0.7 0 @0.3' euler='0 1.5707963267948966 0'>
        <joint name='turn' pos='@0.1 @0.2 @0.05' axis='0 1 0'/>
        <joint name='turn_on' pos='@0.1 @0.2 @0.05' axis='1 0 0'/>
        <joint name='slide' type='slide' ref='@0.2617993877991494'/>
        <geom type='box' size='@0.1 @0.2 @0.3' pos='@0.1 0 @0.2' mass='0.7'/>
        <geom type='capsule' fromto='@-0.1 0 @0.2 @0.1 0 @0.3' size='@0.05' mass='0.3'/>
        <body name='tip' pos='@0.3 @0.1 0' quat='0.5 0.5 0.5 0.5'>
          <joint name='tip' pos='@0.3 0 @0.1' axis='0 0 1'/>
          <inertial pos='@0.01 0 0' mass='0.2' diaginertia='@@0.01 @@0.01 @@0.015' euler='0.1 0.2 0.3'/>
          <site name='end' pos='@0.3 @0.1 @0.2'/>
        </body>
      </body>
    </frame>
  </worldbody>
  <equality><connect body1='tip' anchor='@0.1 @0.2 @0.3'/></equality>
  <sensor><framepos objtype='site' objname='end'/></sensor></mujoco>)");
}

TEST(MjcfOptions, ResistanceMayBeLeftOut) {
  const std::string text =
      model("<body><joint name='j' damping='1' frictionloss='2'/><geom size='0.1'/></body>");
  EXPECT_THAT(import(model_of(text)).text, testing::HasSubstr("damping: 1"));
  DescribeOptions options;
  options.resistance = false;
  EXPECT_THAT(import(model_of(text), options).text, testing::HasSubstr("coordinates: [j]"));
}

}  // namespace
}  // namespace alembert
