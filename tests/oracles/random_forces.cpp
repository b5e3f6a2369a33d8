// Draws forces (see the header).
#include "oracles/random_forces.hpp"

#include <cmath>
#include <map>
#include <regex>
#include <sstream>
#include <vector>

#include "oracles/description/description.hpp"

namespace alembert::oracles {

namespace {

/// Puts lines into a section; where there is none, begins it before `before`, or at the end.
void add_lines(std::string& text, const std::string& section, const std::string& lines,
               const std::string& before = "") {
  if (lines.empty()) return;
  const std::string header = section + ":\n";
  const std::size_t found = ("\n" + text).find("\n" + header);
  if (found != std::string::npos) {
    text.insert(found + header.size(), lines);
  } else if (before.empty()) {
    text += header + lines;
  } else {
    text.insert(("\n" + text).find("\n" + before), header + lines);
  }
}

class ForceWriter : private RandomQuantities {
 public:
  ForceWriter(const std::string& yaml, const Description& given, std::uint64_t seed, const ForceUnits& units)
      : RandomQuantities(given, seed, units), text_(yaml), given_(given) {}

  std::string write() {
    const int inputs = 1 + draw_.below(3);
    for (int i = 0; i < inputs; ++i) add_input(i);
    const int states = 1 + draw_.below(3);
    for (int i = 0; i < states; ++i) states_.push_back("s" + std::to_string(i));
    const int definitions = draw_.below(3);
    for (int i = 0; i < definitions; ++i) add_definition(i);
    const int frames = 3 + draw_.below(3);
    for (int i = 0; i < frames; ++i) add_frame(i);
    paths_ = 2 + draw_.below(2);
    for (int i = 0; i < kKinds; ++i) add_force(i);
    const int more = draw_.below(3);
    for (int i = 0; i < more; ++i) add_force(draw_.below(kKinds));
    for (; path_ < paths_;) add_force(kPath);
    for (int i = draw_.below(3); i > 0; --i) add_contact();
    add_outputs(draw_.below(3));
    for (const std::string& state : states_) add_state(state);
    add_forces_of_coordinates();
    add_lines(text_, "frames", frame_lines_);
    add_lines(text_, "inputs", input_lines_);
    add_lines(text_, "states", state_lines_);
    add_lines(text_, "forces", forces_);
    add_lines(text_, "outputs", output_lines_);
    add_lines(text_, "definitions", used(definitions_), "bodies:");
    add_lines(text_, "parameters", used(parameters_), "gravity:");
    return text_;
  }

 private:
  static constexpr int kKinds = 8, kPath = 3;

  /// Those that the text mentions.
  std::string used(const std::map<std::string, std::string>& declarations) const {
    std::string lines;
    for (const auto& [name, value] : declarations)
      if (std::regex_search(text_, std::regex("\\b" + name + "\\b")))
        lines += "  " + name + ": " + value + "\n";
    return lines;
  }

  void add_input(int i) {
    const std::string name = "in" + std::to_string(i), initial = decimal(draw_.between(-0.5, 0.5));
    const bool limits = draw_.chance(0.5);
    input_lines_ += i == 0 && !limits ? "  - " + name + "\n"
                                      : "  - {name: " + name + ", initial: " + initial +
                                            (limits ? ", limits: [-0.7, 1.3]" : "") + "}\n";
    inputs_.push_back(name);
  }
  void add_definition(int i) {
    const std::string name = "w" + std::to_string(i), size = constant(0.5, 2);
    const std::string x = coordinate(), in = one_of(draw_.chance(0.6) ? inputs_ : states_);
    definitions_[name] = "\"" + size + "*" + in + " + sin(" + x + " + t)\"";
    defined_.push_back(name);
  }

