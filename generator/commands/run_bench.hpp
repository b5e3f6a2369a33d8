// `bench`: how long each function takes on this machine.
#pragma once

#include <string>
#include <vector>

#include "commands/common_options.hpp"

namespace alembert {

struct BenchOptions {
  std::vector<std::string> functions;  ///< none: those that `generate` writes
  std::vector<std::string> batch;      ///< functions to time over many states too
  std::vector<int> states;             ///< numbers of states, each timed in turn
  std::string compiler;                ///< with its flags; empty: $CXX, or c++
  bool json = false;
};
int run_bench(const CommonOptions& common, const BenchOptions& options);

}  // namespace alembert
