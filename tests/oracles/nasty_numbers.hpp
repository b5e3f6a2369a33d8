// Numbers, lengths, angles and axes that are hard on numbers, as texts of a description that is being written.
#pragma once

#include <string>

#include "oracles/nasty_mechanism.hpp"
#include "oracles/random_expressions.hpp"

namespace alembert::oracles {

/// Which of the difficulties a mechanism has (nasty_mechanism.hpp).
struct NastyKind {
  const char* name;
  bool tilts, offsets, decimals, axes, scales, units, late, curved, trees;
};

class NastyNumbers {
 public:
  /// Draws from `draw`; values of runtime parameters go into `result`, whose units it draws. All must outlive
  /// it.
  NastyNumbers(RandomExpressions& draw, const NastyKind& kind, NastyMechanism& result);

  /// Six digits.
  std::string number(double low, double high);
  /// 10^-k units, k = 3..14.
  std::string tiny(double unit = 1);
  /// 1, or of six decades where the mechanism has small and large parts.
  double scale();
  std::string length();
  /// A length, 0, or next to 0.
  std::string offset();
  std::string shift();
  std::string right_angle();
  std::string turn(char about);
  std::string joint_axis();

  /// Unit of mass.
  double mass() const { return mass_; }
  /// A new runtime parameter, with a default far from its value.
  std::string parameter(double value, const std::string& usual);
  /// The value with so many digits or, in some mechanisms, a parameter.
  std::string value_or_parameter(double value, int digits = 6);

 private:
  RandomExpressions& draw_;
  const NastyKind& kind_;
  NastyMechanism& result_;
  double mass_ = 1;
  bool at_run_time_ = false;  ///< some numbers are parameters
};

}  // namespace alembert::oracles
