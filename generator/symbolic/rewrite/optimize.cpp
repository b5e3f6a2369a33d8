// Stage `optimise`: expressions in, equal ones that never cost more out.
#include "symbolic/rewrite/optimize.hpp"

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>

#include "support/error.hpp"
#include "symbolic/count_operations.hpp"
#include "symbolic/rebuilt.hpp"
#include "symbolic/rewrite/factor_sums.hpp"
#include "symbolic/rewrite/node_rewrite.hpp"
#include "symbolic/rewrite/share_divisions.hpp"
#include "symbolic/rewrite/share_products.hpp"
#include "symbolic/round_constants.hpp"
#include "symbolic/transferred.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {
namespace {

// Rounds of all rewrites at most; all of them in a row without a gain end the work, in practice in the third
// to fifth.
constexpr int kRounds = 8;
// Up to this weight a round that neither gains nor loses is followed by another one: gravity of lwr_full takes 97 operations
// instead of 120. Longer programs gain one in ten thousand, and take a seventh more time.
constexpr std::size_t kShort = 1'000;
const GoesOn kAlways = [](std::size_t, std::size_t) { return true; };

/// Roots, their nodes and what they cost.
struct Candidate {
  explicit Candidate(LiveNodes values)
      : nodes(std::move(values)), count(count_operations(nodes.roots, nodes.order)), weight(count.weight) {}
  LiveNodes nodes;
  OperationCount count;
  std::size_t weight;
};

class Rewriting {
 public:
  explicit Rewriting(FactorsLeft left) : left_(left) {}
  /// Nothing where `goes_on` is false at stage 0.
  std::optional<Candidate> run(std::vector<Expr> roots, const GoesOn& goes_on);
  FactorsLeft met() const { return met_; }

 private:
  Candidate rewrite(std::vector<Expr> roots);
  std::optional<LiveNodes> rewritten(const LiveNodes& nodes, int which);

  FactorsLeft left_, met_{false, false};
};

constexpr int kRewrites = 3;

// Nothing where a rewrite finds nothing, or brings forth what expressions refuse: a division by zero, or a
// constant outside of a function's domain.
std::optional<LiveNodes> Rewriting::rewritten(const LiveNodes& nodes, int which) {
  try {
    if (which == 0) return factor_sums(nodes, left_, met_);
    return which == 1 ? share_divisions(nodes) : share_products(nodes);
  } catch (const std::domain_error&) {
    return std::nullopt;
  }
}

// The local rewrites, each kept if it gains, until none does. The first, which is nearly certain to gain, is
// not compared: callers compare what comes out.
Candidate Rewriting::rewrite(std::vector<Expr> roots) {
  Candidate best(LiveNodes(std::move(roots)));
  bool compares = false;
  int failed = 0;  // since the last gain
  for (int i = 0; i < kRounds * kRewrites && failed < kRewrites; ++i) {
    ++failed;
    std::optional<LiveNodes> other = rewritten(best.nodes, i % kRewrites);
    if (!other) continue;
    Candidate next(*std::move(other));
    if (compares && next.weight >= best.weight) continue;
    compares = true;
    best = std::move(next);
    failed = 0;
  }
  return best;
}

// The roots with equal values merged, as probabilistic value numbering finds them: rewriting brings forth
// values that are there already in another form.
std::optional<std::vector<Expr>> merge_equal_values(std::span<const Expr> roots) {
  try {
    ExprGraph& graph = roots.front().graph();
    // With all rules of construction.
    const std::vector<Expr> anew = rebuilt(roots, [&](std::uint32_t id, Ref a, Ref b) {
      const Operation op = graph.node(id).op;
      return operand_count(op) == 0 ? Ref(id, false) : graph.make(op, a, b);
    });
    return value_number(anew);
  } catch (const std::domain_error&) {
    return std::nullopt;
  }
}

// Rewriting and value numbering in turn, for as long as that gains or, where little is to be done, brings forth another
// form that is as long: the next round may gain from it.
std::optional<Candidate> Rewriting::run(std::vector<Expr> roots, const GoesOn& goes_on) {
  Candidate best = rewrite(std::move(roots));
  if (!goes_on(0, best.count.all())) return std::nullopt;
  int idle = 0;  // rounds since the last gain
  for (int round = 0; round < kRounds && idle < 2; ++round) {
    std::optional<std::vector<Expr>> merged = merge_equal_values(best.nodes.roots);
    if (!merged) break;
    Candidate next = rewrite(*std::move(merged));
    if (next.weight > best.weight || (next.weight == best.weight && best.weight > kShort)) break;
    idle = next.weight < best.weight ? 0 : idle + 1;
    best = std::move(next);
  }
  return best;
}

/// In a graph that holds little else: most nodes that rewriting makes are of no use in the end.
std::optional<std::vector<Expr>> optimize_alone(std::span<const Expr> roots, const GoesOn& goes_on) {
  const Candidate given(LiveNodes(round_constants(roots)));
  // Which factors had better stay in sums shows in the end only.
  Rewriting sparing({true, false});
  std::optional<Candidate> first = sparing.run(given.nodes.roots, goes_on);
  if (!first || !goes_on(1, first->count.all())) return std::nullopt;
  Candidate best = *std::move(first);
  if (sparing.met().in_common_pairs) {
    Candidate other = *Rewriting({false, false}).run(given.nodes.roots, kAlways);
    if (other.weight <= best.weight) best = std::move(other);
  }
  if (sparing.met().twos) {
    Candidate other = *Rewriting({true, true}).run(given.nodes.roots, kAlways);
    if (other.weight < best.weight) best = std::move(other);
  }
  if (best.weight > given.weight) return given.nodes.roots;
  try {
    return round_constants(best.nodes.roots);
  } catch (const InternalError&) {  // of a constant that rewriting brought forth: log(x - x - 1), say
    return given.nodes.roots;
  }
}

}  // namespace

std::vector<Expr> optimize(std::span<const Expr> roots) {
  return *optimize(roots, kAlways);
}

std::optional<std::vector<Expr>> optimize(std::span<const Expr> roots, const GoesOn& goes_on) {
  if (roots.empty()) return std::vector<Expr>();
  ExprGraph alone;
  const std::optional<std::vector<Expr>> found = optimize_alone(transferred(roots, alone), goes_on);
  if (!found) return std::nullopt;
  return transferred(*found, roots.front().graph());
}

}  // namespace alembert
