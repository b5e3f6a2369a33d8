// `bench`: the C++ of a mechanism is written into a temporary folder, compiled by the compiler at hand and run at
// random states. Out: a row a function: operations, bytes of code, time, and what that is likely spent on.
#include "commands/run_bench.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <utility>

#include "commands/bench_states.hpp"
#include "commands/compiler.hpp"
#include "commands/run_import.hpp"
#include "commands/work_folder.hpp"
#include "emit/bench_program.hpp"
#include "program/time_shares.hpp"

namespace alembert {

namespace {

constexpr int kBenchStates = 256;  // unless --states says otherwise

/// Flags as alembert_add_mechanism sets them (cmake/AlembertAddMechanism.cmake).
const std::vector<std::string> kFlags = {"-O2", "-fno-math-errno", "-DALEMBERT_VECTOR_TRIG"};
const std::vector<std::string> kFlagsOfGcc = {"-fno-tree-slp-vectorize", "-frename-registers",
                                              "-fno-omit-frame-pointer"};
const std::map<std::string, std::vector<std::string>, std::less<>> kFlagsOfInstructions = {
    {"avx2", {"-ffp-contract=off", "-mavx2", "-mfma"}},
    {"avx512", {"-ffp-contract=off", "-mavx512f", "-mavx512dq", "-mavx512vl", "-mavx2", "-mfma"}},
    {"baseline", {"-ffp-contract=off"}}};

Compiler compiler_of(const BenchOptions& options) {
  const std::string advice = "the compiler is that of --compiler, or of the environment variable CXX, or c++";
  const char* const variable = std::getenv("CXX");
  if (!options.compiler.empty() || variable == nullptr || *variable == 0)
    return {"--compiler", options.compiler.empty() ? "c++" : options.compiler, "C++", advice};
  return {"CXX", variable, "C++", advice};
}

/// Times by function, with kBatchEnding and kKeptEnding behind names.
using Times = std::map<std::string, double, std::less<>>;

/// Machine code, by function, and times, by number of states.
struct Measured {
  std::vector<std::string> flags;
  std::map<std::string, std::size_t, std::less<>> bytes;
  std::vector<std::pair<int, Times>> times;
  std::string instructions;  ///< of batches

  /// Of one state: at the first number of states.
  const Times& first() const { return times.front().second; }
};

/// Files of a mechanism, compiled in a folder.
class Build {
 public:
  Build(const CompiledMechanism& compiled, const EmitOptions& emit, const Compiler& compiler)
      : compiled_(compiled), emit_(emit), compiler_(compiler), folder_("bench") {}

  Measured measured(const std::vector<int>& states) {
    Measured out;
    out.flags = flags();
    const std::string& name = compiled_.mechanism->name;
    const std::vector<Program> programs = programs_of(compiled_);
    std::vector<EmittedFile> files = emit_mechanism(*compiled_.mechanism, programs, emit_);
    std::ranges::move(bench_files(*compiled_.mechanism, programs, emit_), std::back_inserter(files));
    for (const EmittedFile& file : files) folder_.write(file);
    std::vector<std::string> sources, link{"-o", folder_ / "bench"};
    for (const EmittedFile& file : files)
      if (file.path.ends_with(".cpp") && file.path != fmt::format("src/{}_c.cpp", name))
        sources.push_back(file.path);
    for (const std::string& source : sources) link.push_back(compile_file(source, out.flags));
    if (!emit_.batch.empty()) link.emplace_back("-pthread");
    compiler_.run(folder_, out.flags, link);
    for (const int n : states) time(n, out);
    for (const std::string& source : sources) add_bytes(source, out);
    return out;
  }

