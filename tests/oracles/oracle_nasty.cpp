// oracle_nasty EXECUTABLE [COUNT] [SEED]: mechanisms that are hard on numbers, every function of each at six
// states against the Taylor oracle in long double. What disagrees is printed with its description, then one
// line for each kind and each function; exit 1. With --quiet before EXECUTABLE, descriptions are left out.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include "oracles/nasty_mechanism.hpp"
#include "oracles/reference.hpp"

namespace {

struct Summary {
  int compared = 0, failed = 0;
  double worst = 0;
  void print(const std::string& name) const {
    std::printf("%-42s %6d compared, %d failed, worst error %.1e\n", name.c_str(), compared, failed, worst);
  }
};

}  // namespace

int main(int argc, char** argv) {
  using namespace alembert::oracles;
  const bool quiet = argc > 1 && std::strcmp(argv[1], "--quiet") == 0;
  if (quiet) ++argv, --argc;
  if (argc < 2) {
    std::fprintf(stderr, "usage: oracle_nasty [--quiet] EXECUTABLE [COUNT] [SEED]\n");
    return 2;
  }
  const std::string executable = argv[1];
  const int count = argc > 2 ? std::atoi(argv[2]) : 300;
  const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("alembert_nasty_" + std::to_string(getpid()) + ".yaml");
  std::map<std::string, Summary> functions, kinds;
  int failed = 0;
  for (int i = 0; i < count; ++i) {
    const std::uint64_t here = seed + static_cast<std::uint64_t>(i);
    const NastyMechanism mechanism = nasty_mechanism(here);
    const Description description = parse_description(mechanism.text, mechanism.parameters);
    std::ofstream(file) << mechanism.text;
    std::vector<Comparison> bad;
    Summary& kind = kinds["kind " + mechanism.kind];
    ++kind.compared;
    const std::vector<State> states = nasty_states(mechanism, description, here);
    const std::set<std::string> asked = comparable_functions(description);
    const std::vector<Reference> references = taylor_references(description, states, asked);
    std::vector<Comparison> lines =
        compare_functions(executable, file.string(), description.name, states, references, asked);
    if (!description.constraints.empty())
      lines.push_back(compare_constrained(executable, file.string(), description, states, references));
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
  for (const auto& [name, summary] : functions) summary.print(name);
  for (const auto& [name, summary] : kinds) summary.print(name);
  std::printf("%d nasty mechanisms from seed %llu, %d of them wrong: %s\n", count,
              static_cast<unsigned long long>(seed), failed, failed == 0 ? "PASS" : "FAIL");
  return failed == 0 ? 0 : 1;
}
