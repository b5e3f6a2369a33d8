// Runs benchmarks registered by name and keeps their medians. In: Google Benchmark's arguments. Out:
// nanoseconds by name.
#pragma once

#include <map>
#include <string>

namespace alembert::benchmarks {

/// Median and coefficient of variation of the repetitions of one benchmark, which are interleaved with all
/// others.
struct Timing {
  double nanoseconds = 0;
  double variation = 0;
};

/// Runs what is registered. Progress on standard error.
std::map<std::string, Timing> run_registered(int argc, char** argv);

/// Results go here, so that no computation is without effect.
inline volatile double sink = 0;

/// Fused multiplications and additions, as fast as they go; returns how many operations, two for each.
double fused_operations(int rounds);

/// Sines and cosines of a batch and nothing else; returns of how many angles.
double sines_of_angles(int rounds);

}  // namespace alembert::benchmarks
