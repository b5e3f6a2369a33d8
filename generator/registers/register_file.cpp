// Registers by the farthest next use, see the header.
#include "registers/register_file.hpp"

#include <algorithm>

#include "support/no_index.hpp"

namespace alembert {
namespace {

// x86 without AVX-512 has sixteen; some are for what is being computed.
constexpr std::size_t kRegisters = 14;

constexpr std::uint64_t kAccess = 4, kInstruction = 1;

// To leave without being stored is worth so many statements.
constexpr std::uint32_t kNoStore = 2;

constexpr std::uint32_t kNever = 0x7fffffff;

}  // namespace

RegisterFile::RegisterFile(const RegisterUses& uses)
    : uses_(uses),
      next_of_read_(uses.values.size()),
      next_of_result_(uses.statements.size()),
      next_(uses.in_memory.size()),
      held_(uses.in_memory.size()),
      kept_(uses.in_memory.size()) {}

/// Next uses, from the end.
void RegisterFile::look_ahead(std::span<const std::uint32_t> order) {
  std::fill(next_.begin(), next_.end(), kNever);
  for (std::size_t p = order.size(); p-- > 0;) {
    const RegisterUses::Statement& s = uses_.statements[order[p]];
    if (s.result != kNoIndex) next_of_result_[order[p]] = next_[s.result];
    for (std::uint32_t k = s.first_read; k < s.first_read + s.reads; ++k) {
      std::uint32_t& next = next_[uses_.values[k]];
      next_of_read_[k] = next;
      next = static_cast<std::uint32_t>(p);
    }
  }
}

/// Lets go of the value whose next use is the farthest while there are too many.
std::uint64_t RegisterFile::make_room(Record* record) {
  std::uint64_t cost = 0;
  while (registers_.size() > kRegisters) {
    std::size_t farthest = 0;
    std::uint32_t distance = 0;
    for (std::size_t i = 0; i < registers_.size(); ++i) {
      const std::uint32_t v = registers_[i], d = next_[v] + (kept_[v] ? kNoStore : 0);
      if (d >= distance) {
        distance = d;
        farthest = i;
      }
    }
    const std::uint32_t v = registers_[farthest];
    registers_[farthest] = registers_.back();
    registers_.pop_back();
    held_[v] = 0;
    if (kept_[v]) continue;
    kept_[v] = 1;
    cost += kAccess;
    if (record != nullptr) record->stored[v] = true;
  }
  return cost;
}

/// Whether a value that is read from memory and will be again is worth a register.
bool RegisterFile::is_worth_holding(std::uint32_t v) const {
  if (next_[v] == kNever) return false;
  return registers_.size() < kRegisters ||
         std::ranges::any_of(registers_, [&](std::uint32_t other) { return next_[other] > next_[v]; });
}

std::uint64_t RegisterFile::run(std::span<const std::uint32_t> order, std::uint64_t limit, Record* record) {
  look_ahead(order);
  std::ranges::copy(uses_.in_memory, kept_.begin());
  std::ranges::fill(held_, 0);
  registers_.clear();
  std::uint64_t cost = 0;
  for (const std::uint32_t number : order) {
    const RegisterUses::Statement& s = uses_.statements[number];
    bool died = false;
    for (std::uint32_t k = s.first_read; k < s.first_read + s.reads; ++k) {
      const std::uint32_t v = uses_.values[k];
      next_[v] = next_of_read_[k];
      OperandFrom from = OperandFrom::a_register;
      if (!held_[v]) {
        cost += kAccess;
        from = OperandFrom::memory;
        if (is_worth_holding(v)) {
          cost += kInstruction;
          from = OperandFrom::memory_into_register;
          held_[v] = 1;
          registers_.push_back(v);
        }
      } else if (next_[v] == kNever) {
        died = true;
      }
      if (record != nullptr) record->operands[number].push_back(from);
    }
    if (died) {
      std::erase_if(registers_, [&](std::uint32_t v) {
        if (next_[v] != kNever) return false;
        held_[v] = 0;
        return true;
      });
    }
    if (s.result != kNoIndex && next_of_result_[number] != kNever) {
      next_[s.result] = next_of_result_[number];
      held_[s.result] = 1;
      registers_.push_back(s.result);
    }
    if (registers_.size() > kRegisters) cost += make_room(record);
    if (cost > limit) return cost;
  }
  return cost;
}

std::uint64_t RegisterFile::cost(std::span<const std::uint32_t> order, std::uint64_t limit) {
  return run(order, limit, nullptr);
}

RegisterFile::Record RegisterFile::record(std::span<const std::uint32_t> order) {
  Record record;
  record.operands.resize(uses_.statements.size());
  record.stored.assign(uses_.in_memory.size(), false);
  run(order, kNoLimit, &record);
  return record;
}

}  // namespace alembert
