// Threshold accepting on orders, see the header.
#include "registers/order_search.hpp"

#include <algorithm>
#include <map>
#include <random>

#include "support/no_index.hpp"

namespace alembert {
namespace {

// Statements that are searched at a time, and how far the next ones are.
constexpr std::size_t kWindow = 300, kStep = 200;

// Orders tried, by statement of a window; fewer in long programs, so that the time is bounded.
constexpr std::size_t kOrdersTried = 100, kAllOrdersTried = 100'000;

// A worse order is taken as long as it costs so much more at most: at first, decreasing to 0.
constexpr std::uint64_t kThreshold = 4;

// Runs of so many statements are moved; and how far, every other time.
constexpr std::uint32_t kLongestRun = 8, kNear = 10;

class WindowSearch {
 public:
  WindowSearch(const RegisterUses& uses, const Predecessors& predecessors, std::span<std::uint32_t> order)
      : order_(order) {
    take(uses, predecessors);
  }

  void search(std::size_t tries) {
    RegisterFile file(uses_);
    const auto size = static_cast<std::uint32_t>(order_.size());
    std::vector<std::uint32_t> current(size), place(size), moved;
    for (std::uint32_t i = 0; i < size; ++i) current[i] = place[i] = i;
    std::uint64_t cost = file.cost(current), best_cost = cost;
    std::vector<std::uint32_t> best = current;
    std::mt19937_64 random(1);
    const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
    for (std::size_t i = 0; i < tries; ++i) {
      const std::uint32_t at = below(size), longest = below(3) == 0 ? 1 + below(kLongestRun) : 1;
      const std::uint32_t run = std::min(longest, size - at);
      std::uint32_t lowest = 0, highest = size - run;
      for (std::uint32_t k = at; k < at + run; ++k) {
        for (const std::uint32_t p : before_[current[k]])
          if (place[p] < at) lowest = std::max(lowest, place[p] + 1);
        for (const std::uint32_t s : after_[current[k]])
          if (place[s] >= at + run) highest = std::min(highest, place[s] - run);
      }
      if (below(2) == 0) {
        lowest = std::max(lowest, at > kNear ? at - kNear : 0);
        highest = std::min(highest, at + kNear);
      }
      if (highest <= lowest) continue;
      const std::uint32_t to = lowest + below(highest - lowest + 1);
      if (to == at) continue;
      moved = current;
      const auto begin = moved.begin();
      if (to < at)
        std::rotate(begin + to, begin + at, begin + at + run);
      else
        std::rotate(begin + at, begin + at + run, begin + to + run);
      const std::uint64_t limit = cost + (kThreshold - kThreshold * i / tries);
      const std::uint64_t new_cost = file.cost(moved, limit);
      if (new_cost > limit) continue;
      cost = new_cost;
      current.swap(moved);
      for (std::uint32_t k = std::min(at, to); k < std::max(at, to) + run; ++k) place[current[k]] = k;
      if (cost >= best_cost) continue;
      best_cost = cost;
      best = current;
    }
    std::vector<std::uint32_t> out;
    for (const std::uint32_t i : best) out.push_back(order_[i]);
    std::ranges::copy(out, order_.begin());
  }

 private:
  /// The window as a program of its own: statements by their places in the order. What comes from before is
  /// in memory; that something is read behind the window counts for nothing.
  void take(const RegisterUses& uses, const Predecessors& predecessors) {
    std::map<std::uint32_t, std::uint32_t> place, number;
    for (std::uint32_t i = 0; i < order_.size(); ++i) place[order_[i]] = i;
    const auto number_of = [&](std::uint32_t value, bool in_memory) {
      const auto [entry, fresh] = number.try_emplace(value, static_cast<std::uint32_t>(number.size()));
      if (fresh) uses_.in_memory.push_back(in_memory ? 1 : 0);
      return entry->second;
    };
    before_.resize(order_.size());
    after_.resize(order_.size());
    for (const std::uint32_t s : order_)
      if (uses.statements[s].result != kNoIndex)
        number_of(uses.statements[s].result, uses.in_memory[uses.statements[s].result]);
    for (std::uint32_t i = 0; i < order_.size(); ++i) {
      const std::uint32_t s = order_[i];
      std::vector<std::uint32_t> reads;
      for (const std::uint32_t v : uses.reads(s)) reads.push_back(number_of(v, true));
      const std::uint32_t result = uses.statements[s].result;
      uses_.add(reads, result == kNoIndex ? result : number_of(result, false));
      for (const std::uint32_t p : predecessors[s])
        if (const auto found = place.find(p); found != place.end()) {
          before_[i].push_back(found->second);
          after_[found->second].push_back(i);
        }
    }
  }

  std::span<std::uint32_t> order_;
  RegisterUses uses_;
  std::vector<std::vector<std::uint32_t>> before_, after_;
};

}  // namespace

void search_order(const RegisterUses& uses, const Predecessors& predecessors,
                  std::vector<std::uint32_t>& order) {
  const std::size_t tries = std::min(kOrdersTried, kAllOrdersTried / std::max<std::size_t>(order.size(), 1));
  if (tries == 0) return;
  RegisterFile file(uses);
  std::uint64_t cost = file.cost(order);
  for (std::size_t begin = 0;; begin += kStep) {
    const std::size_t count = std::min(kWindow, order.size() - begin);
    const std::vector<std::uint32_t> before = order;
    WindowSearch(uses, predecessors, std::span(order).subspan(begin, count)).search(tries * count);
    // What is good for a window need not be for the whole.
    const std::uint64_t new_cost = file.cost(order);
    if (new_cost > cost) order = before;
    cost = std::min(cost, new_cost);
    if (begin + count >= order.size()) break;
  }
}

}  // namespace alembert
