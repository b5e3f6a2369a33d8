// Rewrite of stage `optimise`: fewer divisions. In: a value program. Out: the same values with shared
// reciprocals and merged quotients. See the header.
#include "program/rewrite/share_divisions.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "program/rewrite/node_rewrite.hpp"
#include "support/operation.hpp"

namespace alembert {
namespace {

struct Quotient {
  Value numerator, denominator;
};

class DivisionSharing : NodeRewrite {
 public:
  explicit DivisionSharing(const LiveProgram& from)
      : NodeRewrite(from), divisions_by_(from_.graph.size(), 0) {
    for (const std::uint32_t id : order_)
      if (from_.graph.node(id).op == Operation::div) ++divisions_by_[from_.graph.node(id).b.node()];
  }

  std::optional<ValueProgram> run() {
    if (std::none_of(order_.begin(), order_.end(),
                     [this](std::uint32_t id) { return from_.graph.node(id).op == Operation::div; }))
      return std::nullopt;
    rewrite_nodes([this](std::uint32_t id) { return rewrite(id); });
    if (!rewritten_) return std::nullopt;
    return finished();
  }

 private:
  Value one() { return to_.graph.constant(1); }

  // The quotient that v is, if nothing else needs it and no other division has its divisor.
  std::optional<Quotient> lone_quotient(Value v) const {
    const ValueNode& n = from_.graph.node(v.node());
    if (uses_[v.node()] != 1) return std::nullopt;
    if (n.op == Operation::div && divisions_by_[n.b.node()] > 1) return std::nullopt;
    const Value w = image(v);
    const ValueNode& m = to_.graph.node(w.node());
    if (m.op != Operation::div) return std::nullopt;
    return Quotient{m.a.negated_if(w.negative()), m.b};
  }

  Value rewrite(std::uint32_t id) {
    if (const auto other = shared(id)) {
      rewritten_ = true;
      return *other;
    }
    return copied(id);
  }

  Value copied(std::uint32_t id) {
    const ValueNode& n = from_.graph.node(id);
    ValueGraph& to = to_.graph;
    if (n.op == Operation::constant) return to.constant(from_.graph.constant_value(Value(id, false)));
    if (n.op == Operation::input) return to.input(n.a.bits);
    return to.make(n.op, image(n.a), operand_count(n.op) == 2 ? image(n.b) : Value());
  }

  /// The value of a product or a quotient in another way, if there is a better one.
  std::optional<Value> shared(std::uint32_t id) {
    const ValueNode& n = from_.graph.node(id);
    if (n.op != Operation::div && n.op != Operation::mul) return std::nullopt;
    ValueGraph& to = to_.graph;
    const Value a = image(n.a), b = image(n.b);
    if (n.op == Operation::div) {
      if (divisions_by_[n.b.node()] > 1) {
        const Value reciprocal = to.make(Operation::div, one(), b);
        return to.make(Operation::mul, a, reciprocal);
      }
      if (const auto inner = lone_quotient(n.a)) {
        const Value divisor = to.make(Operation::mul, inner->denominator, b);
        return to.make(Operation::div, inner->numerator, divisor);
      }
      if (const auto inner = lone_quotient(n.b)) {
        const Value numerator = to.make(Operation::mul, a, inner->denominator);
        return to.make(Operation::div, numerator, inner->numerator);
      }
    }
    if (n.op == Operation::mul) {
      const auto left = lone_quotient(n.a), right = lone_quotient(n.b);
      if (left && right) {
        const Value numerator = to.make(Operation::mul, left->numerator, right->numerator);
        const Value divisor = to.make(Operation::mul, left->denominator, right->denominator);
        return to.make(Operation::div, numerator, divisor);
      }
      if (left && pays(*left, b)) return into_numerator(*left, b);
      if (right && pays(*right, a)) return into_numerator(*right, a);
    }
    return std::nullopt;
  }

  // (c/y)*x -> (c*x)/y saves a multiply if c is one or c*x is a constant.
  bool pays(const Quotient& q, Value x) const {
    if (!to_.graph.is_constant(q.numerator)) return false;
    return to_.graph.is_constant(x) || std::abs(to_.graph.constant_value(q.numerator)) == 1;
  }
  Value into_numerator(const Quotient& q, Value x) {
    const Value numerator = to_.graph.make(Operation::mul, q.numerator, x);
    return to_.graph.make(Operation::div, numerator, q.denominator);
  }

  std::vector<std::uint32_t> divisions_by_;
  bool rewritten_ = false;
};

}  // namespace

std::optional<ValueProgram> share_divisions(const LiveProgram& program) {
  return DivisionSharing(program).run();
}

}  // namespace alembert
