// Values of a program as an interned graph with signs: the form in which programs are rewritten. In:
// instructions, or expressions from `lower`. Out: nodes that are folded and value-numbered on construction.
//
// A handle (Value) is a node and a sign, so that negation and subtraction are no operations here;
// `place_signs` decides at the end where they go. Ids grow in the order of construction, which follows the
// instructions and so is the same in every build; operands are ordered by id.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "program/program.hpp"

namespace alembert {

/// A node and a sign.
struct Value {
  std::uint32_t bits = 0;
  constexpr Value() = default;
  constexpr Value(std::uint32_t node, bool negative) : bits(node << 1 | (negative ? 1u : 0u)) {}
  constexpr std::uint32_t node() const { return bits >> 1; }
  constexpr bool negative() const { return (bits & 1u) != 0; }
  constexpr Value magnitude() const { return {node(), false}; }
  constexpr Value operator-() const { return {node(), !negative()}; }
  constexpr Value negated_if(bool flip) const { return {node(), negative() != flip}; }
  friend constexpr bool operator==(Value, Value) = default;
};

/// One node. `add` is a + b with a unsigned; operands of mul, div and of odd and even functions are unsigned.
/// A constant operand of add or mul is a, and there is at most one. Constants and inputs keep their index in
/// a.bits.
struct ValueNode {
  Operation op;  ///< never sub or neg
  Value a, b;
};

class ValueGraph {
 public:
  Value constant(double value);  ///< of a finite number
  Value input(std::uint32_t slot);
  /// Applies an operation, folding what the operands alone decide: constants, 0, +-1, x - x, x*2 -> x + x,
  /// c*(d*x), (x + c) + d, x/c. No rule costs more operations than the one that was asked for.
  Value make(Operation op, Value a, Value b = Value());

  std::uint32_t size() const { return static_cast<std::uint32_t>(nodes_.size()); }
  const ValueNode& node(std::uint32_t id) const { return nodes_[id]; }
  bool is_constant(Value v) const { return nodes_[v.node()].op == Operation::constant; }
  double constant_value(Value v) const;  ///< of a constant, with its sign
  void reserve(std::size_t nodes);

 private:
  Value intern(Operation op, Value a, Value b);
  Value make_add(Value a, Value b);
  Value make_mul(Value a, Value b);
  Value make_div(Value a, Value b);
  Value twice(Value a);
  bool is_number(Value v, double number) const { return is_constant(v) && constant_value(v) == number; }
  bool has_constant_operand(std::uint32_t id) const { return is_constant(nodes_[id].a); }
  void rehash(std::size_t slots);

  std::vector<ValueNode> nodes_;
  std::vector<double> constants_;
  std::vector<std::uint32_t> table_;  ///< open addressing; id + 1, 0 if free
};

/// A whole program in this form.
struct ValueProgram {
  struct Output {
    std::string name;
    std::uint32_t rows = 0, columns = 1;
    std::vector<Value> values;
  };
  std::string function, formulation;
  std::vector<InputSlot> inputs;
  std::vector<Output> outputs;
  ValueGraph graph;
};

/// Nodes that the outputs need, operands before users, depth first from the outputs in their order.
std::vector<std::uint32_t> live_order(const ValueProgram& program);

/// Number of uses of each node by nodes of `order` and by outputs.
std::vector<std::uint32_t> use_counts(const ValueProgram& program, std::span<const std::uint32_t> order);

/// A program with its live nodes in their order and the number of uses of each: what all rewrites read.
struct LiveProgram {
  explicit LiveProgram(ValueProgram program)
      : values(std::move(program)), order(live_order(values)), uses(use_counts(values, order)) {}
  ValueProgram values;
  std::vector<std::uint32_t> order, uses;
};

/// Reads a program; dead instructions come along as nodes that nothing needs.
ValueProgram to_values(const Program& program);

}  // namespace alembert
