// Labels, pruning, and the invariants of the labelled graph.
#include "differentiation/labelled_graph.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "support/error.hpp"
#include "support/no_index.hpp"
#include "symbolic/modular.hpp"

namespace alembert {

namespace {

/// Rows of bits, one row a vertex.
class BitRows {
 public:
  BitRows(std::size_t rows, std::size_t columns) : words_((columns + 63) / 64), bits_(rows * words_) {}
  std::span<std::uint64_t> row(std::size_t i) { return {bits_.data() + i * words_, words_}; }
  void insert(std::size_t i, std::size_t j) { bits_[i * words_ + j / 64] |= std::uint64_t{1} << (j % 64); }
  void merge(std::size_t into, std::size_t from) {
    for (std::size_t k = 0; k < words_; ++k) bits_[into * words_ + k] |= bits_[from * words_ + k];
  }
  std::uint64_t count(std::size_t i) const {
    std::uint64_t sum = 0;
    for (std::size_t k = 0; k < words_; ++k)
      sum += static_cast<std::uint64_t>(std::popcount(bits_[i * words_ + k]));
    return sum;
  }
  template <typename Visit>
  void for_each(std::size_t i, Visit visit) const {
    for (std::size_t k = 0; k < words_; ++k)
      for (std::uint64_t word = bits_[i * words_ + k]; word != 0; word &= word - 1)
        visit(k * 64 + static_cast<std::size_t>(std::countr_zero(word)));
  }

