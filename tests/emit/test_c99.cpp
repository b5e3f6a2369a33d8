// C99 of every mechanism of the catalogue and of samples, compiled with each C compiler at hand and all
// warnings, against the interpreter: the same bits for double, and for float as many units in the last place
// as double may differ by elsewhere.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <sstream>

#include "catalogue.hpp"
#include "emit/c_library.hpp"
#include "emit/sample.hpp"
#include "mechanism/load.hpp"
#include "pipeline.hpp"
#include "program/passes.hpp"

namespace sample {
namespace {

using alembert::ArgumentKind;
using alembert::EmitOptions;
using alembert::Language;
using alembert::Mechanism;
using alembert::Program;
using testing::HasSubstr;

/// 1e-12 of the largest entry of an array, in units of the last place of double; as many of float are
/// allowed.
constexpr double kFloatTolerance = 1e-12 * 0x1p29;

/// Whether it is a sample, whose functions are random ones.
bool random_functions(const Mechanism& mechanism) {
  return mechanism.name.starts_with("sample_");
}

/// A random state as arrays of numbers that Real holds exactly.
template <class Real>
struct CState {
  std::vector<Real> q, qd, qdd, tau, parameters, wrenches;
  Real t;

  CState(const Mechanism& mechanism, std::uint64_t seed) {
    Random random(seed);
    const bool wide = random_functions(mechanism);
    const auto near = [&](double x, double by) { return static_cast<Real>(x + random.uniform(-by, by)); };
    for (const alembert::Coordinate& c : mechanism.coordinates) {
      double square = 0;
      const std::size_t first = q.size();
      for (const double x : c.initial) {
        q.push_back(wide ? near(0, 2) : near(x, 0.5));
        square += static_cast<double>(q.back()) * static_cast<double>(q.back());
      }
      for (std::size_t i = first; i < q.size() && c.type == alembert::CoordinateType::quaternion; ++i)
        q[i] = static_cast<Real>(static_cast<double>(q[i]) / std::sqrt(square));
    }
    for (std::vector<Real>* array : {&qd, &qdd, &tau})
      for (int i = 0; i < mechanism.nv; ++i) array->push_back(near(0, 2));
    for (const alembert::Parameter& p : mechanism.parameters)
      if (p.runtime) parameters.push_back(wide ? near(1.25, 0.75) : near(p.value, 0.1 * std::abs(p.value)));
    for (const alembert::Body& body : mechanism.bodies)
      for (int i = 0; i < 6 && body.external_wrench; ++i) wrenches.push_back(near(0, 3));
    t = near(1, 1);
  }
  const std::vector<Real>& array(ArgumentKind kind) const {
    switch (kind) {
      case ArgumentKind::q:
        return q;
      case ArgumentKind::qd:
        return qd;
      case ArgumentKind::qdd:
        return qdd;
      case ArgumentKind::tau:
        return tau;
      case ArgumentKind::parameter:
        return parameters;
      case ArgumentKind::wrench:
        return wrenches;
      case ArgumentKind::time:
        break;
    }
    throw std::invalid_argument("no array");
  }
  std::vector<double> interpreted(const Program& program) const {
    std::vector<double> inputs, scratch;
    for (const alembert::InputSlot& slot : program.inputs)
      inputs.push_back(
          static_cast<double>(slot.kind == ArgumentKind::time ? t : array(slot.kind)[slot.index]));
    std::size_t size = 0;
    for (const alembert::OutputArray& output : program.outputs) size += output.values.size();
    std::vector<double> outputs(size);
    alembert::interpret(program, inputs, outputs, scratch);
    return outputs;
  }
};

/// A function's results in C, one array after the other; arrays that it needs may be null.
template <class Real>
struct CCall {
  std::vector<Real> results;
  int status;

  CCall(const CLibrary<Real>& library, std::size_t function, const Program& program,
        const CState<Real>& state, bool defaults = false, bool no_argument = false) {
    std::size_t size = 0;
    for (const alembert::OutputArray& output : program.outputs) size += output.values.size();
    results.assign(size, std::numeric_limits<Real>::quiet_NaN());
    std::vector<const Real*> arguments;
    for (const ArgumentKind kind : alembert::find_signature(program.function)->arguments)
      arguments.push_back(no_argument ? nullptr : state.array(kind).data());
    std::vector<Real*> to;
    std::size_t first = 0;
    for (const alembert::OutputArray& output : program.outputs) {
      to.push_back(results.data() + first);
      first += output.values.size();
    }
    if (no_argument && arguments.empty()) to.back() = nullptr;
    status = library(function, arguments, state.t, defaults ? nullptr : state.parameters.data(),
                     defaults ? nullptr : state.wrenches.data(), to);
  }
};

/// One NaN is as good as another; random functions have some.
template <class Real>
bool same(Real x, Real y) {
  return x == y || (std::isnan(x) && std::isnan(y));
}

void expect_near(const Program&, const std::vector<double>& results, const std::vector<double>& expected,
                 const std::string& what) {
  EXPECT_TRUE(std::ranges::equal(results, expected, same<double>))
      << what << ": " << testing::PrintToString(results) << " and " << testing::PrintToString(expected);
}
void expect_near(const Program& program, const std::vector<float>& results,
                 const std::vector<double>& expected, const std::string& what) {
  std::size_t i = 0;
  for (const alembert::OutputArray& output : program.outputs) {
    const std::size_t end = i + output.values.size();
    double largest = 0;
    for (std::size_t k = i; k < end; ++k) largest = std::max(largest, std::abs(expected[k]));
    for (; i < end; ++i)
      EXPECT_NEAR(static_cast<double>(results[i]), expected[i], kFloatTolerance * largest)
          << what << ", " << output.name;
  }
}

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
      for (std::size_t i = 0, k = 0; i < mechanism.parameters.size(); ++i)
        if (mechanism.parameters[i].runtime)
          state.parameters[k++] = static_cast<Real>(mechanism.parameters[i].value);
      state.wrenches.assign(state.wrenches.size(), 0);
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

/// All functions that give anything.
void check_file(const std::string& path, alembert::CompileOptions options = {}) {
  alembert::ExprGraph graph;
  const std::unique_ptr<const Mechanism> mechanism =
      std::make_unique<Mechanism>(alembert::load_mechanism(alembert::read_source(path), graph));
  for (const alembert::FunctionKind kind : alembert::all_function_kinds())
    if (alembert::array_size(alembert::find_signature(to_string(kind))->results[0].size, *mechanism) > 0)
      options.functions.push_back(kind);
  options.singular = alembert::SingularMass::leave_out;
  const alembert::CompiledMechanism compiled =
      alembert::compile_mechanism(alembert::read_source(path), options);
  std::vector<Program> programs;
  for (const alembert::CompiledFunction& function : compiled.functions) programs.push_back(function.program);
  check<double>(*compiled.mechanism, programs);
  check<float>(*compiled.mechanism, programs);
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
  for (const char* word : {"std::", "nullptr", "Eigen", "template", "malloc", "#include <c"})
    EXPECT_THAT(c[1].text, testing::Not(HasSubstr(word)));
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
  options.batch = {"bias"};
  EXPECT_THAT(error_of(options), HasSubstr("functions over many states are written in C++ only"));
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
