// Expressions: an arena of interned nodes. In: operators and function calls. Out: handles whose equality is
// id equality, simplified on construction by rules that only look at the operands.
//
// A handle (Ref) is a node index and a sign bit, so x and -x are one node and negation costs nothing.
// Children are created before parents: every pass is one loop over ids, without recursion.
// Operand order is by content (structural key), never by id, address or order of evaluation, so that
// the same input gives the same output whatever compiler built this program.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "support/operation.hpp"
#include "support/scoped.hpp"
#include "symbolic/rational.hpp"

namespace alembert {

/// Node index shifted left by one, plus 1 if negated. Node 0 is the constant zero, which has no sign: there
/// is no -0.
struct Ref {
  std::uint32_t bits = 0;
  constexpr Ref() = default;
  constexpr Ref(std::uint32_t node, bool negative) : bits(node << 1 | (negative && node != 0 ? 1u : 0u)) {}
  constexpr std::uint32_t node() const { return bits >> 1; }
  constexpr bool negative() const { return (bits & 1u) != 0; }
  constexpr Ref operator-() const { return {node(), !negative()}; }
  friend constexpr bool operator==(Ref, Ref) = default;
};

/// One node. Leaves keep an index into the graph's constant or symbol tables in a.bits.
/// a and b are its operands.
struct Node {
  Operation op;
  bool constant;  ///< no symbol below
  Ref a, b;       ///< unary operations leave b at zero
  constexpr int arity() const { return operand_count(op); }
};

class ExprGraph;

/// A value in a graph. Cheap to copy; the graph must outlive it. Two Exprs of one graph are the same
/// expression exactly if they compare equal. A default-constructed Expr belongs to no graph and may only be
/// assigned to.
class Expr {
 public:
  Expr() = default;
  Expr(ExprGraph& graph, Ref ref) : graph_(&graph), ref_(ref) {}
  ExprGraph& graph() const { return *graph_; }
  Ref ref() const { return ref_; }
  bool valid() const { return graph_ != nullptr; }
  bool is_zero() const;
  bool is_one() const;
  bool is_constant() const;  ///< no symbol below
  Expr operator-() const { return {*graph_, -ref_}; }
  friend bool operator==(const Expr& x, const Expr& y) { return x.graph_ == y.graph_ && x.ref_ == y.ref_; }

 private:
  ExprGraph* graph_ = nullptr;
  Ref ref_;
};

Expr operator+(Expr a, Expr b);
Expr operator-(Expr a, Expr b);
Expr operator*(Expr a, Expr b);
Expr operator/(Expr a, Expr b);  ///< throws std::domain_error if b is the constant zero
inline Expr& operator+=(Expr& a, Expr b) {
  return a = a + b;
}
inline Expr& operator-=(Expr& a, Expr b) {
  return a = a - b;
}
inline Expr& operator*=(Expr& a, Expr b) {
  return a = a * b;
}

Expr sqrt(Expr x);
Expr sin(Expr x);
Expr cos(Expr x);
Expr tan(Expr x);
Expr asin(Expr x);
Expr acos(Expr x);
Expr atan(Expr x);
Expr atan2(Expr y, Expr x);
Expr exp(Expr x);
Expr log(Expr x);
Expr abs(Expr x);
Expr sign(Expr x);
Expr sinh(Expr x);
Expr cosh(Expr x);
Expr tanh(Expr x);
/// x where c > 0, else 0; and the other way round. What is not taken may have no value.
Expr if_positive(Expr c, Expr x);
Expr unless_positive(Expr c, Expr x);
/// x times the epsilon of the type that computes.
Expr rounding(Expr x);
Expr pow(Expr x, Expr y);
Expr pow(Expr x, int n);
/// Any operation that is no leaf, signs included; b is for those of two operands.
Expr apply(Operation op, Expr a, Expr b);

/// A constant that doubles cannot hold: infinity, or no number.
class ConstantOutOfRange : public std::domain_error {
 public:
  ConstantOutOfRange() : std::domain_error("a constant is infinite or not a number") {}
};

/// Owns nodes, constants and symbols. Not copyable; not thread safe.
/// 0*x is 0 whatever x is: NaN and infinity are not values here.
class ExprGraph {
 public:
  ExprGraph();
  ExprGraph(const ExprGraph&) = delete;
  ExprGraph& operator=(const ExprGraph&) = delete;

