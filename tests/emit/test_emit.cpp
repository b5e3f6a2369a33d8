// The set of files, their banners, what is refused, and that nothing of the user's text escapes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <sstream>
#include <string>

#include "emit/argument_lists.hpp"
#include "emit/emit.hpp"
#include "emit/sample.hpp"
#include "emit/speed_parents.hpp"
#include "emit/statements/statements.hpp"
#include "program/loops/dot_products.hpp"
#include "program/program_maker.hpp"
#include "support/error.hpp"

namespace alembert {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string& text_of(const std::vector<EmittedFile>& files, const std::string& path) {
  for (const EmittedFile& file : files)
    if (file.path == path) return file.text;
  throw std::out_of_range(path);
}

TEST(Emit, FilesAreKnownFromNameAndParts) {
  const sample::Sample s = sample::big();
  for (const int parts : {1, 4, 64}) {
    EmitOptions options;
    options.parts = parts;
    const std::vector<EmittedFile> files = emit_mechanism(s.mechanism, s.programs, options);
    std::vector<std::string> paths;
    for (const EmittedFile& file : files) paths.push_back(file.path);
    EXPECT_EQ(paths, emitted_paths("sample_big", parts));
  }
  EXPECT_THAT(
      emitted_paths("arm", 2),
      testing::ElementsAre("include/arm/arm.hpp", "include/arm/arm_raw.hpp", "include/arm/arm_impl.hpp",
                           "include/arm/arm_part1.hpp", "include/arm/arm_part2.hpp", "include/arm/arm.h",
                           "src/arm_part1.cpp", "src/arm_part2.cpp", "src/arm_c.cpp"));
}

/// mass_matrix_and_bias with a mass matrix that is zero but for its diagonal and these entries.
Program with_mass_matrix(std::uint32_t n, const std::vector<std::pair<int, int>>& tied) {
  Program program;
  program.function = "mass_matrix_and_bias";
  program.constants = {0.0, 2.0};
  program.code = {{Operation::real, 0}, {Operation::real, 1}};
  std::vector<std::uint32_t> M(n * n, 0);
  for (std::uint32_t i = 0; i < n; ++i) M[i * n + i] = 1;
  for (const auto& [i, k] : tied) M[i * n + k] = M[k * n + i] = 1;
  program.outputs = {{"M", n, n, M}, {"c", n, 1, std::vector<std::uint32_t>(n, 1)}};
  return program;
}

TEST(SpeedParents, AreThoseOfTheTree) {
  using testing::ElementsAre;
  // Two legs in turn on a base of two speeds.
  EXPECT_THAT(
      speed_parents(
          with_mass_matrix(
              6, {{0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}, {0, 4}, {1, 4}, {2, 4}, {0, 5}, {1, 5}, {3, 5}}),
          6),
      ElementsAre(-1, 0, 1, 1, 2, 3));
  // What stands apart.
  EXPECT_THAT(speed_parents(with_mass_matrix(3, {}), 3), ElementsAre(-1, -1, -1));
  // 3 ties 0 and 2 together in L, though not in M.
  EXPECT_THAT(speed_parents(with_mass_matrix(4, {{0, 3}, {2, 3}}), 4), ElementsAre(-1, -1, 0, 2));
  EXPECT_THAT(speed_parents(with_mass_matrix(0, {}), 0), ElementsAre());
}

TEST(SpeedParents, AreWrittenWithTheMassMatrix) {
  sample::Sample s = sample::every_function();
  const auto header = [&] {
    return text_of(emit_mechanism(s.mechanism, s.programs, {}),
                   "include/" + s.mechanism.name + "/" + s.mechanism.name + ".hpp");
  };
  EXPECT_THAT(header(), HasSubstr("kSpeedParents"));
  std::erase_if(s.programs, [](const Program& p) { return p.function == "mass_matrix_and_bias"; });
  EXPECT_THAT(header(), Not(HasSubstr("SpeedParents")));
}

TEST(Emit, PartsBySizeUnlessGiven) {
  sample::Sample small = sample::every_function();
  const sample::Sample big = sample::big();
  small.programs.resize(3);
  EXPECT_EQ(emit_mechanism(small.mechanism, small.programs, {}).size(), emitted_paths("", 1).size());
  EXPECT_GT(emit_mechanism(big.mechanism, big.programs, {}).size(), emitted_paths("", 1).size());
}

TEST(Emit, PartsShareTheWork) {
  const sample::Sample s = sample::big();
  EmitOptions options;
  options.parts = 3;
  const std::vector<EmittedFile> files = emit_mechanism(s.mechanism, s.programs, options);
  std::size_t smallest = std::string::npos, largest = 0;
  for (int k = 1; k <= 3; ++k) {
    const std::size_t size =
        text_of(files, "include/sample_big/sample_big_part" + std::to_string(k) + ".hpp").size();
    smallest = std::min(smallest, size);
    largest = std::max(largest, size);
  }
  EXPECT_LT(largest, 2 * smallest);
}

TEST(Emit, SameInputSameBytes) {
  const sample::Sample first = sample::every_function(), second = sample::every_function();
  const std::vector<EmittedFile> a = emit_mechanism(first.mechanism, first.programs, {});
  std::vector<Program> reversed(second.programs.rbegin(), second.programs.rend());
  const std::vector<EmittedFile> b = emit_mechanism(second.mechanism, reversed, {});
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].text, b[i].text) << a[i].path;
}

