// A list scheduler on statements. In: statements with what they read, and weights. Out: an order that obeys
// dependences.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace alembert {

/// One statement: a named value with what is written into it.
struct ScheduledStatement {
  std::vector<std::uint32_t> members;  ///< instructions, in their order; the last is the named value
  std::vector<std::uint32_t> reads;    ///< inputs and values of other statements, each once
  std::vector<std::uint32_t> readers;  ///< statements that read its value
  std::uint32_t before = 0;            ///< statements to be written before it
  int height = 0;                      ///< operations from its first to the last result that needs it
};

/// What a choice is worth: a register that becomes free, a value that is in none, an operation between the
/// choice and the last result that depends on it. The register file evicts the least recently used
/// value.
struct ScheduleWeights {
  std::size_t registers;
  int freed, missing, height;
};

/// Of the statements whose operands are known, and that are not `look_ahead` or more behind the first that is
/// not written, the one that is worth most is next; of equals, the first. The first `leading` statements stay
/// first, and their values wait in memory. `left` has, by value, how many statements read it.
std::vector<std::uint32_t> list_schedule(const std::vector<ScheduledStatement>& statements,
                                         std::uint32_t leading, std::vector<std::uint32_t> left,
                                         const ScheduleWeights& weights, std::uint32_t look_ahead);

}  // namespace alembert