 private:
  std::vector<std::string> flags() const {
    folder_.write({"src/which.cpp", "#if defined(__GNUC__) && !defined(__clang__)\nis_gcc\n#endif\n"});
    const std::vector<std::string> arguments{"-E", folder_ / "src/which.cpp"};
    const bool gcc = compiler_.run(folder_, {}, arguments).find("\nis_gcc") != std::string::npos;
    std::vector<std::string> all = kFlags;
    if (gcc) all.insert(all.end(), kFlagsOfGcc.begin(), kFlagsOfGcc.end());
    return all;
  }
  /// The set of instructions that a file is for; empty for those that are no batch.
  std::string set_of(const std::string& path) const {
    const std::string start = fmt::format("src/{}_batch_", compiled_.mechanism->name);
    return path.starts_with(start) ? path.substr(start.size(), path.size() - start.size() - 4) : "";
  }
  /// The object file.
  std::string compile_file(const std::string& path, const std::vector<std::string>& flags) const {
    const std::string object = folder_ / (path + ".o");
    std::vector<std::string> arguments{"-std=c++17", "-I" + folder_ / "include", "-c", folder_ / path, "-o",
                                       object};
    if (const auto more = kFlagsOfInstructions.find(set_of(path)); more != kFlagsOfInstructions.end())
      arguments.insert(arguments.end(), more->second.begin(), more->second.end());
    compiler_.run(folder_, flags, arguments);
    return object;
  }
  void time(int states, Measured& out) const {
    std::string bytes;
    for (const std::vector<double>& array :
         bench_states(*compiled_.mechanism, static_cast<std::size_t>(states)))
      bytes.append(reinterpret_cast<const char*>(array.data()), array.size() * sizeof(double));
    folder_.write({"states", bytes});
    const ProgramRun done = folder_.run({folder_ / "bench", std::to_string(states), folder_ / "states"});
    if (done.exit_code != 0)
      compiler_.fail(fmt::format("what it compiled does not run: it ended with {}", done.exit_code));
    Times& times = out.times.emplace_back(states, Times{}).second;
    std::istringstream lines(done.out);
    for (std::string name, value; lines >> name >> value;) {
      if (name == "instructions") out.instructions = value;
      if (name != "instructions") times[name] = std::stod(value);
    }
  }
  /// Of the batches those that this machine runs.
  void add_bytes(const std::string& path, Measured& out) const {
    const std::string set = set_of(path);
    if (!set.empty() && set != out.instructions) return;
    const std::optional<std::vector<CodeSymbol>> symbols =
        code_symbols(compiler_, folder_, folder_ / (path + ".o"));
    if (!symbols) return;
    for (const CodeSymbol& symbol : *symbols) {
      for (const CompiledFunction& function : compiled_.functions) {
        const std::string name = fmt::format("::{}", to_string(function.kind));
        const auto has = [&](std::string_view ending) {
          return symbol.name.find(name + std::string(ending)) != std::string::npos;
        };
        if (set.empty() && (has("<double>") || has("_block"))) out.bytes[name.substr(2)] += symbol.bytes;
        if (!set.empty() && (has("_lanes(") || has("_packs<") || has("_pack_block")))
          out.bytes[fmt::format("{}{}", name.substr(2), kBatchEnding)] += symbol.bytes;
      }
    }
  }