TEST(Emit, EveryFileBearsTheBannerAndEndsInOneLineBreak) {
  const sample::Sample s = sample::every_function();
  for (const EmittedFile& file : emit_mechanism(s.mechanism, s.programs, {})) {
    EXPECT_THAT(file.text, HasSubstr("Do not edit")) << file.path;
    EXPECT_THAT(file.text, HasSubstr("alembert " + std::string(generator_version()))) << file.path;
    EXPECT_THAT(file.text, HasSubstr("belongs to its user")) << file.path;
    EXPECT_TRUE(file.text.ends_with("\n") && !file.text.ends_with("\n\n")) << file.path;
    EXPECT_THAT(file.text, Not(HasSubstr("@"))) << file.path;
    EXPECT_THAT(file.text, Not(HasSubstr(" \n"))) << file.path;
    EXPECT_THAT(file.text, Not(HasSubstr("\n\n\n"))) << file.path;
  }
}

TEST(Emit, HeaderSaysWhatThereIs) {
  const sample::Sample s = sample::every_function();
  const std::string raw =
      text_of(emit_mechanism(s.mechanism, s.programs, {}), "include/sample_all/sample_all_raw.hpp");
  EXPECT_THAT(raw, HasSubstr("[7] coordinates: shoulder, base.x, base.y, base.z, base.w, slide, wrist"));
  EXPECT_THAT(raw, HasSubstr("tau = M(q) qdd + c(q, qd)"));
  EXPECT_THAT(raw, HasSubstr("multiplications"));
  EXPECT_THAT(raw, HasSubstr("reduced formulation"));
}

/// Only texts of the function table speak of constants: a unit of the user's that looks like one stays.
TEST(Emit, ConstantsHaveTheNamesOfEachLanguageAndTextsOfTheUserStay) {
  sample::Sample s = sample::every_function();
  s.mechanism.description = "Lifts 5 kN over kBodyNames.";
  s.mechanism.coordinates[0].name = "kBoom";
  const auto in = [&](Language language, const std::string& path) {
    EmitOptions options;
    options.language = language;
    options.scalars = {"double"};
    return text_of(emit_mechanism(s.mechanism, s.programs, options), path);
  };
  const std::string cpp = in(Language::cpp, "include/sample_all/sample_all_raw.hpp");
  const std::string c = in(Language::c, "include/sample_all/sample_all.h");
  const std::string python = in(Language::python, "python/sample_all.py");
  EXPECT_THAT(cpp, HasSubstr("Lifts 5 kN over kBodyNames."));
  EXPECT_THAT(python, HasSubstr("Lifts 5 kN over kBodyNames."));
  for (const std::string& text : {cpp, c, python}) EXPECT_THAT(text, HasSubstr("coordinates: kBoom, base.x"));
  EXPECT_THAT(cpp, HasSubstr("for each body of kBodyNames"));
  EXPECT_THAT(c, HasSubstr("for each body of sample_all_body_names"));
  EXPECT_THAT(python, HasSubstr("for each body of body_names"));
  EXPECT_THAT(c, Not(testing::ContainsRegex("kBodyNames|kFrameNames|kConstraintNames|kHolonomic")));
}

