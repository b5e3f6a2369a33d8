// C99 of every mechanism of the catalogue and of samples, compiled with each C compiler at hand and all
// warnings, against the interpreter: the same bits for double, and for float as many units in the last place
// as double may differ by elsewhere. JavaScript of the same by node, to 1e-12.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <sstream>

#include "catalogue.hpp"
#include "emit/c_library.hpp"
#include "emit/c_state.hpp"
#include "emit/javascript_check.hpp"
#include "emit/sample.hpp"
#include "mechanism/names.hpp"
#include "pipeline.hpp"
#include "program/interpret.hpp"

namespace sample {
namespace {

using alembert::ArgumentKind;
using alembert::EmitOptions;
using alembert::Language;
using alembert::Mechanism;
using alembert::Program;
using testing::HasSubstr;

/// Emits, compiles with each compiler and compares every function at a few states.
template <class Real>
void check(const Mechanism& mechanism, const std::vector<Program>& programs) {
  const std::string number = sizeof(Real) == 4 ? "float" : "double";
  EmitOptions options;
  options.language = Language::c;
  options.scalars = {number};
  std::vector<alembert::EmittedFile> files = alembert::emit_mechanism(mechanism, programs, options);
  std::vector<std::string> names;
  for (const Program& program : programs) names.push_back(program.function);
  files.push_back({"caller.c", caller(mechanism.name, names, number)});
  const Folder folder;
  put(files, folder.path);
  std::istringstream compilers(ALEMBERT_C_COMPILERS);
  for (std::string compiler; std::getline(compilers, compiler, ':');) {
    const CLibrary<Real> library(folder.path, mechanism.name, compiler);
    if (!library.loaded()) continue;
    for (std::size_t f = 0; f < programs.size(); ++f) {
      const Program& program = programs[f];
      const std::string what =
          fmt::format("{} of {} for {} by {}", names[f], mechanism.name, number, compiler);
      CState<Real> state(mechanism, 0);
      for (std::uint64_t seed = 0; seed < 5; ++seed) {
        state = CState<Real>(mechanism, seed);
        const CCall<Real> call(library, f, program, state);
        EXPECT_EQ(call.status, 0) << what;
        const std::vector<double> expected = state.interpreted(program);
        expect_near(program, call.results, expected, what);
        EXPECT_TRUE(random_functions(mechanism) ||
                    std::ranges::all_of(expected, [](double x) { return std::isfinite(x); }))
            << what;
      }
      state.set_defaults(mechanism);
      const std::vector<Real> by_default = CCall<Real>(library, f, program, state, true).results;
      const std::vector<Real> given = CCall<Real>(library, f, program, state).results;
      EXPECT_TRUE(std::ranges::equal(by_default, given, same<Real>))
          << "NULL stands for the description's parameters and for no wrenches: " << what;
      const CCall<Real> refused(library, f, program, state, false, true);
      EXPECT_EQ(refused.status, 1) << what;
      EXPECT_TRUE(std::ranges::all_of(refused.results, [](Real x) { return std::isnan(x); })) << what;
    }
  }
}

void check_file(const std::string& path, const alembert::CompileOptions& options = {}) {
  const alembert::CompiledMechanism compiled = all_functions(path, options);
  check<double>(*compiled.mechanism, programs_of(compiled));
  check<float>(*compiled.mechanism, programs_of(compiled));
  check_javascript(*compiled.mechanism, programs_of(compiled));
}

TEST(C99, EveryOperation) {
  const Sample s = every_function();
  check<double>(s.mechanism, s.programs);
}
TEST(C99, Blocks) {
  const Sample s = big();
  check<double>(s.mechanism, s.programs);
}
TEST(C99, Loops) {
  const Sample s = stepping();
  check<double>(s.mechanism, s.programs);
}
TEST(C99, DotProducts) {
  const Sample s = looping();
  check<double>(s.mechanism, s.programs);
}
TEST(C99, NamesAreTextOnly) {
  const Sample s = evil();
  check<double>(s.mechanism, s.programs);
  check_file(ALEMBERT_SOURCE_DIR "/tests/emit/macro_names.yaml");
}
TEST(C99, Forces) {
  check_file(ALEMBERT_SOURCE_DIR "/mechanisms/forces/hopping_leg.yaml");
  check_file(ALEMBERT_SOURCE_DIR "/mechanisms/forces/elbow_elastic_tendons.yaml");
}
TEST(C99, ChainWithLoops) {
  alembert::CompileOptions options;
  options.loop_results = 6;
  options.loop_operations = 300;
  check_file(ALEMBERT_SOURCE_DIR "/tests/emit/chain.yaml", options);
}

TEST(C99, HeaderIsThatOfTheInterfaceOfCpp) {
  const Sample s = every_function();
  EmitOptions options;
  const std::vector<alembert::EmittedFile> cpp = alembert::emit_mechanism(s.mechanism, s.programs, options);
  options.language = Language::c;
  options.scalars = {"double"};
  const std::vector<alembert::EmittedFile> c = alembert::emit_mechanism(s.mechanism, s.programs, options);
  ASSERT_EQ(c.size(), 2u);
  EXPECT_EQ(c[0].path, "include/sample_all/sample_all.h");
  EXPECT_EQ(c[1].path, "src/sample_all.c");
  const auto same = std::ranges::find(cpp, c[0].path, &alembert::EmittedFile::path);
  ASSERT_NE(same, cpp.end());
  // But for the guard.
  const auto declarations = [](const std::string& text) {
    const std::size_t begin = text.find("#ifdef __cplusplus"), end = text.rfind("#ifdef __cplusplus");
    return text.substr(begin, end - begin);
  };
  EXPECT_GT(declarations(c[0].text).size(), 2000u);
  EXPECT_EQ(declarations(c[0].text), declarations(same->text));
  EXPECT_THAT(c[0].text, HasSubstr("sample_all_coordinate_"));
  // Lists have the names that they have in C.
  EXPECT_THAT(c[0].text, HasSubstr("sample_all_body_names the matrix [R p]"));
  EXPECT_THAT(c[0].text, testing::Not(HasSubstr("kBodyNames")));
  EXPECT_THAT(cpp[1].text, HasSubstr("kBodyNames the matrix [R p]"));
  for (const char* word : {"std::", "nullptr", "Eigen", "template", "malloc", "#include <c"})
    EXPECT_THAT(c[1].text, testing::Not(HasSubstr(word)));
}

TEST(C99, KeywordsAreNoNames) {
  for (const char* keyword :
       {"auto",   "break",  "case",     "char",       "const",    "continue", "default",  "do",
        "double", "else",   "enum",     "extern",     "float",    "for",      "goto",     "if",
        "inline", "int",    "long",     "register",   "restrict", "return",   "short",    "signed",
        "sizeof", "static", "struct",   "switch",     "typedef",  "union",    "unsigned", "void",
        "while",  "_Bool",  "_Complex", "_Imaginary", "volatile"})
    EXPECT_NE(alembert::objection_to_mechanism_name(keyword), "") << keyword;
}

TEST(C99, OneScalarAndNoBatches) {
  const Sample s = every_function();
  const auto error_of = [&](const EmitOptions& options) -> std::string {
    try {
      alembert::emit_mechanism(s.mechanism, s.programs, options);
    } catch (const alembert::InputError& error) {
      return error.what();
    }
    return "";
  };
  EmitOptions options;
  options.language = Language::c;
  EXPECT_THAT(error_of(options), HasSubstr("C is written for one scalar type"));
  options.scalars = {"float"};
  EXPECT_EQ(error_of(options), "");
  Program measured = s.programs[0];
  measured.formulation = "reduced";
  measured.error = 2e-16;
  const auto files = alembert::emit_mechanism(s.mechanism, {&measured, 1}, options);
  EXPECT_THAT(files[0].text, HasSubstr("relative error 2e-16 in double where it was measured"));
  options.batch = {"bias"};
  EXPECT_THAT(error_of(options), HasSubstr("functions over many states are written in C++ only"));
}

TEST(JavaScript, EveryOperation) {
  const alembert::CompiledMechanism compiled =
      all_functions(ALEMBERT_SOURCE_DIR "/tests/emit/batch_sample.yaml");
  check_javascript(*compiled.mechanism, programs_of(compiled));
}
TEST(JavaScript, NamesAreTextOnly) {
  for (const Sample& s : {every_function(), evil()})
    check_javascript(s.mechanism, s.programs, {"mass_matrix", "energy"});
}
TEST(JavaScript, StepsInLoops) {
  const Sample s = stepping();
  check_javascript(s.mechanism, s.programs);
}
TEST(JavaScript, TablesWithConstants) {
  alembert::CompileOptions options;
  for (const char* name : {"mass_matrix", "body_jacobians", "inverse_dynamics_derivatives"})
    options.functions.emplace_back(*alembert::find_function(name));
  options.loop_results = 6;
  options.loop_operations = 100000;  // blocks instead
  const alembert::CompiledMechanism compiled = alembert::compile_mechanism(
      alembert::read_source(ALEMBERT_SOURCE_DIR "/tests/emit/chain.yaml"), options);
  check_javascript(*compiled.mechanism, programs_of(compiled));
}
TEST(JavaScript, IsForDoubleAlone) {
  const Sample s = every_function();
  EmitOptions options;
  options.language = Language::javascript;
  const auto error_of = [&]() -> std::string {
    try {
      alembert::emit_mechanism(s.mechanism, s.programs, options);
    } catch (const alembert::InputError& error) {
      return error.what();
    }
    return "";
  };
  options.scalars = {"float"};
  EXPECT_THAT(error_of(), HasSubstr("JavaScript has one scalar type: double"));
  options.scalars = {"double"};
  options.batch = {"bias"};
  EXPECT_THAT(error_of(), HasSubstr("functions over many states are written in C++ only"));
}

class C99Catalogue : public testing::TestWithParam<std::string> {};
TEST_P(C99Catalogue, GivesWhatTheInterpreterGives) {
  check_file(GetParam());
}
INSTANTIATE_TEST_SUITE_P(Files, C99Catalogue,
                         testing::ValuesIn(alembert::test::catalogue_where([](const std::string& path) {
                           return std::filesystem::path(path).parent_path() == ALEMBERT_SOURCE_DIR
                                  "/mechanisms";
                         })),
                         [](const auto& file) { return alembert::test::test_name(file.param); });

}  // namespace
}  // namespace sample
