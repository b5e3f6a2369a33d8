// Numbers, comments, strings, templates and statements as text.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <clocale>
#include <cstdlib>
#include <limits>

#include "emit/sample.hpp"
#include "emit/statements/literals.hpp"
#include "emit/statements/statements.hpp"
#include "emit/text_template.hpp"
#include "registers/statement_layout.hpp"
#include "support/error.hpp"

namespace alembert {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(NumberLiteral, ReadsBackAndIsNoInteger) {
  EXPECT_EQ(number_literal(1.0), "1.0");
  EXPECT_EQ(number_literal(0.4318), "0.4318");
  EXPECT_EQ(number_literal(-0.0), "-0.0");
  EXPECT_EQ(number_literal(1e300), "1e+300");
  sample::Random random(5);
  for (int i = 0; i < 10000; ++i) {
    const double x = std::bit_cast<double>(random.next());
    if (!std::isfinite(x)) continue;
    const std::string text = number_literal(x);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(std::strtod(text.c_str(), nullptr)),
              std::bit_cast<std::uint64_t>(x))
        << text;
    EXPECT_NE(text.find_first_of(".e"), std::string::npos) << text;
  }
  EXPECT_THROW(number_literal(std::numeric_limits<double>::quiet_NaN()), InternalError);
  EXPECT_THROW(number_literal(-std::numeric_limits<double>::infinity()), InternalError);
}

TEST(CommentText, CannotLeaveAComment) {
  for (const std::string text : {"a */ b", "a\nb", "a\r\nb", "end\\", "\\\n", "?\?/", "?\?/\n#error",
                                 "/* open", "//", "*/*/", "**//", "/*/"}) {
    const std::string comment = comment_text(text);
    for (const char* bad : {"*/", "/*", "//", "\n", "\r", "\\", "?\?"})
      EXPECT_THAT(comment, Not(HasSubstr(bad))) << text;
  }
  EXPECT_EQ(comment_text("Gr\xC3\xB6\xC3\x9F"
                         "e, 6\xE2\x80\x93R"),
            "Gr\xC3\xB6\xC3\x9F"
            "e, 6\xE2\x80\x93R");
  EXPECT_EQ(comment_text("a\xE2\x80\xAE"
                         "b"),
            "a<U+202E>b");  // right-to-left override
  EXPECT_EQ(comment_text("a\xC2\x85"
                         "b"),
            "a<U+0085>b");  // next line
  EXPECT_EQ(comment_text("a\xE2\x80\xA8"
                         "b"),
            "a<U+2028>b");  // line separator
  EXPECT_EQ(comment_text(std::string("a\0b", 3)), "a<U+0000>b");
  EXPECT_EQ(comment_text("\xFF\xC0\xAF\xED\xA0\x80\xE2\x80"),
            "<FF><C0><AF><ED><A0><80><E2><80>");  // no UTF-8
}

TEST(StringLiteral, HoldsAnyText) {
  EXPECT_EQ(string_literal("arm"), "\"arm\"");
  EXPECT_EQ(string_literal("a\"b\\c?\?/\n\xFF"
                           "1"),
            R"("a\"b\\c\?\?/\012\3771")");
}

TEST(Lists, AreShortenedAndWrapped) {
  const std::vector<std::string> names{"a", "b", "c", "d"};
  EXPECT_EQ(name_list(names), "a, b, c, d");
  EXPECT_EQ(name_list(names, 2), "a, b and 2 more");
  EXPECT_EQ(name_list(names, 3), "a, b, c, d");
  EXPECT_EQ(name_list({}), "none");
  EXPECT_EQ(wrap_list("aaa, bbb, ccc", 2, 4, 10), "aaa,\n    bbb,\n    ccc");
  EXPECT_EQ(wrap_list("aaa, bbb, ccc", 0, 0, 10), "aaa, bbb,\nccc");
  const std::string items(50, 'a'), list = items + ", " + items + ", " + items;
  EXPECT_EQ(wrap_behind("f(", list), items + ", " + items + ",\n  " + items);
  EXPECT_EQ(wrap_behind("f(", list, 1), items + ", " + items + ",\n " + items);
  EXPECT_EQ(wrap_words("a bb, ccc dddd", 0, 2, 8), "a bb,\n  ccc\n  dddd");
  EXPECT_EQ(wrap_words("unbreakable", 0, 2, 8), "unbreakable");
  EXPECT_EQ(prefix_lines("a\n\nb\n", "// "), "// a\n//\n// b\n");
}

