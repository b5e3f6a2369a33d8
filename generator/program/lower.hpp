// Stage `lower`: expressions in, a straight-line program out.
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

/// Elements of all arrays, in order.
std::vector<Expr> elements(std::span<const OutputExpressions> outputs);
/// The same arrays with other elements.
std::vector<OutputExpressions> with_elements(std::span<const OutputExpressions> outputs,
                                             std::span<const Expr> elements);

/// Stage `lower`: expressions to instructions, depth first from the outputs in their order; the same for the
/// same expressions in whatever order they were built. Constants become doubles (`round_constants`); 2x is
/// x + x; signs are placed so that few negations remain. Input i of the program is binding i, also where
/// nothing needs it. Throws InternalError if an output depends on a symbol that is not bound, has not rows x
/// columns elements, or holds a constant without a finite value.
Program lower(std::string function, std::span<const OutputExpressions> outputs,
              std::span<const SymbolBinding> bindings);

/// Programs are lowered with every argument that there is; what a function does not use is no argument of it.
Program without_unused_inputs(Program program);

}  // namespace alembert
