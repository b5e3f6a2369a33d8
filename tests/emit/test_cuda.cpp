// CUDA's functions as a compiler of C++ sees them, against the interpreter: the same bits for double, on one of several
// states that lie as kernels read them. Where nvcc is, it compiles the kernels; where it is not, that test is skipped.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "catalogue.hpp"
#include "emit/c_library.hpp"
#include "emit/c_state.hpp"
#include "emit/sample.hpp"
#include "functions/array_shape.hpp"

namespace sample {
namespace {

using alembert::ArgumentKind;
using alembert::EmitOptions;
using alembert::Language;
using alembert::OutputFunction;

EmitOptions for_cuda() {
  EmitOptions options;
  options.language = Language::cuda;
  return options;
}

const OutputFunction& row_of(const Program& program) {
  return *alembert::find_function(program.function);
}

/// C++ that calls a function by its place in a list, on state 1 of 3: call(i, arguments, t, parameters, wrenches, results).
std::string strided_caller(const Mechanism& mechanism, const std::vector<Program>& programs,
                           const std::string& number) {
  std::string text = fmt::format(R"(#include "cuda/{0}.cuh"
#include <vector>
namespace m = ::alembert::mechanisms::{0}::cuda;
using Real = {1};
namespace {{
constexpr std::size_t kStride = 3, kState = 1;
std::vector<Real> spread(const Real* from, std::size_t n) {{
  std::vector<Real> to(kStride * n + 1, Real(0));
  for (std::size_t i = 0; i < n; ++i) to[i * kStride + kState] = from[i];
  return to;
}}
m::Lane<const Real> lane(const std::vector<Real>& x) {{ return {{x.data() + kState, kStride}}; }}
m::Lane<Real> lane(std::vector<Real>& x) {{ return {{x.data() + kState, kStride}}; }}
}}
extern "C" int call(int f, const Real* const* a, Real t, const Real* p, const Real* w, Real* const* r);
extern "C" int call(int f, const Real* const* a, Real t, const Real* p, const Real* w, Real* const* r) {{
  m::BatchInputs<Real> given;
  given.t = t;
  std::vector<Real> parameters, wrenches;
  if (p != nullptr) given.parameters = (parameters = spread(p, m::kParameterCount)).data(), given.parameters_vary = true;
  if (w != nullptr) given.wrenches = (wrenches = spread(w, 6 * m::kWrenchCount)).data();
  const auto in = given.of(kState, kStride);
  (void)in;
  switch (f) {{
)",
                                 mechanism.name, number);
  for (std::size_t f = 0; f < programs.size(); ++f) {
    const OutputFunction& row = row_of(programs[f]);
    std::string before, list, after;
    const auto add = [&](const std::string& item) { list += (list.empty() ? "" : ", ") + item; };
    for (std::size_t i = 0; i < row.arguments.size(); ++i) {
      before += fmt::format("const std::vector<Real> a{0} = spread(a[{0}], {1}); ", i,
                            alembert::argument_size(row.arguments[i], mechanism));
      add(fmt::format("lane(a{})", i));
    }
    if (row.takes_inputs) add("in");
    for (std::size_t i = 0; i < row.results.size(); ++i) {
      const std::size_t size = alembert::array_shape(row.results[i], mechanism).size();
      before += fmt::format("std::vector<Real> r{}(kStride * {} + 1); ", i, size);
      add(fmt::format("lane(r{})", i));
      after += fmt::format("for (int i = 0; i < {0}; ++i) r[{1}][i] = lane(r{1})[i]; ", size, i);
    }
    text += fmt::format("    case {}: {{ {} m::{}<Real>({}); {} return 0; }}\n", f, before, row.name, list,
                        after);
  }
  return text + "    default: (void)a, (void)r; return -1;\n  }\n}\n";
}

template <class Real>
void check(const Mechanism& mechanism, const std::vector<Program>& programs) {
  const std::string number = sizeof(Real) == 4 ? "float" : "double";
  std::vector<alembert::EmittedFile> files = alembert::emit_mechanism(mechanism, programs, for_cuda());
  ASSERT_EQ(files.size(), 1u);
  EXPECT_EQ(files[0].path, "cuda/" + mechanism.name + ".cuh");
  EXPECT_EQ(files[0].text, alembert::emit_mechanism(mechanism, programs, for_cuda())[0].text);
  files.push_back({"caller.cpp", strided_caller(mechanism, programs, number)});
  const Folder folder;
  put(files, folder.path);
  const CLibrary<Real> library(folder.path, ALEMBERT_HOST_CXX,
                               fmt::format("-std=c++17 '-I{0}' '{0}/caller.cpp'", folder.path), 0);
  if (!library.loaded()) return;
  for (std::size_t f = 0; f < programs.size(); ++f) {
    const std::string what = fmt::format("{} of {} for {}", programs[f].function, mechanism.name, number);
    CState<Real> state(mechanism, 0);
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      state = CState<Real>(mechanism, seed);
      const CCall<Real> call(library, f, programs[f], state);
      EXPECT_EQ(call.status, 0) << what;
      expect_near(programs[f], call.results, state.interpreted(programs[f]), what);
    }
    state.set_defaults(mechanism);
    EXPECT_TRUE(std::ranges::equal(CCall<Real>(library, f, programs[f], state, true).results,
                                   CCall<Real>(library, f, programs[f], state).results, same<Real>))
        << "none given are those of the description: " << what;
  }
}

void check_file(const std::string& path, const alembert::CompileOptions& options = {}) {
  const alembert::CompiledMechanism compiled = all_functions(path, options);
  check<double>(*compiled.mechanism, programs_of(compiled));
  check<float>(*compiled.mechanism, programs_of(compiled));
}

TEST(Cuda, EveryOperation) {
  const Sample s = every_function();
  check<double>(s.mechanism, s.programs);
}
TEST(Cuda, LoopsAndDotProducts) {
  for (const Sample& s : {stepping(), looping()}) check<double>(s.mechanism, s.programs);
}
TEST(Cuda, Blocks) {
  const Sample s = big();
  check<double>(s.mechanism, s.programs);
}
TEST(Cuda, NamesAreTextOnly) {
  const Sample s = evil();
  check<double>(s.mechanism, s.programs);
}
TEST(Cuda, Mechanisms) {
  for (const char* name : {"free_body", "runtime_parameters", "four_bar_knee", "forces/hopping_leg"})
    check_file(fmt::format(ALEMBERT_SOURCE_DIR "/mechanisms/{}.yaml", name));
}

/// The whole catalogue, in double: float has too few digits for some of its derivatives. No test of ctest's: test_cuda
/// --gtest_filter=Whole/*
class CudaCatalogue : public testing::TestWithParam<std::string> {};
TEST_P(CudaCatalogue, GivesWhatTheInterpreterGives) {
  const alembert::CompiledMechanism compiled = all_functions(GetParam());
  check<double>(*compiled.mechanism, programs_of(compiled));
}
INSTANTIATE_TEST_SUITE_P(Whole, CudaCatalogue, testing::ValuesIn(alembert::test::catalogue()),
                         [](const auto& file) { return alembert::test::test_name(file.param); });

/// Kernels of all functions for both types, and what ptxas says of them.
TEST(Cuda, KernelsCompile) {
  const std::string nvcc = ALEMBERT_NVCC;
  if (nvcc.empty()) GTEST_SKIP() << "there is no nvcc on this machine";
  for (const char* name : {"puma560", "free_body"}) {
    const alembert::CompiledMechanism compiled =
        all_functions(fmt::format(ALEMBERT_SOURCE_DIR "/mechanisms/{}.yaml", name));
    const std::vector<Program> programs = programs_of(compiled);
    std::vector<alembert::EmittedFile> files =
        alembert::emit_mechanism(*compiled.mechanism, programs, for_cuda());
    std::string text =
        fmt::format("#include \"cuda/{0}.cuh\"\nnamespace m = ::alembert::mechanisms::{0}::cuda;\n", name);
    for (const char* number : {"double", "float"}) {
      for (const Program& program : programs) {
        const OutputFunction& row = row_of(program);
        text += fmt::format(
            "template cudaError_t m::{}_batch<{}>(std::size_t, std::size_t, {}, cudaStream_t);\n", row.name,
            number,
            alembert::argument_list(row, fmt::format("const {}*", number),
                                    row.takes_inputs ? fmt::format("m::BatchInputs<{}>", number) : "",
                                    fmt::format("{}*", number)));
      }
      for (const char* method : {"semi_implicit_euler", "rk4"})
        text += fmt::format(
            "template cudaError_t m::rollout_batch<{0}, m::Method::{1}>(std::size_t, std::size_t, {0}*, "
            "{0}*, const "
            "m::BatchInputs<{0}>&, const m::Rollout<{0}>&, cudaStream_t, const m::NoPolicy&);\n",
            number, method);
    }
    files.push_back({"kernels.cu", text});
    const Folder folder;
    put(files, folder.path);
    const std::string log = folder.path + "/log";
    const std::string command = fmt::format(
        "'{0}' -std=c++17 -arch=sm_80 -Werror all-warnings -Xptxas -v '-I{1}' -c '{1}/kernels.cu' -o "
        "'{1}/kernels.o' "
        ">'{2}' 2>&1",
        nvcc, folder.path, log);
    std::ifstream in;
    const int status = std::system(command.c_str());
    in.open(log);
    const std::string said{std::istreambuf_iterator<char>(in), {}};
    EXPECT_EQ(status, 0) << said;
    EXPECT_THAT(said, testing::HasSubstr("inverse_dynamics_kernel"));
  }
}

/// Files of a mechanism with a caller.cpp, as a library of the host.
CLibrary<double> called_on_host(const std::vector<alembert::EmittedFile>& files, const Folder& folder) {
  put(files, folder.path);
  return CLibrary<double>(folder.path, ALEMBERT_HOST_CXX,
                          fmt::format("-std=c++17 '-I{0}' '{0}/caller.cpp'", folder.path), 0);
}

/// A step is that of forward dynamics, many are steps one by one, and records are what is passed on the way.
TEST(Cuda, RolloutMakesStepsOfForwardDynamics) {
  const alembert::CompiledMechanism compiled =
      all_functions(ALEMBERT_SOURCE_DIR "/mechanisms/free_body.yaml");
  const Mechanism& mechanism = *compiled.mechanism;
  const std::vector<Program> programs = programs_of(compiled);
  std::vector<alembert::EmittedFile> files = alembert::emit_mechanism(mechanism, programs, for_cuda());
  files.push_back({"caller.cpp", R"(#include "cuda/free_body.cuh"
namespace m = ::alembert::mechanisms::free_body::cuda;
struct Push {
  template <class S>
  bool operator()(std::size_t, S, const S*, const S*, S* tau, S*) const {
    tau[0] += S(1);
    return true;
  }
};
/// From 100 on: so many steps less, pushed by 1 more, with the end alone recorded.
extern "C" int call(int, const double* const* a, double, const double*, const double*, double* const* r);
extern "C" int call(int steps, const double* const* a, double, const double*, const double*, double* const* r) {
  for (int i = 0; i < m::kNq; ++i) r[0][i] = a[0][i];
  for (int i = 0; i < m::kNv; ++i) r[1][i] = a[1][i];
  m::Rollout<double> way;
  way.steps = steps;
  way.h = 0.0078125;
  way.tau = a[2];
  way.record = r[2];
  way.every = 5;
  if (steps < 100) {
    m::rollout<double>(0, 1, r[0], r[1], m::BatchInputs<double>(), way);
    return 0;
  }
  way.steps = steps - 100;
  way.every = 0;
  m::rollout<double, m::Method::semi_implicit_euler>(0, 1, r[0], r[1], m::BatchInputs<double>(), way, Push());
  return 0;
}
)"});
  const Folder folder;
  const CLibrary<double> library = called_on_host(files, folder);
  ASSERT_TRUE(library.loaded());
  const std::size_t nq = static_cast<std::size_t>(mechanism.nq), nv = static_cast<std::size_t>(mechanism.nv);
  CState<double> state(mechanism, 1);
  state.wrenches.assign(state.wrenches.size(), 0);
  state.t = 0;
  std::vector<double> q = state.q, u = state.qd, record(4 * (nq + nv), 0.0), on_the_way(nq + nv);
  const auto go = [&](int steps, std::vector<double>& rows) {
    const std::vector<double> from_q = q, from_u = u;
    ASSERT_EQ(library(static_cast<std::size_t>(steps), {from_q.data(), from_u.data(), state.tau.data()}, 0,
                      nullptr, nullptr, {q.data(), u.data(), rows.data()}),
              0);
  };
  const auto program = std::ranges::find(programs, "forward_dynamics", &Program::function);
  ASSERT_NE(program, programs.end());
  const std::vector<double> qdd = state.interpreted(*program);
  std::vector<double> none;
  for (int i = 0; i < 20; ++i) {
    go(1, none);
    for (std::size_t k = 0; k < nv && i == 0; ++k)
      EXPECT_DOUBLE_EQ(u[k], state.qd[k] + 0.0078125 * qdd[k]) << "speed " << k;
    if (i != 4) continue;
    std::ranges::copy(q, on_the_way.begin());
    std::ranges::copy(u, on_the_way.begin() + static_cast<std::ptrdiff_t>(nq));
  }
  const std::vector<double> one_by_one_q = q, one_by_one_u = u;
  q = state.q;
  u = state.qd;
  go(20, record);
  EXPECT_EQ(q, one_by_one_q);
  EXPECT_EQ(u, one_by_one_u);
  EXPECT_TRUE(std::ranges::equal(std::span(record).first(nq + nv), on_the_way));
  double square = 0;
  for (std::size_t i = 3; i < 7; ++i) square += q[i] * q[i];
  EXPECT_NEAR(square, 1, 1e-15);
  // A policy finds held forces as they are given, not as it left them.
  state.tau[0] = 3;
  q = state.q;
  u = state.qd;
  go(20, record);
  const std::vector<double> pushed_q = q, pushed_u = u;
  state.tau[0] = 2;
  q = state.q;
  u = state.qd;
  std::vector<double> end(nq + nv, 0.0);
  go(120, end);
  EXPECT_EQ(q, pushed_q);
  EXPECT_EQ(u, pushed_u);
  EXPECT_TRUE(std::ranges::equal(std::span(end).first(nq), q) &&
              std::ranges::equal(std::span(end).subspan(nq), u));
}

/// The input drives the state a, which drives a block; the state way is what the block has moved. In closed form, a is
/// 1 - 0.75 exp(-t / 0.05), and the speed 2 (t - 0.75 0.05 (1 - exp(-t / 0.05))).
TEST(Cuda, RolloutsIntegrateStatesAndEnd) {
  const alembert::CompiledMechanism compiled = all_functions(ALEMBERT_SOURCE_DIR "/tests/emit/states.yaml");
  std::vector<alembert::EmittedFile> files =
      alembert::emit_mechanism(*compiled.mechanism, programs_of(compiled), for_cuda());
  const std::string name = compiled.mechanism->name;
  files.push_back({"caller.cpp", fmt::format(R"(#include "cuda/{}.cuh"
#include <limits>
namespace m = ::alembert::mechanisms::{}::cuda;
struct UntilMoved {{
  double way;
  bool operator()(std::size_t, double, const double* q, const double*, double*, double* inputs) const {{
    inputs[0] = 1;
    return q[0] < way;
  }}
}};
/// Results: q and qd of 2 motions, of which the second has no finite speed; 2 states; steps and status; the record.
extern "C" int call(int, const double* const* a, double, const double*, const double*, double* const* r);
extern "C" int call(int kind, const double* const* a, double, const double*, const double*, double* const* r) {{
  m::Rollout<double> way;
  way.h = 1e-3;
  way.steps = 300;
  way.every = 100;
  int made[2] = {{}}, status[2] = {{}};
  way.made = made;
  way.status = status;
  way.states = r[1];
  way.record = r[3];
  double start = a[0][0];
  r[0][0] = r[0][1] = start;
  r[0][2] = 0;
  r[0][3] = 1e200 * std::numeric_limits<double>::max();
  for (std::size_t s = 0; s < 2; ++s) {{
    const m::BatchInputs<double> in;
    if (kind == 0) m::rollout<double>(s, 2, r[0], r[0] + 2, in, way);
    if (kind == 1) m::rollout<double, m::Method::rk4>(s, 2, r[0], r[0] + 2, in, way);
    if (kind == 2) m::rollout<double, m::Method::rk4>(s, 2, r[0], r[0] + 2, in, way, UntilMoved{{start + 0.01}});
    r[2][s] = made[s], r[2][2 + s] = status[s];
  }}
  return 0;
}}
)",
                                             name, name)});
  const Folder folder;
  const CLibrary<double> library = called_on_host(files, folder);
  ASSERT_TRUE(library.loaded());
  const double start = 1;
  const auto speed_at = [](double t) { return 2 * (t - 0.75 * 0.05 * (1 - std::exp(-t / 0.05))); };
  for (const std::size_t kind : {0, 1, 2}) {
    std::vector<double> state(4), states(4), ends(4), record(2 * 3 * 4, -1.0);
    ASSERT_EQ(library(kind, {&start}, 0, nullptr, nullptr,
                      {state.data(), states.data(), ends.data(), record.data()}),
              0);
    const double t = 1e-3 * ends[0], near = kind == 0 ? 1e-2 : 1e-7;
    EXPECT_NEAR(state[2], speed_at(t), near);
    EXPECT_NEAR(states[0], 1 - 0.75 * std::exp(-t / 0.05), near);
    EXPECT_NEAR(states[2], state[0] - start, kind == 0 ? 1e-3 : 1e-12);
    EXPECT_EQ(ends[2], 0);
    // The second one makes no step, and its record is its start.
    EXPECT_EQ(ends[1], 0);
    EXPECT_EQ(ends[3], 1);
    EXPECT_EQ(state[1], start);
    EXPECT_EQ(record[1], start);
    if (kind == 2) {
      EXPECT_LT(ends[0], 300);
      EXPECT_GE(state[0], start + 0.01);
      EXPECT_LT(state[0] - 1e-3 * state[2], start + 0.01);
    } else {
      EXPECT_EQ(ends[0], 300);
      EXPECT_NEAR(record[2 * 1], speed_at(0.1), near);
    }
    EXPECT_EQ(record[2 * 8], state[0]) << "the last row is the end, also of what ended before";
    EXPECT_EQ(record[2 * 9], state[2]);
    EXPECT_EQ(record[2 * 10], states[0]);
  }
}

/// Of order four: halved steps have a sixteenth of the error.
TEST(Cuda, RolloutsOfRungeAndKutta) {
  const alembert::CompiledMechanism compiled =
      all_functions(ALEMBERT_SOURCE_DIR "/mechanisms/free_body.yaml");
  std::vector<alembert::EmittedFile> files =
      alembert::emit_mechanism(*compiled.mechanism, programs_of(compiled), for_cuda());
  files.push_back({"caller.cpp", R"(#include "cuda/free_body.cuh"
namespace m = ::alembert::mechanisms::free_body::cuda;
extern "C" int call(int, const double* const* a, double, const double*, const double*, double* const* r);
extern "C" int call(int steps, const double* const* a, double, const double*, const double*, double* const* r) {
  for (int i = 0; i < m::kNq; ++i) r[0][i] = a[0][i];
  for (int i = 0; i < m::kNv; ++i) r[1][i] = a[1][i];
  m::Rollout<double> way;
  way.steps = steps;
  way.h = 0.5 / steps;
  m::rollout<double, m::Method::rk4>(0, 1, r[0], r[1], m::BatchInputs<double>(), way);
  return 0;
}
)"});
  const Folder folder;
  const CLibrary<double> library = called_on_host(files, folder);
  ASSERT_TRUE(library.loaded());
  const CState<double> state(*compiled.mechanism, 1);
  const auto end = [&](std::size_t steps) {
    std::vector<double> q = state.q, u = state.qd;
    EXPECT_EQ(library(steps, {state.q.data(), state.qd.data()}, 0, nullptr, nullptr, {q.data(), u.data()}),
              0);
    q.insert(q.end(), u.begin(), u.end());
    return q;
  };
  const std::vector<double> exact = end(2048);
  const auto error = [&](std::size_t steps) {
    double square = 0;
    const std::vector<double> x = end(steps);
    for (std::size_t i = 0; i < x.size(); ++i) square += (x[i] - exact[i]) * (x[i] - exact[i]);
    return std::sqrt(square);
  };
  EXPECT_NEAR(error(32) / error(64), 16, 3);
}

TEST(Cuda, LoopsAreNotRolledOut) {
  const alembert::CompiledMechanism closed =
      all_functions(ALEMBERT_SOURCE_DIR "/mechanisms/paper/five_bar.yaml");
  EXPECT_THAT(alembert::emit_mechanism(*closed.mechanism, programs_of(closed), for_cuda())[0].text,
              testing::Not(testing::HasSubstr("rollout_batch")));
}

}  // namespace
}  // namespace sample
