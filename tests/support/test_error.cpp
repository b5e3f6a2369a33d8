// Diagnostics: what the user sees when an input is wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/error.hpp"

namespace alembert {
namespace {

std::shared_ptr<const SourceText> source(std::string text) {
  return std::make_shared<const SourceText>(SourceText{"arm.yaml", std::move(text)});
}

TEST(InputError, ShowsPlaceLineAndCaret) {
  const InputError error({source("name: arm\nmass: 1,5\n"), 2, 7}, "not a number");
  EXPECT_STREQ(error.what(), "arm.yaml:2:7: error: not a number\n  mass: 1,5\n        ^");
  EXPECT_EQ(error.message(), "not a number");
  EXPECT_EQ(error.where().line, 2);
}

TEST(Warnings, OfOneKindAreToldOnce) {
  const auto file = source("a\nb\nc\nd\n");
  const Warnings found = one_of_each_kind({{{file, 4, 1}, "of d", "look", "k"},
                                           {{file, 2, 1}, "of b", "look", "k"},
                                           {{file, 1, 1}, "alone"},
                                           {{file, 3, 1}, "of c", "look", "k"},
                                           {{file, 1, 1}, "alone, too"}});
  std::vector<std::string> texts;
  for (const Warning& w : found) texts.push_back(warning_text(w.where, w.message, w.note));
  EXPECT_THAT(texts,
              testing::ElementsAre("arm.yaml:1:1: warning: alone\n  a\n  ^",
                                   "arm.yaml:1:1: warning: alone, too\n  a\n  ^",
                                   "arm.yaml:2:1: warning: of b\n  b\n  ^\nnote: look\nnote: 2 more like "
                                   "this one, in lines 3, 4"));
}

TEST(InputError, AddsNote) {
  const InputError error({source("a\n"), 1, 1}, "bad", "write b");
  EXPECT_STREQ(error.what(), "arm.yaml:1:1: error: bad\n  a\n  ^\nnote: write b");
}

TEST(InputError, KeepsTabsSoThatTheCaretLinesUp) {
  const InputError error({source("\tx: y"), 1, 5}, "bad");
  EXPECT_STREQ(error.what(), "arm.yaml:1:5: error: bad\n  \tx: y\n  \t   ^");
}

TEST(InputError, CountsCharactersOfUtf8Once) {
  const InputError error({source("ä: y"), 1, 5}, "bad");  // column 5 is byte 5, the y
  EXPECT_STREQ(error.what(), "arm.yaml:1:5: error: bad\n  ä: y\n     ^");
}

TEST(InputError, EmptyOrMissingTextHasNoExcerpt) {
  EXPECT_STREQ(InputError({source(""), 1, 1}, "empty").what(), "arm.yaml:1:1: error: empty");
  EXPECT_STREQ(InputError({nullptr, 1, 1}, "nowhere").what(), "<unknown>:1:1: error: nowhere");
}

TEST(InputError, PlacesOutsideTheTextAreHarmless) {
  EXPECT_STREQ(InputError({source("ab"), 1, 99}, "bad").what(), "arm.yaml:1:99: error: bad\n  ab\n    ^");
  EXPECT_THAT(InputError({source("ab"), 7, 1}, "bad").what(),
              testing::StartsWith("arm.yaml:7:1: error: bad\n"));
  EXPECT_THAT(InputError({source("ab"), 0, -3}, "bad").what(), testing::HasSubstr("error: bad"));
}

TEST(InputError, LongLinesAreCutAroundTheColumn) {
  const std::string line(100000, 'x');
  const std::string what = InputError({source(line), 1, 50000}, "bad").what();
  EXPECT_LT(what.size(), 500u);
  EXPECT_THAT(what, testing::HasSubstr("...x"));
  EXPECT_THAT(what, testing::HasSubstr("x..."));
  EXPECT_EQ(what.back(), '^');
}

TEST(InputError, ControlCharactersDoNotReachTheTerminal) {
  const std::string what = InputError({source("a\x1b[31mb\r\n"), 1, 1}, "bad").what();
  EXPECT_THAT(what, testing::HasSubstr("  a?[31mb\n"));
}

TEST(NearestName, FindsLikelySlips) {
  const std::vector<std::string> names{"revolute", "prismatic", "mass", "inertia"};
  EXPECT_EQ(nearest_name("revolut", names), "revolute");
  EXPECT_EQ(nearest_name("prismtaic", names), "prismatic");
  EXPECT_EQ(nearest_name("Mass", names), "mass");
  EXPECT_EQ(nearest_name("spherical", names), "");
  EXPECT_EQ(nearest_name("", names), "");
}

TEST(NearestName, ShortNamesNeedOneCharacterInCommon) {
  const std::vector<std::string> names{"m", "q1"};
  EXPECT_EQ(nearest_name("q2", names), "q1");
  EXPECT_EQ(nearest_name("x", names), "");
}

TEST(NearestName, TiesGoToTheFirst) {
  EXPECT_EQ(nearest_name("q3", std::vector<std::string>{"q1", "q2"}), "q1");
}

TEST(NearestName, HugeNamesAreNotCompared) {
  const std::vector<std::string> names{std::string(1000, 'a')};
  EXPECT_EQ(nearest_name(std::string(999, 'a'), names), "");
}

TEST(DidYouMean, SaysSoOrNothing) {
  EXPECT_EQ(did_you_mean("masss", std::vector<std::string>{"mass"}), " (did you mean 'mass'?)");
  EXPECT_EQ(did_you_mean("zzz", std::vector<std::string>{"mass"}), "");
}

TEST(Printable, EscapesAndBounds) {
  EXPECT_EQ(printable("a\nb\t'\"\\\x01"), "a\\nb\\t\\'\\\"\\\\\\x01");
  EXPECT_EQ(printable(std::string(100, 'x'), 10), "xxxxxxxxxx...");
  EXPECT_EQ(printable("ä", 1), "ä");  // never cuts a character in two
}

}  // namespace
}  // namespace alembert