  /// Many pull towards what they should be.
  void add_state(const std::string& name) {
    const std::string initial = decimal(draw_.between(-0.5, 0.5)), change = value();
    const std::string rate =
        draw_.chance(0.5) ? "(" + change + " - " + name + ")/" + constant(0.05, 0.8) : change;
    state_lines_ += "  - {name: " + name + ", rate: \"" + rate + "\"" +
                    (draw_.chance(0.6) ? ", initial: " + initial : "") +
                    (draw_.chance(0.3) ? ", limits: [-1.3, 0.9]" : "") + "}\n";
  }
  /// Half of the time of no speeds, so that they have derivatives.
  void add_outputs(int count) {
    with_speeds_ = draw_.chance(0.5);
    for (int i = 0; i < count; ++i) {
      const std::string name = "y" + std::to_string(i);
      output_lines_ += "  - {name: " + name + ", value: \"" + value() + "\"}\n";
      outputs_.push_back(name);
    }
    with_speeds_ = true;
  }

  /// On a body or in the world; some move there.
  void add_frame(int i) {
    const std::string name = "g" + std::to_string(i);
    const int body = draw_.below(static_cast<int>(given_.bodies.size()) + 1) - 1;
    const double unit = units_.length;
    const std::string x = constant(-0.6, 0.6, unit), y = constant(-0.6, 0.6, unit),
                      z = constant(0.1, 0.8, unit);
    body_of_.push_back(body);
    frame_lines_ += "  - {name: " + name +
                    ", body: " + (body < 0 ? "world" : given_.bodies[static_cast<std::size_t>(body)].name) +
                    ", transform: [{translate: " + list({x, y, z}) + "}";
    if (draw_.chance(0.6)) {
      const std::string about = draw_.axis(), angle = constant(-1.5, 1.5);
      frame_lines_ += ", {rotate: {axis: " + about + ", angle: " + angle + "}}";
    }
    if (draw_.chance(0.4)) frame_lines_ += ", " + moving_factor();
    frame_lines_ += "]}\n";
    frames_.push_back(name);
  }
  std::string moving_factor() {
    const std::string q = coordinate();
    const double unit = units_.length;
    switch (draw_.below(3)) {
      case 0:
        return "{translate: " +
               list({decimal(0.3 * unit) + "*sin(" + q + ")", decimal(0.1 * unit),
                     decimal(0.2 * unit) + "*t"}) +
               "}";
      case 1: {
        const std::string about = draw_.axis();
        return "{rotate: {axis: " + about + ", angle: \"0.5*" + q + " + 0.3*sin(t)\"}}";
      }
      default: {
        const std::string other = coordinate();
        return "{translate: " +
               list({decimal(0.2 * unit) + "*" + q, decimal(0.1 * unit) + "*cos(" + other + ")",
                     decimal(0.1 * unit)}) +
               "}, {rotate: {axis: y, angle: \"" + other + "/2\"}}";
      }
    }
  }

  std::string tension() {
    const std::string length = this->length("length"), rate = this->length("rate");
    switch (draw_.below(3)) {
      case 0: {
        const std::string stiff = constant(3, 20), rest = constant(0.1, 1), damp = constant(0.1, 0.5);
        return stiff + "*max(0, " + length + " - " + rest + ") + " + damp + "*" + rate;
      }
      case 1: {
        const std::string in = one_of(draw_.chance(0.5) ? inputs_ : states_);
        return "(" + in + " + 1)*exp(-(" + length + " - 0.8)^2)*smoothstep(0.5 - " + rate + "/4)";
      }
      default:
        return value() + " + 0.5*" + length;
    }
  }

