// What registers hold while a function without loops runs, statement by statement. In: Program and its
// layout. Out: which operands a statement reads from memory, and where there; which values are stored because
// they leave their register before their last use.
//
// Compilers decide this for a value as a whole: one that does not stay in a register throughout is read from
// memory wherever it is used. Straight code over several hundred values in sixteen registers spends most of
// its time on that.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "registers/register_file.hpp"
#include "registers/statement_layout.hpp"
#include "support/no_index.hpp"

namespace alembert {

class RegisterPlan {
 public:
  RegisterPlan(const Program& program, const StatementLayout& layout);

  struct Read {
    std::uint32_t value;
    OperandFrom from;
  };
  /// Inputs and values of other statements that a statement reads.
  std::span<const Read> reads(std::uint32_t statement) const { return reads_[statement]; }
  /// The place in kept that v is written to when it is computed, beside those of the layout; kNoIndex if none is
  /// needed.
  std::uint32_t slot(std::uint32_t v) const { return slot_[v]; }
  /// Size of kept.
  std::size_t crossing() const { return crossing_; }

 private:
  void plan_block(std::uint32_t block, std::span<const std::uint32_t> statements);
  std::vector<std::uint32_t> reads_of(std::uint32_t statement) const;
  bool is_in_memory(std::uint32_t v, std::uint32_t block) const;

  const Program& program_;
  const StatementLayout& layout_;
  std::vector<std::uint32_t> slot_;
  std::vector<std::vector<std::uint32_t>> members_;  // by statement
  std::vector<std::vector<Read>> reads_;             // by statement
  std::size_t crossing_;
};

}  // namespace alembert
