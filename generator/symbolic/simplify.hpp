// Simplification. In: roots. Out: equal ones that need no more operations.
#pragma once

#include <span>
#include <vector>

#include "symbolic/expr.hpp"

namespace alembert {

/// Equal roots, smaller: sin^2+cos^2 with common factors, common factors of sums, like terms, sqrt of squares
/// under proven sign, cancellation of quotients. The set never needs more operations than it was given.
/// Throws std::domain_error if a divisor turns out to be zero everywhere.
std::vector<Expr> simplify(std::span<const Expr> roots);

/// While one lives, `simplify` gives the roots of its graph as they are: what is written is measured against what
/// stands in the description.
class LeftAsWritten {
 public:
  explicit LeftAsWritten(ExprGraph& graph) : graph_(graph), before_(graph.simplifies()) {
    graph_.set_simplifies(false);
  }
  ~LeftAsWritten() { graph_.set_simplifies(before_); }
  LeftAsWritten(const LeftAsWritten&) = delete;
  LeftAsWritten& operator=(const LeftAsWritten&) = delete;

 private:
  ExprGraph& graph_;
  bool before_;
};

}  // namespace alembert
