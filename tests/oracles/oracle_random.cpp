// oracle_random EXECUTABLE [COUNT] [SEED]: random mechanisms against every oracle, three states each, runtime
// parameters off their defaults; functions besides the dynamics of every seventh mechanism. With `-` for the executable,
// oracles are compared with each other. What disagrees is printed with its description; exit 1.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "oracles/comparison.hpp"
#include "oracles/random_mechanism.hpp"

int main(int argc, char** argv) {
  using namespace alembert::oracles;
  if (argc < 2) {
    std::fprintf(stderr, "usage: oracle_random EXECUTABLE|- [COUNT] [SEED]\n");
    return 2;
  }
  const std::string executable = std::string(argv[1]) == "-" ? "" : argv[1];
  const int count = argc > 2 ? std::atoi(argv[2]) : 200;
  const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() /
      ("alembert_random_" + std::to_string(seed) + "_" + std::to_string(count) + ".yaml");
  struct Summary {
    int compared = 0, failed = 0;
    double worst = 0;
  };
  std::map<std::string, Summary> summaries;
  int failed = 0;
  for (int i = 0; i < count; ++i) {
    const std::uint64_t here = seed + static_cast<std::uint64_t>(i);
    const std::string text = random_mechanism(here);
    const std::map<std::string, double> values = random_parameters(parse_description(text), here);
    std::ofstream(file) << text;
    std::vector<Comparison> bad;
    for (const Comparison& line : compare(executable, file.string(), 3, here, "", values, here)) {
      const bool fails = line.verdict == Comparison::Verdict::fail;
      if (fails) bad.push_back(line);
      if (!fails && line.verdict != Comparison::Verdict::pass) continue;
      Summary& summary = summaries[line.oracle + " " + line.function + " " + line.formulation];
      ++summary.compared;
      summary.failed += fails ? 1 : 0;
      summary.worst = std::max(summary.worst, line.error);
    }
    if (bad.empty()) continue;
    ++failed;
    std::printf("seed %llu\n", static_cast<unsigned long long>(here));
    print_table(bad);
    std::printf("%s\n", text.c_str());
    std::fflush(stdout);
  }
  std::filesystem::remove(file);
  for (const auto& [name, summary] : summaries) {
    std::printf("%-42s %6d compared, %d failed, worst error %.1e\n", name.c_str(), summary.compared,
                summary.failed, summary.worst);
  }
  std::printf("%d random mechanisms from seed %llu: %s\n", count, static_cast<unsigned long long>(seed),
              failed == 0 && !(summaries.empty() && !executable.empty()) ? "PASS" : "FAIL");
  return failed == 0 && !(summaries.empty() && !executable.empty()) ? 0 : 1;
}
