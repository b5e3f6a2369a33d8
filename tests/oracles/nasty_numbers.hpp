// Lengths, angles and axes that are hard on numbers, as texts of a description that is being written.
#pragma once

#include <string>

#include "oracles/random_expressions.hpp"

namespace alembert::oracles {

/// Which of the difficulties a mechanism has (nasty_mechanism.hpp).
struct NastyKind {
  const char* name;
  bool tilts, offsets, decimals, axes, scales, units, late, curved, trees;
};

class NastyNumbers {
 public:
  /// Draws from `draw`; `length` is the unit of the mechanism. All must outlive it.
  NastyNumbers(RandomExpressions& draw, const NastyKind& kind, const double& length)
      : draw_(draw), kind_(kind), length_(length) {}

  /// Six digits.
  std::string number(double low, double high);
  /// 10^-k units, k = 3..14.
  std::string tiny(double unit = 1);
  /// 1, or of twelve decades where the mechanism has small and large parts.
  double scale();
  std::string length();
  /// A length, 0, or next to 0.
  std::string offset();
  std::string shift();
  std::string right_angle();
  std::string turn(char about);
  std::string joint_axis();

 private:
  RandomExpressions& draw_;
  const NastyKind& kind_;
  const double& length_;
};

}  // namespace alembert::oracles
