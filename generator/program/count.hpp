// Stage `count`: a program in, its operations out.
#pragma once

#include <cstddef>

#include "program/program.hpp"

namespace alembert {

/// Counting convention: subtractions are adds; negation and multiplication by +-1 are free; 2x is one add;
/// divisions and sin/cos/tan are listed apart (a constant offset inside a sin/cos argument belongs to that
/// call and counts nowhere else: sin(q + c) is one trig); everything that is computed from constants alone is
/// folded. `other`: sqrt, exp, pow, ...
struct OperationCount {
  std::size_t mul = 0, add = 0, div = 0, trig = 0, other = 0;
  std::size_t arithmetic() const { return mul + add; }
};

/// Stage `count`: operations by the convention at `OperationCount`.
OperationCount count(const Program& program);

}  // namespace alembert
