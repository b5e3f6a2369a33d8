// Draws forces (see the header).
#include "oracles/random_forces.hpp"

#include <cmath>
#include <map>
#include <regex>
#include <sstream>
#include <vector>

#include "oracles/random_quantities.hpp"

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

class ForceWriter : QuantityWriter {
 public:
  ForceWriter(const std::string& yaml, std::uint64_t seed, const ForceUnits& units)
      : ForceWriter(yaml, parse_description(yaml), seed, units) {}

  std::string write() {
    const int inputs = 1 + draw_.below(3);
    for (int i = 0; i < inputs; ++i) add_input(i);
    const int definitions = draw_.below(3);
    for (int i = 0; i < definitions; ++i) add_definition(i);
    const int frames = 3 + draw_.below(3);
    for (int i = 0; i < frames; ++i) add_frame(i);
    paths_ = 2 + draw_.below(2);
    for (int i = 0; i < kKinds; ++i) add_force(i);
    const int more = draw_.below(3);
    for (int i = 0; i < more; ++i) add_force(draw_.below(kKinds));
    for (; path_ < paths_;) add_force(kPath);
    add_forces_of_coordinates();
    const int contacts = draw_.below(3), outputs = draw_.below(4);
    for (int i = 0; i < contacts; ++i) add_contact();
    for (int i = 0; i < outputs; ++i) add_output(i);
    add_lines(text_, "frames", frame_lines_);
    add_lines(text_, "inputs", input_lines_);
    add_lines(text_, "forces", forces_);
    add_lines(text_, "outputs", outputs_);
    add_lines(text_, "definitions", used(definitions_), "bodies:");
    add_lines(text_, "parameters", used(parameters_), "gravity:");
    return text_;
  }

 private:
  ForceWriter(const std::string& yaml, const Description& given, std::uint64_t seed, const ForceUnits& units)
      : QuantityWriter(seed, given, units), text_(yaml), given_(given) {}

  static constexpr int kKinds = 7, kPath = 3;

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
    const std::string x = coordinate(), in = one_of(inputs_);
    definitions_[name] = "\"" + size + "*" + in + " + sin(" + x + " + t)\"";
    defined_.push_back(name);
  }

  /// On a body or in the world; some move there.
  void add_frame(int i) {
    const std::string name = "g" + std::to_string(i);
    const int body = draw_.below(static_cast<int>(given_.bodies.size()) + 1) - 1;
    const double unit = units_.length;
    const std::string x = constant(-0.6, 0.6, unit), y = constant(-0.6, 0.6, unit),
                      z = constant(0.1, 0.8, unit);
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
    body_of_.push_back(body);
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
        std::string frames = two_frames(", ");
        if (path_ % 2 == 1) {
          // Over a third frame, and perhaps back to the first.
          const std::string first = frames.substr(0, frames.find(','));
          for (const std::string& frame : frames_) {
            if (frames.find(frame) != std::string::npos) continue;
            frames += ", " + frame;
            break;
          }
          if (draw_.chance(0.3)) frames += ", " + first;
        }
        forces_ += "  - {name: path" + std::to_string(path_) +
                   (path_ % 2 == 1 ? ", path: [" : ", between: [") + frames + "], tension: \"" +
                   times(units_.force, tension()) + "\"}\n";
        ++path_;
        return;
      }
      case 4: {
        const std::string at = one_of(frames_), force = three_values(units_.force);
        return add("at: " + at + ", force: " + force);
      }
      case 5: {
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
    lines += ", stiffness: " + constant(5, 50, units_.force / std::pow(unit, 1.5));
    if (draw_.chance(0.8)) lines += ", dissipation: " + constant(0.05, 0.5, 1 / unit);
    if (draw_.chance(0.7)) {
      const std::string friction = constant(0.1, 1), slow = constant(0.05, 0.5, unit);
      lines += ", friction: " + friction + ", slip_velocity: " + slow;
    }
    forces_ += "  - {name: force" + std::to_string(force_count_++) + ", contact: " + lines + "}}\n";
  }

  /// Of positions and time, so that it has derivatives, but for some.
  void add_output(int i) {
    with_speeds_ = draw_.chance(0.1);
    std::string text = value();
    if (i > 0 && draw_.chance(0.4)) text += " + 0.5*out" + std::to_string(i - 1) + "^2";
    with_speeds_ = true;
    outputs_ += "  - {name: out" + std::to_string(i) + ", value: \"" + text + "\"}\n";
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
  Description given_;
  std::vector<int> body_of_;  ///< by frame; -1: the world
  std::map<std::string, std::string> definitions_;
  std::string frame_lines_, input_lines_, forces_, outputs_;
  int force_count_ = 0, path_ = 0;
};

}  // namespace

std::string with_random_forces(const std::string& yaml, std::uint64_t seed, const ForceUnits& units) {
  return ForceWriter(yaml, seed, units).write();
}

}  // namespace alembert::oracles
