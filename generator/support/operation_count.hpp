// Operation counts: operations of a program or of expressions in, how many there are of each kind and what they
// weigh together out.
#pragma once

#include <cstddef>

#include "support/operation.hpp"

namespace alembert {

/// Counting convention: subtractions are adds; negation and multiplication by +-1 are free; 2x is one add;
/// divisions and sin/cos/tan are listed apart (a constant offset inside a sin/cos argument belongs to that
/// call and counts nowhere else: sin(q + c) is one trig); everything that is computed from constants alone is
/// folded. `other`: sqrt, exp, pow, ...
struct OperationCount {
  std::size_t mul = 0, add = 0, div = 0, trig = 0, other = 0;
  std::size_t weight = 0;  ///< the sum of their weights in the table of operations
  std::size_t arithmetic() const { return mul + add; }
  /// Without sines, cosines and tangents, which other functions may share.
  std::size_t total() const { return mul + add + div + other; }
  std::size_t all() const { return total() + trig; }

  /// One more operation, which is no product with 1; `doubles`: it is 2x.
  void include(Operation op, bool doubles = false) {
    switch (facts(op).counted) {
      case Counted::free:
        break;
      case Counted::add:
        ++add;
        break;
      case Counted::mul:
        ++(doubles ? add : mul);
        break;
      case Counted::div:
        ++div;
        break;
      case Counted::trig:
        ++trig;
        break;
      case Counted::other:
        ++other;
        break;
    }
    weight += facts(op).weight;
  }
};

}  // namespace alembert
