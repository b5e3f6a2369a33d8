// Writes mechanisms that are hard on numbers (see the header).
#include "oracles/nasty_mechanism.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "oracles/late_functions.hpp"
#include "oracles/random_expressions.hpp"
#include "oracles/reference.hpp"
#include "oracles/taylor/numeric_lagrangian.hpp"

namespace alembert::oracles {

namespace {

constexpr long double kNastyCondition = 1e9L;
constexpr int kNastySpeeds = 8;

struct Kind {
  const char* name;
  bool tilts, offsets, decimals, axes, scales, units, late, curved, trees;
};
constexpr std::array<Kind, 10> kKinds{{
    {"tilts", true, false, false, false, false, false, false, false, false},
    {"offsets", false, true, false, false, false, false, false, false, false},
    {"decimals", false, false, true, false, false, false, false, false, false},
    {"axes", false, false, false, true, false, false, false, false, false},
    {"scales", false, false, false, false, true, false, false, false, false},
    {"units", false, false, false, false, false, true, false, false, false},
    {"late", false, false, false, false, false, false, true, false, false},
    {"curved", false, false, false, false, false, false, true, true, false},
    {"trees", false, false, false, false, false, false, false, false, true},
    {"mixed", true, true, true, true, true, false, true, false, true},
}};

class NastyWriter {
 public:
  NastyWriter(std::uint64_t seed, const Kind& kind) : draw_(seed), kind_(kind), late_(draw_, result_.events) {
    if (kind.units) {
      constexpr std::array<double, 4> kLengths{1e-6, 1e-3, 1e3, 1e6}, kMasses{1e-6, 1e-4, 1e3, 1e5};
      const int which = draw_.below(4);
      result_.length = kLengths[static_cast<std::size_t>(which)];
      mass_ = kMasses[static_cast<std::size_t>(which)];
    }
    result_.kind = kind.name;
  }

  NastyMechanism write() {
    const int bodies = 2 + draw_.below(kind_.curved ? 2 : 3);
    for (int i = 0; i < bodies; ++i) write_body(i, i + 1 == bodies);
    const bool falls = draw_.chance(0.8);
    if (!falls) result_.gravity = 1;
    const std::string x = falls ? "0" : number(-1, 1), z = falls ? "-9.81" : number(-1, 1);
    result_.text = "alembert: 1\nname: nasty_" + result_.kind + "\n";
    if (!parameters_.empty()) result_.text += "parameters:\n" + parameters_;
    result_.text += "gravity: " + list({x, "0", z}) + "\ncoordinates:\n" + coordinates_;
    if (!definitions_.empty()) result_.text += "definitions:\n" + definitions_;
    result_.text += "bodies:\n" + bodies_ + frames_;
    return result_;
  }

 private:
  std::string number(double low, double high) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.6g", draw_.between(low, high));
    return buffer;
  }
  /// 10^-k, k = 3..14.
  std::string tiny(double unit = 1) {
    const double size =
        draw_.between(1, 9) * (draw_.chance(0.5) ? 1 : -1) * std::pow(10, -3 - draw_.below(12));
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.3g", size * unit);
    return buffer;
  }
  double scale() { return kind_.scales ? std::pow(10, draw_.between(-6, 0)) : 1; }
  std::string length() {
    const double unit = scale() * result_.length;
    return number(-0.8 * unit, 0.8 * unit);
  }

  std::string offset() {
    if (kind_.offsets && draw_.chance(0.5)) return tiny(result_.length);
    if (draw_.chance(kind_.trees ? 0.2 : 0.4)) return "0";
    return length();
  }
  std::string shift() {
    const std::string x = offset(), y = offset(), z = offset();
    return "{translate: " + list({x, y, z}) + "}";
  }

