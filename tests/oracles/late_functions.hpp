// Functions that change far from 0 and are constant to rounding near it.
#pragma once

#include <string>
#include <vector>

#include "oracles/nasty_mechanism.hpp"
#include "oracles/random_expressions.hpp"

namespace alembert::oracles {

class LateFunctions {
 public:
  /// Draws from `draw`; notes in `events` where the functions change.
  LateFunctions(RandomExpressions& draw, std::vector<Event>& events) : draw_(draw), events_(events) {}

  /// A step, bump or detent of `size`, between 3 and 9 of what it is a function of.
  std::string function(const std::string& of, double size) {
    const std::string centre = decimal(draw_.between(3, 9)), height = decimal(size);
    const std::string x = "(" + of + " - " + centre + ")";
    const auto note = [&](double width) { events_.push_back({of, std::stod(centre), width}); };
    switch (draw_.below(6)) {
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
