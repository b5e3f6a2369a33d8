// Probabilistic value numbering. In: roots. Out: equal roots in which nodes of equal value, up to sign, are
// one node, and nodes that are zero or a small rational are that number. This is what turns a long sum of
// products of sines and cosines into a cosine that is there already. Constants that agree to rounding count
// as equal (close_constants.hpp).
//
// Values are taken in a finite field at two random points and confirmed at two more; a false match of
// expressions without roots has a chance below 2^-100. The sign of a root is arbitrary in the field, so that
// sqrt(x^2 + 2xy + y^2) agrees with x + y at every second point: matches that involve roots are confirmed at
// many more points and in double precision, where roots are positive.
#include "symbolic/value_number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "support/no_index.hpp"
#include "symbolic/close_constants.hpp"
#include "symbolic/count_operations.hpp"
#include "symbolic/error_bound.hpp"
#include "symbolic/evaluate_modular.hpp"
#include "symbolic/exactness.hpp"
#include "symbolic/modular.hpp"
#include "symbolic/postorder.hpp"

namespace alembert {
namespace {

constexpr std::size_t kPoints = 4;
constexpr std::size_t kFirstPoints = 2;  // by which values are found; the others are for what is found
constexpr std::size_t kRootPoints =
    40;  // further points where roots are involved: each halves the chance of error
constexpr std::size_t kDoublePoints = 8;
constexpr double kRoundingFactor = 1e3;  // of the bounds on rounding errors; a wrong sign is far more,
                                         // however small the constants are

using Values = std::array<std::vector<Modular>, kPoints>;

// n/d with |n| and d below 2^12 that has this value, if there is one.
std::optional<Rational> small_rational(Modular value) {
  constexpr std::int64_t kBound = 1 << 12;
  if (value.im != 0) return std::nullopt;
  // Euclid on (p, value), stopped at the first small remainder: n = value * d modulo p.
  std::uint64_t last = modular::kPrime, rest = value.re;
  std::int64_t last_d = 0, d = 1;
  while (rest >= static_cast<std::uint64_t>(kBound)) {
    const std::uint64_t q = last / rest;
    const std::uint64_t next = last - q * rest;
    if (q > static_cast<std::uint64_t>(2 * kBound)) return std::nullopt;
    const std::int64_t next_d = last_d - static_cast<std::int64_t>(q) * d;
    last = rest;
    rest = next;
    last_d = d;
    d = next_d;
    if (d >= kBound || d <= -kBound) return std::nullopt;
  }
  return make_rational(static_cast<std::int64_t>(rest), d);
}

// A random point at which every symbol keeps its assumed interval.
std::vector<double> double_point(ExprGraph& graph, std::uint64_t seed) {
  const std::vector<Modular> random = random_modular_point(graph.symbol_count(), seed);
  std::vector<double> out(random.size());
  for (std::uint32_t i = 0; i < out.size(); ++i) {
    const double unit = static_cast<double>(random[i].re) / static_cast<double>(modular::kPrime);
    Interval range = graph.bounds(graph.symbol_at(i).ref());
    constexpr double kReach = 2;
    if (!std::isfinite(range.lower))
      range.lower = std::isfinite(range.upper) ? range.upper - kReach : -kReach;
    if (!std::isfinite(range.upper)) range.upper = std::max(range.lower + kReach, kReach);
    out[i] = range.lower + unit * (range.upper - range.lower);
  }
  return out;
}

// A node of the order found equal to another one (or to a number), to be confirmed because roots are
// involved.
struct Match {
  std::uint32_t node, other;  // positions; other == kNoIndex: the number of the class
  std::uint32_t value_class;
  bool negative;
};

class Numbering {
 public:
  explicit Numbering(std::span<const Expr> roots)
      : graph_(*graph_of(roots)), order_(indexed_postorder(roots)) {}

  std::vector<Expr> run(std::span<const Expr> roots) {
    classify();
    confirm();
    choose();
    std::vector<Expr> out;
    out.reserve(roots.size());
    for (const Expr& root : roots) out.emplace_back(graph_, build(order_.local(root.ref())));
    return out;
  }

 private:
  struct Class {
    std::uint32_t first = kNoIndex;           // member found first
    std::uint32_t representative = kNoIndex;  // cheapest member
    Ref number;
    bool is_number = false, built = false;
    Ref image;  // of the representative
  };
  struct Member {
    std::uint32_t value_class = kNoIndex;
    bool negative = false;  // relative to the first member, or to the number
  };

