// oracle_nasty EXECUTABLE [COUNT] [SEED]: mechanisms that are hard on numbers, every function of each at six
// states against the Taylor oracle in long double. What disagrees is printed with its description, then one
// line for each kind and each function; exit 1. Before EXECUTABLE, --quiet leaves descriptions out, --forces puts
// random forces of every kind, with states and outputs, on such mechanisms and on random trees, --in-turn asks
// mechanisms of more than two speeds for functions besides the dynamics in turn only: they take nine tenths of the
// time; --speeds N goes on until there are COUNT mechanisms of at most N speeds; and --functions f,g asks for those
// functions alone, of the mechanisms that have them.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "oracles/comparison.hpp"
#include "oracles/nasty_mechanism.hpp"
#include "oracles/random_forces.hpp"
#include "oracles/random_mechanism.hpp"
#include "oracles/reference.hpp"

namespace {

using namespace alembert::oracles;

constexpr int kForcedStates = 3;
constexpr int kSpeedsForEveryFunction = 2;
/// Of so many with forces one is hard on numbers, and one is compared in each formulation too.
constexpr std::uint64_t kForcedKinds = 5;

struct Case {
  std::string text, kind;
  std::map<std::string, double> parameters;
  Description description;
  std::vector<State> states;
};

Case nasty_case(std::uint64_t seed) {
  const NastyMechanism mechanism = nasty_mechanism(seed);
  Case result{mechanism.text,
              mechanism.kind,
              mechanism.parameters,
              parse_description(mechanism.text, mechanism.parameters),
              {}};
  result.states = nasty_states(mechanism, result.description, seed);
  return result;
}

double weight_of(const NastyMechanism& mechanism) {
  double mass = 0;
  for (const Body& body : parse_description(mechanism.text).bodies) mass = std::max(mass, body.mass);
  return mass * mechanism.gravity;
}

/// Runtime parameters are off their defaults.
Case forced_case(std::uint64_t seed) {
  const bool nasty = seed % kForcedKinds == 0;
  const std::uint64_t kind = seed / kForcedKinds;  // they come in turn
  NastyMechanism mechanism;
  if (nasty)
    mechanism = nasty_mechanism(kind);
  else
    mechanism.text = random_mechanism(seed);
  const ForceUnits units{mechanism.length, mechanism.length == 1 ? 1 : weight_of(mechanism),
                         mechanism.lengths};
  Case result{with_random_forces(mechanism.text, seed, units),
              nasty ? "forces, " + mechanism.kind : "forces on trees",
              {},
              {},
              {}};
  result.parameters = random_parameters(parse_description(result.text), seed);
  for (const auto& [name, value] : mechanism.parameters) result.parameters[name] = value;
  result.description = parse_description(result.text, result.parameters);
  result.states = nasty ? nasty_states(mechanism, result.description, kind, kForcedStates)
                        : comparable_states(result.description, kForcedStates, seed);
  return result;
}

struct Summary {
  int compared = 0, failed = 0;
  double worst = 0;
  void print(const std::string& name) const {
    std::printf("%-42s %6d compared, %d failed, worst error %.1e\n", name.c_str(), compared, failed, worst);
  }
};

}  // namespace

int main(int argc, char** argv) {
  bool quiet = false, forces = false, in_turn = false;
  int most_speeds = std::numeric_limits<int>::max();
  std::set<std::string> only;
  for (; argc > 1 && std::strncmp(argv[1], "--", 2) == 0; ++argv, --argc) {
    quiet = quiet || std::strcmp(argv[1], "--quiet") == 0;
    forces = forces || std::strcmp(argv[1], "--forces") == 0;
    in_turn = in_turn || std::strcmp(argv[1], "--in-turn") == 0;
    if (std::strcmp(argv[1], "--speeds") == 0 && argc > 2) {
      most_speeds = std::atoi(argv[2]);
      ++argv, --argc;
    }
    if (std::strcmp(argv[1], "--functions") == 0 && argc > 2) {
      only = names_in(argv[2]);
      ++argv, --argc;
    }
  }
  if (argc < 2 || most_speeds < 1) {
    std::fprintf(
        stderr,
        "usage: oracle_nasty [--quiet] [--forces] [--in-turn] [--speeds N] [--functions f,g] EXECUTABLE "
        "[COUNT] [SEED]\n");
    return 2;
  }
  const std::string executable = argv[1];
  const int count = argc > 2 ? std::atoi(argv[2]) : 300;
  const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("alembert_nasty_" + std::to_string(getpid()) + ".yaml");
  std::map<std::string, Summary> functions, kinds;
  int compared = 0, failed = 0;
  std::uint64_t here = seed;
  for (int taken = 0; taken < count; ++here) {
    const Case mechanism = forces ? forced_case(here) : nasty_case(here);
    if (mechanism.description.nv > most_speeds) continue;
    ++taken;
    std::set<std::string> asked = comparable_functions(mechanism.description);
    if (!only.empty()) {
      std::erase_if(asked, [&](const std::string& name) { return only.count(name) == 0; });
      if (asked.empty()) continue;
    }
    ++compared;
    std::ofstream(file) << mechanism.text;
    if (in_turn && mechanism.description.nv > kSpeedsForEveryFunction) asked = functions_in_turn(asked, here);
    const std::vector<Reference> references =
        taylor_references(mechanism.description, mechanism.states, asked);
    std::vector<Comparison> lines = compare_functions(executable, file.string(), mechanism.description.name,
                                                      mechanism.states, references, asked);
    if (!mechanism.description.constraints.empty() &&
        (only.empty() || only.count("constrained_forward_dynamics") != 0))
      lines.push_back(compare_constrained(executable, file.string(), mechanism.description, mechanism.states,
                                          references));
    if (forces && here % kForcedKinds == 1) {
      for (const Comparison& line :
           compare(executable, file.string(), 2, here, "", mechanism.parameters, here))
        lines.push_back(line);
    }
    std::vector<Comparison> bad;
    Summary& kind = kinds["kind " + mechanism.kind];
    ++kind.compared;
    for (const Comparison& line : lines) {
      const bool fails = line.verdict == Comparison::Verdict::fail;
      if (fails) bad.push_back(line);
      for (Summary* summary : {&functions[line.function], &kind})
        summary->worst = std::max(summary->worst, line.error);
      ++functions[line.function].compared;
      functions[line.function].failed += fails ? 1 : 0;
    }
    if (bad.empty()) continue;
    ++failed;
    ++kind.failed;
    std::printf("seed %llu\n", static_cast<unsigned long long>(here));
    print_table(bad);
    if (!quiet) std::printf("%s\n", mechanism.text.c_str());
    std::fflush(stdout);
  }
  std::filesystem::remove(file);
  for (const std::string& name : only)
    if (functions.count(name) == 0) {
      std::fprintf(stderr, "no mechanism has the function '%s'\n", name.c_str());
      return 2;
    }
  for (const auto& [name, summary] : functions) summary.print(name);
  for (const auto& [name, summary] : kinds) summary.print(name);
  std::printf("%d mechanisms from seed %llu, %d of them wrong: %s\n", compared,
              static_cast<unsigned long long>(seed), failed, failed == 0 ? "PASS" : "FAIL");
  return failed == 0 ? 0 : 1;
}
