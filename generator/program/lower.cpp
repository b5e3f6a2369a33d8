// Stage `lower` (see the header). Each node becomes one value, each constant one double.
//
// Besides `verify` the only stage of this room that knows expressions. The order of everything follows
// `postorder`, which is structural, so that the program does not depend on the order in which the expressions
// were built.
#include "program/lower.hpp"

#include <bit>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "program/sign_placement.hpp"
#include "support/error.hpp"
#include "support/no_index.hpp"
#include "support/operation.hpp"
#include "symbolic/postorder.hpp"
#include "symbolic/round_constants.hpp"

namespace alembert {
namespace {

class Writer {
 public:
  Writer(std::span<const Expr> roots, const Postorder& order, Program& to)
      : graph_(roots.front().graph()),
        order_(order),
        constants_(graph_, order),
        negative_(place_signs(roots, order)),
        to_(to),
        at_(2 * order.ids.size(), kNoIndex) {}

  /// `slot`: of the symbol, where the node is one.
  void write(std::uint32_t id, std::uint32_t slot) {
    const Node& n = graph_.node(order_.ids[id]);
    if (n.constant) return;
    const LocalOperands from = order_.operands[id];
    const bool flip = negative_[id] != 0;
    if (n.op == Operation::symbol) {
      at_[id << 1] = append(Operation::input, slot);
    } else if (n.op == Operation::add) {
      write_sum(id, from, flip);
    } else if (n.op == Operation::mul || n.op == Operation::div) {
      write_product(id, n.op, from, flip);
    } else if (parity(n.op) == Parity::odd) {
      const std::uint32_t sign = pick(from.a, flip);
      at_[id << 1 | sign] = append(n.op, get(from.a ^ sign));
    } else if (parity(n.op) == Parity::even) {
      const std::uint32_t sign = pick(from.a, false);
      at_[id << 1] = append(n.op, get(from.a ^ sign));
    } else {
      const std::uint32_t a = get(from.a);
      const std::uint32_t b = n.arity() == 2 ? get(from.b) : 0;
      at_[id << 1] = append(n.op, a, b);
    }
  }

  /// The instruction that computes a node with a sign, as Postorder tells them; a constant or a negation is
  /// appended where there is none yet.
  std::uint32_t get(std::uint32_t v) {
    if (is_constant(v)) return constant(constants_.rounded(v));
    std::uint32_t& index = at_[v];
    if (index == kNoIndex) index = append(Operation::neg, at_[v ^ 1]);
    return index;
  }

 private:
  bool is_constant(std::uint32_t v) const { return graph_.node(order_.ids[v >> 1]).constant; }
  bool has(std::uint32_t v) const { return is_constant(v) || at_[v] != kNoIndex; }
  // The sign in which to take v: the preferred one unless only the other exists.
  std::uint32_t pick(std::uint32_t v, std::uint32_t preferred) const {
    return has(v ^ preferred) ? preferred : preferred ^ 1;
  }

  void write_sum(std::uint32_t id, LocalOperands n, std::uint32_t flip) {
    if (is_constant(n.b)) std::swap(n.a, n.b);
    if (is_constant(n.a)) {
      const std::uint32_t other = pick(n.b, flip);  // b enters as x = (other ? -b : b)
      const double c = constants_.rounded(n.a ^ flip);
      const std::uint32_t x = get(n.b ^ other);
      if (other != flip) {
        const std::uint32_t k = constant(c);
        store(id, flip, Operation::sub, k, x);
      } else {
        const std::uint32_t k = constant(std::abs(c));
        store(id, flip, c < 0 ? Operation::sub : Operation::add, x, k);
      }
      return;
    }
    // Of a + b with the signs that exist: prefer a result with the wanted sign, then one without a negation.
    for (const std::uint32_t sign : {flip, flip ^ 1}) {
      const std::uint32_t a = n.a ^ sign, b = n.b ^ sign;
      if (has(a) && has(b)) return store(id, sign, Operation::add, get(a), get(b));
      if (has(a) && has(b ^ 1)) return store(id, sign, Operation::sub, get(a), get(b ^ 1));
      if (has(a ^ 1) && has(b)) return store(id, sign, Operation::sub, get(b), get(a ^ 1));
    }
  }