  NodeKind kind(std::uint32_t position) const { return order_.kinds[position]; }
  Ref ref(std::uint32_t position) const { return {order_.ids[position], false}; }
  bool upper(std::uint32_t i) {
    for (std::size_t k = 0; k < kFirstPoints; ++k) {
      if (!modular::is_zero(values_[k][i])) return modular::is_upper(values_[k][i]);
    }
    for (const auto& at : all_values()) {
      if (!modular::is_zero(at[i])) return modular::is_upper(at[i]);
    }
    return false;
  }
  bool equal(std::uint32_t i, std::uint32_t k, bool negative) {
    const auto same = [&](const std::vector<Modular>& at) {
      return (negative ? modular::negate(at[k]) : at[k]) == at[i];
    };
    return std::all_of(values_.begin(), values_.begin() + kFirstPoints, same) &&
           std::all_of(all_values().begin() + kFirstPoints, values_.end(), same);
  }

  void evaluate_points(std::size_t begin, std::size_t end) {
    std::vector<std::vector<Modular>> points;
    for (std::size_t k = begin; k < end; ++k)
      points.push_back(random_modular_point(graph_.symbol_count(), 0x5eed + k));
    std::ranges::move(modular::values(graph_, order_, points), values_.begin() + begin);
  }
  // At the points that only confirm: often nothing is to be confirmed.
  Values& all_values() {
    if (values_.back().empty()) evaluate_points(kFirstPoints, kPoints);
    return values_;
  }

  std::uint32_t own_class(std::uint32_t i) {
    classes_.push_back({});
    classes_.back().first = i;
    members_[i] = {static_cast<std::uint32_t>(classes_.size() - 1), false};
    return members_[i].value_class;
  }

  std::uint32_t number_class(Rational magnitude) {
    const Ref number = graph_.rational(magnitude).ref();
    const std::uint32_t known = numbers_.find(number.node());
    if (known != kNoIndex) return known;
    classes_.push_back({});
    Class& made = classes_.back();
    made.number = made.image = number;
    made.is_number = made.built = true;
    numbers_.add(number.node(), static_cast<std::uint32_t>(classes_.size() - 1));
    return static_cast<std::uint32_t>(classes_.size() - 1);
  }

  void classify() {
    const std::uint32_t count = static_cast<std::uint32_t>(order_.ids.size());
    evaluate_points(0, kFirstPoints);
    members_.assign(count, {});
    rooted_.assign(count, false);
    std::size_t slots = 64;
    while (slots < 2 * static_cast<std::size_t>(count)) slots *= 2;
    std::vector<std::uint32_t> table(slots, kNoIndex);
    for (std::uint32_t i = 0; i < count; ++i) {
      const NodeKind n = kind(i);
      const LocalOperands operands = order_.operands[i];
      rooted_[i] = n.op == Operation::sqrt || (n.arity() >= 1 && rooted_[operands.a >> 1]) ||
                   (n.arity() == 2 && rooted_[operands.b >> 1]);
      if (n.op == Operation::rational) {
        members_[i] = {number_class(graph_.rational_value(order_.ids[i])), false};
        continue;
      }
      // What does not change from point to point is a constant, perhaps a small one.
      if (values_[0][i] == values_[1][i] && equal_everywhere(i)) {
        if (const auto small = small_rational(values_[0][i])) {
          const bool negative = small->negative();
          const Rational magnitude(negative ? -small->numerator : small->numerator, small->denominator);
          const std::uint32_t found = number_class(magnitude);
          members_[i] = {found, negative};
          // Constants have the same value at every point: the points confirm nothing.
          if (rooted_[i] || n.constant) matches_.push_back({i, kNoIndex, found, negative});
          continue;
        }
      }
      const bool flipped = upper(i);
      std::uint64_t hash = 0;
      for (std::size_t k = 0; k < kFirstPoints; ++k) {
        const Modular value = flipped ? modular::negate(values_[k][i]) : values_[k][i];
        hash = (hash ^ value.re) * 0x9e3779b97f4a7c15u;
        hash = (hash ^ (hash >> 32) ^ value.im) * 0xbf58476d1ce4e5b9u;
      }
      std::size_t slot = static_cast<std::size_t>(hash >> 20) & (slots - 1);
      bool found = false;
      for (; table[slot] != kNoIndex && !found; slot = (slot + 1) & (slots - 1)) {
        const std::uint32_t other = table[slot];
        const bool negative = flipped != upper(other);
        if (!equal(i, other, negative)) continue;
        found = true;
        const Member first = members_[other];
        members_[i] = {first.value_class, negative};
        if (rooted_[i] || rooted_[other] || n.constant)
          matches_.push_back({i, other, first.value_class, negative});
        break;
      }
      if (found) continue;
      own_class(i);
      table[slot] = i;
    }
  }

