// Simplification of small sets of expressions. In: roots. Out: equal roots with at most as many operations.
//
// Candidates are made by rewriting every node as a polynomial (polynomial.hpp), once with sums kept whole
// inside products and once multiplied out, reduced by the identities of the circle and factored again; value
// numbering runs between them. A candidate is taken only if it needs fewer operations
// and its rounding errors are of the same size.
#include "symbolic/simplify.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "symbolic/count_operations.hpp"
#include "symbolic/exactness.hpp"
#include "symbolic/node_index.hpp"
#include "symbolic/polynomial.hpp"
#include "symbolic/postorder.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {
namespace {

constexpr std::size_t kMostRewritten = 4000;  // larger sets are value-numbered only
constexpr std::size_t kMostTerms = 256;       // of a polynomial; larger ones become one atom
constexpr std::size_t kMostWork =
    300000;  // products of terms in one call; then nothing is multiplied out any more
constexpr int kSimplifyRounds = 4;

enum class Sums {
  keep_shared,  // a sum with several users is an atom, others are joined with the sum around them
  join,         // all sums are joined with the sum around them, and kept whole in products
  multiply_out,
};

class Rewriter {
 public:
  Rewriter(ExprGraph& graph, std::span<const Expr> roots, Sums sums, std::size_t budget)
      : graph_(graph), algebra_(graph, budget), order_(indexed_postorder(roots)), sums_(sums) {}

  std::vector<Expr> run(std::span<const Expr> roots) {
    const std::size_t count = order_.ids.size();
    forms_.resize(count);
    collected_.resize(count);
    is_collected_.assign(count, false);
    users_.assign(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
      const int arity = graph_.node(order_.ids[i]).arity();
      if (arity >= 1) ++users_[order_.operands[i].a >> 1];
      if (arity == 2) ++users_[order_.operands[i].b >> 1];
    }
    for (const Expr& root : roots) ++users_[order_.at(root.ref().node())];
    for (std::size_t i = 0; i < count; ++i) forms_[i] = form(i);
    std::vector<Expr> out;
    for (const Expr& root : roots) out.emplace_back(graph_, collected(order_.local(root.ref())));
    return out;
  }
  std::size_t work() const { return algebra_.work(); }

 private:
  Polynomial operand(std::uint32_t local) {
    const Polynomial& x = forms_[local >> 1];
    return (local & 1) != 0 ? algebra_.negated(x) : x;
  }

  Ref collected(std::uint32_t local) {
    const std::size_t i = local >> 1;
    if (!is_collected_[i]) {
      collected_[i] = algebra_.expression(forms_[i]);
      is_collected_[i] = true;
    }
    return (local & 1) != 0 ? -collected_[i] : collected_[i];
  }

  // The operand as one term, its sum kept whole.
  Polynomial whole(std::uint32_t local) { return algebra_.polynomial(collected(local)); }

  bool may_multiply(const Polynomial& x, const Polynomial& y) const {
    if (sums_ != Sums::multiply_out || x.size() * y.size() > kMostTerms) return false;
    return is_number(x) || is_number(y) || (!is_offset(x) && !is_offset(y));
  }

  static bool is_number(const Polynomial& x) { return x.size() == 1 && x[0].powers.empty(); }

  // Whether x says how far a symbol is from a number. Where that is little, (q - 6)^2 has all its digits and
  // q^2 - 12 q + 36 has lost them. (3 q - 18 is as if q were rounded.)
  bool is_offset(const Polynomial& x) const {
    const auto number = [](const PolynomialTerm& term) { return term.powers.empty(); };
    const auto symbol = [&](const PolynomialTerm& term) {
      return term.powers.size() == 1 && term.powers[0].halves == 2 &&
             graph_.node(term.powers[0].base.node()).op == Operation::symbol;
    };
    return std::any_of(x.begin(), x.end(), number) && std::any_of(x.begin(), x.end(), symbol);
  }

