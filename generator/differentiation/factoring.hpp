// The factoring of D*. In: a labelled derivative graph. Out: the same graph with an edge added for each
// factor subgraph, until every pair's edges are one path.
#pragma once

#include <cstdint>
#include <vector>

#include "differentiation/dominators.hpp"
#include "differentiation/factor_groups.hpp"
#include "differentiation/labelled_graph.hpp"

namespace alembert {

class Factoring {
 public:
  struct Limits {
    std::uint64_t max_steps;  ///< factorings
    std::uint64_t max_work;   ///< edges visited
  };

  /// With `check`, every step recomputes all path sums modulo a prime and throws InternalError if one has
  /// changed.
  Factoring(ExprGraph& expressions, LabelledGraph& graph, std::size_t vertex_count, Limits limits,
            bool check);

  /// False if a limit was reached; the graph's path sums are right even then.
  bool run();

  std::uint64_t steps() const { return steps_; }
  std::uint64_t work() const { return work_ + dominators_.work(); }

 private:
  /// A factor subgraph of one pair.
  struct Candidate {
    std::uint32_t a, b, least_size;
    FactorKind kind;
    std::uint64_t numerator, denominator;  ///< the fingerprint is their quotient
    /// The vertex that makes it one.
    std::uint32_t vertex() const { return kind == FactorKind::dominator ? b : a; }
  };
  /// The group that a pair's candidate belongs to.
  struct Stake {
    std::uint32_t a, b;
    FactorKind kind;
    std::uint64_t fingerprint;
    std::uint32_t group;
    std::uint32_t vertex() const { return kind == FactorKind::dominator ? b : a; }
  };
  /// Sums over the paths from the root down to a vertex and from it down to the variable, and their greatest
  /// numbers of edges.
  struct PathMeasure {
    std::uint64_t from_root = 0, to_variable = 0;
    std::uint32_t depth = 0, height = 0;
  };

  std::uint64_t expected_work();
  void refresh(std::size_t pair);
  void find_candidates(std::size_t pair);
  std::vector<std::uint64_t> fingerprints() const;
  void renew_stakes(std::size_t pair);
  void measure_paths(const LabelledGraph::Pair& pair);
  std::vector<std::uint32_t> collect(const FactorGroup& group);
  Expr sum_of_paths(const FactorGroup& group);
  void apply(const FactorGroup& group);
  void add_edge(std::uint32_t top, std::uint32_t bottom, Ref value, const PairSet& pairs);
  void check_step() const;

  ExprGraph& expressions_;
  LabelledGraph& graph_;
  Limits limits_;
  Dominators dominators_;
  FactorGroups groups_;
  std::vector<std::vector<Stake>> stakes_;  // of each pair
  std::vector<std::uint64_t> weights_;      // of each edge, for fingerprints
  std::vector<Candidate> candidates_;       // scratch
  std::vector<PathMeasure> measures_;       // scratch, of each vertex
  std::vector<std::uint8_t> marks_;         // scratch, of each vertex
  std::vector<Expr> sums_;                  // scratch, of each vertex
  std::uint64_t steps_ = 0, work_ = 0;

  bool check_;
  std::vector<Modular> point_;
  std::vector<Modular> values_;       // of each edge, at the point
  std::vector<Modular> derivatives_;  // of each pair, at the point
};

}  // namespace alembert
