// Lays out blocks that repeat, see the header.
#include "emit/repeated_layout.hpp"

#include <functional>
#include <map>
#include <queue>

#include "program/repeated_blocks.hpp"
#include "support/error.hpp"

namespace alembert {

RepeatedLayout::RepeatedLayout(const Program& program) : program_(program), size_(program.code.size()) {
  collect_uses();
  collect_angles();
  cut();
  for (RepeatedBlock& block : blocks_) connect(block);
  assign_places();
}

void RepeatedLayout::collect_uses() {
  live_.assign(size_, 0);
  results_.resize(size_);
  for (std::uint32_t array = 0; array < program_.outputs.size(); ++array)
    for (std::uint32_t k = 0; k < program_.outputs[array].values.size(); ++k) {
      results_[program_.outputs[array].values[k]].emplace_back(array, k);
      live_[program_.outputs[array].values[k]] = 1;
    }
  for (std::uint32_t v = static_cast<std::uint32_t>(size_); v-- > 0;)
    for (int k = 0; k < operands(v); ++k) {
      if (operand(v, k) >= v)
        throw InternalError("emit: a value of " + program_.function + " is used before it is computed");
      if (live_[v] != 0) live_[operand(v, k)] = 1;
    }
}

// As in a function without blocks, all sines and cosines whose angles are known at the first one come from
// one call.
void RepeatedLayout::collect_angles() {
  angle_.assign(size_, kNoPlace);
  const auto is_trig = [&](std::uint32_t v) {
    return live_[v] != 0 && (op(v) == Operation::sin || op(v) == Operation::cos);
  };
  while (first_trig_ < size_ && !is_trig(first_trig_)) ++first_trig_;
  std::map<std::uint32_t, std::uint32_t> known;
  for (std::uint32_t v = first_trig_; v < size_; ++v) {
    const std::uint32_t a = program_.code[v].a;
    if (!is_trig(v) || a >= first_trig_) continue;
    const auto [entry, fresh] = known.try_emplace(a, static_cast<std::uint32_t>(angles_.size()));
    if (fresh) angles_.push_back(a);
    angle_[v] = entry->second;
  }
}

// Before the first sine come the angles, which are a block of their own, then all the rest.
void RepeatedLayout::cut() {
  std::vector<std::uint32_t> before, after;
  for (std::uint32_t v = 0; v < size_; ++v)
    if (live_[v] != 0 && !is_leaf(op(v)) && angle_[v] == kNoPlace)
      (v < first_trig_ && !angles_.empty() ? before : after).push_back(v);
  time_.assign(size_, kNoPlace);
  position_.assign(size_, kNoPlace);
  const auto append = [&](const RepeatedBlocks& cut) {
    const auto first_block = static_cast<std::uint32_t>(blocks_.size());
    const auto first_place = static_cast<std::uint32_t>(order_.size());
    order_.insert(order_.end(), cut.order.begin(), cut.order.end());
    blocks_.resize(blocks_.size() + cut.lengths.size());
    for (const BlockOccurrence& occurrence : cut.occurrences) {
      RepeatedBlock& block = blocks_[first_block + occurrence.block];
      const auto time = static_cast<std::uint32_t>(sequence_.size());
      block.length = cut.lengths[occurrence.block];
      block.begins.push_back(first_place + occurrence.begin);
      block.times.push_back(time);
      sequence_.push_back(first_block + occurrence.block);
      for (std::uint32_t i = 0; i < block.length; ++i) {
        const std::uint32_t v = order_[first_place + occurrence.begin + i];
        time_[v] = time;
        position_[v] = i;
      }
    }
  };
  append(find_repeated_blocks(program_, before));
  calls_before_ = sequence_.size();
  append(find_repeated_blocks(program_, after));
  last_use_.assign(size_, 0);
  crosses_.assign(size_, 0);
}

// Finds out which operands come from inside in all occurrences.
void RepeatedLayout::connect(RepeatedBlock& block) {
  std::map<External, std::uint32_t> known;
  block.sources.assign(2 * std::size_t{block.length}, {Source::Kind::inside, 0});
  for (std::uint32_t i = 0; i < block.length; ++i) {
    const std::uint32_t first = value(block, 0, i);
    for (int k = 0; k < operands(first); ++k) {
      const auto inside = [&](std::size_t o) {
        const std::uint32_t from = operand(value(block, o, i), k);
        return time_[from] == block.times[o] ? position_[from] : kNoPlace;
      };
      const std::uint32_t at = inside(0);
      bool same = at != kNoPlace;
      for (std::size_t o = 0; o < block.begins.size(); ++o) same &= inside(o) == at;
      Source& source = block.sources[2 * std::size_t{i} + static_cast<std::size_t>(k)];
      if (same) {
        source = {Source::Kind::inside, at};
        continue;
      }
      External external;
      for (std::size_t o = 0; o < block.begins.size(); ++o) {
        const std::uint32_t from = operand(value(block, o, i), k);
        external.push_back(from);
        crosses_[from] = 1;
        last_use_[from] = std::max(last_use_[from], block.times[o]);
      }
      const auto [entry, fresh] = known.try_emplace(external, static_cast<std::uint32_t>(known.size()));
      if (fresh) block.externals.push_back(std::move(external));
      source = {Source::Kind::outside, entry->second};
    }
  }
}

// Places in v: inputs in the order of their arrays, constants that stand where other occurrences have
// values, angles, sines, cosines; then what crosses. A place is free again after the last use.
void RepeatedLayout::assign_places() {
  place_.assign(size_, kNoPlace);
  std::vector<std::uint8_t> mixed(size_, 0);
  for (RepeatedBlock& block : blocks_) {
    for (const External& external : block.externals)
      if (!all_constant(external))
        for (const std::uint32_t v : external)
          if (constant(v)) mixed[v] = 1;
  }
  std::map<std::pair<ArgumentKind, std::uint32_t>, std::uint32_t> elements;
  for (std::uint32_t v = 0; v < size_; ++v)
    if (op(v) == Operation::input && live_[v] != 0) {
      const InputSlot& slot = program_.inputs[program_.code[v].a];
      elements.try_emplace({slot.kind, slot.index}, 0);
    }
  for (auto& [element, place] : elements) {
    place = places_++;
    loads_.push_back({element.first, element.second});
  }
  for (std::uint32_t v = 0; v < size_; ++v) {
    if (op(v) == Operation::input && live_[v] != 0) {
      const InputSlot& slot = program_.inputs[program_.code[v].a];
      place_[v] = elements.at({slot.kind, slot.index});
    }
    if (mixed[v] != 0) {
      place_[v] = places_++;
      mixed_.push_back(v);
    }
  }
  const auto count = static_cast<std::uint32_t>(angles_.size());
  // Angles that are no inputs cross from the block before; all are copied to be side by side.
  for (const std::uint32_t v : angles_) crosses_[v] = 1;
  first_angle_ = places_;
  for (std::uint32_t v = 0; v < size_; ++v)
    if (angle_[v] != kNoPlace)
      place_[v] = first_angle_ + (op(v) == Operation::sin ? count : 2 * count) + angle_[v];
  places_ += 3 * count;
  assign_crossing_places();
}

void RepeatedLayout::assign_crossing_places() {
  for (const std::uint32_t v : angles_)
    last_use_[v] = std::max(last_use_[v], static_cast<std::uint32_t>(calls_before_));
  for (RepeatedBlock& block : blocks_) {
    block.exported.assign(block.length, 0);
    for (std::uint32_t i = 0; i < block.length; ++i)
      for (std::size_t o = 0; o < block.begins.size(); ++o)
        if (crosses_[value(block, o, i)] != 0) block.exported[i] = 1;
  }
  std::vector<std::vector<std::uint32_t>> expiring(sequence_.size() + 1);
  std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> free_places;
  std::vector<std::uint32_t> next(blocks_.size(), 0);
  for (std::uint32_t time = 0; time < sequence_.size(); ++time) {
    if (time > 0)
      for (const std::uint32_t place : expiring[time - 1]) free_places.push(place);
    const RepeatedBlock& block = blocks_[sequence_[time]];
    const std::uint32_t occurrence = next[sequence_[time]]++;
    for (std::uint32_t i = 0; i < block.length; ++i) {
      if (block.exported[i] == 0) continue;
      const std::uint32_t v = value(block, occurrence, i);
      if (free_places.empty()) free_places.push(places_++);
      place_[v] = free_places.top();
      free_places.pop();
      expiring[std::max(last_use_[v], time)].push_back(place_[v]);
    }
  }
}

}  // namespace alembert
