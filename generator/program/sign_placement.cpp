// Value graph to program: chooses the sign in which each value is computed, then writes instructions. In:
// nodes and signs. Out: the same values with as few negations as a local search finds.
//
// p(n) is +1 if node n is to be computed and -1 if its negative is. Each node and each output puts a
// condition on the signs around it; a broken condition costs one negation. Two kinds of sweep lower the
// number of broken conditions: from the outputs down, where a negation also moves to an operand at equal cost
// (it may vanish in a difference or a constant below), and from the leaves up, where only gains count.
#include "program/sign_placement.hpp"

#include <bit>
#include <unordered_map>
#include <utility>

#include "program/value_graph.hpp"
#include "support/operation.hpp"

namespace alembert {
namespace {

constexpr int kSweeps = 4;

class Placement {
 public:
  Placement(const ValueProgram& program, std::span<const std::uint32_t> order)
      : graph_(program.graph),
        order_(order),
        negative_(graph_.size(), 0),
        output_uses_(2 * graph_.size(), 0) {
    for (const auto& output : program.outputs)
      for (const Value v : output.values) ++output_uses_[v.bits];
    collect_users();
    find_absorbing();
    broken_above_.assign(graph_.size(), 0);
    for (std::size_t bits = 0; bits < output_uses_.size(); bits += 2)
      broken_above_[bits >> 1] = static_cast<int>(output_uses_[bits | 1]);
    broken_.assign(graph_.size(), 0);
    for (const std::uint32_t id : order_) set_broken(id, breaks(id));
  }

  /// Whether each node is computed with its sign reversed.
  std::vector<std::uint8_t> run() {
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      bool changed = false;
      for (std::size_t i = order_.size(); i-- > 0;) changed |= try_flip(order_[i], true);
      for (const std::uint32_t id : order_) changed |= try_flip(id, false);
      if (!changed) break;
    }
    return std::move(negative_);
  }

 private:
  void collect_users() {
    user_begin_.assign(graph_.size() + 1, 0);
    const auto each_operand = [this](auto&& action) {
      for (const std::uint32_t id : order_) {
        const ValueNode& n = graph_.node(id);
        const int operands = operand_count(n.op);
        if (operands > 0) action(id, n.a.node());
        if (operands > 1 && n.b.node() != n.a.node()) action(id, n.b.node());
      }
    };
    each_operand([this](std::uint32_t, std::uint32_t operand) { ++user_begin_[operand + 1]; });
    for (std::size_t i = 1; i < user_begin_.size(); ++i) user_begin_[i] += user_begin_[i - 1];
    users_.resize(user_begin_.back());
    std::vector<std::uint32_t> fill(user_begin_.begin(), user_begin_.end() - 1);
    each_operand(
        [this, &fill](std::uint32_t user, std::uint32_t operand) { users_[fill[operand]++] = user; });
  }

  // Nodes whose negative costs nothing, if nothing else needs what is below them: differences, constant
  // factors, and what passes a sign on to one of these.
  void find_absorbing() {
    absorbing_.assign(graph_.size(), 0);
    const auto passes_on = [this](Value v) { return graph_.is_constant(v) || absorbing_[v.node()] != 0; };
    for (const std::uint32_t id : order_) {
      const ValueNode& n = graph_.node(id);
      if (n.op == Operation::add)
        absorbing_[id] = n.b.negative() || passes_on(n.a) || passes_on(n.b);
      else if (n.op == Operation::mul || n.op == Operation::div)
        absorbing_[id] = passes_on(n.a) || passes_on(n.b);
      else if (operand_count(n.op) == 1 && parity(n.op) == Parity::odd)
        absorbing_[id] = passes_on(n.a);
    }
  }

  // Sign of the computed value of v relative to v.
  bool minus(Value v) const { return v.negative() != (negative_[v.node()] != 0); }
  int mismatch(Value v) const { return !graph_.is_constant(v) && minus(v) ? 1 : 0; }

