// Writes random descriptions (see the header).
#include "oracles/random_mechanism.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>
#include <regex>
#include <stdexcept>
#include <vector>

#include "oracles/comparison.hpp"

namespace alembert::oracles {

namespace {

constexpr int kMaximumSpeeds = 11;
constexpr int kMaximumSpeedsOfTransform = 6;

std::string decimal(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.4g", value);
  return buffer;
}

std::string list(const std::vector<std::string>& items) {
  std::string text = "[";
  for (std::size_t i = 0; i < items.size(); ++i) text += (i > 0 ? ", \"" : "\"") + items[i] + "\"";
  return text + "]";
}

class Writer {
 public:
  explicit Writer(std::uint64_t seed) : random_(seed), joints_only_(chance(0.5)) {}

  std::string write() {
    const int bodies = 1 + below(5);
    for (int i = 0; i < bodies; ++i) write_body(i);
    if (chance(0.3)) std::reverse(bodies_.begin(), bodies_.end());  // children before parents
    std::string text = "gravity: " + list({gravity(), decimal(between(-3, 3)), gravity()}) + "\n";
    text += "coordinates:\n" + coordinates_;
    if (!definitions_.empty()) text += "definitions:\n" + definitions_;
    text += "bodies:\n";
    for (const std::string& body : bodies_) text += body;
    return "alembert: 1\nname: random_mechanism\n" + parameters_in(text) + text;
  }

 private:
  /// Declarations of the parameters that the text mentions: some are drawn in vain.
  std::string parameters_in(const std::string& text) const {
    std::string declarations;
    for (const auto& [name, line] : parameters_) {
      if (std::regex_search(text, std::regex("\\b" + name + "\\b"))) declarations += line;
    }
    return declarations.empty() ? "" : "parameters:\n" + declarations;
  }

  // Numbers are taken from the generator one by one and in a fixed order, so that a seed means one text.
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }
  bool chance(double p) { return between(0, 1) < p; }
  std::string constant(double low, double high) {
    const std::string value = decimal(between(low, high));
    if (!chance(0.25)) return value;
    const std::string name = "p" + std::to_string(parameter_count_++);
    const bool runtime = chance(0.5);
    parameters_[name] =
        "  " + name + ": " + (runtime ? "{value: " + value + ", runtime: true}" : value) + "\n";
    return name;
  }
  std::string gravity() { return chance(0.7) ? constant(-9, 9) : "0"; }

  // Coordinates. What a transform depends on is counted, since it may have six speeds at most.
  bool has_room(int speeds) const {
    return speeds_ + speeds <= kMaximumSpeeds &&
           static_cast<int>(used_.size()) + used_speeds_of_quaternions_ + speeds <= kMaximumSpeedsOfTransform;
  }
  std::string new_coordinate(double low = -1.5, double high = 1.5) {
    const std::string name = "q" + std::to_string(reals_.size());
    const std::string initial = decimal(between(low / 2, high / 2));
    coordinates_ += "  - {name: " + name + ", initial: " + initial + ", limits: [" + decimal(low) + ", " +
                    decimal(high) + "]}\n";
    reals_.push_back(name);
    used_.push_back(name);
    ++speeds_;
    return name;
  }
  std::string new_quaternion() {
    const std::string name = "r" + std::to_string(quaternions_++);
    coordinates_ += "  - {name: " + name + ", type: quaternion}\n";
    speeds_ += 3;
    used_speeds_of_quaternions_ += 3;
    return name;
  }
  /// An earlier coordinate, if the transform may still depend on it, or a number.
  std::string old_coordinate() {
    if (reals_.empty()) return decimal(between(-1, 1));
    const std::string name = reals_[static_cast<std::size_t>(below(static_cast<int>(reals_.size())))];
    if (std::find(used_.begin(), used_.end(), name) == used_.end()) {
      if (static_cast<int>(used_.size()) + used_speeds_of_quaternions_ + reserved_ >=
          kMaximumSpeedsOfTransform)
        return "0.3";
      used_.push_back(name);
    }
    return name;
  }

