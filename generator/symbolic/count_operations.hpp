// Counting. In: roots. Out: operations, what roots share counted once.
#pragma once

#include <cstddef>
#include <span>

#include "symbolic/expr.hpp"

namespace alembert {

/// Operations of a set of roots, each node counted once: adds, muls, divs, trig, other; signs and 2x as in
/// `program/count`.
struct ExprCount {
  std::size_t add = 0, mul = 0, div = 0, trig = 0, other = 0;
  std::size_t total() const { return add + mul + div + other; }
};
ExprCount count_operations(std::span<const Expr> roots);

}  // namespace alembert