  Polynomial form(std::size_t i) {
    const Node node = graph_.node(order_.ids[i]);
    const LocalOperands operands = order_.operands[i];
    if (is_leaf(node.op)) return algebra_.polynomial(Ref(order_.ids[i], false));
    if (node.op == Operation::add) return sum(operands);
    if (node.op == Operation::mul) {
      const Polynomial x = operand(operands.a), y = operand(operands.b);
      if (x.size() <= 1 && y.size() <= 1) return algebra_.multiply(x, y);
      if (may_multiply(x, y)) return algebra_.reduce(algebra_.multiply(x, y));
      return algebra_.multiply(whole(operands.a), whole(operands.b));
    }
    if (node.op == Operation::div) return quotient(operands);
    if (node.op == Operation::sqrt) return root(operands.a);
    const Ref a = collected(operands.a);
    const Ref b = node.arity() == 2 ? collected(operands.b) : Ref();
    return algebra_.polynomial(graph_.make(node.op, a, b));
  }

  Polynomial sum(LocalOperands operands) {
    std::array<Polynomial, 2> parts;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::uint32_t local = k == 0 ? operands.a : operands.b;
      const std::uint32_t position = local >> 1;
      const bool shared = sums_ == Sums::keep_shared && users_[position] > 1;
      const bool large = forms_[position].size() > kMostTerms;
      parts[k] = forms_[position].size() > 1 && (shared || large) ? whole(local) : operand(local);
    }
    return algebra_.reduce(algebra_.add(parts[0], parts[1]));
  }

  Polynomial quotient(LocalOperands operands) {
    const Polynomial x = operand(operands.a), y = operand(operands.b);
    if (y.size() == 1) {
      if (x.size() <= 1 || sums_ == Sums::multiply_out)
        return algebra_.multiply(x, algebra_.inverse(y.front()));
    } else if (x.size() > 1) {
      if (const auto exact = divided(x, y)) return *exact;
    }
    // Sums kept whole: factors in common cancel.
    const Ref below = collected(operands.b);
    const Ref above = collected(operands.a);
    return algebra_.polynomial(graph_.make(Operation::div, above, below));
  }

  // x/y as a polynomial, looked for with squares of sines or of cosines replaced.
  std::optional<Polynomial> divided(const Polynomial& x, const Polynomial& y) {
    if (auto exact = algebra_.divide(x, y)) return exact;
    std::vector<CirclePair> pairs = algebra_.circle_pairs(algebra_.add(x, y));
    if (pairs.empty()) return std::nullopt;
    for (const unsigned second : {0u, ~0u}) {
      const Polynomial p = algebra_.eliminated(x, pairs, second), q = algebra_.eliminated(y, pairs, second);
      if (q.empty()) continue;
      if (auto exact = algebra_.divide(p, q)) return exact;
    }
    return std::nullopt;
  }

  // sqrt(m^2 q^2 r) = |m| |q| sqrt(r)
  Polynomial root(std::uint32_t local) {
    const Polynomial x = operand(local);
    if (x.empty()) return x;
    PolynomialTerm outside{kOne, {}};
    const PolynomialTerm common = algebra_.common_factor(x);
    for (const Power& power : common.powers) {
      // base^4k leaves the root as |base|^2k, base^(4k+2) likewise, leaving base behind.
      const int halves = power.halves / 4 * 4;
      if (halves != 0) outside.powers.push_back({power.base, halves});
    }
    const Polynomial inside = algebra_.multiply(x, algebra_.inverse(outside));
    Ref factor = kOne;
    for (const Power& power : outside.powers) {
      const Ref magnitude = graph_.make(Operation::abs, power.base);
      const Ref whole_power = algebra_.builder().integer_power(magnitude, power.halves / 4);
      factor = algebra_.builder().product(factor, whole_power);
    }
    Ref rest;
    if (const auto exact = exact_root(inside)) {
      rest = graph_.make(Operation::abs, algebra_.expression(*exact));
    } else {
      rest = graph_.make(Operation::sqrt, algebra_.expression(inside));
    }
    return algebra_.polynomial(algebra_.builder().product(factor, rest));
  }

