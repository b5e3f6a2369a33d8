// Results that are the same value, as those of the two triangles of M are and all zeros of a tree. In: a
// program. Out: one that gives each value once, and which of them each result is.
#pragma once

#include <cstdint>
#include <vector>

#include "program/program.hpp"

namespace alembert {

struct DistinctResults {
  Program program;
  /// Of each result array: the places of its elements among the distinct ones; nothing where all stay.
  std::vector<std::vector<std::uint32_t>> rows;
};

/// Loops and tables of dot products write their results in the order of the arrays: such programs stay.
DistinctResults distinct_results(Program program);

}  // namespace alembert
