// Where the values of a program lie whose blocks repeat. In: a program. Out: blocks with their occurrences,
// what each takes from outside, and the places of values in the array v.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "emit/statement_layout.hpp"
#include "program/operation.hpp"
#include "program/program.hpp"

namespace alembert {

/// Where an operand comes from, the same for all occurrences of a block.
struct Source {
  enum class Kind : std::uint8_t { inside, outside } kind;
  std::uint32_t index;  ///< instruction of the block, or external of the block
};

/// What a block takes from outside: one value for each occurrence.
using External = std::vector<std::uint32_t>;

/// A block of a function and its occurrences.
struct RepeatedBlock {
  std::uint32_t length = 0;
  std::vector<std::uint32_t> begins;  ///< of its occurrences
  std::vector<std::uint32_t> times;   ///< number of each among all occurrences
  std::vector<Source> sources;        ///< two for each instruction
  std::vector<External> externals;
  std::vector<std::uint8_t> exported;
  std::vector<std::vector<std::uint32_t>> table;  ///< by occurrence
};

/// Layout of one program; the writer of its text builds on it.
class RepeatedLayout {
 protected:
  explicit RepeatedLayout(const Program& program);

  int operands(std::uint32_t v) const { return operand_count(program_.code[v].op); }
  Operation op(std::uint32_t v) const { return program_.code[v].op; }
  std::uint32_t operand(std::uint32_t v, int k) const {
    return k == 0 ? program_.code[v].a : program_.code[v].b;
  }
  bool constant(std::uint32_t v) const { return op(v) == Operation::constant; }
  double constant_value(std::uint32_t v) const { return program_.constants[program_.code[v].a]; }
  std::uint32_t value(const RepeatedBlock& block, std::size_t occurrence, std::uint32_t i) const {
    return order_[block.begins[occurrence] + i];
  }
  bool all_constant(const External& external) const {
    return std::ranges::all_of(external, [&](std::uint32_t v) { return constant(v); });
  }

  const Program& program_;
  std::size_t size_;
  std::vector<std::uint8_t> live_;
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> results_;  ///< output array and index
  std::vector<std::uint32_t> angles_, angle_;  ///< angle_: of what the call of sines and cosines gives
  std::vector<std::uint32_t> sequence_;        ///< blocks in the order of their calls
  std::size_t calls_before_ = 0;               ///< calls ahead of the sines and cosines
  std::vector<RepeatedBlock> blocks_;
  std::vector<std::uint32_t> place_;                           ///< in v
  std::vector<std::pair<ArgumentKind, std::uint32_t>> loads_;  ///< inputs: places 0, 1, ... of v
  std::vector<std::uint32_t> mixed_;                           ///< constants that have places
  std::uint32_t places_ = 0, first_angle_ = 0;

 private:
  void collect_uses();
  void collect_angles();
  void cut();
  void connect(RepeatedBlock& block);
  void assign_places();
  void assign_crossing_places();

  std::uint32_t first_trig_ = 0;
  std::vector<std::uint8_t> crosses_;
  std::vector<std::uint32_t> order_, time_, position_, last_use_;
};

}  // namespace alembert
