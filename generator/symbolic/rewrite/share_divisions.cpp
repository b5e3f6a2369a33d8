// Rewrite of stage `optimise`: fewer divisions. In: live nodes. Out: the same roots with shared reciprocals and
// merged quotients. See the header.
#include "symbolic/rewrite/share_divisions.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "support/operation.hpp"

namespace alembert {
namespace {

struct Quotient {
  Ref numerator, denominator;
};

class DivisionSharing : NodeRewrite {
 public:
  explicit DivisionSharing(const LiveNodes& from) : NodeRewrite(from), divisions_by_(size(), 0) {
    for (std::uint32_t id = 0; id < size(); ++id)
      if (is_division(id)) ++divisions_by_[operands(id).b >> 1];
  }

  std::optional<LiveNodes> run() {
    if (std::none_of(divisions_by_.begin(), divisions_by_.end(), [](std::uint32_t n) { return n > 0; }))
      return std::nullopt;
    rewrite_nodes([this](std::uint32_t id) {
      const std::optional<Ref> other = shared(id);
      rewritten_ = rewritten_ || other;
      return other ? *other : copied(id);
    });
    if (!rewritten_) return std::nullopt;
    return finished();
  }

 private:
  bool is_division(std::uint32_t id) const { return !is_constant(id) && op(id) == Operation::div; }

  // The quotient that an operand is, if nothing else needs it and no other division has its divisor.
  std::optional<Quotient> lone_quotient(std::uint32_t local) const {
    const std::uint32_t id = local >> 1;
    if (uses_[id] != 1) return std::nullopt;
    if (is_division(id) && divisions_by_[operands(id).b >> 1] > 1) return std::nullopt;
    const Ref w = image(local);
    const Node& n = graph_.node(w.node());
    if (n.op != Operation::div) return std::nullopt;
    return Quotient{w.negative() ? -n.a : n.a, n.b};
  }

  /// The value of a product or a quotient in another way, if there is a better one.
  std::optional<Ref> shared(std::uint32_t id) {
    const Operation kind = op(id);
    if (is_constant(id) || (kind != Operation::div && kind != Operation::mul)) return std::nullopt;
    const LocalOperands from = operands(id);
    const Ref a = image(from.a), b = image(from.b);
    if (kind == Operation::div) {
      if (divisions_by_[from.b >> 1] > 1) {
        const Ref reciprocal = make(Operation::div, graph_.one().ref(), b);
        return make(Operation::mul, a, reciprocal);
      }
      if (const auto inner = lone_quotient(from.a)) {
        const Ref divisor = make(Operation::mul, inner->denominator, b);
        return make(Operation::div, inner->numerator, divisor);
      }
      if (const auto inner = lone_quotient(from.b)) {
        const Ref numerator = make(Operation::mul, a, inner->denominator);
        return make(Operation::div, numerator, inner->numerator);
      }
      return std::nullopt;
    }
    const auto left = lone_quotient(from.a), right = lone_quotient(from.b);
    if (left && right) {
      const Ref numerator = make(Operation::mul, left->numerator, right->numerator);
      const Ref divisor = make(Operation::mul, left->denominator, right->denominator);
      return make(Operation::div, numerator, divisor);
    }
    if (left && pays(*left, b)) return into_numerator(*left, b);
    if (right && pays(*right, a)) return into_numerator(*right, a);
    return std::nullopt;
  }

  // (c/y)*x -> (c*x)/y saves a multiply if c is one or c*x is a constant.
  bool pays(const Quotient& q, Ref x) const {
    if (!graph_.node(q.numerator.node()).constant) return false;
    return graph_.node(x.node()).constant || std::abs(number_of(q.numerator)) == 1;
  }
  Ref into_numerator(const Quotient& q, Ref x) {
    const Ref numerator = make(Operation::mul, q.numerator, x);
    return make(Operation::div, numerator, q.denominator);
  }

  std::vector<std::uint32_t> divisions_by_;
  bool rewritten_ = false;
};

}  // namespace

std::optional<LiveNodes> share_divisions(const LiveNodes& nodes) {
  return DivisionSharing(nodes).run();
}

}  // namespace alembert
