#include <gtest/gtest.h>

#include "mechanism/document.hpp"
#include "mechanism/loaded.hpp"

namespace alembert {
namespace {

using test::source_of;

std::string error_of_document(std::string text) {
  try {
    const Document document(source_of(std::move(text)));
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

/// `line:column` of the character `c` in the value of the first key.
std::string place_of(const Document& document, char c) {
  const YamlNode& value = *document.root().items.at(1);
  const SourceLocation where = document.where(value, value.text.find(c));
  return std::to_string(where.line) + ":" + std::to_string(where.column);
}

TEST(Document, KeepsPlacesOfNodes) {
  const Document document(source_of("a: 1\nbb: [x,\n  {c: y}]\n"));
  const YamlNode& root = document.root();
  ASSERT_EQ(root.items.size(), 4u);
  EXPECT_EQ(root.items[2]->line, 2);
  EXPECT_EQ(root.items[2]->column, 1);
  const YamlNode& list = *root.items[3];
  EXPECT_EQ(list.kind, YamlNode::Kind::sequence);
  EXPECT_EQ(list.column, 5);
  EXPECT_EQ(list.items[0]->column, 6);
  EXPECT_EQ(list.items[1]->kind, YamlNode::Kind::mapping);
  EXPECT_EQ(list.items[1]->line, 3);
  EXPECT_EQ(list.items[1]->column, 3);
}

TEST(Document, TellsPlainFromQuotedScalars) {
  const Document document(source_of("[true, 'true', \"true\"]"));
  EXPECT_TRUE(document.root().items[0]->plain);
  EXPECT_FALSE(document.root().items[1]->plain);
  EXPECT_FALSE(document.root().items[2]->plain);
}

TEST(Document, FindsCharactersOfPlainScalars) {
  EXPECT_EQ(place_of(Document(source_of("a:   x + Z")), 'Z'), "1:10");
  EXPECT_EQ(place_of(Document(source_of("a: x +\n   y +\n     Z\n")), 'Z'), "3:6");
  EXPECT_EQ(place_of(Document(source_of("a: x  +  Z")), 'Z'), "1:10");
}
TEST(Document, FindsCharactersOfQuotedScalars) {
  EXPECT_EQ(place_of(Document(source_of("a: 'x + Z'")), 'Z'), "1:9");
  EXPECT_EQ(place_of(Document(source_of("a: \"x + Z\"")), 'Z'), "1:9");
  EXPECT_EQ(place_of(Document(source_of("a: \" Z\"")), 'Z'), "1:6");
}
TEST(Document, FindsCharactersOfBlockScalars) {
  EXPECT_EQ(place_of(Document(source_of("a: |\n  x +\n  Z\n")), 'Z'), "3:3");
  EXPECT_EQ(place_of(Document(source_of("a: >\n  x +\n  Z\n")), 'Z'), "3:3");
}
TEST(Document, FallsBackToTheStartOfScalarsWithEscapes) {
  EXPECT_EQ(place_of(Document(source_of("a: \"\\x78 + Z\"")), 'Z'), "1:4");
}
TEST(Document, SkipsAByteOrderMark) {
  const Document document(
      source_of("\xEF\xBB\xBF"
                "a: Z\nb: 1\n"));
  EXPECT_EQ(place_of(document, 'Z'), "1:7");  // columns count bytes of the file
  EXPECT_EQ(document.root().items[2]->column, 1);
}

TEST(Document, LimitsTextThatAliasesRepeat) {
  const auto rows = [](int count) {
    std::string text = "a: &long \"" + std::string(std::size_t{1} << 20, 'q') + "\"\nb: [*long";
    for (int i = 1; i < count; ++i) text += ", *long";
    return text + "]\n";
  };
  EXPECT_NO_THROW(Document{source_of(rows(20))});
  try {
    const Document document(source_of(rows(40)));
    FAIL() << "was accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.where().line, 2);
    EXPECT_EQ(error.message(), "more than 32 MiB of text, aliases counted as often as they are used");
  }
}
TEST(Document, SharesAliasedNodes) {
  const Document document(source_of("a: &x [1, 2]\nb: *x\n"));
  EXPECT_EQ(document.root().items[1], document.root().items[3]);
}

TEST(Document, AcceptsNestingUpToTheLimitOnly) {
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + "x" + std::string(depth, ']');
  };
  EXPECT_EQ(error_of_document(nested(Document::kMaximumDepth)), "");
  EXPECT_NE(error_of_document(nested(Document::kMaximumDepth + 1)).find("nested more than 64 levels deep"),
            std::string::npos);
}

TEST(Document, RefusesMoreNodesThanTheLimit) {
  std::string text = "[";
  for (std::size_t i = 0; i < Document::kMaximumNodes; ++i) text += "x,";
  EXPECT_NE(error_of_document(text + "x]").find("more than 1000000 values"), std::string::npos);
}

TEST(Document, AcceptsTabsThatDoNotIndent) {
  EXPECT_EQ(error_of_document("a:\t1\t# comment\n\t# comment\n\t\nb: 2\n"), "");
}

TEST(Document, AcceptsUtf8InTextAndComments) {
  const Document document(source_of("a: \xCE\xB8 \xF0\x9F\xA4\x96 # \xE2\x82\xAC\n"));
  EXPECT_EQ(document.root().items[1]->text, "\xCE\xB8 \xF0\x9F\xA4\x96");
}

TEST(Document, AcceptsWindowsLineEnds) {
  const Document document(source_of("a: 1\r\nb: Z\r\n"));
  EXPECT_EQ(document.root().items[3]->text, "Z");
  EXPECT_EQ(document.root().items[3]->line, 2);
}

}  // namespace
}  // namespace alembert
