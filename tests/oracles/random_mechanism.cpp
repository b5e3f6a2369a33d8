// Writes random descriptions (see the header).
#include "oracles/random_mechanism.hpp"

#include <algorithm>
#include <array>
#include <regex>
#include <stdexcept>
#include <vector>

#include "oracles/comparison.hpp"
#include "oracles/random_constraints.hpp"
#include "oracles/random_expressions.hpp"

namespace alembert::oracles {

namespace {

class Writer : private RandomExpressions {
 public:
  explicit Writer(std::uint64_t seed) : RandomExpressions(seed), joints_only_(chance(0.5)) {}

  std::string write() {
    const int bodies = 1 + below(5);
    for (int i = 0; i < bodies; ++i) write_body(i);
    if (chance(0.3)) std::reverse(bodies_.begin(), bodies_.end());  // children before parents
    const std::string constraints = chance(0.6) ? random_constraints(*this, bodies, rolling_) : "";
    std::string text = "gravity: " + list({gravity(), decimal(between(-3, 3)), gravity()}) + "\n";
    // Engines have no words for armatures of most joints. Nothing is drawn for them: a seed means what it
    // meant.
    const std::string armatures = joints_only_ ? "$1," : "$1, armature: 0.3,";
    text +=
        "coordinates:\n" + std::regex_replace(coordinates(), std::regex("(name: (?:q[147]|r0)),"), armatures);
    if (!definitions().empty()) text += "definitions:\n" + definitions();
    text += "bodies:\n";
    for (const std::string& body : bodies_) text += body;
    text += constraints;
    return "alembert: 1\nname: random_mechanism\n" + parameters_in(text) + text;
  }

 private:
  std::string gravity() { return chance(0.7) ? constant(-9, 9) : "0"; }
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
    surface_coordinates_.insert(surface_coordinates_.end(), {u, v});
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
    reserve(5);
    const std::string a = surface(first);
    const std::string b = surface(chance(0.7) != first);
    reserve(0);
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
        return depends_on_nothing() && has_room(5) ? mate() : "";
      default: {
        const std::string inner = moving_factor(1);
        if (inner.empty()) return "";
        return "{inverse: [" + turn() + ", " + inner + "]}";
      }
    }
  }

  void write_body(int index) {
    begin_transform();
    std::string text = "  - name: body" + std::to_string(index) + "\n";
    std::string parent = "world";
    if (index > 0 && chance(0.8)) {
      parent = "body" + std::to_string(below(index));
      text += "    parent: " + parent + "\n";
    }
    text += "    transform:\n";
    bool moves = false;
    if (!joints_only_ && chance(0.2) && has_room(5)) {
      text += "      - " + mate() + "\n";
      moves = true;
      const auto c = surface_coordinates_.end() - 4;
      rolling_.push_back({"body" + std::to_string(index), parent, c[0], c[1], c[2], c[3]});
    }
    const int factors = moves ? 0 : 1 + below(3);
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
    // All of them by one factor, so that they stay those of a body whatever it is.
    const std::string factor = chance(0.5) ? constant(0.8, 1.2) + "*" : "";
    const auto entry = [&](std::size_t k) { return factor + "(" + decimal(I[k]) + ")"; };
    return "    mass: " + mass + "\n    com: " + list({x, y, z}) + "\n    inertia: {xx: " + entry(0) +
           ", yy: " + entry(1) + ", zz: " + entry(2) + ", xy: " + entry(3) + ", xz: " + entry(4) +
           ", yz: " + entry(5) + "}\n";
  }

  bool joints_only_;  // nothing that multibody engines have no words for
  std::vector<std::string> bodies_;
  std::vector<std::string> surface_coordinates_;  // of all surfaces drawn, two each
  std::vector<RollingBody> rolling_;
};

}  // namespace

std::string random_mechanism(std::uint64_t seed) {
  for (std::uint64_t trial = 0; trial < 50; ++trial) {
    const std::string text = Writer(1000003 * seed + trial).write();
    try {
      const Description description = parse_description(text);
      comparable_states(description, 3, seed);
      comparable_states(parse_description(text, random_parameters(description, seed)), 3, seed);
      return text;
    } catch (const BadlyConditioned&) {
      continue;
    }
  }
  throw std::runtime_error("no well conditioned mechanism near seed " + std::to_string(seed));
}

}  // namespace alembert::oracles