  int breaks(std::uint32_t id) const {
    const ValueNode& n = graph_.node(id);
    const bool flip = negative_[id] != 0;
    const int operands = operand_count(n.op);
    if (operands == 0) return flip && n.op != Operation::constant ? 1 : 0;
    const bool any_constant = graph_.is_constant(n.a) || (operands == 2 && graph_.is_constant(n.b));
    if (n.op == Operation::add) return !any_constant && flip != minus(n.a) && flip != minus(n.b) ? 1 : 0;
    if (n.op == Operation::mul || n.op == Operation::div)
      return !any_constant && (flip != minus(n.a)) != minus(n.b) ? 1 : 0;
    switch (parity(n.op)) {
      case Parity::odd:
        return flip != minus(n.a) ? 1 : 0;
      case Parity::even:
        return flip ? 1 : 0;
      case Parity::none:
        break;
    }
    return (flip ? 1 : 0) + mismatch(n.a) + (operands == 2 ? mismatch(n.b) : 0);
  }

  // Of a node's condition as it is found to be now; what is broken above its operands follows.
  void set_broken(std::uint32_t id, int now) {
    const int more = now - broken_[id];
    if (more == 0) return;
    broken_[id] = static_cast<std::uint8_t>(now);
    const ValueNode& n = graph_.node(id);
    const int operands = operand_count(n.op);
    if (operands > 0) broken_above_[n.a.node()] += more;
    if (operands > 1 && n.b.node() != n.a.node()) broken_above_[n.b.node()] += more;
  }

  bool try_flip(std::uint32_t id, bool move_down) {
    const int above = broken_above_[id], here = broken_[id];
    if (above + here == 0) return false;
    const Operation op = graph_.node(id).op;
    if (op == Operation::constant || op == Operation::input) return false;
    negative_[id] ^= 1;
    const std::span users(users_.data() + user_begin_[id], user_begin_[id + 1] - user_begin_[id]);
    int new_above = static_cast<int>(output_uses_[id << 1 | (negative_[id] != 0 ? 0u : 1u)]);
    for (const std::uint32_t user : users) new_above += breaks(user);
    const int new_here = breaks(id);
    const bool fewer = new_above + new_here < above + here;
    const bool moved =
        move_down && absorbing_[id] != 0 && new_above + new_here == above + here && new_above < above;
    if (!fewer && !moved) {
      negative_[id] ^= 1;
      return false;
    }
    set_broken(id, new_here);
    for (const std::uint32_t user : users) set_broken(user, breaks(user));
    broken_above_[id] = new_above;
    return true;
  }

  const ValueGraph& graph_;
  std::span<const std::uint32_t> order_;
  std::vector<std::uint8_t> negative_;
  std::vector<std::uint32_t> output_uses_;  ///< by Value::bits
  std::vector<std::uint32_t> user_begin_, users_;
  std::vector<std::uint8_t> absorbing_;
  std::vector<std::uint8_t> broken_;  ///< conditions of each node; a function of two operands may break three
  std::vector<int> broken_above_;     ///< of its users and of outputs
};

class Writer {
 public:
  Writer(const ValueProgram& from, Program& to, std::vector<std::uint8_t> negative)
      : graph_(from.graph), to_(to), negative_(std::move(negative)), at_(2 * graph_.size(), kNone) {}

  void write(std::uint32_t id) {
    const ValueNode& n = graph_.node(id);
    const bool flip = negative_[id] != 0;
    const int operands = operand_count(n.op);
    if (n.op == Operation::constant) return;
    if (n.op == Operation::input) {
      at_[id << 1] = append(Operation::input, n.a.bits);
    } else if (n.op == Operation::add) {
      write_sum(id, n, flip);
    } else if (n.op == Operation::mul || n.op == Operation::div) {
      write_product(id, n, flip);
    } else if (parity(n.op) == Parity::odd) {
      const bool sign = pick(n.a, flip);
      at_[id << 1 | (sign ? 1u : 0u)] = append(n.op, get(n.a.negated_if(sign)));
    } else if (parity(n.op) == Parity::even) {
      const bool sign = pick(n.a, false);
      at_[id << 1] = append(n.op, get(n.a.negated_if(sign)));
    } else {
      const std::uint32_t a = get(n.a);
      const std::uint32_t b = operands == 2 ? get(n.b) : 0;
      at_[id << 1] = append(n.op, a, b);
    }
  }

  /// Index of the instruction that computes v, appending a constant or a negation where there is none yet.
  std::uint32_t get(Value v) {
    if (graph_.is_constant(v)) return constant(graph_.constant_value(v));
    std::uint32_t& index = at_[v.bits];
    if (index == kNone) index = append(Operation::neg, at_[(-v).bits]);
    return index;
  }