  Expr integer(std::int64_t value);
  Expr rational(Rational value);
  Expr pi(Rational multiple = Rational(1));
  /// Exact rational if it is a short one. Sums of others in which no more than rounding is left are 0. Throws
  /// ConstantOutOfRange on NaN and infinity.
  Expr real(double value);
  Expr zero() { return integer(0); }
  Expr one() { return integer(1); }

  /// The symbol of that name (made on first use). Names are arbitrary text; equal names are equal symbols.
  Expr symbol(std::string_view name);
  /// Declares that a symbol stays inside an interval (a parameter's value, a coordinate's hard range); sign
  /// proofs use it.
  void assume(Expr symbol, Interval interval);
  bool simplifies() const { return simplifies_; }  ///< whether `simplify` does anything
  /// While what this returns lives, `simplify` gives roots as they are: what is written is measured against what stands
  /// in the description.
  [[nodiscard]] Scoped<bool> leave_as_written() { return {simplifies_, false}; }
  /// While what this returns lives, sums, products and quotients stay bracketed as they are made: (c*x)*y does not become
  /// c*(x*y), which costs more where c*x is there anyway. What the operands alone decide still folds.
  [[nodiscard]] Scoped<bool> keep_brackets() { return {keeps_brackets_, true}; }

  std::uint32_t size() const { return static_cast<std::uint32_t>(nodes_.size()); }
  const Node& node(std::uint32_t id) const { return nodes_[id]; }
  /// Content hash with the rank of the operation on top; orders operands, equal in every run and build.
  std::uint64_t key(std::uint32_t id) const { return keys_[id]; }
  Rational rational_value(std::uint32_t id) const;  ///< of a rational or pi_multiple node
  double real_value(std::uint32_t id) const;        ///< of a real node
  std::uint32_t symbol_count() const { return static_cast<std::uint32_t>(symbols_.size()); }
  std::uint32_t symbol_index(std::uint32_t id) const { return nodes_[id].a.bits; }
  const std::string& symbol_name(std::uint32_t index) const { return *symbols_[index].name; }
  Expr symbol_at(std::uint32_t index) { return {*this, Ref(symbols_[index].node, false)}; }
  Interval bounds(Ref x) const;  ///< interval bound of a value, by interval arithmetic over its operands
  /// Whether by these bounds it may divide by 0, or be a function outside of its domain.
  bool may_leave_domain(const Node& node) const;
  std::size_t memory_bytes() const;

  /// Applies an operation to operands, with simplification: the one door through which nodes are made.
  Ref make(Operation op, Ref a, Ref b = Ref());
  /// A node with other operands: itself where they are its own.
  Ref remade(std::uint32_t id, Ref a, Ref b);

 private:
  friend struct Builder;
  struct Symbol {
    const std::string* name;  ///< the key in symbol_ids_, which does not move

    std::uint32_t node;
    Interval interval;
  };
  std::uint32_t append(Node node, std::uint64_t key);
  template <class Same>
  std::uint32_t find(std::uint64_t key,
                     Same same) const;  ///< 0 if there is none: the zero node is never looked up
  void place(std::uint64_t key, std::uint32_t id);
  void rehash(std::size_t slots);
  Ref intern_number(Operation op, Rational value);
  Ref intern_real(double value);

  std::vector<Node> nodes_;
  std::vector<std::uint64_t> keys_;
  // Open addressing by key. Tags are a few more bits of it: looking for a new node reads one line of tags and
  // no node.
  std::vector<std::uint8_t> tags_;    ///< 0 if free
  std::vector<std::uint32_t> table_;  ///< node ids
  std::vector<Rational> rationals_;
  std::vector<double> reals_;
  std::vector<Symbol> symbols_;
  std::unordered_map<std::string, std::uint32_t> symbol_ids_;
  mutable std::unordered_map<std::uint32_t, Interval>
      bounds_;  ///< of nodes that were asked for; looked up only
  bool simplifies_ = true, keeps_brackets_ = false;
};

}  // namespace alembert
