// A program as expressions again. See to_expressions.hpp.
#include "program/to_expressions.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include "support/operation.hpp"

namespace alembert {
namespace {

std::vector<Expr> outputs_of(const Program& program, ExprGraph& graph) {
  const std::vector<Expr> inputs = input_symbols(program, graph);
  std::vector<Expr> values, roots;
  values.reserve(program.code.size());
  for (const Instruction& c : program.code) {
    if (c.op == Operation::constant)
      values.push_back(graph.real(program.constants[c.a]));
    else if (c.op == Operation::input)
      values.push_back(inputs[c.a]);
    else
      values.push_back(apply(c.op, values[c.a], values[operand_count(c.op) == 2 ? c.b : c.a]));
  }
  for (const OutputArray& output : program.outputs)
    for (const std::uint32_t v : output.values) roots.push_back(values[v]);
  return roots;
}

}  // namespace

std::vector<Expr> input_symbols(const Program& program, ExprGraph& graph) {
  std::vector<Expr> symbols;
  for (std::size_t i = 0; i < program.inputs.size(); ++i)
    symbols.push_back(graph.symbol(fmt::format("input {}", i)));
  return symbols;
}

std::optional<std::vector<Expr>> to_expressions(const Program& program, ExprGraph& graph) {
  try {
    return outputs_of(program, graph);
  } catch (const std::domain_error&) {
    return std::nullopt;
  }
}

}  // namespace alembert
