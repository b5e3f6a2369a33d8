// Programs and arrays of expressions as `optimize` leaves them, for tests.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "program/lower.hpp"
#include "program/program.hpp"
#include "support/error.hpp"
#include "support/operation.hpp"
#include "symbolic/rewrite/optimize.hpp"

namespace alembert {

/// The same arrays with optimised elements.
inline std::vector<OutputExpressions> optimized(const std::vector<OutputExpressions>& outputs) {
  return with_elements(outputs, optimize(elements(outputs)));
}

/// The arrays of a program as expressions, bracketed as they are computed; `symbols` are its inputs. Throws
/// std::domain_error where expressions refuse an operation: a division by zero, say.
inline std::vector<OutputExpressions> expressions_of(const Program& program, const std::vector<Expr>& symbols,
                                                     ExprGraph& graph) {
  const auto kept = graph.keep_brackets();
  std::vector<Expr> values;
  for (const Instruction& c : program.code) {
    if (c.op == Operation::constant)
      values.push_back(graph.real(program.constants[c.a]));
    else if (c.op == Operation::input)
      values.push_back(symbols[c.a]);
    else
      values.push_back(apply(c.op, values[c.a], values[operand_count(c.op) == 2 ? c.b : c.a]));
  }
  std::vector<OutputExpressions> outputs;
  for (const OutputArray& output : program.outputs) {
    outputs.push_back({output.name, output.rows, output.columns, {}});
    for (const std::uint32_t v : output.values) outputs.back().values.push_back(values[v]);
  }
  return outputs;
}

/// The program by way of expressions; as it is where expressions refuse one of its operations, or a constant
/// has no finite value.
inline Program optimized(const Program& program) {
  ExprGraph graph;
  std::vector<SymbolBinding> bindings;
  std::vector<Expr> symbols;
  for (std::size_t i = 0; i < program.inputs.size(); ++i) {
    symbols.push_back(graph.symbol(fmt::format("input {}", i)));
    bindings.push_back({symbols.back(), program.inputs[i]});
  }
  try {
    Program out = lower(program.function, optimized(expressions_of(program, symbols, graph)), bindings);
    out.formulation = program.formulation;
    return out;
  } catch (const std::domain_error&) {
    return program;
  } catch (const InternalError&) {
    return program;
  }
}

}  // namespace alembert
