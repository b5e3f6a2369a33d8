// Writes mechanisms that are hard on numbers (see the header).
#include "oracles/nasty_mechanism.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "oracles/nasty_constraints.hpp"
#include "oracles/nasty_joints.hpp"
#include "oracles/reference.hpp"
#include "oracles/taylor/numeric_lagrangian.hpp"

namespace alembert::oracles {

namespace {

constexpr double kNastyCondition = 1e9;
constexpr long double kRowDigits = 1e-3L;

constexpr std::array<NastyKind, 10> kKinds{{
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

class NastyWriter : private NastyJoints {
 public:
  NastyWriter(RandomExpressions& draw, const NastyKind& kind, NastyMechanism& result)
      : NastyJoints(draw, kind, result), draw_(draw), kind_(kind), result_(result) {}

  void write() {
    const int bodies = 2 + draw_.below(kind_.curved ? 2 : 3);
    for (int i = 0; i < bodies; ++i) write_body(i, i + 1 == bodies);
    ConstraintSections sections;
    if (draw_.chance(0.5)) {
      Constrainable of{{}, angles(), speeds(), rolling_, bodies, result_.length};
      of.coordinates = angles();
      for (const auto& [name, unit] : result_.lengths) of.coordinates.push_back(name);
      sections = nasty_constraints(draw_, *this, late(), kind_.late, of);
    }
    const bool falls = draw_.chance(0.8);
    if (!falls) result_.gravity = 1;
    const std::string x = falls ? "0" : number(-1, 1), z = falls ? value_or_parameter(-9.81) : number(-1, 1);
    std::string rest = "gravity: " + list({x, "0", z}) + "\ncoordinates:\n" + coordinates();
    if (!definitions_.empty()) rest += "definitions:\n" + definitions_;
    rest += "bodies:\n" + bodies_ + frames_ + sections.frames + sections.constraints;
    result_.text =
        "alembert: 1\nname: nasty_" + std::string(kind_.name) + "\n" + draw_.parameters_in(rest) + rest;
    result_.kind = kind_.name;
  }

 private:
  /// The value of a late function, or a parameter of tiny default times a function; a length or an angle.
  std::string late_value(double size) {
    const std::string of = draw_.chance(0.25) ? "t" : old_angle();
    if (draw_.chance(0.2)) {
      static constexpr std::array<const char*, 3> kDefaults{"1.0e-09", "1.0e-15", "0"};
      const std::string usual = kDefaults[static_cast<std::size_t>(draw_.below(3))];
      return parameter(size * draw_.between(0.4, 0.9), usual) + "*(1 + sin(" + of + " - 0.3))";
    }
    const std::string f = late().function(of, size);
    if (!draw_.chance(0.2)) return f;
    const std::string name = "d" + std::to_string(definition_count_++);
    definitions_ += "  " + name + ": \"" + f + "\"\n";
    return name;
  }

  std::string late_factor() {
    const double unit = 0.3 * result_.length;
    switch (draw_.below(kind_.curved ? 6 : 3)) {
      case 0: {
        const std::string x = late_value(unit), y = length();
        return "{translate: " + list({x, y, "0"}) + "}";
      }
      case 1: {
        const std::string x = length(), z = late_value(unit);
        return "{translate: " + list({x, "0", z}) + "}";
      }
      case 2: {
        const std::string about = draw_.axis();
        return "{rotate: {axis: " + about + ", angle: \"" + late_value(0.7) + "\"}}";
      }
      case 3: {
        const std::string f = "(" + late_value(0.7) + ")", x = length();
        const std::string c = "cos(" + f + ")", s = "sin(" + f + ")", minus = "-sin(" + f + ")";
        return "{matrix: [" + list({c, minus, "0", x}) + ", " + list({s, c, "0", "0"}) + ", " +
               list({"0", "0", "1", "0.1"}) + "]}";
      }
      case 4: {
        const std::string about = draw_.axis(), z = late_value(unit);
        return "{inverse: [{rotate: {axis: " + about +
               ", angle: 0.7}}, {translate: " + list({"0.2", "0", z}) + "}]}";
      }
      default:
        return has_room(1) ? guide() : shift();
    }
  }

  /// A curve or a surface that a body slides on.
  std::string guide() {
    const double unit = 0.3 * result_.length;
    const std::string s = new_angle(), r = number(0.5, 1.1), h = number(0.1, 0.4);
    if (draw_.chance(0.5) || !has_room(1)) {
      const std::string lift = late().function(s, unit);
      return "{curve: {point: " +
             list({r + "*cos(" + s + ")", r + "*sin(" + s + ")", h + "*" + s + " + " + lift}) +
             ", along: " + s + ", frame: " + (draw_.chance(0.3) ? "frenet" : "{reference: [0.02, 0.03, 1]}") +
             "}}";
    }
    const std::string v = new_angle();
    return torus(s, v, r, false);
  }

  /// A torus with a late bulge.
  std::string torus(const std::string& u, const std::string& v, const std::string& radius, bool flip) {
    const std::string tube = number(0.2, 0.4), bulge = late().function(u, 0.2);
    const std::string R = "(" + radius + " + 0.6 + " + bulge + " + " + tube + "*cos(" + v + "))";
    return "{surface: {point: " +
           list({R + "*cos(" + u + ")", R + "*sin(" + u + ")", tube + "*sin(" + v + ")"}) + ", along: [" + u +
           ", " + v + "]" + (flip ? ", flip: true" : "") + "}}";
  }
  /// Two tori that touch, and turn about where they do.
  std::string mate(const std::string& body, const std::string& parent) {
    const std::string u1 = new_angle(), v1 = new_angle(), u2 = new_angle(), v2 = new_angle();
    const std::string r1 = number(0.5, 1.1), r2 = number(0.5, 1.1);
    const bool flips = draw_.chance(0.5);
    const std::string first = torus(u1, v1, r1, false), second = torus(u2, v2, r2, flips);
    std::string spin;
    if (draw_.chance(0.5)) {
      const std::string of = has_room(1) ? new_angle() : "t";
      spin = ", spin: \"" + late().function(of, 0.7) + " + " + of + "\"";
    }
    rolling_.push_back({body, parent, u1, v1, u2, v2});
    return "{mate: [" + first + ", " + second + "]" + spin + "}";
  }

  void write_body(int index, bool last) {
    const auto add = [&](const std::string& factor) { bodies_ += "      - " + factor + "\n"; };
    const std::string name = "body" + std::to_string(index);
    bodies_ += "  - name: " + name + "\n";
    std::string parent = "world";
    if (index > 0) {
      parent = "body" + std::to_string(kind_.trees && draw_.chance(0.4) ? draw_.below(index) : index - 1);
      bodies_ += "    parent: " + parent + "\n";
    }
    bodies_ += "    transform:\n";
    begin_transform();
    const bool touches = kind_.curved && index > 0 && has_room(4) && draw_.chance(0.4);
    if (touches) add(mate(name, parent));
    const int joints = touches ? 0 : 1 + draw_.below(2);
    for (int i = 0; i < joints; ++i) {
      if (index > 0 || draw_.chance(0.3)) add(shift());
      if (index > 0 || i > 0) {
        add(turn("xy"[draw_.below(2)]));
        if (draw_.chance(0.3)) add(turn('z'));
      }
      if (draw_.chance(0.08)) add(driven());
      if (kind_.trees && index == 0 && i == 0 && draw_.chance(0.3)) {
        add(free_joint());
      } else if (kind_.trees && has_room(3) && draw_.chance(0.15)) {
        add(spherical_joint());
      } else if (!has_room(1) || (index > 0 && draw_.chance(kind_.trees ? 0.25 : 0.08))) {
        add(follower());
      } else {
        add(joint());
      }
      if (kind_.late && draw_.chance(0.6)) add(late_factor());
    }
    if (!touches && draw_.chance(0.4)) add(shift());
    if (!(kind_.trees && !last && index > 0 && draw_.chance(0.2))) mass_properties(last);
    if (draw_.chance(0.2)) bodies_ += "    external_wrench: true\n";
    if (!last) return;
    begin_transform();
    const std::string at = shift(), moved = draw_.chance(0.2) ? follower() : turn('x');
    frames_ = "frames:\n  - {name: tip, body: " + name + ", transform: [" + at + ", " + moved + "]}\n";
  }

  /// A full inertia is that of six point masses.
  void mass_properties(bool last) {
    const double unit = scale() * result_.length;
    const double own = mass() * (kind_.scales ? std::pow(10, draw_.between(-7, 1)) : draw_.between(0.3, 3));
    std::array<double, 6> I{};
    for (int i = 0; i < 6; ++i) {
      const double x = draw_.between(-0.4, 0.4), y = draw_.between(-0.4, 0.4), z = draw_.between(-0.4, 0.4);
      const double m = own * unit * unit / 6;
      I[0] += m * (y * y + z * z);
      I[1] += m * (x * x + z * z);
      I[2] += m * (x * x + y * y);
      I[3] -= m * x * y;
      I[4] -= m * x * z;
      I[5] -= m * y * z;
    }
    bodies_ += "    mass: " + value_or_parameter(own, 12) + "\n";
    const auto within = [&] { return value_or_parameter(draw_.between(-0.3, 0.3) * unit); };
    const std::string x = within(), y = within(), z = within();
    if (last || draw_.chance(0.8)) bodies_ += "    com: " + list({x, y, z}) + "\n";
    if (draw_.chance(kind_.trees || kind_.tilts ? 0.3 : 0.15)) return;
    // All entries by one factor, so that they stay those of a body.
    const std::string factor = value_or_parameter(1);
    const auto text = [&](double value) {
      char buffer[32];
      std::snprintf(buffer, sizeof buffer, "%.12g", value);
      return factor == "1" ? std::string(buffer) : factor + "*(" + buffer + ")";
    };
    bodies_ += "    inertia: {xx: " + text(I[0]) + ", yy: " + text(I[1]) + ", zz: " + text(I[2]);
    if (draw_.chance(0.7)) bodies_ += ", xy: " + text(I[3]) + ", xz: " + text(I[4]) + ", yz: " + text(I[5]);
    bodies_ += "}\n";
  }

  RandomExpressions& draw_;
  const NastyKind& kind_;
  NastyMechanism& result_;
  int definition_count_ = 0;
  std::vector<RollingBody> rolling_;
  std::string definitions_, bodies_, frames_;
};

/// Whether M and the constraints' rows are those of a mechanism that moves.
bool is_regular(const Description& description, const State& state) {
  if (!(scaled_condition(numeric_lagrangian<long double>(description, state).mass_matrix) < kNastyCondition))
    return false;
  if (description.constraints.empty()) return true;
  const ConstraintRowsOf<double> rows = numeric_constraints<double>(description, state);
  const ConstraintRowsOf<long double> exact = numeric_constraints<long double>(description, state);
  // A row that no speed enters, but for the rounding of pi/2, constrains nothing.
  for (Eigen::Index i = 0; i < exact.P.rows(); ++i)
    if (!((rows.P.row(i).cast<long double>() - exact.P.row(i)).norm() < kRowDigits * exact.P.row(i).norm()))
      return false;
  return constrained_motion(numeric_lagrangian<double>(description, state), rows).condition < kNastyCondition;
}

}  // namespace

NastyMechanism nasty_mechanism(std::uint64_t seed) {
  const NastyKind& kind = kKinds[seed % kKinds.size()];
  for (std::uint64_t trial = 0; trial < 200; ++trial) {
    RandomExpressions draw(1000003 * seed + trial);
    NastyMechanism mechanism;
    NastyWriter(draw, kind, mechanism).write();
    const Description description = parse_description(mechanism.text, mechanism.parameters);
    if (kind.late && mechanism.events.empty() && mechanism.parameters.empty()) continue;
    const std::vector<State> states = nasty_states(mechanism, description, seed, kNastyStates);
    if (std::all_of(states.begin(), states.end(),
                    [&](const State& state) { return is_regular(description, state); }))
      return mechanism;
  }
  throw std::runtime_error("no mechanism that moves near seed " + std::to_string(seed));
}

}  // namespace alembert::oracles
