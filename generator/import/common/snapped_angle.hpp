// An angle as it was written in; the angle that was meant out, if it is a multiple of pi/12.
#pragma once

#include <array>
#include <string>

namespace alembert {

class SnappedAngle {
 public:
  /// Within `tolerance` radians of k pi / 12, and of at most two turns, it is that multiple.
  SnappedAngle(double radians, double tolerance);

  bool is_zero() const { return exact_ && twelfths_ == 0; }
  /// Whether it is no multiple, but differs from a quarter turn, half a turn or so by less than 2e-3.
  bool nearly_right() const;
  /// As an expression: `-pi/2`, `5*pi/12`, `0.7`.
  std::string text() const;
  /// Cosine and sine, exact at quarter turns.
  std::array<double, 2> cosine_and_sine() const;

 private:
  double value_;
  int twelfths_ = 0;  // k
  bool exact_ = false;
};

/// The shortest decimal that is the number.
std::string number_text(double x);

}  // namespace alembert
