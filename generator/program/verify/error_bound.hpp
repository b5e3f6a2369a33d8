// Errors of the operations of programs. See symbolic/error_bound.hpp.
#pragma once

#include <array>
#include <cstddef>

#include "program/expression_operation.hpp"
#include "symbolic/error_bound.hpp"

namespace alembert {

/// Error of `result` = op(a, b), as that of the expression's operation that this one computes.
inline double error_bound(Operation op, Approximate a, Approximate b, double result) {
  static constexpr auto kOpOf = [] {
    std::array<Op, static_cast<std::size_t>(Operation::pow) + 1> table{};
    for (int i = 0; i < kOpCount; ++i)
      table[static_cast<std::size_t>(operation_of(static_cast<Op>(i)))] = static_cast<Op>(i);
    // Signs change no error.
    table[static_cast<std::size_t>(Operation::sub)] = Op::add;
    table[static_cast<std::size_t>(Operation::neg)] = Op::abs;
    return table;
  }();
  return error_bound(kOpOf[static_cast<std::size_t>(op)], a, b, result);
}

}  // namespace alembert
