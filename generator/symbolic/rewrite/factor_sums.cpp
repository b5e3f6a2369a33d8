// Rewrite of stage `optimise`: common factors of sums. In: live nodes. Out: the same roots with fewer
// operations. See the header.
//
// A chain is a maximal tree of sums whose inner nodes have no other use; its leaves are terms, and a term
// that is a product without other use is a list of factors (divisors among them, marked). All terms with a
// factor in common form a group, worth the multiplies that collecting it saves. The best group is taken
// first, until none gains anything; what is left inside the brackets is a chain of its own in the next round.
#include "symbolic/rewrite/factor_sums.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <queue>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "support/operation.hpp"

namespace alembert {
namespace {

/// A node, by its position, that multiplies, or divides if `bits` is odd.
struct Factor {
  std::uint32_t bits;
  Factor(std::uint32_t node, bool divides) : bits(node << 1 | (divides ? 1u : 0u)) {}
  std::uint32_t node() const { return bits >> 1; }
  bool divides() const { return (bits & 1u) != 0; }
  friend bool operator==(Factor, Factor) = default;
};

struct Term {
  std::uint32_t leaf;        ///< position and sign
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
  SumFactoring(const LiveNodes& from, FactorsLeft left, FactorsLeft& met)
      : NodeRewrite(from), left_(left), met_(met), inner_(size(), 0), angle_(size(), 1) {
    for (std::uint32_t id = 0; id < size(); ++id) {
      const Operation user = op(id);
      for (int k = 0; k < arity(id); ++k) {
        const std::uint32_t operand = (k == 0 ? operands(id).a : operands(id).b) >> 1;
        if (is_inner(operand, user)) inner_[operand] = 1;
        if (!is_trigonometric(user)) angle_[operand] = 0;
      }
    }
    for (const Expr& root : from_.roots) angle_[from_.order.at(root.ref().node())] = 0;
  }

  std::optional<LiveNodes> run() {
    if (left_.in_common_pairs) count_pairs();
    rewrite_nodes([this](std::uint32_t id) { return rewrite(id); });
    if (!rewritten_) return std::nullopt;
    return finished();
  }

 private:
  static bool multiplies(Operation op) { return op == Operation::mul || op == Operation::div; }
  bool is_sum(std::uint32_t id) const { return !is_constant(id) && op(id) == Operation::add; }
  bool is_product(std::uint32_t id) const { return !is_constant(id) && multiplies(op(id)); }
  // Whether a node belongs to the sum or the product that is its only user.
  bool is_inner(std::uint32_t id, Operation user) const {
    if (uses_[id] != 1) return false;
    return (is_sum(id) && user == Operation::add) || (is_product(id) && multiplies(user));
  }

  Ref rewrite(std::uint32_t id) {
    if (inner_[id] != 0) return copied(id);
    if (is_sum(id) && read_chain(id)) {
      rewritten_ = true;
      return write_chain();
    }
    if (is_product(id) && read_product(id)) {
      rewritten_ = true;
      return write_product(terms_[0], nullptr);
    }
    return copied(id);
  }

  static std::uint64_t pair_of(Factor x, Factor y) {
    return std::uint64_t{std::min(x.bits, y.bits)} << 32 | std::max(x.bits, y.bits);
  }

