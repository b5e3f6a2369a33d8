// MJCF files in, descriptions out: whole texts to the letter, what each bad file is told, and that none asks for more
// than its own folder.
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

TEST(MjcfStdin, HasNoFolder) {
  EXPECT_THAT(import(model_of(model(kBody))).text, testing::HasSubstr("coordinates: [j]"));
  EXPECT_THROW(import(model_of(model("<include file='leg.xml'/>"))), InputError);
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