  const CompiledMechanism& compiled_;
  const EmitOptions& emit_;
  const Compiler& compiler_;
  WorkFolder folder_;
};

nlohmann::json json_of(const CompiledMechanism& compiled, const Measured& measured) {
  nlohmann::json out = {{"mechanism", compiled.mechanism->name},
                        {"states", nlohmann::json::array()},
                        {"flags", measured.flags}};
  for (const auto& [states, times] : measured.times) out["states"].push_back(states);
  if (!measured.instructions.empty()) out["instructions"] = measured.instructions;
  const auto bytes_of = [&](const std::string& name) {
    const auto bytes = measured.bytes.find(name);
    return bytes == measured.bytes.end() ? nlohmann::json() : nlohmann::json(bytes->second);
  };
  for (const CompiledFunction& f : compiled.functions) {
    const std::string name(to_string(f.kind));
    const TimeShares shares = estimated_shares(f.program);
    nlohmann::json& row = out["functions"][name];
    row = {{"mul", f.count.mul},
           {"add", f.count.add},
           {"div", f.count.div},
           {"trig", f.count.trig},
           {"other", f.count.other},
           {"estimated_shares",
            {{"arithmetic", shares.arithmetic},
             {"division", shares.division},
             {"trig", shares.trig},
             {"other", shares.other},
             {"memory", shares.memory}}}};
    row["median_ns"] = measured.first().at(name);
    row["code_bytes"] = bytes_of(name);
    const std::string as_batch = fmt::format("{}{}", name, kBatchEnding),
                      kept = fmt::format("{}{}", name, kKeptEnding);
    if (!measured.first().contains(as_batch)) continue;
    nlohmann::json& batch = row["batch"];
    batch["code_bytes"] = bytes_of(as_batch);
    for (const auto& [states, times] : measured.times) {
      batch["median_ns"].push_back(times.at(as_batch));
      batch["one_by_one_ns"].push_back(times.at(kept));
    }
  }
  return out;
}

void print_table(const CompiledMechanism& compiled, const Measured& measured) {
  std::size_t width = 22;
  for (const auto& [name, nanoseconds] : measured.first()) width = std::max(width, name.size());
  fmt::print("{:<{}} {:>7} {:>7} {:>5} {:>5} {:>5} {:>9} {:>10}   {:>5} {:>5} {:>5} {:>5} {:>6}\n",
             "function", width, "x", "+", "div", "trig", "other", "bytes", "ns", "x,+", "div", "trig",
             "other", "memory");
  const auto bytes = [&](const std::string& name) {
    const auto found = measured.bytes.find(name);
    return found == measured.bytes.end() ? std::string("-") : std::to_string(found->second);
  };
  for (const CompiledFunction& f : compiled.functions) {
    const std::string name(to_string(f.kind));
    const TimeShares s = estimated_shares(f.program);
    fmt::print(
        "{:<{}} {:>7} {:>7} {:>5} {:>5} {:>5} {:>9} {:>10.4g}   {:>4.0f}% {:>4.0f}% {:>4.0f}% {:>4.0f}% "
        "{:>5.0f}%\n",
        name, width, f.count.mul, f.count.add, f.count.div, f.count.trig, f.count.other, bytes(name),
        measured.first().at(name), 100 * s.arithmetic, 100 * s.division, 100 * s.trig, 100 * s.other,
        100 * s.memory);
  }
  if (measured.instructions.empty()) return;
  fmt::print("\n{:<{}} {:>9}", "states in one call", width, "bytes");
  for (const auto& [states, times] : measured.times) fmt::print(" {:>17}", states);
  fmt::print("\n");
  for (const auto& [name, nanoseconds] : measured.first()) {
    if (!name.ends_with(kBatchEnding)) continue;
    const std::string kept =
        fmt::format("{}{}", name.substr(0, name.size() - kBatchEnding.size()), kKeptEnding);
    fmt::print("{:<{}} {:>9}", name, width, bytes(name));
    for (const auto& [states, times] : measured.times)
      fmt::print(" {:>10.4g} ({:.2f})", times.at(name), times.at(name) / times.at(kept));
    fmt::print("\n");
  }
}

}  // namespace

int run_bench(const CommonOptions& common, const BenchOptions& options) {
  const Compiler compiler = compiler_of(options);
  const FunctionChoice choice = function_choice(options.functions);
  const CompiledMechanism compiled =
      compile(common, description_of(common), choice.kinds, choice.inapplicable);
  EmitOptions emit;
  emit.scalars = {"double"};
  set_batch(emit, common, options.batch);
  const std::vector<int> states = options.states.empty() ? std::vector{kBenchStates} : options.states;
  const Measured measured = Build(compiled, emit, compiler).measured(states);
  if (options.json) {
    fmt::print("{}\n", json_of(compiled, measured).dump(2));
    return 0;
  }
  const Mechanism& mechanism = *compiled.mechanism;
  fmt::print("{}: {} coordinates, {} speeds, {} bodies\n", mechanism.name, mechanism.nq, mechanism.nv,
             mechanism.bodies.size());
  print_table(compiled, measured);
  fmt::print(
      "\nns: median time of one state, in double, over {} random states within the limits, one after the "
      "other\n"
      "{}"
      "bytes: machine code of the function\n"
      "%: an ESTIMATE of what the time is spent on, from the operations and the weights that alembert's "
      "optimiser\n"
      "gives them, not a measurement; memory: arguments read and results written\n"
      "compiled by: {}\n",
      states.front(),
      measured.instructions.empty()
          ? ""
          : fmt::format(
                "_batch: ns of a state, by one thread, instructions {}; in brackets: times that of one "
                "state after\nthe other, all results kept\n",
                measured.instructions),
      fmt::join(compiler.command(measured.flags), " "));
  return 0;
}

}  // namespace alembert
