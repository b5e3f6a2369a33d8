// The rules of construction. In: an operation and its operands. Out: the interned, simplified node. Private
// to this room.
//
// Every rule looks at most two levels below its operands and gives a result with no more operations than it
// was asked for. Rules may call each other; past kMaxDepth nested calls nodes are interned as they stand, so
// that neither the stack nor the time depends on how deep the operands are.
// Where brackets are kept, rules only fold: none of them takes an operand apart that is no constant.
#pragma once

#include <cstdint>
#include <optional>

#include "symbolic/expr.hpp"

namespace alembert {

inline constexpr Ref kZero{};
inline constexpr Ref kOne{1, false};

struct Builder {
  explicit Builder(ExprGraph& owner) : graph(owner) {}

  Ref sum(Ref a, Ref b);
  Ref difference(Ref a, Ref b) { return sum(a, -b); }
  Ref product(Ref a, Ref b);
  Ref quotient(Ref a, Ref b);
  Ref function(Operation op, Ref x);
  Ref arctangent2(Ref y, Ref x);
  Ref choice(Operation wanted, Ref condition, Ref x);
  /// Whether it divides by what may be 0, or has a function outside of its domain. A choice whose factor this
  /// is takes it in: it must not spoil what is not chosen.
  bool may_lack_value(Ref x) const;
  Ref power(Ref x, Ref y);
  Ref integer_power(Ref x, std::int64_t n);

  Ref number(Rational value);
  Ref number(std::int64_t value) { return number(Rational(value)); }
  Ref pi(Rational multiple);
  Ref real(double value);  ///< throws ConstantOutOfRange on NaN and infinity

  // A product seen as coefficient * rest. The coefficient of a constant is its exact number, that of anything
  // else all its constant factors; `rest` is unsigned.
  struct Term {
    Ref coefficient, rest;
  };
  Term factor(Ref x);
  Term term(Ref x);  ///< also of c/x, whose rest is 1/x
  bool is_scaled_sine(Ref x) const;

  const Node& node(Ref x) const { return graph.nodes_[x.node()]; }
  Operation op(Ref x) const { return node(x).op; }
  bool constant(Ref x) const { return node(x).constant; }
  bool numeric(Ref x) const {
    const Operation o = op(x);
    return o == Operation::rational || o == Operation::pi_multiple || o == Operation::real;
  }
  bool rational(Ref x) const { return op(x) == Operation::rational; }
  Rational rational_of(Ref x) const;  ///< of a rational or pi_multiple, with its sign
  double numeric_value(Ref x) const;  ///< of a number, with its sign
  bool nonnegative(Ref x) const { return graph.bounds(x).lower >= 0; }
  bool before(Ref a, Ref b) const;  ///< operand order: by content
  static Ref magnitude(Ref x) { return {x.node(), false}; }
  static Ref signed_as(Ref x, bool negative) { return negative ? -x : x; }

  Ref intern(Operation op, Ref a, Ref b);

  static constexpr int kMaxDepth = 24;
  struct Nested {
    explicit Nested(Builder& b) : depth(b.depth_) { ++depth; }
    ~Nested() { --depth; }
    int& depth;
  };
  bool too_deep() const { return depth_ > kMaxDepth; }

  ExprGraph& graph;

 private:
  Ref intern_sum(Ref a, Ref b);
  Ref intern_product(Ref a, Ref b);  // of unsigned operands
  std::optional<Ref> fold_sum(Ref a, Ref b);
  std::optional<Ref> fold_product(Ref a, Ref b);
  std::optional<Ref> sum_with_nested(Ref a, Ref b);
  std::optional<Ref> sum_of_sums(Ref a, Ref b);
  std::optional<Ref> pythagorean(Ref a, Ref b);
  std::optional<Ref> constant_product(Ref a, Ref b);
  std::optional<Ref> cancel_product(Ref a, Ref b);
  std::optional<Ref> cancel_quotient(Ref a, Ref b);
  Ref reciprocal(Ref constant);

  // An angle seen as rest + multiple * pi, negated as a whole if `negative`.
  struct Angle {
    Ref rest;
    Rational multiple;
    bool negative;
  };
  Angle angle(Ref x);
  Ref unsigned_angle(const Angle& angle);  // rest + multiple * pi
  Ref sine(Ref x);
  Ref cosine(Ref x);
  Ref sine_or_cosine(bool cosine, Ref x);
  Ref exact_sine(Rational multiple);
  Ref tangent(Ref x);
  Ref arcsine(Ref x);
  Ref arccosine(Ref x);
  Ref arctangent(Ref x);
  Ref square_root(Ref x);
  Ref root_of_rational(Rational x);
  Ref absolute(Ref x);
  Ref signum(Ref x);
  Ref exponential(Ref x);
  Ref logarithm(Ref x);
  Ref any_function(Operation wanted, Ref x);
  Ref complement_root(Ref x, bool plus);  // sqrt(1 +- x^2)

  int depth_ = 0;
};

}  // namespace alembert
