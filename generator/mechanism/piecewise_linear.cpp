#include "mechanism/piecewise_linear.hpp"

#include <algorithm>

namespace alembert {

PiecewiseLinear::PiecewiseLinear(std::span<const ConstantNumber> knots,
                                 std::span<const ConstantNumber> values)
    : knots_(knots.begin(), knots.end()), values_(values.begin(), values.end()) {
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const Expr rise = values[i + 1].expr - values[i].expr;
    slopes_.push_back({rise / (knots[i + 1].expr - knots[i].expr),
                       (values[i + 1].value - values[i].value) / (knots[i + 1].value - knots[i].value)});
  }
}

// A piece begins above its knot.
Expr PiecewiseLinear::operator()(const Expr& x) const {
  Expr result;
  for (std::size_t i = 0; i < slopes_.size(); ++i) {
    const Expr above = x - knots_[i].expr;
    const Expr piece = values_[i].expr + slopes_[i].expr * above;
    result = i == 0 ? piece : if_positive(above, piece) + unless_positive(above, result);
  }
  return result;
}

double PiecewiseLinear::operator()(double x) const {
  std::size_t i = 0;
  while (i + 1 < slopes_.size() && x > knots_[i + 1].value) ++i;
  return values_[i].value + slopes_[i].value * (x - knots_[i].value);
}

}  // namespace alembert
