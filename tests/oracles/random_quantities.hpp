// Values that forces and outputs may have: random expressions of everything that they may use.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "oracles/description/description.hpp"
#include "oracles/random_expressions.hpp"
#include "oracles/random_forces.hpp"

namespace alembert::oracles {

/// Who derives from it declares what the values use.
class QuantityWriter {
 protected:
  QuantityWriter(std::uint64_t seed, const Description& given, const ForceUnits& units);

  const std::string& one_of(const std::vector<std::string>& names) {
    return names[static_cast<std::size_t>(draw_.below(static_cast<int>(names.size())))];
  }
  /// In units of its own.
  static std::string per(double unit, const std::string& x) {
    return unit == 1 ? x : "(" + x + "/" + decimal(unit) + ")";
  }
  static std::string times(double unit, const std::string& x) {
    return unit == 1 ? x : decimal(unit) + "*(" + x + ")";
  }
  double unit_of(const std::string& coordinate) const {
    const auto found = units_.lengths.find(coordinate);
    return found == units_.lengths.end() ? 1 : found->second;
  }
  double torque() const { return units_.force * units_.length; }
  std::string length(const std::string& x) const { return per(units_.length, x); }
  /// A number, or a new parameter.
  std::string constant(double low, double high, double unit = 1);
  std::string coordinate();
  std::string component() { return std::string(".") + "xyz"[draw_.below(3)]; }
  std::string two_frames(const std::string& between);
  /// A function of one or two quantities, or once of such functions. What jumps or bends does so where quantities are not
  /// equal: at rest many are 0, others always but for rounding.
  std::string value(int depth = 1);
  std::string three_values(double unit);
  std::string tension();

  RandomExpressions draw_;
  ForceUnits units_;
  std::vector<std::string> reals_, quaternions_, inputs_, defined_, frames_;
  std::map<std::string, std::string> parameters_;
  int paths_ = 0;
  bool with_speeds_ = true;

 private:
  std::string any_speed();
  std::string quantity();
  std::string table(const std::string& function, const std::string& x);
  int parameter_count_ = 0;
};

}  // namespace alembert::oracles