  /// A smooth function of x, defined for |x| <= 1.5, of x alone.
  std::string curved(const std::string& x) {
    const std::string a = constant(0.3, 1.2), b = constant(0.1, 0.4);
    switch (below(17)) {
      case 0:
        return a + "*" + x + " + " + b;
      case 1:
        return a + "*" + x + " + " + b + "*sin(" + x + ")";
      case 2:
        return x + " + " + b + "*" + x + "^2";
      case 3:
        return "atan(" + x + ") - " + a;
      case 4:
        return "sinh(" + b + "*" + x + ")/" + b;
      case 5:
        return a + "*tanh(" + x + ")";
      case 6:
        return "sqrt(1.2 + (" + x + " - 2)^2)";
      case 7:
        return "log(3 + " + x + ")*" + a;
      case 8:
        return "exp(" + b + "*" + x + ")";
      case 9:
        return "atan2(sin(" + x + ") + " + b + ", 2 + cos(" + x + "))*2";
      case 10:
        return "asin(0.6*sin(" + x + "/2))*2";
      case 11:
        return "acos(0.5*sin(" + x + "/2 + 0.1))";
      case 12:
        return "-" + x + "^3/6 - " + x;
      case 13:
        return a + "/(2.5 + " + x + ")";
      case 14:
        return "tan(" + b + "*" + x + ")*2";
      case 15:
        return "cosh(" + x + "/2 - 1)";
      default:
        return "(2 + sin(" + x + "))^1.5/2";
    }
  }
  /// A function that moves with x, and perhaps with earlier coordinates and time.
  std::string function(const std::string& x) {
    std::string f = chance(0.35) ? x : curved(x);
    if (chance(0.3)) f += " + " + decimal(between(0.1, 0.4)) + "*sin(" + old_coordinate() + ")";
    if (chance(0.15)) f = "(" + f + ")*(1 + 0.2*cos(" + old_coordinate() + "))";
    if (chance(0.2)) f += " + " + decimal(between(0.1, 0.5)) + "*sin(" + decimal(between(0.5, 2)) + "*t)";
    if (!chance(0.2)) return f;
    const std::string name = "d" + std::to_string(definition_count_++);
    definitions_ += "  " + name + ": \"" + f + "\"\n";
    return name;
  }
  std::string axis() {
    switch (below(5)) {
      case 0:
        return "x";
      case 1:
        return "y";
      case 2:
        return "z";
      default: {
        const std::string x = decimal(between(-1, 1)), y = decimal(between(-1, 1)),
                          z = decimal(between(0.2, 1));
        return "[" + x + ", " + y + ", " + z + "]";
      }
    }
  }
  std::string shift() {
    const std::string x = constant(-0.5, 0.5), y = constant(-0.5, 0.5), z = constant(-0.5, 0.5);
    return "{translate: " + list({x, y, z}) + "}";
  }
  std::string turn() {
    const std::string about = axis();
    return "{rotate: {axis: " + about + ", angle: " + constant(-1.5, 1.5) + "}}";
  }

  std::string joint() {
    const std::string start = "{joint: {type: ";
    const auto fits = [this](int speeds) { return has_room(speeds); };
    switch (below(8)) {
      case 0:
        break;
      case 1: {
        const std::string about = axis();
        return start + "prismatic, axis: " + about + ", coordinates: [" + new_coordinate() + "]}}";
      }
      case 2: {
        const std::string about = axis();
        const std::string pitch = constant(0.05, 0.3);
        return start + "helical, axis: " + about + ", pitch: " + pitch + ", coordinates: [" +
               new_coordinate() + "]}}";
      }
      case 3: {
        if (!fits(2)) break;
        const std::string about = axis();
        const std::string a = new_coordinate(), b = new_coordinate();
        return start + "cylindrical, axis: " + about + ", coordinates: [" + a + ", " + b + "]}}";
      }
      case 4: {
        if (!fits(2)) break;
        const std::string axes =
            chance(0.5) ? "" : "axes: [[1, 0.3, 0], [0.2, 1, " + decimal(between(-1, 1)) + "]], ";
        const std::string a = new_coordinate(), b = new_coordinate();
        return start + "universal, " + axes + "coordinates: [" + a + ", " + b + "]}}";
      }
      case 5: {
        if (!fits(3)) break;
        const std::string a = new_coordinate(), b = new_coordinate(), c = new_coordinate();
        return start + "planar, coordinates: [" + a + ", " + b + ", " + c + "]}}";
      }
      case 6: {
        if (!fits(3)) break;
        return start + "spherical, coordinates: [" + new_quaternion() + "]}}";
      }
      default: {
        if (!fits(6)) break;
        const std::string a = new_coordinate(), b = new_coordinate(), c = new_coordinate();
        return start + "free, coordinates: [" + a + ", " + b + ", " + c + ", " + new_quaternion() + "]}}";
      }
    }
    const std::string about = axis();
    return start + "revolute, axis: " + about + ", coordinates: [" + new_coordinate() + "]}}";
  }

