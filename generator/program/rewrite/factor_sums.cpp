// Rewrite of stage `optimise`: common factors of sums. In: a value program. Out: the same values with fewer
// operations. See the header.
//
// A chain is a maximal tree of sums whose inner nodes have no other use; its leaves are terms, and a term
// that is a product without other use is a list of factors (divisors among them, marked). All terms with a
// factor in common form a group, worth the multiplies that collecting it saves. The best group is taken
// first, until none gains anything; what is left inside the brackets is a chain of its own in the next round.
#include "program/rewrite/factor_sums.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <queue>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "program/rewrite/node_rewrite.hpp"
#include "support/operation.hpp"

namespace alembert {
namespace {

/// A node that multiplies, or divides if `bits` is odd.
struct Factor {
  std::uint32_t bits;
  Factor(std::uint32_t node, bool divides) : bits(node << 1 | (divides ? 1u : 0u)) {}
  std::uint32_t node() const { return bits >> 1; }
  bool divides() const { return (bits & 1u) != 0; }
  friend bool operator==(Factor, Factor) = default;
};

struct Term {
  Value leaf;                ///< in the program that is read
  bool negative;             ///< sign of the product of the factors
  std::uint32_t begin, end;  ///< its factors
  bool constant = false;     ///< nothing but a number
  bool taken = false;        ///< by a group
};

struct Group {
  Factor factor;
  std::vector<std::uint32_t> terms;
};

std::size_t product_cost(std::size_t multiply, std::size_t divide) {
  const std::size_t muls = (multiply > 1 ? multiply - 1 : 0) + (divide > 1 ? divide - 1 : 0);
  return muls + (divide > 0 ? facts(Operation::div).weight : 0);
}

class SumFactoring : NodeRewrite {
 public:
  SumFactoring(const LiveProgram& from, CommonPairs common_pairs, bool& any_spared)
      : NodeRewrite(from),
        graph_(from.values.graph),
        spares_pairs_(common_pairs == CommonPairs::spared),
        any_spared_(any_spared),
        inner_(graph_.size(), 0),
        angle_(graph_.size(), 1) {
    for (const std::uint32_t id : order_) {
      const ValueNode& n = graph_.node(id);
      const int operands = operand_count(n.op);
      for (int k = 0; k < operands; ++k) {
        const std::uint32_t operand = (k == 0 ? n.a : n.b).node();
        if (is_inner(operand, n.op)) inner_[operand] = 1;
        if (!is_trigonometric(n.op)) angle_[operand] = 0;
      }
    }
    for (const auto& output : from_.outputs)
      for (const Value v : output.values) angle_[v.node()] = 0;
  }

  std::optional<ValueProgram> run() {
    if (spares_pairs_) count_pairs();
    rewrite_nodes([this](std::uint32_t id) { return rewrite(id); });
    if (!rewritten_) return std::nullopt;
    return finished();
  }

 private:
  static bool is_product(Operation op) { return op == Operation::mul || op == Operation::div; }
  // Whether a node belongs to the sum or the product that is its only user.
  bool is_inner(std::uint32_t id, Operation user) const {
    if (uses_[id] != 1) return false;
    const Operation op = graph_.node(id).op;
    return (op == Operation::add && user == Operation::add) || (is_product(op) && is_product(user));
  }

  Value rewrite(std::uint32_t id) {
    const ValueNode& n = graph_.node(id);
    if (n.op == Operation::constant) return to_.graph.constant(graph_.constant_value(Value(id, false)));
    if (n.op == Operation::input) return to_.graph.input(n.a.bits);
    if (inner_[id] == 0) {
      if (n.op == Operation::add && read_chain(id)) {
        rewritten_ = true;
        return write_chain();
      }
      if (is_product(n.op) && read_product(id)) {
        rewritten_ = true;
        return write_product(terms_[0], nullptr);
      }
    }
    const Value a = image(n.a);
    const Value b = operand_count(n.op) == 2 ? image(n.b) : Value();
    return to_.graph.make(n.op, a, b);
  }

  static std::uint64_t pair_of(Factor x, Factor y) {
    return std::uint64_t{std::min(x.bits, y.bits)} << 32 | std::max(x.bits, y.bits);
  }