  // In how many products each pair of factors is.
  void count_pairs() {
    for (std::uint32_t id = 0; id < size(); ++id) {
      if (inner_[id] != 0 || !is_product(id)) continue;
      factors_.clear();
      read_term(id << 1, true);
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

  // Reads the product below an operand; only inner nodes and the top are opened.
  Term read_term(std::uint32_t leaf, bool open) {
    const std::uint32_t top = leaf >> 1;
    Term term{leaf, (leaf & 1) != 0, static_cast<std::uint32_t>(factors_.size()), 0, is_constant(top)};
    if (open && is_product(top)) {
      stack_.assign(1, {top, false});
    } else {
      factors_.push_back(Factor(top, false));
    }
    while (!stack_.empty()) {
      const auto [id, divides] = stack_.back();
      stack_.pop_back();
      if (id == top || (inner_[id] != 0 && is_product(id))) {
        const bool quotient = op(id) == Operation::div;
        const LocalOperands n = quotient ? operands(id) : in_order(id);
        stack_.push_back({n.b >> 1, divides != quotient});
        stack_.push_back({n.a >> 1, divides});
      } else {
        factors_.push_back(Factor(id, divides));
      }
    }
    term.end = static_cast<std::uint32_t>(factors_.size());
    return term;
  }

  /// Reads a product; true if it holds two constants, or a factor and its reciprocal.
  bool read_product(std::uint32_t id) {
    terms_.clear();
    factors_.clear();
    terms_.push_back(read_term(id << 1, true));
    if (factors_.size() < 3) return false;
    std::vector<Factor> sorted = factors_;
    std::sort(sorted.begin(), sorted.end(), [](Factor x, Factor y) { return x.bits < y.bits; });
    std::size_t constants = 0;
    bool cancels = false;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      if (is_constant(sorted[i].node())) ++constants;
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
    chain_.assign(1, root << 1);
    std::size_t constants = 0;
    while (!chain_.empty()) {
      const std::uint32_t local = chain_.back(), id = local >> 1, sign = local & 1;
      chain_.pop_back();
      if (is_sum(id) && (id == root || inner_[id] != 0)) {
        chain_.push_back(in_order(id).b ^ sign);
        chain_.push_back(in_order(id).a ^ sign);
        continue;
      }
      terms_.push_back(read_term(local, uses_[id] == 1));
      constants += terms_.back().constant;
    }
    const bool offset_moves =
        constants == 1 && angle_[root] != 0 && terms_.size() > 2 && !is_constant(operands(root).a >> 1);
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
      bool is_two, constant;                      ///< 2x is a sum, and stands last
      bool operator<(const Candidate& y) const {  // the worse one
        return std::tie(y.is_two, gain, y.first_term, y.constant, y.begin) <
               std::tie(is_two, y.gain, first_term, constant, begin);
      }
    };
    std::priority_queue<Candidate> queue;
    for (std::size_t begin = 0, end = 0; begin < occurrences_.size(); begin = end) {
      while (end < occurrences_.size() && occurrences_[end].first == occurrences_[begin].first) ++end;
      if (end - begin < 2) continue;
      if (left_.in_common_pairs && better_in_pairs(std::span(occurrences_).subspan(begin, end - begin))) {
        met_.in_common_pairs = true;
        continue;
      }
      const std::ptrdiff_t gained = gain(std::span(occurrences_).subspan(begin, end - begin));
      const std::uint32_t factor = occurrences_[begin].first >> 1;
      if (gained <= 0) continue;
      const bool is_two = number_of(factor) == 2;
      met_.twos = met_.twos || is_two;
      if (!is_two || !left_.twos)
        queue.push({gained, occurrences_[begin].second, begin, end, is_two, is_constant(factor)});
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
        } else if (is_constant(factors_[f].node()) && !factors_[f].divides()) {
          constant *= number_of(factors_[f].node());
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
  Ref write_product(const Term& term, const Factor* except) {
    Ref numbers = one_, multipliers = one_, divisors = one_;
    bool removed = except == nullptr;
    for (std::uint32_t f = term.begin; f < term.end; ++f) {
      const Factor factor = factors_[f];
      if (!removed && factor == *except) {
        removed = true;
        continue;
      }
      const Ref value = image_[factor.node()];
      Ref& product = factor.divides() ? divisors : made_constant(value) ? numbers : multipliers;
      product = make(Operation::mul, product, value);
    }
    Ref result = make(Operation::mul, numbers, multipliers);
    if (divisors != one_) result = make(Operation::div, result, divisors);
    return term.negative ? -result : result;
  }

  Ref write_group(const Group& group) {
    Ref sum, numbers;
    for (const std::uint32_t t : group.terms) {
      const Ref rest = write_product(terms_[t], &group.factor);
      Ref& part = made_constant(rest) ? numbers : sum;
      part = make(Operation::add, part, rest);
    }
    sum = make(Operation::add, sum, numbers);
    const Ref factor = image_[group.factor.node()];
    return group.factor.divides() ? make(Operation::div, sum, factor) : make(Operation::mul, factor, sum);
  }

  // Terms in their order, each group where its first term stood, numbers last.
  Ref write_chain() {
    std::sort(groups_.begin(), groups_.end(),
              [](const Group& x, const Group& y) { return x.terms[0] < y.terms[0]; });
    Ref sum, numbers;
    std::size_t next = 0;
    for (std::uint32_t t = 0; t < terms_.size(); ++t) {
      Ref part;
      if (next < groups_.size() && groups_[next].terms[0] == t)
        part = write_group(groups_[next++]);
      else if (terms_[t].taken)
        continue;
      else
        part = image(terms_[t].leaf);
      Ref& to_sum = made_constant(part) ? numbers : sum;
      to_sum = make(Operation::add, to_sum, part);
    }
    return make(Operation::add, sum, numbers);
  }

  bool made_constant(Ref x) const { return graph_.node(x.node()).constant; }

  const Ref one_ = graph_.one().ref();
  FactorsLeft left_;
  FactorsLeft& met_;
  std::vector<std::uint64_t> pairs_;  ///< one for each product that a pair is in, in order
  std::vector<std::uint8_t> inner_;   ///< part of the sum or product that uses it
  std::vector<std::uint8_t> angle_;   ///< used by sin, cos and tan only
  bool rewritten_ = false;

  // Of the chain at hand.
  std::vector<Term> terms_;
  std::vector<Factor> factors_;
  std::vector<Group> groups_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> occurrences_;  ///< factor bits and term
  std::vector<std::uint32_t> chain_;                                  ///< positions and signs
  std::vector<std::pair<std::uint32_t, bool>> stack_;
};

}  // namespace

std::optional<LiveNodes> factor_sums(const LiveNodes& nodes, FactorsLeft left, FactorsLeft& met) {
  return SumFactoring(nodes, left, met).run();
}

}  // namespace alembert
