// Part of stage `verify`: a program against its expressions modulo a large prime, where nothing is rounded
// and so no cancellation hides a difference. In: a program, expressions and the inputs' symbols. Out: whether
// they can be compared so, and the first difference.
#pragma once

#include <cstddef>
#include <span>

#include "program/lower.hpp"
#include "symbolic/modular.hpp"

namespace alembert {

struct ExactComparison {
  bool possible = false;             ///< both sides are exact
  std::size_t first_difference = 0;  ///< index of a root, or the number of roots if all agree
  Modular found, wanted;             ///< by the program and by the expression, where they differ
};

/// Compares at a random point if both sides consist of + - * / sqrt sin cos of inputs and short binary
/// fractions: then folding has rounded nothing, and every value exists in the field. The elements of all
/// outputs are `roots`, in order.
ExactComparison compare_exactly(const Program& program, std::span<const Expr> roots,
                                std::span<const SymbolBinding> bindings);

}  // namespace alembert