TEST(Emit, NamespaceAndScalars) {
  const sample::Sample s = sample::big();
  EmitOptions options;
  options.outer_namespace = "acme::robots";
  options.scalars = {"float"};
  const std::vector<EmittedFile> files = emit_mechanism(s.mechanism, s.programs, options);
  const std::string raw = text_of(files, "include/sample_big/sample_big_raw.hpp");
  EXPECT_THAT(raw, HasSubstr("namespace acme::robots::sample_big {"));
  EXPECT_THAT(raw, Not(HasSubstr("alembert::mechanisms")));
  EXPECT_THAT(raw, HasSubstr("<float>"));
  EXPECT_THAT(raw, Not(HasSubstr("void mass_matrix<double>")));
  // The C interface is for double all the same: its file compiles that itself.
  EXPECT_THAT(text_of(files, "src/sample_big_c.cpp"), HasSubstr("sample_big_impl.hpp"));
}

std::string refused(const sample::Sample& s, const EmitOptions& options) {
  try {
    emit_mechanism(s.mechanism, s.programs, options);
  } catch (const InputError& error) {
    return error.message();
  }
  return "";
}

TEST(Emit, OptionsThatCannotBeAreRefused) {
  sample::Sample s = sample::every_function();
  EmitOptions options;
  options.outer_namespace = "a::b c";
  EXPECT_THAT(refused(s, options), HasSubstr("'a::b c' is no namespace"));
  for (const char* bad : {"", "::a", "a::", "a:b", "class", "a::int", "1a", "a\nb"}) {
    options.outer_namespace = bad;
    EXPECT_THAT(refused(s, options), HasSubstr("is no namespace")) << bad;
  }
  options = {};
  options.scalars = {"quad"};
  EXPECT_THAT(refused(s, options), HasSubstr("'quad' is no scalar type"));
  options.scalars = {};
  EXPECT_THAT(refused(s, options), HasSubstr("no scalar type"));
  options.scalars = {"float", "float"};
  EXPECT_THAT(refused(s, options), HasSubstr("given twice"));
  options = {};
  options.parts = 65;
  EXPECT_THAT(refused(s, options), HasSubstr("1 to 64"));
  options = {};
  options.expected_name = "other";
  EXPECT_THAT(refused(s, options), HasSubstr("'sample_all' where the build expects 'other'"));
  options = {};
  for (const char* bad : {"while", "errno", "linux", "a b", "a/b", "../a", "", "a\"b"}) {
    s.mechanism.name = bad;
    EXPECT_THAT(refused(s, options), HasSubstr("cannot name a mechanism")) << bad;
  }
}

/// A value that is written into its user stands before the last statements of the block before: blocks are
/// written to in turns there, and each loads a value of an earlier block once.
TEST(Emit, BlocksLoadAValueOnce) {
  Program program;
  program.function = "bias";
  program.inputs = {{ArgumentKind::q, 0, "a"}, {ArgumentKind::q, 1, "b"}};
  program.code = {{Operation::input, 0, 0}, {Operation::input, 1, 0}, {Operation::mul, 0, 1}};
  const std::uint32_t shared = 2;
  std::uint32_t sum = shared;
  for (int k = 0; k < 5000; ++k) {
    // The product is used by the statement after the next one.
    program.code.push_back({Operation::mul, shared, 1});
    const auto product = static_cast<std::uint32_t>(program.code.size() - 1);
    program.code.push_back({Operation::add, sum, shared});
    const auto next = static_cast<std::uint32_t>(program.code.size() - 1);
    program.code.push_back({Operation::mul, next, next});
    program.code.push_back({Operation::add, next + 1, product});
    sum = next + 2;
    program.code.push_back({Operation::mul, sum, sum});
    program.code.push_back({Operation::add, sum, sum + 1});
    sum += 2;
  }
  program.outputs = {{"c", 1, 1, {sum}}};
  OutputFunction signature = *find_function("bias");
  const FunctionBody body = function_body(program, signature);
  ASSERT_GE(body.blocks.size(), 3U);
  int loads = 0;
  for (const CodeBlock& block : body.blocks) {
    std::set<std::string> names;
    std::istringstream lines(block.statement_lines);
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("const S ")) continue;
      const std::string name = line.substr(8, line.find(' ', 8) - 8);
      EXPECT_TRUE(names.insert(name).second) << "declared twice: " << line;
      loads += line.find("= kept[") != std::string::npos ? 1 : 0;
    }
  }
  EXPECT_GE(loads, 4);
}

