// Units of forces, inputs and outputs, for plots: descriptions do not name them. In: a mechanism and an expression. Out: a
// unit, if it is plain.
#pragma once

#include <map>
#include <string>

#include "viewer/shapes.hpp"

namespace alembert {

class ValueUnits {
 public:
  explicit ValueUnits(const InitialValues& values);

  /// `m`, `rad`, `m/s`, `rad/s`, `s`, `N`, `N m` or `J` of what is known to be one; empty otherwise.
  std::string of(const Expr& value) const;
  /// Of a force along a speed: what goes with it to make watts.
  std::string along(int speed) const;

 private:
  void set(const Expr& value, const std::string& unit);
  void set_inputs();

  const Mechanism& mechanism_;
  std::map<std::uint32_t, std::string> known_;  ///< by node
  std::vector<std::string> along_;              ///< by speed
};

}  // namespace alembert