 private:
  bool has(Value v) const { return graph_.is_constant(v) || at_[v.bits] != kNone; }
  // The sign in which to take v: the preferred one unless only the other exists.
  bool pick(Value v, bool preferred) const { return has(v.negated_if(preferred)) ? preferred : !preferred; }

  void write_sum(std::uint32_t id, const ValueNode& n, bool flip) {
    if (graph_.is_constant(n.a)) {
      const bool other = pick(n.b, flip);  // b enters as x = (other ? -b : b)
      const double c = graph_.constant_value(n.a.negated_if(flip));
      const std::uint32_t x = get(n.b.negated_if(other));
      std::uint32_t result = 0;
      if (other != flip) {
        const std::uint32_t k = constant(c);
        result = append(Operation::sub, k, x);
      } else if (c < 0) {
        const std::uint32_t k = constant(-c);
        result = append(Operation::sub, x, k);
      } else {
        const std::uint32_t k = constant(c);
        result = append(Operation::add, x, k);
      }
      at_[id << 1 | (flip ? 1u : 0u)] = result;
      return;
    }
    // Of a + b with the signs that exist: prefer a result with the wanted sign, then one without a negation.
    for (const bool sign : {flip, !flip}) {
      const Value a = n.a.negated_if(sign), b = n.b.negated_if(sign);
      if (has(a) && has(b)) return store(id, sign, Operation::add, get(a), get(b));
      if (has(a) && has(-b)) return store(id, sign, Operation::sub, get(a), get(-b));
      if (has(-a) && has(b)) return store(id, sign, Operation::sub, get(b), get(-a));
    }
  }

  void write_product(std::uint32_t id, const ValueNode& n, bool flip) {
    bool sign_a = pick(n.a, false), sign_b = pick(n.b, false);
    if (graph_.is_constant(n.a)) {
      sign_a = flip != sign_b;
    } else if (graph_.is_constant(n.b)) {
      sign_b = flip != sign_a;
    } else if ((sign_a != sign_b) != flip) {
      if (has(n.a.negated_if(!sign_a)))
        sign_a = !sign_a;
      else if (has(n.b.negated_if(!sign_b)))
        sign_b = !sign_b;
    }
    const std::uint32_t a = get(n.a.negated_if(sign_a));
    const std::uint32_t b = get(n.b.negated_if(sign_b));
    store(id, sign_a != sign_b, n.op, a, b);
  }

  void store(std::uint32_t id, bool sign, Operation op, std::uint32_t a, std::uint32_t b) {
    at_[id << 1 | (sign ? 1u : 0u)] = append(op, a, b);
  }

  std::uint32_t append(Operation op, std::uint32_t a, std::uint32_t b = 0) {
    to_.code.push_back({op, a, b});
    return static_cast<std::uint32_t>(to_.code.size() - 1);
  }

  std::uint32_t constant(double value) {
    if (value == 0) value = 0;  // never -0
    const auto [entry, fresh] = constant_at_.try_emplace(std::bit_cast<std::uint64_t>(value), 0);
    if (fresh) {
      to_.constants.push_back(value);
      entry->second = append(Operation::constant, static_cast<std::uint32_t>(to_.constants.size() - 1));
    }
    return entry->second;
  }

  const ValueGraph& graph_;
  Program& to_;
  std::vector<std::uint8_t> negative_;
  std::vector<std::uint32_t> at_;  ///< by Value::bits: the instruction, or kNone
  std::unordered_map<std::uint64_t, std::uint32_t> constant_at_;
};

}  // namespace

Program place_signs(const ValueProgram& program) {
  const std::vector<std::uint32_t> order = live_order(program);
  Program out;
  out.function = program.function;
  out.formulation = program.formulation;
  out.inputs = program.inputs;
  out.code.reserve(order.size());
  Writer writer(program, out, Placement(program, order).run());
  for (const std::uint32_t id : order) writer.write(id);
  for (const auto& output : program.outputs) {
    OutputArray& to = out.outputs.emplace_back();
    to.name = output.name;
    to.rows = output.rows;
    to.columns = output.columns;
    to.values.reserve(output.values.size());
    for (const Value v : output.values) to.values.push_back(writer.get(v));
  }
  return out;
}

}  // namespace alembert
