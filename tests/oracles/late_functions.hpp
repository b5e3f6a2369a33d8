// Functions that change far from 0 and are constant to rounding near it.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "oracles/nasty_mechanism.hpp"
#include "oracles/random_expressions.hpp"

namespace alembert::oracles {

class LateFunctions {
 public:
  /// Draws from `draw`; notes in `events` where the functions change.
  LateFunctions(RandomExpressions& draw, std::vector<Event>& events) : draw_(draw), events_(events) {}

  /// A spline that steps between knots that are near each other, somewhere from `low` to `high`. Knots are
  /// binary fractions, so that their distances are the same of decimals and of doubles.
  std::string spline(const std::string& of, double size, int low, int high) {
    const int centre = 1024 * low + draw_.below(1024 * (high - low));
    const int width = draw_.chance(0.3) ? 1 : 20 + draw_.below(400);
    events_.push_back({of, centre / 1024.0, width / 1024.0});
    const auto knot = [](int at) { return std::to_string(at) + "/1024, "; };
    const std::string height = decimal(size * std::min(1.0, 5 * width / 1024.0));
    return "spline(" + of + "; [" + std::to_string(low - 5) + ", " + std::to_string(low - 2) + ", " +
           knot(centre - width) + knot(centre) + knot(centre + width) + std::to_string(high + 2) +
           "]; [0, 0, 0, " + height + "/3, " + height + ", 0])";
  }

  /// A step, bump or detent of `size`, between 3 and 9 of what it is a function of.
  std::string function(const std::string& of, double size) {
    const std::string centre = decimal(draw_.between(3, 9)), height = decimal(size);
    const std::string x = "(" + of + " - " + centre + ")";
    const auto note = [&](double width) { events_.push_back({of, std::stod(centre), width}); };
    switch (draw_.below(7)) {
      case 0: {
        const int steep = 20 + draw_.below(100);
        note(1.0 / steep);
        return height + "*(1 + tanh(" + std::to_string(steep) + "*" + x + "))";
      }
      case 1: {
        note(0.2);
        return height + "*exp(-10*" + x + "^2)";
      }
      case 2: {
        const double width = draw_.chance(0.5) ? 0.001 : 0.02;
        note(width);
        return decimal(size * width) + "*exp(-(" + x + "/" + decimal(width) + ")^2)";
      }
      case 3: {
        note(0.1);
        return height + "/(1 + exp(-15*" + x + "))";
      }
      case 4: {
        // Once a turn.
        note(0.1);
        return height + "*exp(-100*(1 - cos" + x + "))";
      }
      case 5:
        return spline(of, size, 3, 9);
      default: {
        note(0.05);
        return height + "*(tanh(30*" + x + ") + 1)^2/2";
      }
    }
  }

 private:
  RandomExpressions& draw_;
  std::vector<Event>& events_;
};

}  // namespace alembert::oracles
