// Stages on programs: lower, optimise, schedule, interpret, count, verify, dump. Each is a loop over
// instructions.
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
  double unit = 1;  ///< its values are about that large
};

/// One result array as expressions.
struct OutputExpressions {
  std::string name;
  std::uint32_t rows = 0, columns = 1;
  std::vector<Expr> values;
  friend bool operator==(const OutputExpressions&, const OutputExpressions&) = default;
};

/// Stage `lower`: expressions to binary operations, depth first from the outputs in their order; the same for
/// the same expressions in whatever order they were built. Constant subexpressions become one double each,
/// folded in extended precision; 2x is x + x; signs are placed so that few negations remain. Input i of the
/// program is binding i, also where nothing needs it. Throws InternalError if an output depends on a symbol
/// that is not bound, has not rows x columns elements, or holds a constant without a finite value.
Program lower(std::string function, std::span<const OutputExpressions> outputs,
              std::span<const SymbolBinding> bindings);

/// Stage `optimise`: value numbering, constant folding and sign placement, a*b + a*c -> a*(b + c) with
/// single-use products, shared reciprocals and merged quotients (rewrites.hpp); each kept only if it lowers
/// mul + add + 4 div + trig + other, so that the result never costs more. Values change by rounding only,
/// except that 0*x and x - x are 0 whatever x is.
Program optimize(Program program);

/// Stage `schedule`: orders instructions depth first from the outputs, sin and cos of one argument adjacent,
/// and drops those that no output needs. Same values, bit for bit.
Program schedule(Program program);

/// After `schedule`: results that are dot products of the rows of two tables, as the far entries of a mass
/// matrix are, move to the end of the code and into `dot_products`. Only if there are `least` or more, in
/// long enough runs to be worth a loop; otherwise the program stays as it is. Same operations; sums may be
/// rounded in another order.
Program gather_dot_products(const Program& program, std::size_t least);

/// Stage `reroll`, after `schedule` and gathering: steps that repeat on other values, as those of a
/// recursion along a chain, become iterations of loops; the rest stays straight code around them. Same
/// operations; sums and products of three or more may be rounded in another order, signs are placed anew, and
/// negations may be more. Without such steps the program stays as it is.
Program reroll(const Program& program);

/// How many additions and multiplications a program has in loops over steps.
std::size_t operations_in_loops(const Program& program);

/// How many dot products a program has in loops.
std::size_t dot_products(const Program& program);

/// Stage `count`: operations by the convention at `OperationCount`.
OperationCount count(const Program& program);

/// The value of a function of the C library at one operand or two.
using FunctionValue = double (*)(Operation, double, double);

/// Values of all inputs, in the order of program.inputs, to values of all outputs, concatenated in order.
/// Each instruction is one rounding to double, as in code compiled with -ffp-contract=off. Scratch is resized
/// on first use and holds the values of all instructions after. `function` stands in for the C library, whose
/// roundings differ between machines. Throws InternalError if a span has the wrong size.
void interpret(const Program& program, std::span<const double> inputs, std::span<double> outputs,
               std::vector<double>& scratch, FunctionValue function = nullptr);

/// Stage `verify`: throws InternalError, with function, output, element and both values, unless the program
/// is well formed and agrees with the expressions it came from: at eight or more random points inside the
/// symbols' ranges and about as large as their units, within running error bounds, and modulo a large prime
/// where both sides are exact. An element whose expression has no finite value at any point tried is not
/// compared.
void verify(const Program& program, std::span<const OutputExpressions> outputs,
            std::span<const SymbolBinding> bindings);

/// One instruction a line, then results and loops, for --dump.
std::string dump(const Program& program);

}  // namespace alembert
