// Part of stage `verify`: a program against its expressions modulo a large prime. See exact_comparison.hpp.
#include "program/verify/exact_comparison.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "program/to_expressions.hpp"
#include "symbolic/evaluate_modular.hpp"
#include "symbolic/postorder.hpp"

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
  ExprGraph program_graph;
  const std::optional<std::vector<Expr>> program_roots = to_expressions(program, program_graph);
  if (!program_roots || !are_exact(*program_roots)) return {};

  const ExprGraph& graph = roots.front().graph();
  const std::vector<Modular> point = random_modular_point(graph.symbol_count(), 1);
  std::vector<Modular> program_point;
  for (const SymbolBinding& binding : bindings)
    program_point.push_back(point[graph.symbol_index(binding.symbol.ref().node())]);
  const std::vector<Modular> wanted = evaluate_modular(roots, point);
  const std::vector<Modular> found = evaluate_modular(*program_roots, program_point);
  for (std::size_t k = 0; k < roots.size(); ++k)
    if (!(wanted[k] == found[k])) return {true, k, found[k], wanted[k]};
  return {true, roots.size(), {}, {}};
}

}  // namespace alembert
