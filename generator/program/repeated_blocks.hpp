// Parts of a program that repeat: which runs of instructions are the same operations on other values. In: a
// program in its final order. Out: that order cut into occurrences of blocks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "program/program.hpp"

namespace alembert {

/// Blocks are no longer than this, whether they repeat or not.
inline constexpr std::size_t kMaxBlockLength = 1000;

/// An occurrence of a block: the instructions order[begin], order[begin + 1], ..., as many as the block has.
struct BlockOccurrence {
  std::uint32_t block = 0, begin = 0;
};

/// Occurrences follow each other without gaps and cover `order`. Those of one block have the same operations
/// and give elements of the same output arrays; operands and indices may differ.
struct RepeatedBlocks {
  std::vector<std::uint32_t> order;
  std::vector<std::uint32_t> lengths;  ///< by block
  std::vector<BlockOccurrence> occurrences;
  std::size_t code() const;  ///< instructions of all blocks together
};

/// Cuts `order`, indices of instructions that are to be computed in this order, into blocks that repeat as
/// far as possible, and into others. Runs of like instructions are found by the classes of windows of
/// instructions, joined while a class has one successor only, and then in pairs, the most frequent first.
/// The same program gives the same blocks.
RepeatedBlocks find_repeated_blocks(const Program& program, std::span<const std::uint32_t> order);

}  // namespace alembert
