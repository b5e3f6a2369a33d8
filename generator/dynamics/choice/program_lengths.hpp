// How long the programs of values are. In: lists of expressions. Out: operations of the optimised program of
// each: what counts in the end; and these programs. The same list is optimised once only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "mechanism/model.hpp"
#include "program/lower.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// Operations, trigonometric functions and divisions among them; and those that are no sines and cosines,
/// which other functions may share. For these they are not weighted: by weights, 17 of 542 functions are longer
/// and none is shorter (mass matrix and bias of the knee 254 to 292).
using Length = std::pair<std::size_t, std::size_t>;

/// Lengths of programs over the symbols of one mechanism.
class ProgramLengths {
 public:
  ProgramLengths(const Mechanism& mechanism, ExprGraph& graph);
  Length of(std::span<const Expr> values);
  /// `lowered`, which computes these outputs, as `optimize` leaves it.
  Program optimized(Program lowered, std::span<const OutputExpressions> outputs) const;

 private:
  struct Measured {
    Length length;
    Program program;
  };
  std::vector<SymbolBinding> bindings_;
  std::map<std::vector<std::uint32_t>, Measured> known_;  ///< by the bits of the values
};

}  // namespace alembert
