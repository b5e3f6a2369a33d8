// Draws numbers, lengths, angles and axes that are hard on numbers (see the header).
#include "oracles/nasty_numbers.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace alembert::oracles {

namespace {

std::string digits(double value, int count) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.*g", count, value);
  return buffer;
}

}  // namespace

NastyNumbers::NastyNumbers(RandomExpressions& draw, const NastyKind& kind, NastyMechanism& result)
    : draw_(draw), kind_(kind), result_(result) {
  at_run_time_ = draw_.chance(0.25);
  if (!kind.units) return;
  constexpr std::array<double, 4> kLengths{1e-6, 1e-3, 1e3, 1e6}, kMasses{1e-6, 1e-4, 1e3, 1e5};
  const auto which = static_cast<std::size_t>(draw_.below(4));
  result_.length = kLengths[which];
  mass_ = kMasses[which];
}

std::string NastyNumbers::number(double low, double high) {
  return digits(draw_.between(low, high), 6);
}

std::string NastyNumbers::tiny(double unit) {
  const double sign = draw_.chance(0.5) ? 1 : -1;
  const double size = draw_.between(1, 9);
  return digits(sign * size * std::pow(10, -3 - draw_.below(12)) * unit, 3);
}

double NastyNumbers::scale() {
  return kind_.scales ? std::pow(10, draw_.between(-6, 0)) : 1;
}

std::string NastyNumbers::length() {
  const double unit = scale() * result_.length;
  return value_or_parameter(draw_.between(-0.8, 0.8) * unit);
}

std::string NastyNumbers::offset() {
  if (kind_.offsets && draw_.chance(0.5)) return tiny(result_.length);
  if (draw_.chance(kind_.trees ? 0.2 : 0.4)) return "0";
  return length();
}

std::string NastyNumbers::shift() {
  const std::string x = offset(), y = offset(), z = offset();
  return "{translate: " + list({x, y, z}) + "}";
}

std::string NastyNumbers::right_angle() {
  if (kind_.decimals && draw_.chance(0.8)) {
    static constexpr std::array<const char*, 8> kAngles{"1.5708",   "-1.5708", "3.14159", "1.570796",
                                                        "0.785398", "-3.1416", "1.57",    "6.2832"};
    return kAngles[static_cast<std::size_t>(draw_.below(8))];
  }
  static constexpr std::array<const char*, 5> kAngles{"pi/2", "-pi/2", "pi", "0", "pi/4"};
  std::string angle = kAngles[static_cast<std::size_t>(draw_.below(kind_.offsets ? 2 : 5))];
  if (kind_.tilts && draw_.chance(0.7)) angle += " + " + tiny();
  return angle;
}

std::string NastyNumbers::turn(char about) {
  const bool generic = !kind_.offsets && draw_.chance(kind_.tilts || kind_.decimals ? 0.1 : 0.4);
  const std::string angle = generic ? value_or_parameter(draw_.between(-1.5, 1.5)) : right_angle();
  return std::string("{rotate: {axis: ") + about + ", angle: \"" + angle + "\"}}";
}

std::string NastyNumbers::joint_axis() {
  const int which = draw_.below(8);
  if (!kind_.axes) return which == 0 ? "x" : which == 1 ? "y" : "z";
  switch (which) {
    case 0:
      return "[0, 0, -1]";
    case 1:
      return "[0, 0, 1.0e+12]";
    case 2:
      return "[0, -1.0e-06, 0]";
    case 3: {
      const std::string x = tiny(), y = tiny();
      return "[" + x + ", " + y + ", 1]";
    }
    case 4: {
      const std::string x = tiny();
      return "[" + x + ", -1, 0]";
    }
    case 5: {
      const std::string x = number(-3, 3), y = number(-3, 3);
      return "[" + x + "e+11, " + y + "e+11, 2.0e+11]";
    }
    case 6: {
      const std::string x = number(-3, 3), y = number(-3, 3);
      return "[" + x + "e-6, " + y + "e-6, 0.000002]";
    }
    default:
      return "[-1, 0, 0]";
  }
}

std::string NastyNumbers::parameter(double value, const std::string& usual) {
  const std::string name = "u" + std::to_string(result_.parameters.size());
  draw_.declare_parameter(name, usual);
  result_.parameters[name] = value;
  return name;
}

std::string NastyNumbers::value_or_parameter(double value, int count) {
  if (!at_run_time_ || draw_.chance(0.7)) return digits(value, count);
  return parameter(value, digits(value * draw_.between(0.3, 3), count));
}

}  // namespace alembert::oracles
