// Whether equal expressions are as exact in double precision. In: what is given, and what may take its place.
// Out: whether rounding errors stay of the same size, near 0 and far from it.
#pragma once

#include <span>
#include <vector>

#include "symbolic/expr.hpp"

namespace alembert {

/// Values of all symbols near and far, within their bounds.
std::vector<std::vector<double>> points_near_and_far(ExprGraph& graph);

/// Whether what was found with such an error is as exact as what is given, or nearly.
bool is_as_exact(const Approximate& found, const Approximate& given);

/// Compares lists of equal roots with the one that is given. Multiplied out, functions that hardly change far
/// from 0 are differences of large numbers: such a list is not as exact.
class Exactness {
 public:
  explicit Exactness(std::span<const Expr> given) : roots_(given.begin(), given.end()) {}
  bool keeps(std::span<const Expr> roots);

 private:
  std::vector<Expr> roots_;
  std::vector<std::vector<double>> points_;
  std::vector<std::vector<Approximate>> given_;
};

}  // namespace alembert
