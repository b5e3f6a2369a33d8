// A set of nodes with positions. In: node ids, in any order. Out: the position at which each was added. Small
// sets of a large graph cost only their own size. Private to this room.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "support/no_index.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

class NodeIndex {
 public:
  NodeIndex() : slots_(std::size_t{1} << bits_, Slot{kNoIndex, 0}) {}
  /// For nodes that a graph of that size has, by their ids.
  explicit NodeIndex(std::uint32_t graph_size) {
    if (!spare_.empty()) {
      positions_ = std::move(spare_.back());
      spare_.pop_back();
    }
    if (positions_.size() < graph_size) positions_.resize(graph_size, kNoIndex);
  }
  ~NodeIndex() {
    for (const std::uint32_t id : added_) positions_[id] = kNoIndex;
    if (slots_.empty() && !positions_.empty() && spare_.size() < kSpare)
      spare_.push_back(std::move(positions_));
  }
  NodeIndex(NodeIndex&& other) noexcept { swap(other); }
  NodeIndex& operator=(NodeIndex&& other) noexcept {
    swap(other);
    return *this;
  }

  std::uint32_t find(std::uint32_t id) const {
    if (slots_.empty()) return id < positions_.size() ? positions_[id] : kNoIndex;
    const Slot& slot = slots_[slot_of(id)];
    return slot.id == id ? slot.position : kNoIndex;
  }

  /// Adds an id, unless it is there: then false.
  bool add(std::uint32_t id, std::uint32_t position) {
    if (slots_.empty()) {
      if (positions_[id] != kNoIndex) return false;
      positions_[id] = position;
      added_.push_back(id);
      return true;
    }
    if (2 * (count_ + 1) > slots_.size()) grow();
    Slot& slot = slots_[slot_of(id)];
    if (slot.id == id) return false;
    slot = {id, position};
    ++count_;
    return true;
  }

 private:
  struct Slot {
    std::uint32_t id, position;
  };
  // Neighbouring ids share a block, blocks are spread: dense ranges stay dense in memory and never collide in
  // bulk.
  std::size_t home(std::uint32_t id) const {
    const std::uint64_t block =
        (static_cast<std::uint64_t>(id >> 4) * 0x9e3779b97f4a7c15u) >> (64 - (bits_ - 4));
    return static_cast<std::size_t>(block) << 4 | (id & 15u);
  }
  /// That of the id, or the empty one that it would take.
  std::size_t slot_of(std::uint32_t id) const {
    std::size_t slot = home(id);
    while (slots_[slot].id != id && slots_[slot].id != kNoIndex) slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }
  void grow() {
    std::vector<Slot> old;
    old.swap(slots_);
    ++bits_;
    slots_.assign(std::size_t{1} << bits_, Slot{kNoIndex, 0});
    for (const Slot& entry : old) {
      if (entry.id != kNoIndex) slots_[slot_of(entry.id)] = entry;
    }
  }

  void swap(NodeIndex& other) noexcept {
    std::swap(bits_, other.bits_);
    std::swap(count_, other.count_);
    slots_.swap(other.slots_);
    positions_.swap(other.positions_);
    added_.swap(other.added_);
  }

  /// Tables by id that hold nothing: clearing what was added takes the size of the set, a new table that of
  /// the graph.
  static constexpr std::size_t kSpare = 8;
  static inline thread_local std::vector<std::vector<std::uint32_t>> spare_;

  int bits_ = 6;
  std::size_t count_ = 0;
  std::vector<Slot> slots_;               ///< empty where nodes are of one graph, ...
  std::vector<std::uint32_t> positions_;  ///< ... for which this is by id, ...
  std::vector<std::uint32_t> added_;      ///< ... and has these
};

}  // namespace alembert