  // In how many products each pair of factors is.
  void count_pairs() {
    for (const std::uint32_t id : order_) {
      if (inner_[id] != 0 || !is_product(graph_.node(id).op)) continue;
      factors_.clear();
      read_term(Value(id, false), true);
      if (factors_.size() < 3) continue;
      std::vector<std::uint64_t> here;
      for (std::size_t i = 0; i < factors_.size(); ++i)
        for (std::size_t k = i + 1; k < factors_.size(); ++k)
          here.push_back(pair_of(factors_[i], factors_[k]));
      std::sort(here.begin(), here.end());
      here.erase(std::unique(here.begin(), here.end()), here.end());
      pairs_.insert(pairs_.end(), here.begin(), here.end());
    }
    std::sort(pairs_.begin(), pairs_.end());
  }

  // Whether the factor of a group comes cheaper as a part of products with another factor of each term: in k
  // terms it takes k products if each of them serves in more than k places.
  bool better_in_pairs(std::span<const std::pair<std::uint32_t, std::uint32_t>> members) const {
    return std::all_of(members.begin(), members.end(), [&](const auto& member) {
      const Term& term = terms_[member.second];
      for (std::uint32_t f = term.begin; f < term.end; ++f) {
        if (factors_[f].bits == member.first) continue;
        Factor common = factors_[f];
        common.bits = member.first;
        const auto [begin, end] =
            std::equal_range(pairs_.begin(), pairs_.end(), pair_of(common, factors_[f]));
        if (static_cast<std::size_t>(end - begin) > members.size()) return true;
      }
      return false;
    });
  }

  // Reads the product below v; only inner nodes and the top are opened.
  Term read_term(Value v, bool open) {
    Term term{v, v.negative(), static_cast<std::uint32_t>(factors_.size()), 0};
    stack_.assign(1, {v.node(), false});
    while (!stack_.empty()) {
      const auto [id, divides] = stack_.back();
      stack_.pop_back();
      const ValueNode& n = graph_.node(id);
      const bool top = id == v.node();
      if (is_product(n.op) && (top ? open : inner_[id] != 0)) {
        stack_.push_back({n.b.node(), divides != (n.op == Operation::div)});
        stack_.push_back({n.a.node(), divides});
      } else {
        factors_.push_back(Factor(id, divides));
      }
    }
    term.end = static_cast<std::uint32_t>(factors_.size());
    term.constant = graph_.is_constant(v);
    return term;
  }

  /// Reads a product; true if it holds two constants, or a factor and its reciprocal.
  bool read_product(std::uint32_t id) {
    terms_.clear();
    factors_.clear();
    terms_.push_back(read_term(Value(id, false), true));
    if (factors_.size() < 3) return false;
    std::vector<Factor> sorted = factors_;
    std::sort(sorted.begin(), sorted.end(), [](Factor x, Factor y) { return x.bits < y.bits; });
    std::size_t constants = 0;
    bool cancels = false;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      if (graph_.is_constant(Value(sorted[i].node(), false))) ++constants;
      if (i > 0 && sorted[i].node() == sorted[i - 1].node() && sorted[i].divides() != sorted[i - 1].divides())
        cancels = true;
    }
    if (cancels) cancel(sorted);
    return cancels || constants > 1;
  }

  // Drops each pair of a factor and its reciprocal from the one product that was read.
  void cancel(const std::vector<Factor>& sorted) {
    std::vector<Factor> kept;
    for (std::size_t i = 0; i < sorted.size();) {
      std::size_t end = i, divisors = 0;
      for (; end < sorted.size() && sorted[end].node() == sorted[i].node(); ++end)
        divisors += sorted[end].divides();
      const std::size_t multipliers = end - i - divisors;
      const bool divides = divisors > multipliers;
      const std::size_t left = divides ? divisors - multipliers : multipliers - divisors;
      kept.insert(kept.end(), left, Factor(sorted[i].node(), divides));
      i = end;
    }
    factors_ = std::move(kept);
    terms_[0].end = static_cast<std::uint32_t>(factors_.size());
  }

