// The derivative graph as D* sees it: every edge carries the set of (root, variable) pairs whose derivatives
// have a path over it. In: a linearised graph. Out: the same graph with labels, and for each pair the list of
// its edges. There is no extra vertex above a root: labels say where each pair's paths begin, so a root
// inside another root is nothing special, and an edge of value 1 above each root would never be factored.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "differentiation/derivative_graph.hpp"
#include "differentiation/dominators.hpp"
#include "differentiation/pair_set.hpp"
#include "support/no_index.hpp"
#include "symbolic/modular.hpp"

namespace alembert {

struct LabelledGraph {
  /// One derivative that is asked for and has a path.
  struct Pair {
    std::uint32_t root, variable;  ///< vertices, root != variable
    std::vector<Arc> arcs;  ///< its edges in the order of arc_before: all edges whose label holds the pair
  };

  std::vector<DerivativeEdge> edges;  ///< grows by one in each factoring; numbers are never used again
  std::vector<PairSet> labels;        ///< of each edge
  std::vector<Pair> pairs;
  /// Pair of (root i, variable j) at [i * columns + j], or kNoIndex where the derivative is trivial. Equal roots
  /// share their pairs.
  std::vector<std::uint32_t> pair_of;
};

/// Labels the edges, or returns nothing if the labels would take more than `max_labels` entries in all.
std::optional<LabelledGraph> label_edges(const DerivativeGraph& graph, std::uint64_t max_labels);

/// Takes the pair off every edge that no longer lies on a path from its root to its variable.
/// `marks` is scratch space, one entry a vertex, all zero before and after.
void prune(LabelledGraph& graph, std::size_t pair, std::vector<std::uint8_t>& marks);

/// Sum over the pair's paths of the products of the edges, where `values[e]` is the value of edge e.
Modular path_sum(const LabelledGraph& graph, std::size_t pair, std::span<const Modular> values);
double path_sum(const LabelledGraph& graph, std::size_t pair, std::span<const double> values);

/// Throws InternalError unless each pair's list agrees with the labels, is in order, and has no edge that
/// hangs in the air.
void check_labels(const LabelledGraph& graph);

/// Throws InternalError unless the pair's edges are one path from its root to its variable, or none.
void check_single_path(const LabelledGraph& graph, std::size_t pair);

}  // namespace alembert
