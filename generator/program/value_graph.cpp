// Values of a program as an interned graph with signs: construction, folding and order. See value_graph.hpp.
#include "program/value_graph.hpp"

#include <bit>
#include <cmath>
#include <utility>

#include "support/operation.hpp"

namespace alembert {
namespace {

std::uint64_t mix(Operation op, std::uint64_t a, std::uint64_t b) {
  std::uint64_t h = a * 0x9e3779b97f4a7c15u ^ (b + static_cast<std::uint64_t>(op)) * 0xc2b2ae3d27d4eb4fu;
  h ^= h >> 32;
  h *= 0xd6e8feb86659fd93u;
  return h ^ h >> 32;
}

// Folding keeps accuracy only if the folded constant neither overflows nor underflows.
bool is_ordinary(double x) {
  return x == 0 || std::isnormal(x);
}

}  // namespace

void ValueGraph::reserve(std::size_t nodes) {
  nodes_.reserve(nodes);
  rehash(std::bit_ceil(2 * nodes + 16));
}

void ValueGraph::rehash(std::size_t slots) {
  table_.assign(slots, 0);
  for (std::uint32_t id = 0; id < size(); ++id) {
    const ValueNode& n = nodes_[id];
    const std::uint64_t a =
        n.op == Operation::constant ? std::bit_cast<std::uint64_t>(constants_[n.a.bits]) : n.a.bits;
    std::size_t slot = mix(n.op, a, n.b.bits) & (slots - 1);
    while (table_[slot] != 0) slot = (slot + 1) & (slots - 1);
    table_[slot] = id + 1;
  }
}

Value ValueGraph::constant(double value) {
  const double magnitude = std::abs(value);
  if (2 * (nodes_.size() + 1) > table_.size()) rehash(std::bit_ceil(4 * nodes_.size() + 16));
  const std::size_t mask = table_.size() - 1;
  std::size_t slot = mix(Operation::constant, std::bit_cast<std::uint64_t>(magnitude), 0) & mask;
  for (; table_[slot] != 0; slot = (slot + 1) & mask) {
    const ValueNode& n = nodes_[table_[slot] - 1];
    if (n.op == Operation::constant && constants_[n.a.bits] == magnitude)
      return {table_[slot] - 1, value < 0};
  }
  ValueNode n{Operation::constant, {}, {}};
  n.a.bits = static_cast<std::uint32_t>(constants_.size());
  constants_.push_back(magnitude);
  nodes_.push_back(n);
  table_[slot] = size();
  return {size() - 1, value < 0};
}

double ValueGraph::constant_value(Value v) const {
  const double magnitude = constants_[nodes_[v.node()].a.bits];
  return v.negative() ? -magnitude : magnitude;
}

Value ValueGraph::input(std::uint32_t slot) {
  Value a;
  a.bits = slot;
  return intern(Operation::input, a, {});
}

Value ValueGraph::intern(Operation op, Value a, Value b) {
  if (2 * (nodes_.size() + 1) > table_.size()) rehash(std::bit_ceil(4 * nodes_.size() + 16));
  const std::size_t mask = table_.size() - 1;
  std::size_t slot = mix(op, a.bits, b.bits) & mask;
  for (; table_[slot] != 0; slot = (slot + 1) & mask) {
    const ValueNode& n = nodes_[table_[slot] - 1];
    if (n.op == op && n.a == a && n.b == b) return {table_[slot] - 1, false};
  }
  nodes_.push_back({op, a, b});
  table_[slot] = size();
  return {size() - 1, false};
}

Value ValueGraph::make(Operation op, Value a, Value b) {
  if (op == Operation::add) return make_add(a, b);
  if (op == Operation::sub) return make_add(a, -b);
  if (op == Operation::mul) return make_mul(a, b);
  if (op == Operation::div) return make_div(a, b);
  if (op == Operation::neg) return is_number(a, 0) ? a : -a;
  const bool binary = operand_count(op) == 2;
  if (is_constant(a) && (!binary || is_constant(b))) {
    const double value = apply(op, constant_value(a), binary ? constant_value(b) : 0.0);
    if (std::isfinite(value)) return constant(value);
  }
  switch (parity(op)) {
    case Parity::odd:
      return intern(op, a.magnitude(), {}).negated_if(a.negative());
    case Parity::even:
      return intern(op, a.magnitude(), {});
    case Parity::none:
      break;
  }
  return intern(op, a, binary ? b : Value());
}

// 2x; of 2x or c*x again one operation on x.
Value ValueGraph::twice(Value a) {
  const ValueNode n = nodes_[a.node()];
  if (n.op == Operation::add && n.a == n.b)
    return intern(Operation::mul, constant(4), n.a).negated_if(a.negative());
  if (n.op == Operation::mul && is_constant(n.a) && is_ordinary(2 * constant_value(n.a))) {
    const Value factor = constant(2 * constant_value(n.a));
    return make_mul(factor, n.b).negated_if(a.negative());
  }
  return intern(Operation::add, a.magnitude(), a.magnitude()).negated_if(a.negative());
}

Value ValueGraph::make_add(Value a, Value b) {
  if (is_number(a, 0)) return b;
  if (is_number(b, 0)) return a;
  if (is_constant(a) && is_constant(b)) {
    const double sum = constant_value(a) + constant_value(b);
    if (std::isfinite(sum)) return constant(sum);
  }
  if (a.node() == b.node()) {
    if (a.negative() != b.negative()) return constant(0);
    return twice(a);
  }
  if (is_constant(b) || (b.node() < a.node() && !is_constant(a))) std::swap(a, b);
  if (is_constant(a)) {
    const ValueNode n = nodes_[b.node()];
    if (n.op == Operation::add && is_constant(n.a) && !is_constant(n.b)) {
      const double inner = constant_value(n.a);
      const double sum = constant_value(a) + (b.negative() ? -inner : inner);
      if (is_ordinary(sum)) return make_add(constant(sum), n.b.negated_if(b.negative()));
    }
  }
  const bool flip = a.negative();
  return intern(Operation::add, a.magnitude(), b.negated_if(flip)).negated_if(flip);
}

Value ValueGraph::make_mul(Value a, Value b) {
  const bool flip = a.negative() != b.negative();
  a = a.magnitude();
  b = b.magnitude();
  if (is_number(a, 0)) return a;
  if (is_number(b, 0)) return b;
  if (is_number(a, 1)) return b.negated_if(flip);
  if (is_number(b, 1)) return a.negated_if(flip);
  if (is_constant(b) || (b.node() < a.node() && !is_constant(a))) std::swap(a, b);
  if (is_constant(a)) {
    const double factor = constant_value(a);
    if (is_constant(b)) {
      const double product = factor * constant_value(b);
      if (is_ordinary(product) && product != 0) return constant(flip ? -product : product);
    }
    const ValueNode n = nodes_[b.node()];
    double product = 0;
    Value rest;
    if (n.op == Operation::mul && is_constant(n.a)) {
      product = factor * constant_value(n.a);
      rest = n.b;
    } else if (n.op == Operation::add && n.a == n.b) {
      product = factor * 2;
      rest = n.a;
    }
    if (product != 0 && is_ordinary(product) && !is_constant(rest))
      return make_mul(constant(product), rest).negated_if(flip);
    if (factor == 2) return twice(b).negated_if(flip);
  }
  return intern(Operation::mul, a, b).negated_if(flip);
}

Value ValueGraph::make_div(Value a, Value b) {
  const bool flip = a.negative() != b.negative();
  a = a.magnitude();
  b = b.magnitude();
  if (is_number(b, 0)) return intern(Operation::div, a, b).negated_if(flip);
  if (is_number(a, 0)) return a;
  if (a == b) return constant(flip ? -1.0 : 1.0);
  if (is_constant(b)) {
    const double divisor = constant_value(b);
    if (is_constant(a)) {
      const double quotient = constant_value(a) / divisor;
      if (is_ordinary(quotient) && quotient != 0) return constant(flip ? -quotient : quotient);
    } else if (std::isnormal(1 / divisor)) {
      return make_mul(constant(1 / divisor), a).negated_if(flip);
    }
  } else if (is_constant(a)) {
    const ValueNode n = nodes_[b.node()];
    double quotient = 0;
    Value rest;
    if (n.op == Operation::mul && is_constant(n.a)) {
      quotient = constant_value(a) / constant_value(n.a);
      rest = n.b;
    } else if (n.op == Operation::add && n.a == n.b) {
      quotient = constant_value(a) / 2;
      rest = n.a;
    }
    if (quotient != 0 && is_ordinary(quotient) && !is_constant(rest))
      return intern(Operation::div, constant(quotient), rest).negated_if(flip);
  }
  return intern(Operation::div, a, b).negated_if(flip);
}

std::vector<std::uint32_t> live_order(const ValueProgram& program) {
  const ValueGraph& graph = program.graph;
  std::vector<std::uint32_t> order;
  std::vector<std::uint8_t> seen(graph.size(), 0);
  std::vector<std::pair<std::uint32_t, int>> stack;  // node and the operand to visit next
  for (const auto& output : program.outputs)
    for (const Value value : output.values) {
      if (seen[value.node()]) continue;
      seen[value.node()] = 1;
      stack.push_back({value.node(), 0});
      while (!stack.empty()) {
        auto& [id, next] = stack.back();
        const ValueNode& n = graph.node(id);
        if (next == operand_count(n.op)) {
          order.push_back(id);
          stack.pop_back();
          continue;
        }
        const std::uint32_t operand = (next++ == 0 ? n.a : n.b).node();
        if (seen[operand]) continue;
        seen[operand] = 1;
        stack.push_back({operand, 0});
      }
    }
  return order;
}

std::vector<std::uint32_t> use_counts(const ValueProgram& program, std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> uses(program.graph.size(), 0);
  for (const std::uint32_t id : order) {
    const ValueNode& n = program.graph.node(id);
    const int operands = operand_count(n.op);
    if (operands > 0) ++uses[n.a.node()];
    if (operands > 1) ++uses[n.b.node()];
  }
  for (const auto& output : program.outputs)
    for (const Value value : output.values) ++uses[value.node()];
  return uses;
}

ValueProgram to_values(const Program& program) {
  ValueProgram out;
  out.function = program.function;
  out.formulation = program.formulation;
  out.inputs = program.inputs;
  out.graph.reserve(program.code.size());
  std::vector<Value> values(program.code.size());
  for (std::size_t i = 0; i < program.code.size(); ++i) {
    const Instruction& c = program.code[i];
    if (c.op == Operation::constant)
      values[i] = out.graph.constant(program.constants[c.a]);
    else if (c.op == Operation::input)
      values[i] = out.graph.input(c.a);
    else
      values[i] = out.graph.make(c.op, values[c.a], operand_count(c.op) == 2 ? values[c.b] : Value());
  }
  for (const OutputArray& output : program.outputs) {
    auto& to = out.outputs.emplace_back();
    to.name = output.name;
    to.rows = output.rows;
    to.columns = output.columns;
    for (const std::uint32_t v : output.values) to.values.push_back(values[v]);
  }
  return out;
}

}  // namespace alembert
