// Cubic splines. In: knots, values and what holds at the ends. Out: the spline of an argument as one
// expression without branches, whose first and second derivatives are the spline's everywhere, at the knots
// too.
//
// With pieces P_i between knots k_i and k_(i+1), straight lines outside, and weights
//
//     S(x) = sum_i 1/2 (sign(x - k_i) - sign(x - k_(i+1))) P_i(x - k_i),
//
// a weight is 1 on its piece, 0 elsewhere and 1/2 at its two ends, where both neighbours agree up to the
// second derivative; the derivative of a sign is 0. Nothing large is added to be taken away again, as with
// powers that are cut off at each knot: rounding does not grow with the number of knots.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "symbolic/expr.hpp"

namespace alembert {

/// A constant of an expression, with its double.
struct ConstantNumber {
  Expr expr;
  double value;
};

/// What holds at both ends, where straight lines go on.
enum class SplineEnds {
  /// No second derivative.
  natural,
  /// The third derivative of the cubic through the last four points (three: of the parabola), so that the second
  /// jumps to 0 there. SIMM and OpenSim have it so. Source: Forsythe, Malcolm and Moler, Computer Methods for
  /// Mathematical Computations (1977), chapter 4.
  fitted_cubic
};

class CubicSpline {
 public:
  /// At least two knots, strictly increasing as doubles, and as many values. Coefficients are exact where
  /// knots and values are rational and nothing overflows, else doubles. Throws std::domain_error if one is
  /// not finite.
  CubicSpline(SplineEnds ends, std::span<const ConstantNumber> knots, std::span<const ConstantNumber> values);

  Expr operator()(const Expr& x) const;
  /// NaN if x is NaN.
  double operator()(double x) const;

 private:
  /// A polynomial in x - (a knot).
  struct Piece {
    std::size_t knot;
    std::array<Expr, 4> coefficients;  ///< of powers 0 to 3
  };
  std::size_t piece_at(double x) const;

  std::vector<ConstantNumber> knots_;
  std::vector<Piece> pieces_;  ///< line before the first knot, pieces between knots, line after the last
};

}  // namespace alembert
