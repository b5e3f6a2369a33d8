// Tables that are straight between their knots. In: knots and values. Out: the table's value at an argument as
// one expression without branches. The first and the last piece go on beyond the ends.
#pragma once

#include <span>
#include <vector>

#include "mechanism/cubic_spline.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

class PiecewiseLinear {
 public:
  /// At least two knots, strictly increasing as doubles, and as many values. Throws std::domain_error if a
  /// slope is not finite.
  PiecewiseLinear(std::span<const ConstantNumber> knots, std::span<const ConstantNumber> values);

  Expr operator()(const Expr& x) const;
  double operator()(double x) const;

 private:
  std::vector<ConstantNumber> knots_, values_;
  std::vector<ConstantNumber> slopes_;  ///< from each knot to the next
};

}  // namespace alembert
