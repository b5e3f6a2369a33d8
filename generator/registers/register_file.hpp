// What registers hold while statements are done one after the other. In: for each statement which values it
// reads and which it computes. Out: which of them are read from memory, and what that costs.
//
// A value that many statements later is read again leaves its register for memory, and not one that is read
// soon: the value whose next use is the farthest goes (L. A. Belady, A study of replacement algorithms for a
// virtual-storage computer, IBM Systems Journal 5(2), 1966). That is known here, since the code is straight.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "support/no_index.hpp"

namespace alembert {

/// Statements by number, over values by number.
struct RegisterUses {
  struct Statement {
    std::uint32_t first_read = 0, reads = 0;  ///< in `values`, each value once
    std::uint32_t result = 0;                 ///< kNoIndex if none that others read
  };
  std::vector<Statement> statements;
  std::vector<std::uint32_t> values;
  std::vector<std::uint8_t> in_memory;  ///< by value: inputs, and what is written to memory anyway

  void add(std::span<const std::uint32_t> reads, std::uint32_t result) {
    statements.push_back(
        {static_cast<std::uint32_t>(values.size()), static_cast<std::uint32_t>(reads.size()), result});
    values.insert(values.end(), reads.begin(), reads.end());
  }
  std::span<const std::uint32_t> reads(std::uint32_t statement) const {
    const Statement& s = statements[statement];
    return {values.data() + s.first_read, s.reads};
  }
};

/// What becomes of one operand: it is in a register, or comes from memory, into a register if it is read
/// again soon.
enum class OperandFrom : std::uint8_t { a_register, memory, memory_into_register };

class RegisterFile {
 public:
  explicit RegisterFile(const RegisterUses& uses);

  /// The cost of an order of statements: accesses to memory, each 4, and instructions that only load, each 1.
  /// Beyond `limit`, any number beyond it.
  std::uint64_t cost(std::span<const std::uint32_t> order, std::uint64_t limit = kNoLimit);
  static constexpr std::uint64_t kNoLimit = ~std::uint64_t{0};

  /// The same, with what happens: by statement in the order, its operands; and which values are stored.
  struct Record {
    std::vector<std::vector<OperandFrom>> operands;
    std::vector<bool> stored;  ///< by value
  };
  Record record(std::span<const std::uint32_t> order);

 private:
  std::uint64_t run(std::span<const std::uint32_t> order, std::uint64_t limit, Record* record);
  void look_ahead(std::span<const std::uint32_t> order);
  std::uint64_t make_room(Record* record);
  bool is_worth_holding(std::uint32_t v) const;

  const RegisterUses& uses_;
  std::vector<std::uint32_t> next_of_read_;    // by position and read: the next position that reads the value
  std::vector<std::uint32_t> next_of_result_;  // by position
  std::vector<std::uint32_t> next_;            // by value: the next position that reads it
  std::vector<std::uint8_t> held_, kept_;      // by value: in a register, in memory
  std::vector<std::uint32_t> registers_;       // values that are held
};

}  // namespace alembert