TEST(Template, SlotsAreFilled) {
  EXPECT_EQ(fill_text("t", "x @a@ @b@@a@\n", {{"a", "1"}, {"b", "@a@"}}), "x 1 @a@1\n");
  EXPECT_EQ(fill_text("t", "f {\n  @body@\n}\n", {{"body", "a;\n\nb;\n"}}), "f {\n  a;\n\n  b;\n}\n");
  EXPECT_EQ(fill_text("t", "f\n\n@gone@\n}\n", {{"gone", ""}}), "f\n}\n");
  EXPECT_EQ(fill_text("t", "@a@@c@\n", {{"a", "1"}}, {{"a", "2"}, {"c", "3"}, {"unused", "4"}}), "13\n");
}

TEST(Template, WhatDoesNotFitIsADefect) {
  EXPECT_THROW(fill_text("t", "@missing@\n", {}), InternalError);
  EXPECT_THROW(fill_text("t", "text\n", {{"unknown", "1"}}), InternalError);
  EXPECT_THROW(fill_text("t", "a@b\n", {}), InternalError);
  EXPECT_THROW(fill_text("t", "@not a slot@\n", {}), InternalError);
  EXPECT_THROW(template_text("nothing"), InternalError);
}

/// Statements of a program with the given code over q, whose last value is tau[0].
FunctionBody body_of(std::vector<Instruction> code, std::vector<double> constants = {},
                     const BlockSizes& sizes = {}) {
  Program program;
  program.function = "inverse_dynamics";
  program.code = std::move(code);
  program.constants = std::move(constants);
  for (std::uint32_t i = 0; i < 4; ++i)
    program.inputs.push_back({ArgumentKind::q, i, "angle*/\n" + std::to_string(i)});
  program.outputs = {{"tau", 1, 1, {static_cast<std::uint32_t>(program.code.size() - 1)}}};
  return function_body(program, *find_function("inverse_dynamics"), sizes);
}
const std::string kLoads =
    "const S q0 = q[0];  // angle* / 0\nconst S q1 = q[1];  // angle* / 1\nconst S q2 = q[2];  // angle* / "
    "2\n";
constexpr Instruction in(std::uint32_t i) {
  return {Operation::input, i, 0};
}

TEST(Statements, ParenthesesKeepTheAssociation) {
  using enum Operation;
  const auto text = [](Operation inner, Operation outer, bool inner_left) {
    const FunctionBody body = body_of({in(0),
                                       in(1),
                                       in(2),
                                       {inner, 0, 1},
                                       inner_left ? Instruction{outer, 3, 2} : Instruction{outer, 2, 3}});
    const std::string& lines = body.blocks.at(0).statement_lines;
    EXPECT_THAT(lines, testing::StartsWith(kLoads));
    return lines.substr(kLoads.size());
  };
  EXPECT_EQ(text(add, add, true), "tau[0] = q0 + q1 + q2;\n");
  EXPECT_EQ(text(add, add, false), "tau[0] = q2 + (q0 + q1);\n");
  EXPECT_EQ(text(sub, sub, true), "tau[0] = q0 - q1 - q2;\n");
  EXPECT_EQ(text(sub, sub, false), "tau[0] = q2 - (q0 - q1);\n");
  EXPECT_EQ(text(add, mul, true), "tau[0] = (q0 + q1) * q2;\n");
  EXPECT_EQ(text(mul, add, false), "tau[0] = q2 + q0 * q1;\n");
  EXPECT_EQ(text(mul, mul, false), "tau[0] = q2 * (q0 * q1);\n");
  EXPECT_EQ(text(div, mul, true), "tau[0] = q0 / q1 * q2;\n");
  EXPECT_EQ(text(mul, div, false), "tau[0] = q2 / (q0 * q1);\n");
}

