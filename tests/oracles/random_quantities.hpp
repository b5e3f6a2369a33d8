// Random values of what forces, outputs and states may use, as texts of a description.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "oracles/description/description.hpp"
#include "oracles/random_expressions.hpp"

namespace alembert::oracles {

/// What a mechanism's forces are drawn in.
struct ForceUnits {
  double length = 1, force = 1;
  std::map<std::string, double> lengths = {};  ///< of coordinates that are lengths
};

/// Draws from one generator, in a fixed order.
class RandomQuantities {
 protected:
  RandomQuantities(const Description& given, std::uint64_t seed, const ForceUnits& units);

  const std::string& one_of(const std::vector<std::string>& names);
  /// In units of its own.
  static std::string per(double unit, const std::string& x);
  static std::string times(double unit, const std::string& x);
  double unit_of(const std::string& coordinate) const;
  double torque() const { return units_.force * units_.length; }
  std::string length(const std::string& x) const { return per(units_.length, x); }
  /// A number, or a new parameter.
  std::string constant(double low, double high, double unit = 1);
  std::string coordinate();
  std::string component() { return std::string(".") + "xyz"[draw_.below(3)]; }
  std::string any_speed();
  std::string two_frames(const std::string& between);
  std::string path(int paths) { return "path" + std::to_string(draw_.below(paths)); }
  std::string quantity();
  /// A function of one or two quantities, or once of such functions. What jumps or bends does so where quantities are
  /// not equal: at rest many are 0, others always but for rounding.
  std::string value(int depth = 1);
  std::string three_values(double unit);
  /// Of a point of path number `of`.
  std::string condition(int of);

  RandomExpressions draw_;
  ForceUnits units_;
  std::vector<std::string> reals_, quaternions_, inputs_, states_, defined_, frames_, outputs_;
  std::map<std::string, std::string> parameters_;
  int path_ = 0, paths_ = 0;  ///< how many there are yet, and will be
  bool with_speeds_ = true;

 private:
  std::string table(const std::string& function, const std::string& x);
  int parameter_count_ = 0;
};

}  // namespace alembert::oracles
