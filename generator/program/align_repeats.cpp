// Stage `align`: makes parts of a program that do the same do it in the same way. Program in, the same
// operations out, with operands ordered and signs chosen by a rule that looks at the neighbourhood of a value
// only.
//
// `optimise` orders operands by age and places signs by a search over all of the program, so that the steps
// of a recursion along a chain come out as many variants of one pattern. Here the order follows what the
// operands are computed by, a few steps deep, and a sum takes its sign from its first operand. A difference
// with a product by a constant becomes a sum with the constant's negative, as constants may differ between
// repeats.
#include <bit>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "program/operation.hpp"
#include "program/passes.hpp"
#include "program/value_graph.hpp"

namespace alembert {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

// How far below a value its operands decide about order: farther than the steps of one joint's rotation are
// apart, near enough for the ends of a recursion to be soon forgotten.
constexpr int kDepth = 8;

std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

class Aligner {
 public:
  explicit Aligner(const Program& program)
      : values_(to_values(program)),
        graph_(values_.graph),
        order_(live_order(values_)),
        uses_(use_counts(values_, order_)),
        minus_(graph_.size(), 0),
        flipped_(graph_.size(), 0),
        at_(2 * graph_.size(), kNone) {
    out_.function = program.function;
    out_.formulation = program.formulation;
    out_.inputs = program.inputs;
    out_.repeats = true;
  }

  Program run() {
    classify();
    for (const std::uint32_t id : order_) choose_sign(id);
    for (const std::uint32_t id : order_) write(id);
    for (const auto& output : values_.outputs) {
      OutputArray& to = out_.outputs.emplace_back();
      to.name = output.name;
      to.rows = output.rows;
      to.columns = output.columns;
      for (const Value v : output.values) to.values.push_back(get(v));
    }
    return std::move(out_);
  }

 private:
  /// class_[id] says by which operations a value comes about, kDepth deep, whatever the signs and whichever
  /// the inputs and constants.
  void classify() {
    class_.assign(graph_.size(), 0);
    for (const std::uint32_t id : order_) {
      const ValueNode& n = graph_.node(id);
      const std::uint64_t kind =
          n.op == Operation::input ? 64 + static_cast<std::uint64_t>(values_.inputs[n.a.bits].kind) : 0;
      class_[id] = mixed(static_cast<std::uint64_t>(n.op) + kind + 1);
    }
    std::vector<std::uint64_t> next = class_;
    for (int round = 0; round < kDepth; ++round) {
      for (const std::uint32_t id : order_) {
        const ValueNode& n = graph_.node(id);
        const int operands = operand_count(n.op);
        if (operands == 0) continue;
        const std::uint64_t a = class_[n.a.node()], b = operands > 1 ? class_[n.b.node()] : 0;
        const bool symmetric = n.op == Operation::add || n.op == Operation::mul;
        const std::uint64_t both = symmetric ? mixed(a) + mixed(b) : mixed(a) + 3 * mixed(b);
        next[id] = mixed(both ^ (static_cast<std::uint64_t>(n.op) << 56));
      }
      class_.swap(next);
    }
  }

  /// A product by a constant, or a constant, that one sum alone uses: its sign can be chosen.
  bool flexible(Value v) const {
    if (graph_.is_constant(v)) return true;
    const ValueNode& n = graph_.node(v.node());
    return n.op == Operation::mul && uses_[v.node()] == 1 && graph_.is_constant(n.a);
  }

  // Sign of what is computed for v relative to v.
  bool minus(Value v) const { return v.negative() != (minus_[v.node()] != 0); }

  std::pair<Value, Value> ordered(const ValueNode& n) const {
    const std::uint64_t a = class_[n.a.node()], b = class_[n.b.node()];
    return b < a ? std::pair(n.b, n.a) : std::pair(n.a, n.b);
  }

  void flip(Value v) {
    if (graph_.is_constant(v)) return;  // written with the sign it needs
    minus_[v.node()] ^= 1;
    flipped_[v.node()] ^= 1;
  }