  // A constant has one value at all points.
  bool equal_everywhere(std::uint32_t i) {
    if (kind(i).constant) return true;
    return std::all_of(all_values().begin(), values_.end(),
                       [&](const auto& at) { return at[i] == values_[0][i]; });
  }

  // Takes back matches that fail where roots have a definite sign, or that could not be compared there.
  void confirm() {
    if (matches_.empty()) return;
    // What is compared is often a few constants of a large graph: only they are evaluated.
    std::vector<Expr> pairs;
    for (const Match& match : matches_) {
      pairs.emplace_back(graph_, ref(match.node));
      const Ref other = match.other != kNoIndex ? ref(match.other) : classes_[match.value_class].number;
      pairs.emplace_back(graph_, match.negative ? -other : other);
    }
    const auto reject = [this](const Match& match) { own_class(match.node); };
    std::vector<bool> rejected(matches_.size(), false);
    const Postorder order = indexed_postorder(pairs);
    // Constants have one value at all points.
    const bool constant =
        std::all_of(pairs.begin(), pairs.end(), [](const Expr& x) { return x.is_constant(); });
    for (std::size_t k = 0; k < (constant ? 1 : kRootPoints); ++k) {
      const std::vector<Modular> point = random_modular_point(graph_.symbol_count(), 0xc0ffee + k);
      const std::vector<Modular> values = std::move(modular::values(graph_, order, {&point, 1}).front());
      const auto of = [&](const Expr& x) {
        const Modular value = values[order.at(x.ref().node())];
        return x.ref().negative() ? modular::negate(value) : value;
      };
      for (std::size_t m = 0; m < matches_.size(); ++m)
        if (of(pairs[2 * m]) != of(pairs[2 * m + 1])) rejected[m] = true;
    }
    std::vector<bool> compared(matches_.size(), false);
    std::vector<std::vector<double>> points;
    for (std::size_t k = 0; k < (constant ? 1 : kDoublePoints); ++k)
      points.push_back(double_point(graph_, 0xd0b1e + k));
    for (const std::vector<Approximate>& value : evaluate_bounded(pairs, points)) {
      for (std::size_t m = 0; m < matches_.size(); ++m) {
        const Approximate &x = value[2 * m], &y = value[2 * m + 1];
        const double rounding = kRoundingFactor * (x.error + y.error);
        if (!std::isfinite(x.value) || !std::isfinite(y.value) || !std::isfinite(rounding))
          continue;  // outside the domain of a root
        compared[m] = true;
        if (std::abs(x.value - y.value) > rounding) rejected[m] = true;
      }
    }
    for (std::size_t m = 0; m < matches_.size(); ++m) {
      if (rejected[m] || !compared[m]) reject(matches_[m]);
    }
  }

  // The representative of a class is its cheapest member as a tree, and of several the first: both fall
  // strictly from a representative to those of its operands, so that the rebuilt graph has no cycles. A sum gives
  // way to a member that is none where it cancels and that does not, as 1 - tanh^2 does to 1/cosh^2.
  void choose() {
    constexpr std::uint64_t kMost = std::uint64_t{1} << 60;
    std::vector<std::uint64_t> cost(order_.ids.size(), 0);
    std::vector<std::uint32_t> others(classes_.size(), kNoIndex);  // the cheapest members that are no sums
    for (std::uint32_t i = 0; i < order_.ids.size(); ++i) {
      const NodeKind n = kind(i);
      const LocalOperands operands = order_.operands[i];
      if (!n.constant) {
        cost[i] = facts(n.op).weight;
        if (n.arity() >= 1) cost[i] += cost[operands.a >> 1];
        if (n.arity() == 2) cost[i] += cost[operands.b >> 1];
        cost[i] = std::min(cost[i], kMost);
      }
      const std::uint32_t value_class = members_[i].value_class;
      Class& in = classes_[value_class];
      if (in.is_number) continue;
      if (in.representative == kNoIndex || cost[i] < cost[in.representative]) in.representative = i;
      std::uint32_t& other = others[value_class];
      if (!is_sum(i) && (other == kNoIndex || cost[i] < cost[other])) other = i;
    }
    prefer_exact(others);
  }

  bool is_sum(std::uint32_t i) const { return kind(i).op == Operation::add || kind(i).op == Operation::sub; }

