// The two sweeps: dominators with parents first, postdominators with children first.
#include "differentiation/dominators.hpp"

#include <cstddef>

#include "support/no_index.hpp"

namespace alembert {

Dominators::Dominators(std::size_t vertex_count) : entries_(vertex_count) {}

void Dominators::sweep(std::span<const Arc> arcs, std::uint32_t source, std::uint32_t sink) {
  for (const Arc& arc : arcs) entries_[arc.top] = entries_[arc.bottom] = Entry{};
  entries_[source] = entries_[sink] = Entry{};
  entries_[source].idom = source;
  entries_[sink].ipdom = sink;

  // All arcs into arc.top come before it, so the dominator of arc.top is final, and so are those above it.
  for (const Arc& arc : arcs) {
    ++entries_[arc.top].down;
    ++entries_[arc.bottom].up;
    std::uint32_t& idom = entries_[arc.bottom].idom;
    if (idom == kNoIndex) {
      idom = arc.top;
      continue;
    }
    std::uint32_t other = arc.top;
    while (idom != other) {
      ++work_;
      std::uint32_t& lower = idom < other ? idom : other;
      lower = entries_[lower].idom;
    }
  }
  for (std::size_t k = arcs.size(); k-- > 0;) {
    const Arc& arc = arcs[k];
    std::uint32_t& ipdom = entries_[arc.top].ipdom;
    if (ipdom == kNoIndex) {
      ipdom = arc.bottom;
      continue;
    }
    std::uint32_t other = arc.bottom;
    while (ipdom != other) {
      ++work_;
      std::uint32_t& upper = ipdom > other ? ipdom : other;
      upper = entries_[upper].ipdom;
    }
  }
  work_ += 2 * arcs.size();
}

}  // namespace alembert
