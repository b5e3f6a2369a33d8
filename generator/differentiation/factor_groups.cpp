// A priority queue of groups; entries are left in it when they go out of date and skipped when they come up.
#include "differentiation/factor_groups.hpp"

#include <tuple>
#include <utility>

namespace alembert {

bool FactorGroups::Worse::operator()(const Entry& x, const Entry& y) const {
  if (x.users != y.users) return x.users < y.users;
  if (x.size != y.size) return x.size > y.size;
  // A group that may be larger than it looks has to be measured before an equal one is taken.
  if (x.measured != y.measured) return x.measured;
  return std::tuple(x.a - x.b, x.a, x.serial) > std::tuple(y.a - y.b, y.a, y.serial);
}

std::uint32_t FactorGroups::join(std::uint32_t a, std::uint32_t b, std::uint64_t fingerprint,
                                 std::uint32_t least_size, std::size_t pair, FactorKind kind) {
  const auto [at, is_new] = numbers_.try_emplace({a, b, fingerprint}, 0);
  if (is_new) {
    if (free_.empty()) {
      at->second = static_cast<std::uint32_t>(groups_.size());
      groups_.emplace_back();
    } else {
      at->second = free_.back();
      free_.pop_back();
    }
    FactorGroup& group = groups_[at->second];
    group = FactorGroup{};
    group.a = a;
    group.b = b;
    group.fingerprint = fingerprint;
    group.dominator = group.postdominator = PairSet(pair_count_);
    group.size = least_size;
    group.serial = next_serial_++;
  }
  FactorGroup& group = groups_[at->second];
  if (!group.dominator.contains(pair) && !group.postdominator.contains(pair)) ++group.users;
  (kind == FactorKind::dominator ? group.dominator : group.postdominator).insert(pair);
  touch(at->second);
  return at->second;
}

void FactorGroups::leave(std::uint32_t number, std::size_t pair, FactorKind kind) {
  FactorGroup& group = groups_[number];
  (kind == FactorKind::dominator ? group.dominator : group.postdominator).erase(pair);
  if (!group.dominator.contains(pair) && !group.postdominator.contains(pair)) --group.users;
  touch(number);
}

void FactorGroups::touch(std::uint32_t number) {
  if (groups_[number].touched) return;
  groups_[number].touched = true;
  touched_.push_back(number);
}

void FactorGroups::settle() {
  for (const std::uint32_t number : touched_) {
    FactorGroup& group = groups_[number];
    group.touched = false;
    if (group.users == 0) {
      numbers_.erase({group.a, group.b, group.fingerprint});
      group = FactorGroup{};
      free_.push_back(number);
    } else if (group.users != group.announced) {
      announce(number);
    }
  }
  touched_.clear();
}

void FactorGroups::announce(std::uint32_t number) {
  FactorGroup& group = groups_[number];
  group.announced = group.users;
  queue_.push({group.users, group.size, !group.edges.empty(), group.a, group.b, group.serial, number});
}

std::optional<std::uint32_t> FactorGroups::best() {
  while (!queue_.empty()) {
    const Entry& top = queue_.top();
    const FactorGroup& group = groups_[top.group];
    if (group.serial == top.serial && group.users == top.users && group.edges.empty() == !top.measured)
      return top.group;
    queue_.pop();
  }
  return std::nullopt;
}

void FactorGroups::measure(std::uint32_t number, std::vector<std::uint32_t> edges) {
  FactorGroup& group = groups_[number];
  group.size = static_cast<std::uint32_t>(edges.size());
  group.edges = std::move(edges);
  announce(number);
}

}  // namespace alembert
