// Generated code against KDL, MuJoCo, DART and Simbody on the same mechanisms and states: inverse dynamics,
// M, forward dynamics, and functions over many states. All agree before anything is timed. Prints one table;
// ratios are of medians of runs that were interleaved at random.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <random>
#include <regex>
#include <stdexcept>

#include "alembert/batch.hpp"
#include "benchmark/compiled_mechanism.hpp"
#include "benchmark/timings.hpp"
#include "oracles/engines/engine.hpp"

namespace alembert::benchmarks {
namespace {

constexpr std::size_t kStates = 32;
constexpr std::size_t kBatch = 1032;  // no power of two, whose strides share the lines of a cache
const char* const kFunctions[] = {"ID", "M", "FD"};

struct State {
  oracles::JointMotion motion;
  Eigen::VectorXd tau;
};

/// A mechanism in all engines that can express it.
struct Subject {
  CompiledMechanism compiled;
  std::unique_ptr<oracles::JointTree> tree;
  std::vector<std::string> names;  ///< of engines
  std::vector<std::unique_ptr<oracles::EngineModel>> models;
  std::vector<std::unique_ptr<oracles::TimedModel>> engines;
  std::vector<State> states;
  std::vector<double> M;
  Eigen::VectorXd result;
  std::vector<double> q, qd, qdd, tau, out;  ///< of batches
};

void expect_close(const double* a, const double* b, std::size_t n, const std::string& what) {
  double largest = 1, difference = 0;
  for (std::size_t i = 0; i < n; ++i) {
    largest = std::max(largest, std::abs(b[i]));
    difference = std::max(difference, std::abs(a[i] - b[i]));
  }
  if (!(difference <= 1e-6 * largest))
    throw std::runtime_error(what + " differs by " + std::to_string(difference / largest));
}

std::unique_ptr<Subject> make_subject(const CompiledMechanism& compiled) {
  auto s = std::make_unique<Subject>();
  s->compiled = compiled;
  s->tree = std::make_unique<oracles::JointTree>(oracles::read_description(compiled.description));
  const auto n = static_cast<Eigen::Index>(compiled.n);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  const auto draw = [&] {
    return Eigen::VectorXd(Eigen::VectorXd::NullaryExpr(n, [&] { return uniform(random); }));
  };
  s->result = Eigen::VectorXd::Zero(n);
  s->M.resize(compiled.n * compiled.n);
  for (std::size_t k = 0; k < kStates; ++k) {
    State state;
    state.motion.position = draw();
    state.motion.speed = draw();
    state.motion.rate = draw();
    state.tau.resize(n);
    compiled.inverse_dynamics(state.motion.position.data(), state.motion.speed.data(),
                              state.motion.rate.data(), state.tau.data());
    compiled.forward_dynamics(state.motion.position.data(), state.motion.speed.data(), state.tau.data(),
                              s->result.data());
    expect_close(s->result.data(), state.motion.rate.data(), compiled.n,
                 compiled.name + ": forward dynamics");
    s->states.push_back(state);
  }
  for (const oracles::Engine& engine : oracles::engines()) {
    if (!engine.make) continue;
    std::unique_ptr<oracles::EngineModel> model;
    std::unique_ptr<oracles::TimedModel> timed;
    try {
      model = engine.make(*s->tree);
      timed = model->timed();
    } catch (const std::exception& error) {
      // MuJoCo's parser refuses bodies nested as deeply as in a chain of 200; KDL is timed on chains only.
      std::fprintf(stderr, "%s in %s is left out: %s\n", compiled.name.c_str(), engine.name.c_str(),
                   error.what());
      continue;
    }
    const State& state = s->states[0];
    const std::string name = compiled.name + " in " + engine.name;
    expect_close(timed->inverse_dynamics(state.motion), state.tau.data(), compiled.n,
                 name + ": inverse dynamics");
    expect_close(timed->forward_dynamics(state.motion, state.tau), state.motion.rate.data(), compiled.n,
                 name + ": forward dynamics");
    s->names.push_back(engine.name);
    s->models.push_back(std::move(model));
    s->engines.push_back(std::move(timed));
  }
  if (compiled.inverse_dynamics_batch != nullptr) {
    for (std::vector<double>* x : {&s->q, &s->qd, &s->qdd, &s->tau, &s->out}) x->resize(compiled.n * kBatch);
    for (std::size_t i = 0; i < compiled.n; ++i)
      for (std::size_t k = 0; k < kBatch; ++k) {
        const State& state = s->states[k % kStates];
        const auto row = static_cast<Eigen::Index>(i);
        s->q[i * kBatch + k] = state.motion.position[row];
        s->qd[i * kBatch + k] = state.motion.speed[row];
        s->qdd[i * kBatch + k] = state.motion.rate[row];
        s->tau[i * kBatch + k] = state.tau[row];
      }
  }
  return s;
}

template <class F>
void add(const std::string& name, F body) {
  benchmark::RegisterBenchmark(name.c_str(), [body](benchmark::State& run) {
    std::size_t k = 0;
    for (auto step : run) {
      static_cast<void>(step);
      body(k);
      k = (k + 1) % kStates;
      benchmark::ClobberMemory();
    }
  });
}

constexpr std::pair<const char*, Instructions> kSets[] = {
    {"baseline", Instructions::baseline}, {"avx2", Instructions::avx2}, {"avx512", Instructions::avx512}};

void register_subject(Subject& s) {
  const std::string& name = s.compiled.name;
  const CompiledMechanism& c = s.compiled;
  add(name + "/alembert/ID", [&s, c](std::size_t k) {
    const oracles::JointMotion& m = s.states[k].motion;
    c.inverse_dynamics(m.position.data(), m.speed.data(), m.rate.data(), s.result.data());
  });
  add(name + "/alembert/M",
      [&s, c](std::size_t k) { c.mass_matrix(s.states[k].motion.position.data(), s.M.data()); });
  add(name + "/alembert/FD", [&s, c](std::size_t k) {
    const State& state = s.states[k];
    c.forward_dynamics(state.motion.position.data(), state.motion.speed.data(), state.tau.data(),
                       s.result.data());
  });
  for (std::size_t e = 0; e < s.names.size(); ++e) {
    oracles::TimedModel* engine = s.engines[e].get();
    add(name + "/" + s.names[e] + "/ID",
        [&s, engine](std::size_t k) { engine->inverse_dynamics(s.states[k].motion); });
    add(name + "/" + s.names[e] + "/M",
        [&s, engine](std::size_t k) { engine->mass_matrix(s.states[k].motion); });
    add(name + "/" + s.names[e] + "/FD",
        [&s, engine](std::size_t k) { engine->forward_dynamics(s.states[k].motion, s.states[k].tau); });
  }
  if (c.inverse_dynamics_batch == nullptr) return;
  for (const auto& [set, instructions] : kSets) {
    if (!has_instructions(instructions)) continue;
    BatchOptions options;
    options.instructions = instructions;
    add(name + "/" + set + "/ID", [&s, c, options](std::size_t) {
      c.inverse_dynamics_batch(kBatch, kBatch, s.q.data(), s.qd.data(), s.qdd.data(), s.out.data(), options);
    });
    expect_close(s.tau.data(),
                 (c.inverse_dynamics_batch(kBatch, kBatch, s.q.data(), s.qd.data(), s.qdd.data(),
                                           s.out.data(), options),
                  s.out.data()),
                 c.n * kBatch, name + ": batch");
    add(name + "/" + set + "/FD", [&s, c, options](std::size_t) {
      c.forward_dynamics_batch(kBatch, kBatch, s.q.data(), s.qd.data(), s.tau.data(), s.out.data(), options);
    });
  }
}

/// Rounds of what measures the ceiling.
constexpr int kFusedRounds = 1000, kAngleRounds = 100;

/// Operations of a function.
struct Counts {
  double multiplications = 0, additions = 0, angles = 0;
  double all() const { return multiplications + additions; }
};

/// From the comment in the generated header; none if it has no such function.
Counts operations(const CompiledMechanism& compiled, const std::string& function) {
  std::ifstream stream(compiled.header);
  const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  const std::size_t at = text.find("\nvoid " + function + "(");
  if (at == std::string::npos) return {};
  const std::size_t line = text.rfind("Operations: ", at);
  const std::string counts = text.substr(line, at - line);
  const auto number = [&](const std::string& before) {
    std::smatch match;
    return std::regex_search(counts, match, std::regex("([0-9]+)\\s*(?:///)?\\s*" + before))
               ? std::stod(match[1])
               : 0.0;
  };
  // A sine and a cosine of each angle.
  return {number("multiplication"), number("addition"), number("sin/cos/tan") / 2};
}

void print_table(const std::vector<std::unique_ptr<Subject>>& subjects,
                 const std::map<std::string, Timing>& timings) {
  const auto time = [&](const std::string& name) {
    const auto found = timings.find(name);
    return found == timings.end() ? 0.0 : found->second.nanoseconds;
  };
  double worst = 0, sum = 0;
  for (const auto& [name, timing] : timings) {
    worst = std::max(worst, timing.variation);
    sum += timing.variation;
  }
  const double ceiling = fused_operations(kFusedRounds) / time("ceiling");
  const double angle = time("angles") / sines_of_angles(kAngleRounds);
  std::printf(
      "Medians in ns; the other engines as multiples of MuJoCo are their time over its. Coefficient of "
      "variation of the\n"
      "repetitions: mean %.1f%%, largest %.1f%%. FMA in AVX2 without dependencies: %.1f Gop/s. Sine and "
      "cosine: %.2f ns.\n\n",
      100 * sum / static_cast<double>(timings.size()), 100 * worst, ceiling, angle);
  std::printf("| mechanism | | alembert | Gop/s | KDL | MuJoCo | DART | Simbody | alembert / MuJoCo |\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  const auto cell = [](double value) { value > 0 ? std::printf(" %.0f |", value) : std::printf(" - |"); };
  for (const auto& s : subjects) {
    const CompiledMechanism& c = s->compiled;
    const double counts[] = {operations(c, "inverse_dynamics").all(), operations(c, "mass_matrix").all(),
                             operations(c, "forward_dynamics").all()};
    for (std::size_t f = 0; f < 3; ++f) {
      const double ours = time(c.name + "/alembert/" + kFunctions[f]);
      const double mujoco = time(c.name + "/MuJoCo/" + kFunctions[f]);
      std::printf("| %s | %s | %.0f | %.1f |", c.name.c_str(), kFunctions[f], ours, counts[f] / ours);
      for (const char* engine : {"KDL", "MuJoCo", "DART", "Simbody"})
        cell(time(c.name + "/" + engine + "/" + kFunctions[f]));
      mujoco > 0 ? std::printf(" %.3f |\n", ours / mujoco) : std::printf(" - |\n");
    }
  }
  std::printf(
      "\nMany states: ns a state, times faster than the function over one in a loop, Gop/s (sines and "
      "cosines not counted). The last column:\n"
      "how many times faster AVX2 would be if only the multiplications took time, at the rate of FMA, and "
      "the sines and cosines.\n\n"
      "| mechanism | | one | baseline | AVX2 | AVX-512 | AVX2 at most |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n");
  for (const auto& s : subjects) {
    const CompiledMechanism& c = s->compiled;
    if (c.inverse_dynamics_batch == nullptr) continue;
    for (const std::string f : {"ID", "FD"}) {
      const double one = time(c.name + "/alembert/" + f);
      const Counts counts = operations(c, f == "ID" ? "inverse_dynamics" : "forward_dynamics");
      const double least = counts.multiplications / (ceiling / 2) + counts.angles * angle;
      std::printf("| %s | %s | %.0f |", c.name.c_str(), f.c_str(), one);
      for (const auto& [set, instructions] : kSets) {
        const double each = time(c.name + "/" + set + "/" + f) / static_cast<double>(kBatch);
        each > 0 ? std::printf(" %.1f, %.1fx, %.1f |", each, one / each, counts.all() / each)
                 : std::printf(" - |");
      }
      std::printf(" %.1fx |\n", one / least);
    }
  }
}

}  // namespace
}  // namespace alembert::benchmarks

int main(int argc, char** argv) {
  using namespace alembert::benchmarks;
  try {
    std::vector<std::unique_ptr<Subject>> subjects;
    for (const CompiledMechanism& compiled : compiled_mechanisms())
      subjects.push_back(make_subject(compiled));
    for (const auto& subject : subjects) register_subject(*subject);
    add("ceiling", [](std::size_t) { fused_operations(kFusedRounds); });
    add("angles", [](std::size_t) { sines_of_angles(kAngleRounds); });
    print_table(subjects, run_registered(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_dynamics: %s\n", error.what());
    return 1;
  }
  return 0;
}