 private:
  std::size_t words_;
  std::vector<std::uint64_t> bits_;
};

template <typename Value, typename MultiplyAdd>
Value sum_over_paths(const LabelledGraph& graph, std::size_t index, std::span<const Value> values, Value one,
                     MultiplyAdd multiply_add) {
  const LabelledGraph::Pair& pair = graph.pairs[index];
  std::unordered_map<std::uint32_t, Value> sums;  // vertex -> sum over the paths that lead to it
  sums[pair.root] = one;
  for (const Arc& arc : pair.arcs) {
    const auto top = sums.find(arc.top);
    if (top == sums.end()) throw InternalError("D*: an edge hangs in the air");
    const Value above = top->second;
    Value& sum = sums[arc.bottom];
    sum = multiply_add(sum, above, values[arc.edge]);
  }
  return sums[pair.variable];
}

}  // namespace

std::optional<LabelledGraph> label_edges(const DerivativeGraph& graph, std::uint64_t max_labels) {
  // Equal roots, up to sign, share their pairs.
  std::vector<std::uint32_t> distinct;          // vertices
  std::map<std::uint32_t, std::size_t> row_of;  // vertex -> index in `distinct`
  for (const std::uint32_t root : graph.roots)
    if (root != kNoIndex && row_of.emplace(root, distinct.size()).second) distinct.push_back(root);

  const std::size_t vertex_count = graph.nodes.size();
  const std::size_t columns = graph.variables.size();
  if (vertex_count * ((distinct.size() + 63) / 64 + (columns + 63) / 64) > max_labels) return std::nullopt;
  BitRows above(vertex_count, distinct.size()), below(vertex_count, columns);
  for (std::size_t i = 0; i < distinct.size(); ++i) above.insert(distinct[i], i);
  for (std::size_t j = 0; j < columns; ++j)
    if (graph.variables[j] != kNoIndex) below.insert(graph.variables[j], j);
  for (const DerivativeEdge& edge : graph.edges) below.merge(edge.top, edge.bottom);
  for (std::size_t k = graph.edges.size(); k-- > 0;) above.merge(graph.edges[k].bottom, graph.edges[k].top);

  LabelledGraph result;
  std::vector<std::uint32_t> pair_at(distinct.size() * columns, kNoIndex);
  for (std::size_t i = 0; i < distinct.size(); ++i) {
    below.for_each(distinct[i], [&](std::size_t j) {
      if (graph.variables[j] == distinct[i]) return;
      pair_at[i * columns + j] = static_cast<std::uint32_t>(result.pairs.size());
      result.pairs.push_back({distinct[i], graph.variables[j], {}});
    });
  }
  result.pair_of.assign(graph.roots.size() * columns, kNoIndex);
  for (std::size_t i = 0; i < graph.roots.size(); ++i) {
    if (graph.roots[i] == kNoIndex) continue;
    const std::size_t row = row_of.at(graph.roots[i]);
    for (std::size_t j = 0; j < columns; ++j) result.pair_of[i * columns + j] = pair_at[row * columns + j];
  }

  std::uint64_t labels = 0, used = 0;
  for (const DerivativeEdge& edge : graph.edges) {
    const std::uint64_t here = above.count(edge.top) * below.count(edge.bottom);
    labels += here;
    used += here != 0 ? 1 : 0;
    if (labels > max_labels || used * (result.pairs.size() / 64 + 1) > max_labels) return std::nullopt;
  }
  for (const DerivativeEdge& edge : graph.edges) {
    if (above.count(edge.top) == 0) continue;  // under an operand whose partial is zero
    const auto number = static_cast<std::uint32_t>(result.edges.size());
    result.edges.push_back(edge);
    PairSet& label = result.labels.emplace_back(result.pairs.size());
    above.for_each(edge.top, [&](std::size_t i) {
      below.for_each(edge.bottom, [&](std::size_t j) {
        const std::uint32_t pair = pair_at[i * columns + j];
        label.insert(pair);
        result.pairs[pair].arcs.push_back({edge.top, edge.bottom, number});
      });
    });
  }
  for (LabelledGraph::Pair& pair : result.pairs) std::sort(pair.arcs.begin(), pair.arcs.end(), arc_before);
  return result;
}

void prune(LabelledGraph& graph, std::size_t index, std::vector<std::uint8_t>& marks) {
  constexpr std::uint8_t kBelowRoot = 1, kAboveVariable = 2;
  LabelledGraph::Pair& pair = graph.pairs[index];
  std::vector<Arc>& arcs = pair.arcs;
  marks[pair.root] |= kBelowRoot;
  marks[pair.variable] |= kAboveVariable;
  for (const Arc& arc : arcs)
    if ((marks[arc.top] & kBelowRoot) != 0) marks[arc.bottom] |= kBelowRoot;
  for (std::size_t k = arcs.size(); k-- > 0;)
    if ((marks[arcs[k].bottom] & kAboveVariable) != 0) marks[arcs[k].top] |= kAboveVariable;
  std::size_t kept = 0;
  std::vector<Arc> dropped;
  for (const Arc& arc : arcs) {
    if ((marks[arc.top] & kBelowRoot) != 0 && (marks[arc.bottom] & kAboveVariable) != 0) {
      arcs[kept++] = arc;
    } else {
      graph.labels[arc.edge].erase(index);
      dropped.push_back(arc);
    }
  }
  arcs.resize(kept);
  marks[pair.root] = marks[pair.variable] = 0;
  for (const std::vector<Arc>* list : {&arcs, &dropped})
    for (const Arc& arc : *list) marks[arc.top] = marks[arc.bottom] = 0;
}

Modular path_sum(const LabelledGraph& graph, std::size_t pair, std::span<const Modular> values) {
  return sum_over_paths<Modular>(graph, pair, values, {1, 0}, [](Modular sum, Modular x, Modular y) {
    return modular::add(sum, modular::multiply(x, y));
  });
}

double path_sum(const LabelledGraph& graph, std::size_t pair, std::span<const double> values) {
  return sum_over_paths<double>(graph, pair, values, 1.0,
                                [](double sum, double x, double y) { return sum + x * y; });
}

void check_labels(const LabelledGraph& graph) {
  std::size_t listed = 0, labelled = 0;
  for (std::size_t p = 0; p < graph.pairs.size(); ++p) {
    const LabelledGraph::Pair& pair = graph.pairs[p];
    std::map<std::uint32_t, bool> reached, leads_on;
    reached[pair.root] = true;
    leads_on[pair.variable] = true;
    for (const Arc& arc : pair.arcs) reached[arc.bottom] = leads_on[arc.top] = true;
    for (const Arc& arc : pair.arcs) {
      const DerivativeEdge& edge = graph.edges[arc.edge];
      if (edge.top != arc.top || edge.bottom != arc.bottom || arc.top <= arc.bottom)
        throw InternalError("D*: an edge has other ends than its pair believes");
      if (!graph.labels[arc.edge].contains(p)) throw InternalError("D*: a label lacks a pair");
      if (!reached[arc.top] || !leads_on[arc.bottom]) throw InternalError("D*: an edge hangs in the air");
    }
    for (std::size_t k = 1; k < pair.arcs.size(); ++k)
      if (!arc_before(pair.arcs[k - 1], pair.arcs[k])) throw InternalError("D*: edges out of order");
    listed += pair.arcs.size();
  }
  for (const PairSet& label : graph.labels) label.for_each([&](std::size_t) { ++labelled; });
  if (listed != labelled) throw InternalError("D*: a label holds a pair that does not use the edge");
}

void check_single_path(const LabelledGraph& graph, std::size_t index) {
  const LabelledGraph::Pair& pair = graph.pairs[index];
  if (pair.arcs.empty()) return;
  std::uint32_t vertex = pair.root;
  for (const Arc& arc : pair.arcs) {
    if (arc.top != vertex) throw InternalError("D*: a pair is left with more than one path");
    vertex = arc.bottom;
  }
  if (vertex != pair.variable) throw InternalError("D*: a path does not end at its variable");
}

}  // namespace alembert
