// Part of stage `verify`: a program against its expressions modulo a large prime. See exact_comparison.hpp.
#include "program/exact_comparison.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace alembert {
namespace {

// Products and sums of a few such numbers are exact in double, so that folding has not rounded them.
bool is_short_binary(double x) {
  return std::abs(x) <= 0x1p12 && x * 0x1p12 == std::floor(x * 0x1p12);
}

bool is_exact(Op op) {
  switch (op) {
    case Op::rational:
    case Op::symbol:
    case Op::add:
    case Op::mul:
    case Op::div:
    case Op::sqrt:
    case Op::sin:
    case Op::cos:
      return true;
    case Op::pi_multiple:
    case Op::real:
    case Op::tan:
    case Op::asin:
    case Op::acos:
    case Op::atan:
    case Op::atan2:
    case Op::exp:
    case Op::log:
    case Op::abs:
    case Op::sign:
    case Op::sinh:
    case Op::cosh:
    case Op::tanh:
    case Op::pow:
      return false;
  }
  return false;
}

bool are_exact(std::span<const Expr> roots) {
  const ExprGraph& graph = roots.front().graph();
  for (const std::uint32_t id : postorder(roots)) {
    const Op op = graph.node(id).op;
    if (!is_exact(op)) return false;
    if (op != Op::rational) continue;
    const Rational r = graph.rational_value(id);
    if (!is_short_binary(r.to_double()) || (r.denominator & (r.denominator - 1)) != 0) return false;
  }
  return true;
}

/// The program's outputs as expressions of a graph of its own, whose symbol i is input i; nothing if one is
/// not exact.
std::optional<std::vector<Expr>> as_expressions(const Program& program, ExprGraph& graph) {
  std::vector<Expr> inputs, values, roots;
  for (std::size_t i = 0; i < program.inputs.size(); ++i)
    inputs.push_back(graph.symbol(fmt::format("input {}", i)));
  values.reserve(program.code.size());
  for (const Instruction& c : program.code) {
    switch (c.op) {
      case Operation::constant:
        if (!is_short_binary(program.constants[c.a])) return std::nullopt;
        values.push_back(graph.real(program.constants[c.a]));
        break;
      case Operation::input:
        values.push_back(inputs[c.a]);
        break;
      case Operation::add:
        values.push_back(values[c.a] + values[c.b]);
        break;
      case Operation::sub:
        values.push_back(values[c.a] - values[c.b]);
        break;
      case Operation::mul:
        values.push_back(values[c.a] * values[c.b]);
        break;
      case Operation::div:
        if (values[c.b].is_zero()) return std::nullopt;
        values.push_back(values[c.a] / values[c.b]);
        break;
      case Operation::neg:
        values.push_back(-values[c.a]);
        break;
      case Operation::sqrt:
        values.push_back(sqrt(values[c.a]));
        break;
      case Operation::sin:
        values.push_back(sin(values[c.a]));
        break;
      case Operation::cos:
        values.push_back(cos(values[c.a]));
        break;
      case Operation::tan:
      case Operation::asin:
      case Operation::acos:
      case Operation::atan:
      case Operation::atan2:
      case Operation::exp:
      case Operation::log:
      case Operation::abs:
      case Operation::sign:
      case Operation::sinh:
      case Operation::cosh:
      case Operation::tanh:
      case Operation::pow:
        return std::nullopt;
    }
  }
  for (const OutputArray& output : program.outputs)
    for (const std::uint32_t v : output.values) roots.push_back(values[v]);
  if (!are_exact(roots)) return std::nullopt;  // construction may simplify to |x|, say
  return roots;
}

}  // namespace

ExactComparison compare_exactly(const Program& program, std::span<const Expr> roots,
                                std::span<const SymbolBinding> bindings) {
  if (!are_exact(roots)) return {};
  ExprGraph program_graph;
  const std::optional<std::vector<Expr>> program_roots = as_expressions(program, program_graph);
  if (!program_roots) return {};

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