  void write_product(std::uint32_t id, Operation op, LocalOperands n, std::uint32_t flip) {
    if (op == Operation::mul && is_constant(n.a) && constants_.rounded(n.a) == 2 && has(n.b ^ flip)) {
      const std::uint32_t x = get(n.b ^ flip);
      return store(id, flip, Operation::add, x, x);
    }
    std::uint32_t sign_a = pick(n.a, 0), sign_b = pick(n.b, 0);
    if (is_constant(n.a)) {
      sign_a = flip ^ sign_b;
    } else if (is_constant(n.b)) {
      sign_b = flip ^ sign_a;
    } else if ((sign_a ^ sign_b) != flip) {
      if (has(n.a ^ sign_a ^ 1))
        sign_a ^= 1;
      else if (has(n.b ^ sign_b ^ 1))
        sign_b ^= 1;
    }
    const std::uint32_t a = get(n.a ^ sign_a);
    const std::uint32_t b = get(n.b ^ sign_b);
    store(id, sign_a ^ sign_b, op, a, b);
  }

  void store(std::uint32_t id, std::uint32_t sign, Operation op, std::uint32_t a, std::uint32_t b) {
    at_[id << 1 | sign] = append(op, a, b);
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

  ExprGraph& graph_;
  const Postorder& order_;
  ConstantValues constants_;
  std::vector<std::uint8_t> negative_;
  Program& to_;
  std::vector<std::uint32_t> at_;  ///< by position and sign: the instruction, or kNoIndex
  std::unordered_map<std::uint64_t, std::uint32_t> constant_at_;
};

}  // namespace

std::vector<Expr> elements(std::span<const OutputExpressions> outputs) {
  std::vector<Expr> out;
  for (const OutputExpressions& output : outputs)
    out.insert(out.end(), output.values.begin(), output.values.end());
  return out;
}

std::vector<OutputExpressions> with_elements(std::span<const OutputExpressions> outputs,
                                             std::span<const Expr> elements) {
  std::vector<OutputExpressions> out(outputs.begin(), outputs.end());
  auto next = elements.begin();
  for (OutputExpressions& output : out)
    for (Expr& value : output.values) value = *next++;
  return out;
}

Program lower(std::string function, std::span<const OutputExpressions> outputs,
              std::span<const SymbolBinding> bindings) {
  Program program;
  program.function = std::move(function);
  for (const SymbolBinding& binding : bindings) program.inputs.push_back(binding.slot);

  for (const OutputExpressions& output : outputs) {
    program.outputs.push_back({output.name, output.rows, output.columns, {}});
    if (output.values.size() != std::size_t{output.rows} * output.columns)
      throw InternalError("lower: output " + output.name + " of " + program.function + " has " +
                          std::to_string(output.values.size()) + " elements, not rows x columns");
  }
  const std::vector<Expr> roots = round_constants(elements(outputs));
  if (roots.empty()) return program;
  const ExprGraph& graph = roots.front().graph();
  std::vector<std::uint32_t> slot_of(graph.symbol_count(), kNoIndex);
  for (std::uint32_t i = 0; i < bindings.size(); ++i)
    slot_of[graph.symbol_index(bindings[i].symbol.ref().node())] = i;

  const Postorder order = indexed_postorder(roots);
  program.code.reserve(order.ids.size());
  Writer writer(roots, order, program);
  for (std::uint32_t i = 0; i < order.ids.size(); ++i) {
    std::uint32_t slot = kNoIndex;
    if (graph.node(order.ids[i]).op == Operation::symbol) {
      const std::uint32_t index = graph.symbol_index(order.ids[i]);
      slot = slot_of[index];
      if (slot == kNoIndex)
        throw InternalError("lower: " + program.function + " depends on the symbol '" +
                            graph.symbol_name(index) + "', which no argument stands for");
    }
    writer.write(i, slot);
  }
  auto root = roots.begin();
  for (OutputArray& output : program.outputs) {
    for (std::size_t k = std::size_t{output.rows} * output.columns; k > 0; --k)
      output.values.push_back(writer.get(order.local((root++)->ref())));
  }
  return program;
}

Program without_unused_inputs(Program program) {
  std::vector<std::uint32_t> place(program.inputs.size(), 0);
  for (const Instruction& i : program.code) {
    if (i.op == Operation::input) place[i.a] = 1;
  }
  std::vector<InputSlot> used;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i] == 0) continue;
    place[i] = static_cast<std::uint32_t>(used.size());
    used.push_back(program.inputs[i]);
  }
  for (Instruction& i : program.code) {
    if (i.op == Operation::input) i.a = place[i.a];
  }
  program.inputs = std::move(used);
  return program;
}

}  // namespace alembert
