// Signs for a program that is put together anew: whether a value or its negative is computed. In: a program
// without signs and an order of its values with ranges that are steps of loops. Out: a program in that order,
// in which like steps have become like instructions. Where one step is about the negative axis of another,
// negatives of its sines and inputs come ahead of the loop.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "program/loops/similar_values.hpp"
#include "program/program.hpp"

namespace alembert {

/// A loop has so many steps or more.
inline constexpr std::size_t kFewestSteps = 4;

/// Values order[first], ..., in `count` steps of `length` each.
struct Steps {
  std::size_t first, length, count;
};

/// Signs follow from a value's operands in their order, those of constants from what the sum needs that they
/// are in: a rule that takes like steps for like. `swapped` values have their operands in the other order.
/// Of each range, the most steps in a row that are alike become a loop.
Program with_signs(const UnsignedProgram& values, std::span<const std::uint32_t> order,
                   const std::vector<bool>& swapped, std::span<const Steps> ranges);

}  // namespace alembert
