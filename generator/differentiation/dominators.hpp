// Dominators and postdominators of the paths between two vertices of an acyclic graph (Cooper, Harvey,
// Kennedy 2001, "A simple, fast dominance algorithm"; without cycles one sweep is enough). In: the arcs
// between a source and a sink. Out: the immediate dominator and postdominator of every vertex on a path, and
// its numbers of arcs.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "support/no_index.hpp"

namespace alembert {

/// An edge as seen by one pair (root, variable). Vertices are numbered so that top > bottom.
struct Arc {
  std::uint32_t top, bottom;
  std::uint32_t edge;  ///< number of the edge it stands for
  friend bool operator==(const Arc&, const Arc&) = default;
};

/// The order that every list of arcs is kept in: parents before children.
inline bool arc_before(const Arc& x, const Arc& y) {
  if (x.top != y.top) return x.top > y.top;
  if (x.bottom != y.bottom) return x.bottom > y.bottom;
  return x.edge < y.edge;
}

/// Keeps its tables from one graph to the next, because thousands of small graphs are swept in turn.
class Dominators {
 public:
  explicit Dominators(std::size_t vertex_count);

  /// Sweeps the graph. `arcs` is ordered by arc_before and each arc lies on a path from source to sink.
  void sweep(std::span<const Arc> arcs, std::uint32_t source, std::uint32_t sink);

  // The rest holds for vertices on a path, and lasts until the next sweep.
  /// The nearest vertex other than v that all paths from the source to v pass; the source's is the source.
  std::uint32_t idom(std::uint32_t v) const { return entries_[v].idom; }
  /// The nearest vertex other than v that all paths from v to the sink pass; the sink's is the sink.
  std::uint32_t ipdom(std::uint32_t v) const { return entries_[v].ipdom; }
  std::uint32_t up_count(std::uint32_t v) const { return entries_[v].up; }      ///< arcs that end at v
  std::uint32_t down_count(std::uint32_t v) const { return entries_[v].down; }  ///< arcs that begin at v

  /// Arcs visited and dominator links followed so far, in all sweeps: a measure of time that is the same on
  /// every machine.
  std::uint64_t work() const { return work_; }

 private:
  struct Entry {
    std::uint32_t idom = kNoIndex, ipdom = kNoIndex, up = 0, down = 0;
  };
  std::vector<Entry> entries_;
  std::uint64_t work_ = 0;
};

}  // namespace alembert
