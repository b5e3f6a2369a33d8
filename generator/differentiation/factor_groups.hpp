// Which factor subgraph comes next. In: for each pair, the subgraphs that could be factored in it. Out: the
// one used by most pairs; among equals that of fewest edges, then of least extent, then of lowest vertices,
// then the one found first.
#pragma once

#include <cstdint>
#include <optional>
#include <queue>
#include <unordered_map>
#include <vector>

#include "differentiation/pair_set.hpp"

namespace alembert {

/// All paths between two vertices, a above b, that some pairs have in common.
struct FactorGroup {
  std::uint32_t a = 0, b = 0;
  std::uint64_t fingerprint =
      0;  ///< of the set of edges: the sum over paths of products of random weights, modulo 2^61 - 1
  PairSet dominator;        ///< pairs where a = idom(b) and b has more than one edge upwards
  PairSet postdominator;    ///< pairs where b = ipostdom(a) and a has more than one edge downwards
  std::uint32_t users = 0;  ///< size of the union of the two
  std::uint32_t size = 0;   ///< number of edges; a lower bound while `edges` is empty
  std::vector<std::uint32_t> edges;
  std::uint64_t serial = 0;
  std::uint32_t announced = 0;  ///< users at the last announcement
  bool touched = false;
};

enum class FactorKind : std::uint8_t { dominator, postdominator };

class FactorGroups {
 public:
  explicit FactorGroups(std::size_t pair_count) : pair_count_(pair_count) {}

  /// Enters a pair; returns the number to leave with. `least_size` is a lower bound of the number of edges.
  std::uint32_t join(std::uint32_t a, std::uint32_t b, std::uint64_t fingerprint, std::uint32_t least_size,
                     std::size_t pair, FactorKind kind);
  void leave(std::uint32_t group, std::size_t pair, FactorKind kind);
  /// To be called when all pairs have joined and left: puts the groups that changed in their places.
  void settle();

  /// The group to be factored next, if there is one. If its edges are not known yet it may be the wrong one:
  /// `measure` it and ask again.
  std::optional<std::uint32_t> best();
  void measure(std::uint32_t group, std::vector<std::uint32_t> edges);
  const FactorGroup& operator[](std::uint32_t group) const { return groups_[group]; }

 private:
  struct Key {
    std::uint32_t a, b;
    std::uint64_t fingerprint;
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key& key) const {
      return static_cast<std::size_t>(key.fingerprint ^
                                      (std::uint64_t{key.a} << 32 | key.b) * 0x9e3779b97f4a7c15u);
    }
  };
  struct Entry {
    std::uint32_t users, size;
    bool measured;
    std::uint32_t a, b;
    std::uint64_t serial;
    std::uint32_t group;
  };
  struct Worse {
    bool operator()(const Entry& x, const Entry& y) const;
  };
  void announce(std::uint32_t group);
  void touch(std::uint32_t group);

  std::size_t pair_count_;
  std::vector<FactorGroup> groups_;
  std::vector<std::uint32_t> free_, touched_;
  std::unordered_map<Key, std::uint32_t, KeyHash> numbers_;      // looked up only, never walked
  std::priority_queue<Entry, std::vector<Entry>, Worse> queue_;  // with entries that are out of date
  std::uint64_t next_serial_ = 1;
};

}  // namespace alembert