  /// From frame to frame, each other than the one before, perhaps back to the first; those between the ends perhaps
  /// under conditions. Where these leave a point out, its neighbours may be one frame.
  std::string points_of_path() {
    const int count = 3 + draw_.below(2);
    std::vector<std::string> points;
    while (static_cast<int>(points.size()) < count) {
      const std::string& next = one_of(frames_);
      if (points.empty() || points.back() != next) points.push_back(next);
    }
    if (draw_.chance(0.3) && points.back() != points.front()) points.push_back(points.front());
    std::string text = points.front();
    bool is_fixed = true;
    auto around = draw_;  // what else is drawn does not depend on obstacles
    for (std::size_t i = 1; i < points.size(); ++i) {
      const bool inside = i + 1 < points.size(), conditional = inside && draw_.chance(0.6);
      if (is_fixed && !conditional && around.chance(0.6)) text += ", " + obstacle(around);
      text +=
          ", " + (conditional ? "{frame: " + points[i] + ", when: \"" + condition(path_) + "\"}" : points[i]);
      is_fixed = !conditional;
    }
    return text;
  }
  template <class Random>
  std::string obstacle(Random& draw) const {
    const auto frame = [&] {
      return frames_[static_cast<std::size_t>(draw.below(static_cast<int>(frames_.size())))];
    };
    const bool sphere = draw.chance(0.5);
    std::string round = (sphere ? "{sphere: " : "{cylinder: ") + frame() +
                        ", radius: " + decimal(units_.length * draw.between(0.05, 0.4));
    if (!sphere && draw.chance(0.5)) round += ", length: " + decimal(units_.length * draw.between(0.2, 2));
    return round + (draw.chance(0.5) ? ", side: " + frame() : "") + "}";
  }

  void add_force(int kind) {
    const auto add = [this](const std::string& rest) {
      forces_ += "  - {name: force" + std::to_string(force_count_++) + ", " + rest + "}\n";
    };
    switch (kind) {
      case 0: {
        if (reals_.empty()) return;
        const std::string on = one_of(reals_);
        return add("on: " + on + ", value: \"" + times(torque() / unit_of(on), value()) + "\"");
      }
      case 1: {
        if (quaternions_.empty()) return;
        const std::string on = one_of(quaternions_) + component();
        return add("on: " + on + ", value: \"" + times(torque(), value()) + "\"");
      }
      case 2: {
        with_speeds_ = false;
        const std::string place = draw_.chance(0.3)   ? coordinate()
                                  : draw_.chance(0.5) ? length("position(" + one_of(frames_) + ").z")
                                                      : length("distance(" + two_frames(", ") + ")");
        add("potential: \"" + times(torque(), value() + " + 0.7*" + place + "^2") + "\"");
        with_speeds_ = true;
        return;
      }
      case kPath: {
        if (path_ == paths_) return;
        const bool several = path_ % 2 == 1;
        const std::string points = several ? points_of_path() : two_frames(", ");
        forces_ += "  - {name: path" + std::to_string(path_) + (several ? ", path: [" : ", between: [") +
                   points + "], tension: \"" + times(units_.force, tension()) + "\"}\n";
        ++path_;
        return;
      }
      case 4: {
        const std::string at = one_of(frames_), force = three_values(units_.force);
        return add("at: " + at + ", force: " + force);
      }
      case 5: {
        with_speeds_ = false;
        const std::string place = draw_.chance(0.5) && !reals_.empty()
                                      ? coordinate()
                                      : length("distance(" + two_frames(", ") + ")");
        const std::string function = value() + " + 0.7*" + place;
        with_speeds_ = true;
        return add("along: \"" + function + "\", value: \"" + times(torque(), value() + " - 0.3*rate") +
                   "\"");
      }
      case 6: {
        const std::string at = one_of(frames_), force = three_values(units_.force),
                          torques = three_values(torque());
        return add("at: " + at + ", axes: world, force: " + force + ", torque: " + torques);
      }
      default: {
        const std::string at = one_of(frames_), torques = three_values(torque());
        return add("at: " + at + ", axes: frame, torque: " + torques);
      }
    }
  }

