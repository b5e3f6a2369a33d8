// Part of stage `verify`: a program against its expressions modulo a large prime. See exact_comparison.hpp.
#include "program/verify/exact_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "symbolic/evaluate_modular.hpp"
#include "symbolic/postorder.hpp"
#include "symbolic/rational.hpp"

namespace alembert {
namespace {

// Products and sums of a few such numbers are exact in double, so that folding has not rounded them.
bool is_short_binary(double x) {
  return std::abs(x) <= 0x1p12 && x * 0x1p12 == std::floor(x * 0x1p12);
}

// Numbers that are no fractions are rounded, and functions beside the circle are opaque or have poles.
bool is_exact(Operation op) {
  const FieldValue field = facts(op).field;
  return op != Operation::pi_multiple && op != Operation::real &&
         (field == FieldValue::exact || field == FieldValue::sine || field == FieldValue::cosine);
}

bool are_exact(std::span<const Expr> roots) {
  const ExprGraph& graph = roots.front().graph();
  for (const std::uint32_t id : postorder(roots)) {
    const Operation op = graph.node(id).op;
    if (!is_exact(op)) return false;
    if (op != Operation::rational) continue;
    const Rational r = graph.rational_value(id);
    if (!is_short_binary(r.to_double()) || (r.denominator & (r.denominator - 1)) != 0) return false;
  }
  return true;
}

}  // namespace

ExactComparison compare_exactly(const Program& program, std::span<const Expr> roots,
                                std::span<const SymbolBinding> bindings) {
  if (roots.empty() || !are_exact(roots)) return {};
  for (const double x : program.constants)
    if (!is_short_binary(x)) return {};
  const auto inexact = [](const Instruction& c) { return !is_leaf(c.op) && !is_exact(c.op); };
  if (std::ranges::any_of(program.code, inexact)) return {};

  const ExprGraph& graph = roots.front().graph();
  const std::vector<Modular> point = random_modular_point(graph.symbol_count(), 1);
  const std::vector<Modular> wanted = evaluate_modular(roots, point);
  std::vector<Modular> values;
  for (const Instruction& c : program.code) {
    if (c.op == Operation::constant)
      values.push_back(modular::from_rational(*rational_from_double(program.constants[c.a])));
    else if (c.op == Operation::input)
      values.push_back(point[graph.symbol_index(bindings[c.a].symbol.ref().node())]);
    else
      values.push_back(modular::apply(c.op, values[c.a], values[operand_count(c.op) == 2 ? c.b : c.a]));
  }
  std::size_t k = 0;
  for (const OutputArray& output : program.outputs) {
    for (const std::uint32_t v : output.values) {
      if (!(wanted[k] == values[v])) return {true, k, values[v], wanted[k]};
      ++k;
    }
  }
  return {true, roots.size(), {}, {}};
}

}  // namespace alembert