  /// A rotation by f about a coordinate axis, written out, and a translation.
  std::string matrix() {
    const std::string f = "(" + function(new_coordinate()) + ")";
    const std::string c = "cos(" + f + ")", s = "sin(" + f + ")", minus = "-sin(" + f + ")";
    const std::string x = old_coordinate(), y = constant(-0.5, 0.5);
    switch (below(3)) {
      case 0:
        return "{matrix: [" + list({"1", "0", "0", x}) + ", " + list({"0", c, minus, y}) + ", " +
               list({"0", s, c, "0.1"}) + "]}";
      case 1:
        return "{matrix: [" + list({c, "0", s, y}) + ", " + list({"0", "1", "0", "0.2"}) + ", " +
               list({minus, "0", c, x}) + "]}";
      default:
        return "{matrix: [" + list({c, minus, "0", "0"}) + ", " + list({s, c, "0", x}) + ", " +
               list({"0", "0", "1", y}) + "]}";
    }
  }

  std::string curve() {
    const std::string s = new_coordinate();
    const std::string r = constant(0.5, 1.1), h = constant(0.1, 0.4);
    std::vector<std::string> point;
    switch (below(4)) {
      case 0:
        point = {r + "*cos(" + s + ")", r + "*sin(" + s + ")", h + "*" + s};
        break;
      case 1:
        point = {s, h + "*" + s + "^2", "0.1*" + s + "^3"};
        break;
      case 2:
        point = {r + "*cos(" + s + ")", "0.4*sin(" + s + ") + 0.05*sin(2*" + s + ")", h + "*sin(" + s + ")"};
        break;
      default: {
        const std::string other = old_coordinate();
        const std::string grown = "(" + r + " + 0.1*sin(" + (other == s ? "t" : other) + "))";
        point = {grown + "*cos(" + s + ")", h + "*" + s, grown + "*sin(" + s + ")"};
      }
    }
    std::string frame = chance(0.5) ? "frenet" : "{reference: [0.02, 0.03, 1]}";
    if (frame == "frenet" && chance(0.5)) frame.clear();
    // Along the reference, the third curve and the last one could point; they are kept to the Frenet frame.
    if (point[2].find(h + "*" + s) != 0 && point[2].find("0.1*") != 0 && !frame.empty()) frame = "frenet";
    return "{curve: {point: " + list(point) + ", along: " + s + (frame.empty() ? "" : ", frame: " + frame) +
           "}}";
  }

  std::string surface(bool flip) {
    const std::string u = new_coordinate();
    const std::string v = new_coordinate(-1.2, 1.2);
    const std::string R = constant(0.8, 1.4), r = constant(0.2, 0.5), k = constant(0.2, 0.6);
    std::vector<std::string> point;
    switch (below(4)) {
      case 0:
        point = {"(" + R + " + " + r + "*cos(" + v + "))*cos(" + u + ")",
                 "(" + R + " + " + r + "*cos(" + v + "))*sin(" + u + ")", r + "*sin(" + v + ")"};
        break;
      case 1:
        point = {R + "*cos(" + v + ")*cos(" + u + ")", r + "*cos(" + v + ")*sin(" + u + ")",
                 k + "*sin(" + v + ")"};
        break;
      case 2:
        point = {u, v, k + "*" + u + "^2 + 0.3*" + v + "^2"};
        break;
      default:
        point = {u + " + 0.2*" + v, v, k + "*sin(" + u + ")*cos(" + v + ")"};
    }
    return "{surface: {point: " + list(point) + ", along: [" + u + ", " + v + "]" +
           (flip          ? ", flip: true"
            : chance(0.3) ? ", flip: false"
                          : "") +
           "}}";
  }

  std::string mate() {
    const bool first = chance(0.3);
    reserved_ = 5;
    const std::string a = surface(first);
    const std::string b = surface(chance(0.7) != first);
    reserved_ = 0;
    std::string spin;
    if (has_room(1)) spin = ", spin: \"" + function(new_coordinate()) + "\"";
    return "{mate: [" + a + ", " + b + "]" + spin + "}";
  }