  /// Reads the chain with that root and chooses its groups; true if rewriting it saves operations.
  bool read_chain(std::uint32_t root) {
    terms_.clear();
    factors_.clear();
    groups_.clear();
    chain_.assign(1, Value(root, false));
    std::size_t constants = 0;
    while (!chain_.empty()) {
      const Value v = chain_.back();
      chain_.pop_back();
      const ValueNode& n = graph_.node(v.node());
      if (n.op == Operation::add && (v.node() == root || inner_[v.node()] != 0)) {
        chain_.push_back(n.b.negated_if(v.negative()));
        chain_.push_back(n.a.negated_if(v.negative()));
        continue;
      }
      terms_.push_back(read_term(v, uses_[v.node()] == 1));
      constants += terms_.back().constant;
    }
    const bool offset_moves =
        constants == 1 && angle_[root] != 0 && terms_.size() > 2 && !graph_.is_constant(graph_.node(root).a);
    choose_groups();
    return !groups_.empty() || constants > 1 || offset_moves;
  }

  void choose_groups() {
    occurrences_.clear();
    for (std::uint32_t t = 0; t < terms_.size(); ++t)
      if (!terms_[t].constant)
        for (std::uint32_t f = terms_[t].begin; f < terms_[t].end; ++f)
          occurrences_.push_back({factors_[f].bits, t});
    std::sort(occurrences_.begin(), occurrences_.end());
    occurrences_.erase(std::unique(occurrences_.begin(), occurrences_.end()), occurrences_.end());

    struct Candidate {
      std::ptrdiff_t gain;
      std::uint32_t first_term;
      std::size_t begin, end;                     ///< in occurrences_
      bool operator<(const Candidate& y) const {  // the worse one
        return std::tie(gain, y.first_term, y.begin) < std::tie(y.gain, first_term, begin);
      }
    };
    std::priority_queue<Candidate> queue;
    for (std::size_t begin = 0, end = 0; begin < occurrences_.size(); begin = end) {
      while (end < occurrences_.size() && occurrences_[end].first == occurrences_[begin].first) ++end;
      if (end - begin < 2) continue;
      if (spares_pairs_ && better_in_pairs(std::span(occurrences_).subspan(begin, end - begin))) {
        any_spared_ = true;
        continue;
      }
      const std::ptrdiff_t gained = gain(std::span(occurrences_).subspan(begin, end - begin));
      if (gained > 0) queue.push({gained, occurrences_[begin].second, begin, end});
    }
    while (!queue.empty()) {
      Candidate best = queue.top();
      queue.pop();
      const auto members = std::span(occurrences_).subspan(best.begin, best.end - best.begin);
      const std::ptrdiff_t now = gain(members);  // less if other groups took terms
      if (now <= 0) continue;
      if (now < best.gain) {
        best.gain = now;
        queue.push(best);
        continue;
      }
      const std::uint32_t bits = members.front().first;
      Group group{Factor(bits >> 1, (bits & 1u) != 0), {}};
      for (const auto& [key, t] : members) {
        if (terms_[t].taken) continue;
        terms_[t].taken = true;
        group.terms.push_back(t);
      }
      groups_.push_back(std::move(group));
    }
  }

