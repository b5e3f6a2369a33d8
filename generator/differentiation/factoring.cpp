// One step: find each pair's factor subgraphs, take the group that most pairs use, replace it by an edge.
//
// Two pairs' subgraphs are the same if they have the same edges. Comparing edge lists would cost more than
// all the rest, so every edge has a random weight, and a subgraph is known by the sum over its paths of the
// products of the weights. Since all paths to b pass its dominator a, that sum is (sum from the root to b) /
// (sum from the root to a): one sweep gives the fingerprints of all candidates of a pair.
#include "differentiation/factoring.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "support/error.hpp"
#include "symbolic/evaluate_modular.hpp"
#include "symbolic/modular.hpp"

namespace alembert {

namespace {

/// A number that looks random, from 1 to p - 1 (splitmix64).
std::uint64_t weight_of_edge(std::uint64_t edge) {
  std::uint64_t z = (edge + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  z ^= z >> 31;
  return 1 + z % (modular::kPrime - 1);
}

}  // namespace

Factoring::Factoring(ExprGraph& expressions, LabelledGraph& graph, std::size_t vertex_count, Limits limits,
                     bool check)
    : expressions_(expressions),
      graph_(graph),
      limits_(limits),
      dominators_(vertex_count),
      groups_(graph.pairs.size()),
      stakes_(graph.pairs.size()),
      measures_(vertex_count),
      marks_(vertex_count),
      sums_(vertex_count),
      check_(check) {
  weights_.reserve(graph.edges.size());
  for (std::size_t e = 0; e < graph.edges.size(); ++e) weights_.push_back(weight_of_edge(e));
  if (!check_) return;
  std::vector<Expr> edges;
  for (const DerivativeEdge& edge : graph.edges) edges.emplace_back(expressions, edge.value);
  point_ = random_modular_point(expressions.symbol_count(), 20070801);
  values_ = evaluate_modular(edges, point_);
  for (std::size_t p = 0; p < graph.pairs.size(); ++p) derivatives_.push_back(path_sum(graph, p, values_));
  check_labels(graph);
}

bool Factoring::run() {
  if (expected_work() > limits_.max_work) return false;
  for (std::size_t p = 0; p < graph_.pairs.size(); ++p) {
    refresh(p);
    if (work() > limits_.max_work) return false;
  }
  groups_.settle();
  while (const std::optional<std::uint32_t> best = groups_.best()) {
    const FactorGroup& group = groups_[*best];
    if (group.edges.empty()) {
      groups_.measure(*best, collect(group));
      continue;
    }
    if (steps_ == limits_.max_steps || work() > limits_.max_work) return false;
    ++steps_;
    apply(group);
    if (check_) check_step();
  }
  for (std::size_t p = 0; p < graph_.pairs.size(); ++p) check_single_path(graph_, p);
  return true;
}

/// Each candidate of a pair costs about one more refresh, which visits the pair's edges some seven times, and
/// they grow fewer meanwhile. (Measured: 12 to 16 quarters a candidate and edge, on random functions of all
/// sizes.)
std::uint64_t Factoring::expected_work() {
  std::uint64_t expected = 0;
  for (const LabelledGraph::Pair& pair : graph_.pairs) {
    for (const Arc& arc : pair.arcs) marks_[arc.top] = marks_[arc.bottom] = 0;
    std::uint64_t candidates = 0;
    constexpr std::uint8_t kUp = 1, kUpCounted = 2, kDown = 4, kDownCounted = 8;
    const auto meet = [&](std::uint8_t& mark, std::uint8_t once, std::uint8_t twice) {
      if ((mark & twice) != 0) return;
      if ((mark & once) != 0) ++candidates;
      mark = static_cast<std::uint8_t>(mark | ((mark & once) != 0 ? twice : once));
    };
    for (const Arc& arc : pair.arcs) {
      meet(marks_[arc.bottom], kUp, kUpCounted);
      meet(marks_[arc.top], kDown, kDownCounted);
    }
    for (const Arc& arc : pair.arcs) marks_[arc.top] = marks_[arc.bottom] = 0;
    expected += candidates * pair.arcs.size() * 7 / 2;
  }
  return expected;
}

/// Brings a pair's list, candidates and stakes up to date after its edges have changed.
void Factoring::refresh(std::size_t p) {
  work_ += graph_.pairs[p].arcs.size();
  prune(graph_, p, marks_);
  find_candidates(p);
  renew_stakes(p);
}

/// The fingerprint of each candidate; one inversion serves all denominators.
std::vector<std::uint64_t> Factoring::fingerprints() const {
  std::vector<std::uint64_t> result;
  result.reserve(candidates_.size());
  std::uint64_t product = 1;
  for (const Candidate& candidate : candidates_) {
    result.push_back(product);
    product = modular::multiply(product, candidate.denominator);
  }
  std::uint64_t inverse = modular::inverse(product);
  for (std::size_t k = candidates_.size(); k-- > 0;) {
    const Candidate& candidate = candidates_[k];
    result[k] = modular::multiply(candidate.numerator, modular::multiply(inverse, result[k]));
    inverse = modular::multiply(inverse, candidate.denominator);
  }
  return result;
}

/// Leaves the groups of candidates that are gone or changed, joins those of new ones. Most stay as they are,
/// and both lists run from the root down, so that they are merged.
void Factoring::renew_stakes(std::size_t p) {
  const std::vector<std::uint64_t> prints = fingerprints();
  work_ += 2 * candidates_.size();
  std::vector<Stake> renewed;
  renewed.reserve(candidates_.size());
  const std::vector<Stake>& old = stakes_[p];
  const auto earlier = [](const auto& x, const auto& y) {
    return x.vertex() != y.vertex() ? x.vertex() > y.vertex() : x.kind < y.kind;
  };
  std::size_t next = 0;
  for (std::size_t k = 0; k < candidates_.size(); ++k) {
    const Candidate& candidate = candidates_[k];
    for (; next < old.size() && earlier(old[next], candidate); ++next)
      groups_.leave(old[next].group, p, old[next].kind);
    if (next < old.size() && !earlier(candidate, old[next])) {
      const Stake stake = old[next++];
      if (stake.a == candidate.a && stake.b == candidate.b && stake.fingerprint == prints[k]) {
        renewed.push_back(stake);
        continue;
      }
      groups_.leave(stake.group, p, stake.kind);
    }
    const std::uint32_t group =
        groups_.join(candidate.a, candidate.b, prints[k], candidate.least_size, p, candidate.kind);
    renewed.push_back({candidate.a, candidate.b, candidate.kind, prints[k], group});
  }
  for (; next < old.size(); ++next) groups_.leave(old[next].group, p, old[next].kind);
  stakes_[p] = std::move(renewed);
}

void Factoring::find_candidates(std::size_t p) {
  candidates_.clear();
  const LabelledGraph::Pair& pair = graph_.pairs[p];
  const std::vector<Arc>& arcs = pair.arcs;
  dominators_.sweep(arcs, pair.root, pair.variable);
  measure_paths(pair);
  const auto consider = [&](std::uint32_t v) {
    const PathMeasure& here = measures_[v];
    if (v != pair.root && dominators_.up_count(v) > 1) {
      const std::uint32_t a = dominators_.idom(v);
      const std::uint32_t least = here.depth - measures_[a].depth + dominators_.up_count(v) - 1;
      candidates_.push_back({a, v, least, FactorKind::dominator, here.from_root, measures_[a].from_root});
    }
    if (v != pair.variable && dominators_.down_count(v) > 1) {
      const std::uint32_t b = dominators_.ipdom(v);
      const std::uint32_t least = here.height - measures_[b].height + dominators_.down_count(v) - 1;
      candidates_.push_back(
          {v, b, least, FactorKind::postdominator, here.to_variable, measures_[b].to_variable});
    }
  };
  // Every vertex but the variable is the top of some arc, and equal tops follow one another.
  for (std::size_t k = 0; k < arcs.size(); ++k)
    if (k == 0 || arcs[k - 1].top != arcs[k].top) consider(arcs[k].top);
  if (!arcs.empty()) consider(pair.variable);
}

void Factoring::measure_paths(const LabelledGraph::Pair& pair) {
  for (const Arc& arc : pair.arcs) measures_[arc.top] = measures_[arc.bottom] = PathMeasure{};
  measures_[pair.root].from_root = 1;
  measures_[pair.variable].to_variable = 1;
  for (const Arc& arc : pair.arcs) {
    const PathMeasure& top = measures_[arc.top];
    PathMeasure& bottom = measures_[arc.bottom];
    bottom.from_root = modular::add(bottom.from_root, modular::multiply(top.from_root, weights_[arc.edge]));
    bottom.depth = std::max(bottom.depth, top.depth + 1);
  }
  for (std::size_t k = pair.arcs.size(); k-- > 0;) {
    const Arc& arc = pair.arcs[k];
    const PathMeasure& bottom = measures_[arc.bottom];
    PathMeasure& top = measures_[arc.top];
    top.to_variable =
        modular::add(top.to_variable, modular::multiply(bottom.to_variable, weights_[arc.edge]));
    top.height = std::max(top.height, bottom.height + 1);
  }
  work_ += 2 * pair.arcs.size();
}

/// The edges on all paths from a to b, parents first, as any one of the group's pairs sees them.
std::vector<std::uint32_t> Factoring::collect(const FactorGroup& group) {
  constexpr std::uint8_t kBelowA = 1, kAboveB = 2;
  std::size_t user = graph_.pairs.size();
  for (const PairSet* set : {&group.dominator, &group.postdominator})
    set->for_each([&](std::size_t p) { user = std::min(user, p); });
  const std::vector<Arc>& arcs = graph_.pairs[user].arcs;
  const auto first =
      std::partition_point(arcs.begin(), arcs.end(), [&](const Arc& x) { return x.top > group.a; });
  const auto last = std::partition_point(first, arcs.end(), [&](const Arc& x) { return x.top > group.b; });
  marks_[group.a] |= kBelowA;
  marks_[group.b] |= kAboveB;
  for (auto arc = first; arc != last; ++arc)
    if ((marks_[arc->top] & kBelowA) != 0) marks_[arc->bottom] |= kBelowA;
  for (auto arc = last; arc != first;) {
    --arc;
    if ((marks_[arc->bottom] & kAboveB) != 0) marks_[arc->top] |= kAboveB;
  }
  std::vector<std::uint32_t> edges;
  for (auto arc = first; arc != last; ++arc)
    if ((marks_[arc->top] & kBelowA) != 0 && (marks_[arc->bottom] & kAboveB) != 0) edges.push_back(arc->edge);
  for (auto arc = first; arc != last; ++arc) marks_[arc->top] = marks_[arc->bottom] = 0;
  marks_[group.a] = marks_[group.b] = 0;
  work_ += static_cast<std::uint64_t>(last - first);
  if (edges.size() < 2) throw InternalError("D*: a factor subgraph of a single edge");
  return edges;
}

/// Sum over the paths from a to b of the products of their edges: from a down or from b up, whichever
/// multiplies less.
Expr Factoring::sum_of_paths(const FactorGroup& group) {
  const auto unit = [&](const DerivativeEdge& edge) {
    return Expr(expressions_, Ref(edge.value.node(), false)).is_one();
  };
  std::size_t at_a = 0, at_b = 0;  // edges that need no multiplication when starting there
  for (const std::uint32_t e : group.edges) {
    const DerivativeEdge& edge = graph_.edges[e];
    if (unit(edge)) continue;
    at_a += edge.top == group.a ? 1 : 0;
    at_b += edge.bottom == group.b ? 1 : 0;
  }
  const bool downwards = at_a >= at_b;
  const std::size_t count = group.edges.size();
  sums_[downwards ? group.a : group.b] = expressions_.one();
  for (std::size_t k = 0; k < count; ++k) {
    const DerivativeEdge& edge = graph_.edges[group.edges[downwards ? k : count - 1 - k]];
    const Expr product = sums_[downwards ? edge.top : edge.bottom] * Expr(expressions_, edge.value);
    Expr& sum = sums_[downwards ? edge.bottom : edge.top];
    sum = sum.valid() ? sum + product : product;
  }
  const Expr result = sums_[downwards ? group.b : group.a];
  for (const std::uint32_t e : group.edges)
    sums_[graph_.edges[e].top] = sums_[graph_.edges[e].bottom] = Expr();
  return result;
}

void Factoring::apply(const FactorGroup& group) {
  const std::uint32_t a = group.a, b = group.b;
  PairSet users = group.dominator;
  users.insert(group.postdominator);
  for (const std::uint32_t e : group.edges)
    if (!graph_.labels[e].includes(users)) throw InternalError("D*: pairs of one group have different edges");

  const Expr sum = sum_of_paths(group);
  for (const std::uint32_t e : group.edges) {
    if (graph_.edges[e].bottom == b) graph_.labels[e].erase(group.dominator);
    if (graph_.edges[e].top == a) graph_.labels[e].erase(group.postdominator);
  }
  users.for_each([&](std::size_t p) {
    std::vector<Arc>& arcs = graph_.pairs[p].arcs;
    std::erase_if(arcs, [&](const Arc& arc) { return !graph_.labels[arc.edge].contains(p); });
    work_ += arcs.size();
  });
  if (!sum.is_zero()) add_edge(a, b, sum.ref(), users);
  // From here on the group may be gone.
  users.for_each([&](std::size_t p) { refresh(p); });
  groups_.settle();
}

void Factoring::add_edge(std::uint32_t top, std::uint32_t bottom, Ref value, const PairSet& pairs) {
  const auto number = static_cast<std::uint32_t>(graph_.edges.size());
  graph_.edges.push_back({top, bottom, value});
  graph_.labels.push_back(pairs);
  weights_.push_back(weight_of_edge(number));
  const Arc arc{top, bottom, number};
  pairs.for_each([&](std::size_t p) {
    std::vector<Arc>& arcs = graph_.pairs[p].arcs;
    arcs.insert(std::upper_bound(arcs.begin(), arcs.end(), arc, arc_before), arc);
  });
  if (check_) {
    const std::array<Expr, 1> root = {Expr(expressions_, value)};
    values_.push_back(evaluate_modular(root, point_).front());
  }
}

void Factoring::check_step() const {
  check_labels(graph_);
  for (std::size_t p = 0; p < graph_.pairs.size(); ++p) {
    if (path_sum(graph_, p, values_) != derivatives_[p])
      throw InternalError("D*: a factoring has changed a derivative");
  }
}

}  // namespace alembert
