// Google Benchmark with random interleaving, its report replaced by a map.
#include "benchmark/timings.hpp"

#include <benchmark/benchmark.h>

#include <iostream>
#include <string>
#include <vector>

namespace alembert::benchmarks {
namespace {

class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      const std::string name = run.run_name.function_name;
      if (run.run_type != Run::RT_Aggregate) continue;
      // Processor time: on a machine with other work the clock on the wall counts that too.
      if (run.aggregate_name == "median") timings[name].nanoseconds = run.GetAdjustedCPUTime();
      if (run.aggregate_name == "cv") timings[name].variation = 1e-9 * run.GetAdjustedCPUTime();
    }
    std::cerr << '.' << std::flush;
  }
  std::map<std::string, Timing> timings;
};

}  // namespace

std::map<std::string, Timing> run_registered(int argc, char** argv) {
  std::vector<char*> arguments(argv, argv + argc);
  std::string fixed[] = {"--benchmark_enable_random_interleaving=true",
                         "--benchmark_report_aggregates_only=true", "--benchmark_repetitions=9",
                         "--benchmark_min_time=0.01"};
  // What the user gives comes later and counts.
  for (std::string& argument : fixed) arguments.insert(arguments.begin() + 1, argument.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  std::cerr << '\n';
  return collector.timings;
}

}  // namespace alembert::benchmarks