  /// A factor that moves with coordinates of its own; empty if there is no room for what was drawn.
  std::string moving_factor(int depth = 0) {
    if (!has_room(1)) return "";
    switch (below(joints_only_ ? 5 : depth == 0 ? 11 : 9)) {
      case 0:
      case 1:
      case 2:
        return joint();
      case 3: {
        const std::string about = axis();
        return "{rotate: {axis: " + about + ", angle: \"" + function(new_coordinate()) + "\"}}";
      }
      case 4: {
        const std::string x = new_coordinate();
        const std::string f = function(x), g = curved(x), h = constant(-0.4, 0.4);
        return "{translate: " + list({f, h, g}) + "}";
      }
      case 5:
        return matrix();
      case 6:
        return curve();
      case 7:
        return has_room(2) ? surface(chance(0.3)) : "";
      case 8: {
        if (!has_room(3)) return "";
        return "{rotate: {quaternion: " + new_quaternion() + "}}";
      }
      case 9:
        return used_.empty() && has_room(5) ? mate() : "";
      default: {
        const std::string inner = moving_factor(1);
        if (inner.empty()) return "";
        return "{inverse: [" + turn() + ", " + inner + "]}";
      }
    }
  }

  void write_body(int index) {
    used_.clear();
    used_speeds_of_quaternions_ = 0;
    std::string text = "  - name: body" + std::to_string(index) + "\n";
    if (index > 0 && chance(0.8)) text += "    parent: body" + std::to_string(below(index)) + "\n";
    text += "    transform:\n";
    const int factors = 1 + below(3);
    bool moves = false;
    for (int i = 0; i < factors; ++i) {
      if (chance(0.6)) text += "      - " + shift() + "\n";
      if (chance(0.4)) text += "      - " + turn() + "\n";
      std::string factor = moving_factor();
      if (factor.empty() && !moves && has_room(1)) factor = joint();
      if (factor.empty()) continue;
      moves = true;
      text += "      - " + factor + "\n";
    }
    if (!moves) {
      // No speeds are left: a body that moves with earlier coordinates.
      const std::string about = axis();
      text += "      - {rotate: {axis: " + about + ", angle: \"0.2 + " + old_coordinate() + "/2\"}}\n";
    }
    if (chance(0.5)) text += "      - " + shift() + "\n";
    text += mass_properties();
    if (chance(0.4)) text += "    external_wrench: true\n";
    bodies_.push_back(text);
  }

  /// Of six point masses, so that the inertia is one that bodies have, and full.
  std::string mass_properties() {
    std::array<double, 6> I{};
    for (int i = 0; i < 6; ++i) {
      const double x = between(-0.4, 0.4), y = between(-0.4, 0.4), z = between(-0.4, 0.4),
                   m = between(0.1, 0.6);
      I[0] += m * (y * y + z * z);
      I[1] += m * (x * x + z * z);
      I[2] += m * (x * x + y * y);
      I[3] -= m * x * y;
      I[4] -= m * x * z;
      I[5] -= m * y * z;
    }
    const std::string mass = constant(0.5, 3), x = constant(-0.3, 0.3), y = constant(-0.3, 0.3),
                      z = constant(-0.3, 0.3);
    return "    mass: " + mass + "\n    com: " + list({x, y, z}) + "\n    inertia: {xx: " + decimal(I[0]) +
           ", yy: " + decimal(I[1]) + ", zz: " + decimal(I[2]) + ", xy: " + decimal(I[3]) +
           ", xz: " + decimal(I[4]) + ", yz: " + decimal(I[5]) + "}\n";
  }

  std::mt19937_64 random_;
  bool joints_only_;                               // nothing that multibody engines have no words for
  std::map<std::string, std::string> parameters_;  // the line of each
  std::string coordinates_, definitions_;
  std::vector<std::string> bodies_;
  std::vector<std::string> reals_;
  std::vector<std::string> used_;       // real coordinates in the transform being written
  int used_speeds_of_quaternions_ = 0;  // in the same
  int reserved_ = 0;                    // speeds that the transform being written will still need
  int speeds_ = 0, quaternions_ = 0, parameter_count_ = 0, definition_count_ = 0;
};

}  // namespace

std::string random_mechanism(std::uint64_t seed) {
  for (std::uint64_t trial = 0; trial < 50; ++trial) {
    const std::string text = Writer(1000003 * seed + trial).write();
    try {
      comparable_states(parse_description(text), 3, seed);
      return text;
    } catch (const BadlyConditioned&) {
      continue;
    }
  }
  throw std::runtime_error("no well conditioned mechanism near seed " + std::to_string(seed));
}

}  // namespace alembert::oracles