  std::string right_angle() {
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
  std::string turn(char about) {
    const bool generic = !kind_.offsets && draw_.chance(kind_.tilts || kind_.decimals ? 0.1 : 0.4);
    const std::string angle = generic ? number(-1.5, 1.5) : right_angle();
    return std::string("{rotate: {axis: ") + about + ", angle: \"" + angle + "\"}}";
  }

  std::string joint_axis() {
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

  /// An angle; late functions change within its limits, far from where it begins.
  std::string new_angle() {
    const std::string name = "q" + std::to_string(speeds_++);
    coordinates_ += "  - {name: " + name + (kind_.late ? ", limits: [-1, 10]" : ", limits: [-3, 3]") + "}\n";
    angles_.push_back(name);
    return name;
  }
  std::string new_length() {
    const std::string name = "q" + std::to_string(speeds_++);
    const double unit = scale() * result_.length;
    const std::string half = decimal(0.5 * unit);
    coordinates_ += "  - {name: " + name + ", limits: [-" + half + ", " + half + "]}\n";
    result_.lengths[name] = unit;
    return name;
  }
  std::string old_angle() {
    return angles_.empty() ? new_angle()
                           : angles_[static_cast<std::size_t>(draw_.below(static_cast<int>(angles_.size())))];
  }

  std::string joint() {
    const std::string about = joint_axis();
    if (speeds_ > 0 && draw_.chance(0.2))
      return "{joint: {type: prismatic, axis: " + about + ", coordinates: [" + new_length() + "]}}";
    if (draw_.chance(0.1)) {
      const double unit = 0.1 * result_.length;
      const std::string pitch = number(0.5 * unit, unit);
      return "{joint: {type: helical, axis: " + about + ", pitch: " + pitch + ", coordinates: [" +
             new_angle() + "]}}";
    }
    return "{joint: {type: revolute, axis: " + about + ", coordinates: [" + new_angle() + "]}}";
  }

  /// The value of a late function, or a parameter of tiny default times a function; a length or an angle.
  std::string late(double size) {
    const std::string of = draw_.chance(0.25) ? "t" : old_angle();
    if (draw_.chance(0.2)) {
      const std::string name = "p" + std::to_string(result_.parameters.size());
      static constexpr std::array<const char*, 3> kDefaults{"1.0e-09", "1.0e-15", "0"};
      parameters_ += "  " + name + ": {value: " + kDefaults[static_cast<std::size_t>(draw_.below(3))] +
                     ", runtime: true}\n";
      result_.parameters[name] = size * draw_.between(0.4, 0.9);
      return name + "*(1 + sin(" + of + " - 0.3))";
    }
    const std::string f = late_.function(of, size);
    if (!draw_.chance(0.2)) return f;
    const std::string name = "d" + std::to_string(definition_count_++);
    definitions_ += "  " + name + ": \"" + f + "\"\n";
    return name;
  }

  std::string late_factor() {
    const double unit = 0.3 * result_.length;
    switch (draw_.below(kind_.curved ? 6 : 3)) {
      case 0: {
        const std::string x = late(unit), y = length();
        return "{translate: " + list({x, y, "0"}) + "}";
      }
      case 1: {
        const std::string x = length(), z = late(unit);
        return "{translate: " + list({x, "0", z}) + "}";
      }
      case 2: {
        const std::string about = draw_.axis();
        return "{rotate: {axis: " + about + ", angle: \"" + late(0.7) + "\"}}";
      }
      case 3: {
        const std::string f = "(" + late(0.7) + ")", x = length();
        const std::string c = "cos(" + f + ")", s = "sin(" + f + ")", minus = "-sin(" + f + ")";
        return "{matrix: [" + list({c, minus, "0", x}) + ", " + list({s, c, "0", "0"}) + ", " +
               list({"0", "0", "1", "0.1"}) + "]}";
      }
      case 4: {
        const std::string about = draw_.axis(), z = late(unit);
        return "{inverse: [{rotate: {axis: " + about +
               ", angle: 0.7}}, {translate: " + list({"0.2", "0", z}) + "}]}";
      }
      default: {
        const std::string s = new_angle(), r = number(0.5, 1.1), h = number(0.1, 0.4);
        if (draw_.chance(0.5) || speeds_ >= kNastySpeeds) {
          const std::string lift = late_.function(s, unit);
          return "{curve: {point: " +
                 list({r + "*cos(" + s + ")", r + "*sin(" + s + ")", h + "*" + s + " + " + lift}) +
                 ", along: " + s + ", frame: {reference: [0.02, 0.03, 1]}}}";
        }
        const std::string v = new_angle(), tube = number(0.2, 0.4), bulge = late_.function(s, 0.2);
        const std::string R = "(" + r + " + 0.6 + " + bulge + " + " + tube + "*cos(" + v + "))";
        return "{surface: {point: " +
               list({R + "*cos(" + s + ")", R + "*sin(" + s + ")", tube + "*sin(" + v + ")"}) + ", along: [" +
               s + ", " + v + "]}}";
      }
    }
  }

  /// Moves with an earlier coordinate and with none of its own.
  std::string follower() {
    const std::string name = old_angle(), k = number(-2, 2), b = number(-0.5, 0.5);
    const std::string f = draw_.chance(0.5) ? k + "*" + name + " + " + b : k + "*sin(" + name + ") + " + b;
    return "{rotate: {axis: " + joint_axis() + ", angle: \"" + f + "\"}}";
  }

  void write_body(int index, bool last) {
    const auto add = [&](const std::string& factor) { bodies_ += "      - " + factor + "\n"; };
    bodies_ += "  - name: body" + std::to_string(index) + "\n";
    if (index > 0) {
      const int parent = kind_.trees && draw_.chance(0.4) ? draw_.below(index) : index - 1;
      bodies_ += "    parent: body" + std::to_string(parent) + "\n";
    }
    bodies_ += "    transform:\n";
    const int joints = 1 + draw_.below(2);
    for (int i = 0; i < joints; ++i) {
      if (index > 0 || draw_.chance(0.3)) add(shift());
      if (index > 0 || i > 0) {
        add(turn("xy"[draw_.below(2)]));
        if (draw_.chance(0.3)) add(turn('z'));
      }
      if (kind_.trees && index == 0 && i == 0 && draw_.chance(0.3)) {
        add("{joint: {type: free, coordinates: [x, y, z, r]}}");
        const std::string half = decimal(0.5 * result_.length);
        for (const char* name : {"x", "y", "z"}) {
          coordinates_ += std::string("  - {name: ") + name + ", limits: [-" + half + ", " + half + "]}\n";
          result_.lengths[name] = result_.length;
        }
        coordinates_ += "  - {name: r, type: quaternion}\n";
        speeds_ += 6;
        free_ = true;
        break;  // a transform has six speeds at most
      } else if (kind_.trees && !free_ && speeds_ + 3 <= kNastySpeeds && draw_.chance(0.2)) {
        add("{joint: {type: spherical, coordinates: [r]}}");
        coordinates_ += "  - {name: r, type: quaternion}\n";
        speeds_ += 3;
        free_ = true;
      } else if (kind_.trees && index > 0 && draw_.chance(0.25)) {
        add(follower());
      } else if (speeds_ < kNastySpeeds) {
        add(joint());
      } else {
        add(follower());
      }
      if (kind_.late && draw_.chance(0.6)) add(late_factor());
    }
    if (draw_.chance(0.4)) add(shift());
    if (!(kind_.trees && !last && index > 0 && draw_.chance(0.2))) mass_properties(last);
    if (draw_.chance(0.2)) bodies_ += "    external_wrench: true\n";
    if (last) {
      frames_ = "frames:\n  - {name: tip, body: body" + std::to_string(index) + ", transform: [" + shift() +
                ", " + turn('x') + "]}\n";
    }
  }

  /// A full inertia is that of six point masses.
  void mass_properties(bool last) {
    const double unit = scale() * result_.length;
    const double mass = mass_ * (kind_.scales ? std::pow(10, draw_.between(-7, 1)) : draw_.between(0.3, 3));
    std::array<double, 6> I{};
    for (int i = 0; i < 6; ++i) {
      const double x = draw_.between(-0.4, 0.4), y = draw_.between(-0.4, 0.4), z = draw_.between(-0.4, 0.4);
      const double m = mass * unit * unit / 6;
      I[0] += m * (y * y + z * z);
      I[1] += m * (x * x + z * z);
      I[2] += m * (x * x + y * y);
      I[3] -= m * x * y;
      I[4] -= m * x * z;
      I[5] -= m * y * z;
    }
    const auto text = [](double value) {
      char buffer[32];
      std::snprintf(buffer, sizeof buffer, "%.12g", value);
      return std::string(buffer);
    };
    bodies_ += "    mass: " + text(mass) + "\n";
    const std::string x = number(-0.3 * unit, 0.3 * unit), y = number(-0.3 * unit, 0.3 * unit),
                      z = number(-0.3 * unit, 0.3 * unit);
    if (last || draw_.chance(0.8)) bodies_ += "    com: " + list({x, y, z}) + "\n";
    if (draw_.chance(kind_.trees || kind_.tilts ? 0.3 : 0.15)) return;
    bodies_ += "    inertia: {xx: " + text(I[0]) + ", yy: " + text(I[1]) + ", zz: " + text(I[2]);
    if (draw_.chance(0.7)) bodies_ += ", xy: " + text(I[3]) + ", xz: " + text(I[4]) + ", yz: " + text(I[5]);
    bodies_ += "}\n";
  }

  RandomExpressions draw_;
  Kind kind_;
  NastyMechanism result_;
  LateFunctions late_;
  double mass_ = 1;
  int speeds_ = 0, definition_count_ = 0;
  bool free_ = false;
  std::vector<std::string> angles_;
  std::string parameters_, coordinates_, definitions_, bodies_, frames_;
};

}  // namespace

NastyMechanism nasty_mechanism(std::uint64_t seed) {
  const Kind& kind = kKinds[seed % kKinds.size()];
  for (std::uint64_t trial = 0; trial < 200; ++trial) {
    const NastyMechanism mechanism = NastyWriter(1000003 * seed + trial, kind).write();
    const Description description = parse_description(mechanism.text, mechanism.parameters);
    if (kind.late && mechanism.events.empty() && mechanism.parameters.empty()) continue;
    const std::vector<State> states = nasty_states(mechanism, description, seed, 4);
    if (std::all_of(states.begin(), states.end(), [&](const State& state) {
          return scaled_condition(numeric_lagrangian<long double>(description, state).mass_matrix) <
                 kNastyCondition;
        }))
      return mechanism;
  }
  throw std::runtime_error("no mechanism that moves near seed " + std::to_string(seed));
}

}  // namespace alembert::oracles