  /// A sphere or a point of one body and a plane or a sphere of another, or of the world, if there are such; near
  /// enough to touch at some states.
  void add_contact() {
    const auto first = static_cast<std::size_t>(draw_.below(static_cast<int>(frames_.size())));
    const auto second = static_cast<std::size_t>(draw_.below(static_cast<int>(frames_.size())));
    const double unit = units_.length;
    const bool apart = body_of_[first] != body_of_[second], floor = draw_.chance(0.3);
    if (floor ? body_of_[first] < 0 : !apart) return;
    std::string lines = "{frame: " + frames_[first];
    if (draw_.chance(0.7)) lines += ", radius: " + constant(0.2, 0.9, unit);
    if (floor || draw_.chance(0.5)) {
      std::vector<std::string> normal, point;
      for (int i = 0; i < 3; ++i) normal.push_back(decimal(draw_.between(-1, 1)));
      for (int i = 0; i < 3; ++i) point.push_back(decimal(unit * draw_.between(-0.5, 0.5)));
      lines += ", plane: {normal: " + list(normal) + ", point: " + list(point) +
               (floor ? "" : ", frame: " + frames_[second]) + "}";
    } else {
      lines += ", sphere: {frame: " + frames_[second] + ", radius: " + constant(0.4, 1, unit) + "}";
    }
    const bool usual = draw_.chance(0.7);
    if (usual) {
      lines += ", stiffness: " + constant(5, 50, units_.force / std::pow(unit, 1.5));
      if (draw_.chance(0.8)) lines += ", dissipation: " + constant(0.05, 0.5, 1 / unit);
    } else {
      // Smooth where it touches, and never nothing.
      const std::string strength = constant(2, 20, units_.force / unit), steep = constant(2, 8, 1 / unit),
                        blur = constant(0.01, 0.1, unit * unit), loss = constant(0.05, 0.3, 1 / unit);
      lines += ", normal_force: \"" + strength + "*sqrt(depth^2 + " + blur + ")*(1 + tanh(" + steep +
               "*depth))*(1 + " + loss + "*rate)\", flattening: " + constant(0, 1);
    }
    if (draw_.chance(0.7)) {
      const std::string friction = constant(0.1, 1), slow = constant(0.05, 0.5, unit);
      lines += ", friction: " + (usual ? friction : "\"" + friction + "/(1 + slip/" + slow + ")\"") +
               ", slip_velocity: " + slow;
    }
    forces_ += "  - {name: force" + std::to_string(force_count_++) + ", contact: " + lines + "}}\n";
  }

  /// Into the line of each coordinate.
  void add_forces_of_coordinates() {
    std::istringstream lines(text_);
    std::string result, line;
    bool inside = false;
    while (std::getline(lines, line)) {
      if (line[0] != ' ') inside = line == "coordinates:";
      if (inside && line.back() == '}') {
        line.pop_back();
        const std::size_t name = line.find("name: ") + 6;
        const double unit = unit_of(line.substr(name, line.find_first_of(",}", name) - name));
        const double force = torque() / unit, stiff = force / unit;
        if (draw_.chance(0.4)) line += ", damping: " + constant(0.1, 1, stiff);
        if (draw_.chance(0.3)) {
          const std::string most = constant(0.2, 1, force), velocity = constant(0.05, 0.5, unit);
          line += ", friction: {force: " + most + ", velocity: " + velocity + "}";
        }
        if (draw_.chance(0.4) && line.find("quaternion") == std::string::npos) {
          line += ", stiffness: " + constant(1, 8, stiff);
          if (draw_.chance(0.6)) line += ", rest: " + constant(-0.5, 0.5, unit);
        }
        if (draw_.chance(0.2)) line += ", effort: 20, speed: 3";
        line += "}";
      }
      result += line + "\n";
    }
    text_ = result;
  }

  std::string text_;
  const Description& given_;
  std::map<std::string, std::string> definitions_;
  std::string frame_lines_, input_lines_, state_lines_, forces_, output_lines_;
  int force_count_ = 0;
  std::vector<int> body_of_;  ///< by frame; -1: the world
};

}  // namespace

std::string with_random_forces(const std::string& yaml, std::uint64_t seed, const ForceUnits& units) {
  const Description given = parse_description(yaml);
  return ForceWriter(yaml, given, seed, units).write();
}

}  // namespace alembert::oracles
