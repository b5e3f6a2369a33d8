// Plans registers block by block, see the header.
#include "registers/register_plan.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <queue>

#include "support/no_index.hpp"

namespace alembert {

RegisterPlan::RegisterPlan(const Program& program, const StatementLayout& layout)
    : program_(program), layout_(layout), crossing_(layout.crossing()) {
  const auto size = static_cast<std::uint32_t>(program.code.size());
  slot_.assign(size, kNoIndex);
  members_.resize(size);
  reads_.resize(size);
  std::vector<std::vector<std::uint32_t>> blocks(layout.blocks());
  for (std::uint32_t v = 0; v < size; ++v) {
    if (layout.statement(v) == v) blocks[layout.block(v)].push_back(v);
    // From the named value down, as it is read when it is written.
    const std::uint32_t below = size - 1 - v;
    if (layout.statement(below) != kNoIndex) members_[layout.statement(below)].push_back(below);
  }
  for (std::uint32_t block = 0; block < layout.blocks(); ++block) plan_block(block, blocks[block]);
}

std::vector<std::uint32_t> RegisterPlan::reads_of(std::uint32_t statement) const {
  std::vector<std::uint32_t> reads;
  const auto add = [&](std::uint32_t v) {
    const Operation op = program_.code[v].op;
    if (op == Operation::constant || (op != Operation::input && !layout_.named(v))) return;
    if (std::ranges::find(reads, v) == reads.end()) reads.push_back(v);
  };
  if (statement == layout_.trig_call())
    for (const std::uint32_t angle : layout_.angles()) add(angle);
  if (layout_.angle(statement) != kNoIndex) return reads;
  for (const std::uint32_t member : members_[statement]) {
    const Instruction& c = program_.code[member];
    if (operand_count(c.op) > 0) add(c.a);
    if (operand_count(c.op) > 1) add(c.b);
  }
  return reads;
}

/// Inputs, sines and cosines of the call for all angles, and what is written to w in any case.
bool RegisterPlan::is_in_memory(std::uint32_t v, std::uint32_t block) const {
  return program_.code[v].op == Operation::input || layout_.angle(v) != kNoIndex ||
         layout_.block(v) != block || layout_.place(v) != kNoIndex || !layout_.table_places(v).empty();
}

void RegisterPlan::plan_block(std::uint32_t block, std::span<const std::uint32_t> statements) {
  RegisterUses uses;
  std::vector<std::uint32_t> values, order;  // by number in the block
  std::map<std::uint32_t, std::uint32_t> number;
  const auto number_of = [&](std::uint32_t v) {
    const auto [entry, fresh] = number.try_emplace(v, static_cast<std::uint32_t>(values.size()));
    if (fresh) {
      values.push_back(v);
      uses.in_memory.push_back(is_in_memory(v, block) ? 1 : 0);
    }
    return entry->second;
  };
  for (const std::uint32_t s : statements) {
    std::vector<std::uint32_t> reads;
    for (const std::uint32_t v : reads_of(s)) reads.push_back(number_of(v));
    // Sines and cosines of the call stand in memory, and have no name until they are read.
    const bool named = layout_.angle(s) == kNoIndex && !layout_.result_only(s) && !layout_.table_only(s);
    order.push_back(static_cast<std::uint32_t>(uses.statements.size()));
    uses.add(reads, named ? number_of(s) : kNoIndex);
  }
  const RegisterFile::Record record = RegisterFile(uses).record(order);

  std::vector<std::uint32_t> last_access(values.size(), 0);
  for (std::uint32_t i = 0; i < statements.size(); ++i) {
    const std::span<const std::uint32_t> reads = uses.reads(i);
    for (std::size_t k = 0; k < reads.size(); ++k) {
      reads_[statements[i]].push_back({values[reads[k]], record.operands[i][k]});
      if (record.operands[i][k] != OperandFrom::a_register) last_access[reads[k]] = i;
    }
  }
  // A place is free again after the last access; the lowest free place is taken.
  std::vector<std::vector<std::uint32_t>> expiring(statements.size());
  std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> free_places;
  auto end = static_cast<std::uint32_t>(layout_.crossing());
  for (std::uint32_t i = 0; i < statements.size(); ++i) {
    const std::uint32_t result = uses.statements[i].result;
    if (result != kNoIndex && record.stored[result]) {
      if (free_places.empty()) free_places.push(end++);
      slot_[statements[i]] = free_places.top();
      free_places.pop();
      expiring[last_access[result]].push_back(slot_[statements[i]]);
    }
    for (const std::uint32_t place : expiring[i]) free_places.push(place);
  }
  crossing_ = std::max<std::size_t>(crossing_, end);
}

}  // namespace alembert