TEST(Emit, ProgramsThatDoNotFitAreDefects) {
  const sample::Sample s = sample::big();
  using Programs = std::vector<Program>;
  const auto emit = [&](const std::function<void(Programs&)>& change) {
    Programs programs = s.programs;
    change(programs);
    return emit_mechanism(s.mechanism, programs, EmitOptions());
  };
  EXPECT_THROW(emit([](Programs& p) { p[0].function = "nonsense"; }), InternalError);
  EXPECT_THROW(emit([](Programs& p) { p[1].function = p[0].function; }), InternalError);
  EXPECT_THROW(emit([](Programs& p) { p[0].outputs[0].values.pop_back(); }), InternalError);
  EXPECT_THROW(emit([](Programs& p) { p[0].outputs.clear(); }), InternalError);
  EXPECT_THROW(emit([](Programs& p) { p[1].inputs[0].kind = ArgumentKind::qdd; }), InternalError);
  EXPECT_THROW(emit([](Programs& p) { p[0].inputs[0].index = 6; }), InternalError);
  EXPECT_NO_THROW(emit([](Programs&) {}));
}

TEST(Emit, ARecursionIsWrittenOnceAndRunOften) {
  const sample::Sample s = sample::stepping();
  const Program& program = s.programs[0];
  const FunctionBody body = function_body(program, *find_function("inverse_dynamics"));
  std::size_t statements = 0;
  for (const CodeBlock& block : body.blocks) statements += block.statements;
  std::size_t in_loops = 0;
  for (const Loop& loop : program.loops) in_loops += loop.length * loop.count;
  EXPECT_GT(2 * in_loops, program.code.size());
  EXPECT_LT(statements, program.code.size() - in_loops);
}

TEST(Emit, EqualResultsAtEvenDistancesAreALoop) {
  ProgramMaker m(1);
  m.program.function = "bias";
  std::vector<std::uint32_t> c(120, m.constant(0));
  const std::uint32_t square = m.mul(m.input(0), m.input(0));
  for (std::size_t i = 3; i < 40; ++i) c[i] = i == 3 ? m.add(square, square) : square;
  for (std::size_t i = 40; i < 120; i += 2) c[i] = square;
  const FunctionBody body = function_body(m.returning(c), *find_function("bias"));
  const std::string& text = body.blocks[0].statement_lines;
  EXPECT_THAT(text, HasSubstr("\nc[2] = S(0.0);\n"));
  EXPECT_THAT(text, HasSubstr("for (int i = 4; i <= 40; ++i) c[i] = t0;\n"));
  EXPECT_THAT(text, HasSubstr("for (int i = 42; i <= 118; i += 2) c[i] = t0;\n"));
  EXPECT_THAT(text, HasSubstr("for (int i = 41; i <= 119; i += 2) c[i] = S(0.0);\n"));
  EXPECT_EQ(body.blocks[0].statements, 9u);
}

TEST(Emit, FewDotProductsAreStraightOverManyStates) {
  const sample::Sample s = sample::stepping();
  const std::size_t found = dot_products(s.programs[1]);
  ASSERT_GT(found, 0u);
  const auto loops = [&](std::size_t least) {
    EmitOptions options;
    options.batch = {"mass_matrix_and_bias"};
    options.batch_dot_products = least;
    const std::vector<EmittedFile> files = emit_mechanism(s.mechanism, s.programs, options);
    return text_of(files, "include/sample_steps/sample_steps_batch_impl.hpp").find("dot_products<") !=
           std::string::npos;
  };
  EXPECT_TRUE(loops(found));
  EXPECT_FALSE(loops(found + 1));
}

TEST(Emit, LoopsThatReadInNoOrderAreWrittenStraightOn) {
  ProgramMaker m(4);
  m.program.function = "inverse_dynamics";
  std::vector<std::uint32_t> x, y, z;
  for (std::uint32_t i = 0; i < 4; ++i) x.push_back(m.input(i));
  for (std::uint32_t i = 0; i < 4; ++i) y.push_back(m.mul(x[i], x[i]));
  for (const std::uint32_t i : {0, 2, 1, 3}) z.push_back(m.add(y[i], y[i]));
  Program program = m.returning(z);
  const OutputFunction& signature = *find_function("inverse_dynamics");
  const std::string straight = function_body(program, signature).blocks[0].statement_lines;
  program.loops = {{y[0], 1, 4}, {z[0], 1, 4}};
  const FunctionBody body = function_body(program, signature);
  ASSERT_EQ(body.blocks.size(), 1u);
  EXPECT_EQ(body.blocks[0].statement_lines, straight);
}

// That the output of sample::evil() compiles, and names come through it, is in test_compiled.cpp.

}  // namespace
}  // namespace alembert
