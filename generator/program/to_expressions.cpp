// A program as expressions again. See to_expressions.hpp.
#include "program/to_expressions.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include "program/operation.hpp"

namespace alembert {
namespace {

Expr function_of(Operation op, Expr a, Expr b) {
  switch (op) {
    case Operation::add:
      return a + b;
    case Operation::sub:
      return a - b;
    case Operation::mul:
      return a * b;
    case Operation::div:
      return a / b;
    case Operation::neg:
      return -a;
    case Operation::sqrt:
      return sqrt(a);
    case Operation::sin:
      return sin(a);
    case Operation::cos:
      return cos(a);
    case Operation::tan:
      return tan(a);
    case Operation::asin:
      return asin(a);
    case Operation::acos:
      return acos(a);
    case Operation::atan:
      return atan(a);
    case Operation::atan2:
      return atan2(a, b);
    case Operation::exp:
      return exp(a);
    case Operation::log:
      return log(a);
    case Operation::abs:
      return abs(a);
    case Operation::sign:
      return sign(a);
    case Operation::sinh:
      return sinh(a);
    case Operation::cosh:
      return cosh(a);
    case Operation::tanh:
      return tanh(a);
    case Operation::pow:
      return pow(a, b);
    case Operation::constant:
    case Operation::input:
      break;
  }
  return a;
}

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
      values.push_back(function_of(c.op, values[c.a], operand_count(c.op) == 2 ? values[c.b] : Expr()));
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
