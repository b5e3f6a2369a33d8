// Stages on programs: lower, optimise, schedule, interpret, count, verify, dump. Each is a loop over instructions.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "program/program.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// What the symbols of a graph stand for: slot of symbol index i, used by `lower`.
struct SymbolBinding {
  Expr symbol;
  InputSlot slot;
};

/// One result array as expressions.
struct OutputExpressions {
  std::string name;
  std::uint32_t rows = 0, columns = 1;
  std::vector<Expr> values;
};

/// Stage `lower`: expressions to binary operations, constants folded to double, depth first from the outputs in their order.
/// Throws InternalError if an output depends on a symbol that is not bound.
Program lower(std::string function, std::span<const OutputExpressions> outputs, std::span<const SymbolBinding> bindings);

/// Stage `optimise`: local rewrites (a*b + a*c -> a*(b+c) with single-use products, shared reciprocals, sign placement, constant
/// folding, value numbering); each accepted only if it lowers the count, so the result never has more operations.
Program optimize(Program program);

/// Stage `schedule`: orders instructions depth first from the outputs, sin and cos of one argument adjacent. Same values.
Program schedule(Program program);

OperationCount count(const Program& program);

/// Values of all inputs, in the order of program.inputs, to values of all outputs, concatenated in order.
/// Scratch is resized on first use.
void interpret(const Program& program, std::span<const double> inputs, std::span<double> outputs, std::vector<double>& scratch);

/// Stage `verify`: the program agrees with the expressions it came from at random points, or InternalError with function, output and error.
void verify(const Program& program, std::span<const OutputExpressions> outputs, std::span<const SymbolBinding> bindings);

/// One instruction a line, for --dump.
std::string dump(const Program& program);

}  // namespace alembert