TEST(Statements, NegationAndConstants) {
  using enum Operation;
  EXPECT_EQ(body_of({in(0), in(1), {neg, 0, 0}, {sub, 1, 2}}).blocks[0].statement_lines,
            "const S q0 = q[0];  // angle* / 0\nconst S q1 = q[1];  // angle* / 1\ntau[0] = q1 - -q0;\n");
  EXPECT_THAT(body_of({in(0), in(1), {add, 0, 1}, {neg, 2, 0}, {neg, 3, 0}}).blocks[0].statement_lines,
              HasSubstr("tau[0] = -(-(q0 + q1));\n"));
  EXPECT_THAT(body_of({in(0), {constant, 0, 0}, {mul, 1, 0}}, {-2.0}).blocks[0].statement_lines,
              HasSubstr("tau[0] = S(-2.0) * q0;\n"));
}

TEST(Statements, CallsAndSharedValuesAreNamedAndTheRestIsNot) {
  using enum Operation;
  const FunctionBody body =
      body_of({in(0), in(1), {sin, 0, 0}, {mul, 2, 1}, {mul, 2, 3}, {mul, 3, 4}, {cos, 1, 0}});
  EXPECT_EQ(body.blocks[0].using_lines, "using ::std::cos;\n");
  EXPECT_EQ(body.blocks[0].statement_lines, "const S q1 = q[1];  // angle* / 1\ntau[0] = cos(q1);\n")
      << "the rest is dead";
  const FunctionBody live = body_of({in(0), in(1), {sin, 0, 0}, {mul, 2, 1}, {mul, 2, 3}, {mul, 3, 4}});
  EXPECT_THAT(live.blocks[0].statement_lines,
              HasSubstr("const S t0 = sin(q0);\nconst S q1 = q[1];  // angle* / 1\nconst S t1 = t0 * q1;\n"
                        "tau[0] = t1 * (t0 * t1);\n"))
      << "an input is taken where it is first used";
}

TEST(Statements, SinesThatComeFirstStayInOneBlock) {
  using enum Operation;
  const FunctionBody body = body_of({in(0),
                                     in(1),
                                     {sin, 0, 0},
                                     {cos, 0, 0},
                                     {sin, 1, 0},
                                     {cos, 1, 0},
                                     {exp, 2, 0},
                                     {atan2, 6, 3},
                                     {atan2, 7, 4},
                                     {atan2, 8, 5},
                                     {exp, 9, 0}},
                                    {}, {3, 2});
  ASSERT_GT(body.blocks.size(), 2u);
  EXPECT_THAT(body.blocks[0].statement_lines, HasSubstr("sines_and_cosines(2, q, sine, cosine)"));
  for (std::size_t b = 1; b < body.blocks.size(); ++b)
    EXPECT_THAT(body.blocks[b].using_lines, Not(HasSubstr("::sin")));
}

TEST(Statements, LongExpressionsAreCut) {
  using enum Operation;
  std::vector<Instruction> code{in(0), in(1)};
  for (std::uint32_t i = 1; i < 100; ++i) code.push_back({i % 2 == 0 ? add : mul, i, 0});
  const FunctionBody body = body_of(code);
  std::size_t longest = 0, start = 0;
  const std::string& lines = body.blocks[0].statement_lines;
  for (std::size_t end = lines.find('\n'); end != std::string::npos; end = lines.find('\n', start)) {
    longest = std::max(longest, end - start);
    start = end + 1;
  }
  EXPECT_LT(longest, 150u);
  EXPECT_GE(body.blocks[0].statements, 8u);
}

TEST(Statements, BlocksPassValuesThroughAnArrayThatIsReused) {
  const sample::Sample s = sample::big();
  const FunctionBody body = function_body(s.programs[0], *find_function("inverse_dynamics"));
  ASSERT_GT(body.blocks.size(), 2u);
  EXPECT_GT(body.crossing, 0u);
  std::size_t stores = 0;
  for (const CodeBlock& block : body.blocks) {
    EXPECT_LT(block.statements, 3 * BlockSizes().size);
    for (std::size_t at = block.statement_lines.find("\nkept["); at != std::string::npos;
         at = block.statement_lines.find("\nkept[", at + 1))
      ++stores;
  }
  EXPECT_GT(stores, body.crossing);
}

TEST(Statements, AValueUsedBeforeItExistsIsADefect) {
  EXPECT_THROW(body_of({{Operation::add, 1, 1}, in(0), {Operation::mul, 0, 1}}), InternalError);
}

}  // namespace
}  // namespace alembert