  // What collecting the free terms among `members`, all with one factor, saves.
  std::ptrdiff_t gain(std::span<const std::pair<std::uint32_t, std::uint32_t>> members) const {
    const bool divides = (members.front().first & 1u) != 0;
    std::size_t before = 0, inside = 0, terms = 0, brackets = 0;
    double number = 0;
    bool has_number = false;
    for (const auto& [key, t] : members) {
      const Term& term = terms_[t];
      if (term.taken) continue;
      std::size_t multiply = 0, divide = 0;
      bool other_factor = false;
      double constant = term.negative ? -1 : 1;
      bool removed = false;
      for (std::uint32_t f = term.begin; f < term.end; ++f) {
        ++(factors_[f].divides() ? divide : multiply);
        if (factors_[f].bits == key && !removed) {
          removed = true;
        } else if (graph_.is_constant(Value(factors_[f].node(), false)) && !factors_[f].divides()) {
          constant *= graph_.constant_value(Value(factors_[f].node(), false));
        } else {
          other_factor = true;
        }
      }
      ++terms;
      before += product_cost(multiply, divide);
      if (other_factor) {
        inside += product_cost(multiply - (divides ? 0 : 1), divide - (divides ? 1 : 0));
        ++brackets;
      } else {
        number += constant;
        has_number = true;
      }
    }
    if (terms < 2) return 0;
    before += terms - 1;
    if (has_number && number != 0) ++brackets;
    if (brackets == 0) return static_cast<std::ptrdiff_t>(before + 1);
    const bool unit = brackets == 1 && has_number && std::abs(number) == 1;
    const std::size_t outside = divides ? facts(Operation::div).weight : (unit ? 0 : 1);
    return static_cast<std::ptrdiff_t>(before) - static_cast<std::ptrdiff_t>(inside + brackets - 1 + outside);
  }

  // The product of a term's factors, without one factor `except` if there is such.
  Value write_product(const Term& term, const Factor* except) {
    ValueGraph& to = to_.graph;
    const Value one = to.constant(1);
    Value number = one, multipliers = one, divisors = one;
    bool removed = except == nullptr;
    for (std::uint32_t f = term.begin; f < term.end; ++f) {
      const Factor factor = factors_[f];
      if (!removed && factor == *except) {
        removed = true;
        continue;
      }
      const Value value = image_[factor.node()];
      Value& product = factor.divides() ? divisors : to.is_constant(value) ? number : multipliers;
      product = to.make(Operation::mul, product, value);
    }
    Value result = to.make(Operation::mul, number, multipliers);
    if (divisors != one) result = to.make(Operation::div, result, divisors);
    return result.negated_if(term.negative);
  }

  Value write_group(const Group& group) {
    ValueGraph& to = to_.graph;
    Value sum = to.constant(0), number = to.constant(0);
    for (const std::uint32_t t : group.terms) {
      const Value rest = write_product(terms_[t], &group.factor);
      Value& part = to.is_constant(rest) ? number : sum;
      part = to.make(Operation::add, part, rest);
    }
    sum = to.make(Operation::add, sum, number);
    const Value factor = image_[group.factor.node()];
    return group.factor.divides() ? to.make(Operation::div, sum, factor)
                                  : to.make(Operation::mul, factor, sum);
  }

  // Terms in their order, each group where its first term stood, numbers last.
  Value write_chain() {
    ValueGraph& to = to_.graph;
    std::sort(groups_.begin(), groups_.end(),
              [](const Group& x, const Group& y) { return x.terms[0] < y.terms[0]; });
    Value sum = to.constant(0), number = to.constant(0);
    std::size_t next = 0;
    for (std::uint32_t t = 0; t < terms_.size(); ++t) {
      Value part;
      if (next < groups_.size() && groups_[next].terms[0] == t)
        part = write_group(groups_[next++]);
      else if (terms_[t].taken)
        continue;
      else
        part = image(terms_[t].leaf);
      Value& to_sum = to.is_constant(part) ? number : sum;
      to_sum = to.make(Operation::add, to_sum, part);
    }
    return to.make(Operation::add, sum, number);
  }

  const ValueGraph& graph_;
  bool spares_pairs_;
  bool& any_spared_;
  std::vector<std::uint64_t> pairs_;  ///< one for each product that a pair is in, in order
  std::vector<std::uint8_t> inner_;   ///< part of the sum or product that uses it
  std::vector<std::uint8_t> angle_;   ///< used by sin, cos and tan only
  bool rewritten_ = false;

  // Of the chain at hand.
  std::vector<Term> terms_;
  std::vector<Factor> factors_;
  std::vector<Group> groups_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> occurrences_;  ///< factor bits and term
  std::vector<Value> chain_;
  std::vector<std::pair<std::uint32_t, bool>> stack_;
};

}  // namespace

std::optional<ValueProgram> factor_sums(const LiveProgram& program, CommonPairs common_pairs,
                                        bool& any_spared) {
  return SumFactoring(program, common_pairs, any_spared).run();
}

}  // namespace alembert