  std::optional<Polynomial> exact_root(const Polynomial& x) {
    if (auto exact = algebra_.square_root(x)) return exact;
    const std::vector<CirclePair> pairs = algebra_.circle_pairs(x);
    constexpr std::size_t kMostPairs = 4;
    if (pairs.empty() || pairs.size() > kMostPairs) return std::nullopt;
    for (unsigned second = 0; second < 1u << pairs.size(); ++second) {
      if (auto exact = algebra_.square_root(algebra_.eliminated(x, pairs, second))) return exact;
    }
    return std::nullopt;
  }

  ExprGraph& graph_;
  Algebra algebra_;
  Postorder order_;
  Sums sums_;
  std::vector<Polynomial> forms_;
  std::vector<Ref> collected_;
  std::vector<bool> is_collected_;
  std::vector<std::uint32_t> users_;
};

struct Cost {
  std::size_t operations = 0, weighted = 0;
  bool below(const Cost& other) const {
    return operations <= other.operations && weighted <= other.weighted &&
           (operations < other.operations || weighted < other.weighted);
  }
};

Cost cost_of(std::span<const Expr> roots) {
  const OperationCount count = count_operations(roots);
  return {count.all(), count.weight};
}

// Takes the candidate as a whole or root by root, wherever it lowers the cost and keeps the digits.
bool improve(std::vector<Expr>& best, Cost& cost, const std::vector<Expr>& candidate, Exactness& exactness) {
  if (candidate == best) return false;
  const Cost all = cost_of(candidate);
  if (all.below(cost) && exactness.keeps(candidate)) {
    best = candidate;
    cost = all;
    return true;
  }
  constexpr std::size_t kMostRoots = 64;
  bool improved = false;
  if (best.size() == 1 || best.size() > kMostRoots) return improved;
  for (std::size_t i = 0; i < best.size(); ++i) {
    if (candidate[i] == best[i]) continue;
    const Expr kept = best[i];
    best[i] = candidate[i];
    const Cost one = cost_of(best);
    if (one.below(cost) && exactness.keeps({&best[i], 1}, i)) {
      cost = one;
      improved = true;
    } else {
      best[i] = kept;
    }
  }
  return improved;
}

// The rewritten roots, or nothing if that takes more than the budget, which shrinks.
std::optional<std::vector<Expr>> rewritten(ExprGraph& graph, std::span<const Expr> roots, Sums sums,
                                           std::size_t& budget) {
  Rewriter rewriter(graph, roots, sums, budget);
  std::optional<std::vector<Expr>> out;
  try {
    out = rewriter.run(roots);
  } catch (const TooLarge&) {
  }
  budget -= std::min(budget, rewriter.work());
  return out;
}

}  // namespace

std::vector<Expr> simplify(std::span<const Expr> roots) {
  std::vector<Expr> best(roots.begin(), roots.end());
  ExprGraph* graph = graph_of(roots);
  if (graph == nullptr || !graph->simplifies()) return best;
  Cost cost = cost_of(best);
  if (cost.operations == 0) return best;
  Exactness exactness(roots);
  improve(best, cost, value_number(best), exactness);
  std::size_t budget = kMostWork;
  for (int round = 0; round < kSimplifyRounds && cost.operations > 1; ++round) {
    if (postorder(best).size() > kMostRewritten) break;
    bool improved = false;
    for (const Sums sums : {Sums::keep_shared, Sums::join, Sums::multiply_out}) {
      const auto candidate = rewritten(*graph, best, sums, budget);
      if (!candidate) continue;
      improved = improve(best, cost, *candidate, exactness) || improved;
      improved = improve(best, cost, value_number(*candidate), exactness) || improved;
      if (sums != Sums::multiply_out) continue;
      // Factors that are sums only show once the terms are factored.
      const auto again = rewritten(*graph, *candidate, Sums::join, budget);
      if (!again) continue;
      improved = improve(best, cost, *again, exactness) || improved;
      improved = improve(best, cost, value_number(*again), exactness) || improved;
    }
    if (!improved) break;
  }
  return best;
}

}  // namespace alembert
