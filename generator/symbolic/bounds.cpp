// Interval bounds of expressions. In: a handle, and what is assumed of symbols. Out: an interval that
// certainly holds the value, by outward rounded interval arithmetic over the operands; used to prove signs.
#include "symbolic/expr.hpp"

namespace alembert {

Interval ExprGraph::bounds(Ref x) const {
  const auto of_leaf = [this](std::uint32_t id) -> Interval {
    const Node& n = nodes_[id];
    if (n.op == Operation::symbol) return symbols_[n.a.bits].interval;
    if (n.op == Operation::real) return {real_value(id), real_value(id)};
    const Rational r = rational_value(id);
    constexpr std::int64_t kExact = std::int64_t{1} << 53;
    const double value = r.to_double();
    const bool exact = r.numerator <= kExact && (r.denominator & (r.denominator - 1)) == 0;
    const Interval plain =
        exact ? Interval{value, value} : Interval{interval::down(value), interval::up(value)};
    return n.op == Operation::rational
               ? plain
               : interval::product(plain, {interval::kPi, interval::up(interval::kPi)});
  };
  const auto leaf = [this](std::uint32_t id) { return nodes_[id].arity() == 0; };
  const auto known = [&](Ref r) -> Interval {
    const Interval range = leaf(r.node()) ? of_leaf(r.node()) : bounds_.find(r.node())->second;
    return r.negative() ? interval::negated(range) : range;
  };
  const auto of_node = [&](const Node& n) -> Interval {
    const Interval a = known(n.a);
    if (n.op == Operation::mul && n.a == n.b) return interval::square(a);
    if (is_choice(n.op) && n.a.node() == n.b.node()) {  // max(0, b) or min(0, b)
      const Interval b = known(n.b);
      const bool where_positive = (n.op == Operation::if_positive) != n.a.negative();
      return where_positive ? Interval{0, b.upper > 0 ? b.upper : 0} : Interval{b.lower < 0 ? b.lower : 0, 0};
    }
    return bounds_of(n.op, a, operand_count(n.op) == 2 ? known(n.b) : a);
  };

  if (!leaf(x.node()) && bounds_.find(x.node()) == bounds_.end()) {
    std::vector<std::uint32_t> open{x.node()};
    while (!open.empty()) {
      const std::uint32_t id = open.back();
      const Node& n = nodes_[id];
      const std::size_t before = open.size();
      for (const Ref operand : {n.a, n.b}) {
        if (!leaf(operand.node()) && bounds_.find(operand.node()) == bounds_.end())
          open.push_back(operand.node());
      }
      if (open.size() != before) continue;
      open.pop_back();
      bounds_.emplace(id, of_node(n));
    }
  }
  return known(x);
}

bool ExprGraph::may_leave_domain(const Node& n) const {
  if (n.arity() == 0) return false;
  const Interval a = bounds(n.a);
  if (n.op == Operation::div) {
    const Interval divisor = bounds(n.b);
    return !(divisor.lower > 0 || divisor.upper < 0);
  }
  if (n.op == Operation::sqrt) return !(a.lower >= 0);
  if (n.op == Operation::log || n.op == Operation::pow) return !(a.lower > 0);
  return (n.op == Operation::asin || n.op == Operation::acos) && !(a.lower >= -1 && a.upper <= 1);
}

}  // namespace alembert