  /// minus_[id]: whether the negative of the node is what is computed.
  void choose_sign(std::uint32_t id) {
    const ValueNode& n = graph_.node(id);
    const int operands = operand_count(n.op);
    if (operands == 0) return;
    if (n.op == Operation::add) {
      const auto [first, second] = ordered(n);
      const bool first_free = flexible(first), second_free = flexible(second);
      if (first_free && second_free) {
        if (minus(first)) flip(first);
        if (minus(second)) flip(second);
        minus_[id] = 0;
      } else if (second_free) {
        minus_[id] = minus(first) ? 1 : 0;
        if (minus(second) != minus(first)) flip(second);
      } else if (first_free) {
        minus_[id] = minus(second) ? 1 : 0;
        if (minus(second) != minus(first)) flip(first);
      } else {
        minus_[id] = minus(first) ? 1 : 0;
      }
    } else if (n.op == Operation::mul || n.op == Operation::div) {
      const bool a = !graph_.is_constant(n.a) && minus(n.a), b = !graph_.is_constant(n.b) && minus(n.b);
      minus_[id] = a != b ? 1 : 0;
    } else if (operands == 1 && parity(n.op) == Parity::odd) {
      minus_[id] = !graph_.is_constant(n.a) && minus(n.a) ? 1 : 0;
    }
  }

  void write(std::uint32_t id) {
    const ValueNode& n = graph_.node(id);
    if (n.op == Operation::constant) return;
    const int operands = operand_count(n.op);
    std::uint32_t& at = at_[id << 1 | minus_[id]];
    if (n.op == Operation::input) {
      at = append(Operation::input, n.a.bits);
    } else if (n.op == Operation::add) {
      const auto [first, second] = ordered(n);
      const bool sign = minus_[id] != 0;
      const std::uint32_t a = computed(first, sign);
      // The second operand as it is to be added: a constant, or what there is, subtracted if need be.
      if (graph_.is_constant(second)) {
        const std::uint32_t b = get(second.negated_if(sign));
        at = append(Operation::add, a, b);
      } else {
        const std::uint32_t b = at_[second.node() << 1 | minus_[second.node()]];
        at = append(minus(second) == sign ? Operation::add : Operation::sub, a, b);
      }
    } else if (n.op == Operation::mul || n.op == Operation::div) {
      const auto [first, second] = n.op == Operation::mul ? ordered(n) : std::pair(n.a, n.b);
      const std::uint32_t a = factor(first, flipped_[id] != 0);
      const std::uint32_t b = factor(second, flipped_[id] != 0);
      at = append(n.op, a, b);
    } else if (operands == 1 && parity(n.op) != Parity::none) {
      const std::uint32_t a = graph_.is_constant(n.a) ? get(n.a) : at_[n.a.node() << 1 | minus_[n.a.node()]];
      at = append(n.op, a);
    } else {
      const std::uint32_t a = get(n.a);
      const std::uint32_t b = operands == 2 ? get(n.b) : 0;
      at = append(n.op, a, b);
    }
  }

  /// First operand of a sum whose negative is computed if `sign`.
  std::uint32_t computed(Value v, bool sign) {
    return graph_.is_constant(v) ? get(v.negated_if(sign)) : at_[v.node() << 1 | minus_[v.node()]];
  }

  std::uint32_t factor(Value v, bool flipped) {
    return graph_.is_constant(v) ? get(v.negated_if(flipped)) : at_[v.node() << 1 | minus_[v.node()]];
  }

  /// Index of the instruction that computes v, appending a constant or a negation where there is none yet.
  std::uint32_t get(Value v) {
    if (graph_.is_constant(v)) return constant(graph_.constant_value(v));
    std::uint32_t& index = at_[v.bits];
    if (index == kNone) index = append(Operation::neg, at_[(-v).bits]);
    return index;
  }

  std::uint32_t append(Operation op, std::uint32_t a, std::uint32_t b = 0) {
    out_.code.push_back({op, a, b});
    return static_cast<std::uint32_t>(out_.code.size() - 1);
  }

  std::uint32_t constant(double value) {
    if (value == 0) value = 0;  // never -0
    const auto [entry, fresh] = constant_at_.try_emplace(std::bit_cast<std::uint64_t>(value), 0);
    if (fresh) {
      out_.constants.push_back(value);
      entry->second = append(Operation::constant, static_cast<std::uint32_t>(out_.constants.size() - 1));
    }
    return entry->second;
  }

  const ValueProgram values_;
  const ValueGraph& graph_;
  const std::vector<std::uint32_t> order_, uses_;
  std::vector<std::uint64_t> class_;
  std::vector<std::uint8_t> minus_, flipped_;
  std::vector<std::uint32_t> at_;  ///< by Value::bits: the instruction, or kNone
  std::unordered_map<std::uint64_t, std::uint32_t> constant_at_;
  Program out_;
};

}  // namespace

Program align_repeats(const Program& program) {
  return Aligner(program).run();
}

}  // namespace alembert