  void prefer_exact(const std::vector<std::uint32_t>& others) {
    std::vector<std::uint32_t> asked;
    std::vector<Expr> pairs;
    for (std::uint32_t c = 0; c < classes_.size(); ++c) {
      if (classes_[c].is_number || others[c] == kNoIndex || !is_sum(classes_[c].representative)) continue;
      asked.push_back(c);
      pairs.emplace_back(graph_, ref(classes_[c].representative));
      pairs.emplace_back(graph_, ref(others[c]));
    }
    if (asked.empty()) return;
    std::vector<bool> cancels(asked.size(), false);
    for (const std::vector<Approximate>& at : evaluate_bounded(pairs, points_near_and_far(graph_)))
      for (std::size_t k = 0; k < asked.size(); ++k)
        cancels[k] = cancels[k] || !is_as_exact(at[2 * k], at[2 * k + 1]);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> before;
    for (std::size_t k = 0; k < asked.size(); ++k) {
      if (!cancels[k]) continue;
      before.emplace_back(asked[k], classes_[asked[k]].representative);
      classes_[asked[k]].representative = others[asked[k]];
    }
    if (before.empty() || !has_cycle()) return;
    for (const auto& [value_class, representative] : before)
      classes_[value_class].representative = representative;
  }

  // Whether a class is needed for itself.
  bool has_cycle() const {
    enum : std::uint8_t { untouched, open, done };
    std::vector<std::uint8_t> state(classes_.size(), untouched);
    std::vector<std::uint32_t> stack;
    for (std::uint32_t start = 0; start < classes_.size(); ++start) {
      if (state[start] != untouched) continue;
      stack.push_back(start);
      while (!stack.empty()) {
        const std::uint32_t c = stack.back();
        if (state[c] != untouched) {
          state[c] = done;
          stack.pop_back();
          continue;
        }
        state[c] = open;
        if (classes_[c].is_number) continue;
        const LocalOperands operands = order_.operands[classes_[c].representative];
        const int arity = kind(classes_[c].representative).arity();
        for (int k = 0; k < arity; ++k) {
          const std::uint32_t below = members_[(k == 0 ? operands.a : operands.b) >> 1].value_class;
          if (state[below] == open) return true;
          if (state[below] == untouched) stack.push_back(below);
        }
      }
    }
    return false;
  }

  // Image of the representative's class, seen from member `local`.
  Ref seen(std::uint32_t local) const {
    const Member member = members_[local >> 1];
    const Class& in = classes_[member.value_class];
    bool negative = ((local & 1) != 0) != member.negative;
    if (!in.is_number) negative = negative != members_[in.representative].negative;
    return negative ? -in.image : in.image;
  }

  Ref build(std::uint32_t local) {
    std::vector<std::uint32_t> open{members_[local >> 1].value_class};
    while (!open.empty()) {
      Class& in = classes_[open.back()];
      if (in.built) {
        open.pop_back();
        continue;
      }
      const Node n = graph_.node(order_.ids[in.representative]);
      const LocalOperands operands = order_.operands[in.representative];
      const int arity = n.arity();
      const std::size_t before = open.size();
      if (arity == 2 && !classes_[members_[operands.b >> 1].value_class].built) {
        open.push_back(members_[operands.b >> 1].value_class);
      }
      if (arity >= 1 && !classes_[members_[operands.a >> 1].value_class].built) {
        open.push_back(members_[operands.a >> 1].value_class);
      }
      if (open.size() != before) continue;
      open.pop_back();
      const Ref a = arity >= 1 ? seen(operands.a) : Ref(), b = arity == 2 ? seen(operands.b) : Ref();
      const bool unchanged = a == n.a && (arity < 2 || b == n.b);
      in.image = arity == 0 || unchanged ? ref(in.representative) : graph_.make(n.op, a, b);
      in.built = true;
    }
    return seen(local);
  }

  ExprGraph& graph_;
  Postorder order_;
  Values values_;
  std::vector<Member> members_;
  std::vector<bool> rooted_;  // a square root below
  std::vector<Class> classes_;
  NodeIndex numbers_;  // number node -> class
  std::vector<Match> matches_;
};

}  // namespace

std::vector<Expr> value_number(std::span<const Expr> roots) {
  std::vector<Expr> same(roots.begin(), roots.end());
  if (graph_of(roots) == nullptr) return same;
  const std::vector<Expr> merged = merge_close_constants(roots);
  std::vector<Expr> out = Numbering(merged).run(merged);
  if (out == same) return same;
  // Unweighted: by weights, reverse derivatives of 400 random functions take 2 operations more.
  return count_operations(out).all() > count_operations(roots).all() ? same : out;
}

void value_number_all(const std::vector<std::vector<Expr>*>& arrays) {
  std::vector<Expr> flat;
  for (const std::vector<Expr>* array : arrays) flat.insert(flat.end(), array->begin(), array->end());
  flat = value_number(flat);
  auto next = flat.begin();
  for (std::vector<Expr>* array : arrays)
    for (Expr& value : *array) value = *next++;
}

}  // namespace alembert
