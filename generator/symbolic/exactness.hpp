// Whether equal expressions are as exact in double precision. In: what is given, and what may take its place.
// Out: whether rounding errors stay of the same size, near 0 and far from it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "symbolic/expr.hpp"

namespace alembert {

/// Values of all symbols near and far, within their bounds.
std::vector<std::vector<double>> points_near_and_far(ExprGraph& graph);

/// Whether what was found with such an error is as exact as what is given, or nearly.
bool is_as_exact(const Approximate& found, const Approximate& given);

/// Compares equal roots with those that are given. A function that hardly changes far from 0, multiplied out, is a
/// difference of large numbers there, and not as exact.
class Exactness {
 public:
  explicit Exactness(std::span<const Expr> given) : roots_(given.begin(), given.end()) {}
  /// `first`: the place of the first of these among those given.
  bool keeps(std::span<const Expr> roots, std::size_t first = 0);

 private:
  std::vector<Expr> roots_;
  std::vector<std::vector<double>> points_;
  std::vector<std::vector<Approximate>> given_;
};

}  // namespace alembert
