// oracle_table EXECUTABLE MECHANISMS EQUIVALENTS [STATES] [--in-turn]: every mechanism of a folder against every oracle,
// at random states; --in-turn asks for functions besides the dynamics of every seventh mechanism only. With `-` for the
// executable, the numeric Lagrangian stands in for it, and oracles are compared with each other. Exit 1 if any line
// fails, or if an engine is missing that this build requires.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "oracles/comparison.hpp"

int main(int argc, char** argv) {
  using alembert::oracles::Comparison;
  if (argc < 4) {
    std::fprintf(stderr, "usage: oracle_table EXECUTABLE|- MECHANISMS EQUIVALENTS [STATES] [--in-turn]\n");
    return 2;
  }
  const std::string executable = std::string(argv[1]) == "-" ? "" : argv[1];
  const int states = argc > 4 ? std::atoi(argv[4]) : 20;
  const bool in_turn = argc > 5 && std::string(argv[5]) == "--in-turn";
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(argv[2])) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<Comparison> lines;
  std::uint64_t turn = 0;
  for (const auto& file : files) {
    ++turn;
    const std::filesystem::path equivalent = std::filesystem::path(argv[3]) / file.filename();
    for (Comparison& line :
         alembert::oracles::compare(executable, file.string(), states, 2024,
                                    std::filesystem::exists(equivalent) ? equivalent.string() : "", {},
                                    in_turn ? std::optional(turn) : std::nullopt)) {
      lines.push_back(std::move(line));
    }
  }
  alembert::oracles::print_table(lines);
  bool failed = lines.empty();
  for (const Comparison& line : lines) {
    failed = failed || line.verdict == Comparison::Verdict::fail;
#ifdef ALEMBERT_REQUIRE_ORACLES
    failed = failed || line.verdict == Comparison::Verdict::not_installed;
#endif
  }
  std::printf("%zu mechanisms, %zu comparisons, %d states each: %s\n", files.size(), lines.size(), states,
              failed ? "FAIL" : "PASS");
  return failed ? 1 : 0;
}
