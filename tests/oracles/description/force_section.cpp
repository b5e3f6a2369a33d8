// Names and forces in the order of the file (see the header).
#include "oracles/description/force_section.hpp"

#include <array>
#include <cctype>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace alembert::oracles {

namespace {

std::size_t frame_index(const YAML::Node& root, const std::string& name) {
  std::size_t i = 0;
  for (const YAML::Node& frame : root["frames"]) {
    if (frame["name"].as<std::string>() == name) return i;
    ++i;
  }
  throw std::runtime_error("unknown frame '" + name + "'");
}

/// The frames that a force lies along; null if it is of another kind.
YAML::Node frames_along(const YAML::Node& force) {
  return force["between"] ? force["between"] : force["path"];
}

/// Name, initial value and limits of an input or a state.
template <class Given>
Given given_number(const YAML::Node& node, const Names& names) {
  Given result;
  result.name = node.IsScalar() ? node.as<std::string>() : node["name"].as<std::string>();
  const auto constant = [&](const YAML::Node& of) { return constant_value(expression_of(of, names)); };
  if (node.IsMap() && node["initial"]) result.initial = constant(node["initial"]);
  if (node.IsMap() && node["limits"])
    result.limits = {{constant(node["limits"][0]), constant(node["limits"][1])}};
  return result;
}

/// |difference of two positions|
Expression distance_between(const std::string& from, const std::string& to, const Names& names) {
  std::string squares;
  for (const char axis : {'x', 'y', 'z'}) {
    const auto at = [&](const std::string& frame) { return "position(" + frame + ")." + axis; };
    squares += (squares.empty() ? "(" : " + (") + at(to) + " - " + at(from) + ")^2";
  }
  return expression_of(YAML::Node("sqrt(" + squares + ")"), names);
}

/// `q`, or `q.x` of a quaternion.
int speed_index(const std::string& name, const Description& description) {
  const std::size_t dot = name.find('.');
  for (const Coordinate& c : description.coordinates) {
    if (c.name != name.substr(0, dot)) continue;
    return c.first_speed +
           (dot == std::string::npos ? 0 : static_cast<int>(std::string("xyz").find(name[dot + 1])));
  }
  throw std::runtime_error("no speed '" + name + "'");
}

FramePath read_path(const YAML::Node& points, const YAML::Node& root, const Names& names) {
  FramePath path;
  for (const YAML::Node& point : points) {
    if (point.IsMap() && (point["sphere"] || point["cylinder"])) {
      const bool cylinder = static_cast<bool>(point["cylinder"]);
      PathObstacle& around = path.obstacles[path.points.size() - 1];
      around.frame = frame_index(root, point[cylinder ? "cylinder" : "sphere"].as<std::string>());
      around.cylinder = cylinder;
      around.radius = expression_of(point["radius"], names);
      if (point["length"]) around.length = expression_of(point["length"], names);
      if (point["side"]) around.side = frame_index(root, point["side"].as<std::string>());
    } else if (point.IsScalar())
      path.points.push_back({frame_index(root, point.as<std::string>()), nullptr});
    else
      path.points.push_back({frame_index(root, point["frame"].as<std::string>()),
                             point["when"] ? expression_of(point["when"], names) : nullptr});
  }
  return path;
}

Expression3 three_or_zero(const YAML::Node& node, const Names& names) {
  if (!node) return {number(0), number(0), number(0)};
  return {expression_of(node[0], names), expression_of(node[1], names), expression_of(node[2], names)};
}

/// A contact as formulas in text, whose parts have names: a force at the surface of the sphere, and its opposite on what
/// it touches.
class ContactText {
 public:
  using Three = std::array<std::string, 3>;

  ContactText(const YAML::Node& contact, const YAML::Node& root, const Names& names) : names_(names) {
    const auto text = [&](const char* key, const char* otherwise) {
      return contact[key] ? "(" + contact[key].as<std::string>() + ")" : otherwise;
    };
    const std::string frame = contact["frame"].as<std::string>();
    const std::string radius = text("radius", "0");
    const Three center = of(frame, "position");
    std::string other, depth;
    Three normal;
    if (const YAML::Node plane = contact["plane"]) {
      Three point{"0", "0", "0"}, axis;
      for (std::size_t i = 0; i < 3; ++i) {
        axis[i] = "(" + plane["normal"][i].as<std::string>() + ")";
        if (plane["point"]) point[i] = "(" + plane["point"][i].as<std::string>() + ")";
      }
      const std::string length = "sqrt(" + dot(axis, axis) + ")";
      for (std::string& entry : axis) entry = "(" + entry + "/" + length + ")";
      if (plane["frame"]) {
        other = plane["frame"].as<std::string>();
        axis = turned(other, axis);
        point = sum(of(other, "position"), turned(other, point));
      }
      normal = axis;
      depth = "(" + radius + " - " + dot(normal, difference(center, point)) + ")";
    } else {
      const YAML::Node sphere = contact["sphere"];
      other = sphere["frame"].as<std::string>();
      const Three apart = difference(center, of(other, "position"));
      const std::string distance = "sqrt(" + dot(apart, apart) + ")";
      for (std::size_t i = 0; i < 3; ++i) normal[i] = "(" + apart[i] + "/" + distance + ")";
      depth = "(" + radius + " + " + sphere["radius"].as<std::string>() + " - " + distance + ")";
    }
    depth = called("contact__depth", depth);
    normal = called("contact__normal", normal);
    const Three arm = times("(" + text("flattening", "0") + "*" + depth + " - " + radius + ")", normal);
    Three velocity = at(frame, arm), other_arm;
    if (!other.empty()) {
      other_arm = difference(sum(center, arm), of(other, "position"));
      velocity = difference(velocity, at(other, other_arm));
    }
    velocity = called("contact__velocity", velocity);
    const std::string speed = called("contact__speed", dot(normal, velocity));
    const std::string strength =
        contact["normal_force"]
            ? with_words(text("normal_force", ""), {{"depth", depth}, {"rate", "(-" + speed + ")"}})
            : text("stiffness", "0") + "*select(" + depth + ", " + depth + "^1.5, 0)*max(0, 1 - 1.5*" +
                  text("dissipation", "0") + "*" + speed + ")";
    const Three slip = called("contact__slip", difference(velocity, times(speed, normal)));
    const std::string size =
        called("contact__size", "sqrt(" + dot(slip, slip) + " + " + text("slip_velocity", "1") + "^2)");
    const Three braking = times(with_words(text("friction", "0"), {{"slip", size}}) + "/" + size, slip);
    const Three force =
        called("contact__force", times(called("contact__strength", strength), difference(normal, braking)));
    add(root, frame, force, arm);
    if (!other.empty()) add(root, other, times("(-1)", force), other_arm);
  }
  const std::vector<FrameForce>& forces() const { return forces_; }

 private:
  std::string called(const std::string& name, const std::string& text) {
    names_[name] = expression_of(YAML::Node(text), names_);
    return name;
  }
  Three called(const std::string& name, const Three& texts) {
    return {called(name + ".x", texts[0]), called(name + ".y", texts[1]), called(name + ".z", texts[2])};
  }
  /// A text in which words stand for others.
  static std::string with_words(std::string text, const std::map<std::string, std::string>& words) {
    const auto is_letter = [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    };
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
      std::size_t end = i + 1;
      if (is_letter(text[i]))
        while (end < text.size() && is_letter(text[end])) ++end;
      const std::string word = text.substr(i, end - i);
      const auto found = words.find(word);
      result += found == words.end() ? word : found->second;
      i = end;
    }
    return result;
  }
  static Three of(const std::string& frame, const std::string& what) {
    return {what + "(" + frame + ").x", what + "(" + frame + ").y", what + "(" + frame + ").z"};
  }
  static std::string dot(const Three& a, const Three& b) {
    return "(" + a[0] + "*" + b[0] + " + " + a[1] + "*" + b[1] + " + " + a[2] + "*" + b[2] + ")";
  }
  static Three each(const Three& a, const char* sign, const Three& b) {
    return {"(" + a[0] + sign + b[0] + ")", "(" + a[1] + sign + b[1] + ")", "(" + a[2] + sign + b[2] + ")"};
  }
  static Three sum(const Three& a, const Three& b) { return each(a, " + ", b); }
  static Three difference(const Three& a, const Three& b) { return each(a, " - ", b); }
  static Three times(const std::string& s, const Three& a) { return each({s, s, s}, "*", a); }
  static Three cross(const Three& a, const Three& b) {
    return {"(" + a[1] + "*" + b[2] + " - " + a[2] + "*" + b[1] + ")",
            "(" + a[2] + "*" + b[0] + " - " + a[0] + "*" + b[2] + ")",
            "(" + a[0] + "*" + b[1] + " - " + a[1] + "*" + b[0] + ")"};
  }
  static Three turned(const std::string& frame, const Three& a) {
    Three result;
    for (std::size_t row = 0; row < 3; ++row) {
      const std::string r = "rotation(" + frame + ")." + "xyz"[row];
      result[row] = dot({r + "x", r + "y", r + "z"}, a);
    }
    return result;
  }
  static Three at(const std::string& frame, const Three& arm) {
    return sum(of(frame, "velocity"), cross(of(frame, "angular_velocity"), arm));
  }
  void add(const YAML::Node& root, const std::string& frame, const Three& force, const Three& arm) {
    FrameForce result;
    result.frame = frame_index(root, frame);
    result.world_axes = true;
    const Three torque = cross(arm, force);
    for (std::size_t i = 0; i < 3; ++i) {
      result.force[i] = expression_of(YAML::Node(force[i]), names_);
      result.torque[i] = expression_of(YAML::Node(torque[i]), names_);
    }
    forces_.push_back(std::move(result));
  }

  Names names_;
  std::vector<FrameForce> forces_;
};

}  // namespace

Expression variable(int index) {
  auto symbol = std::make_shared<ExpressionNode>();
  symbol->operation = Operation::coordinate;
  symbol->coordinate = index;
  return symbol;
}

Expression expression_of(const YAML::Node& node, const Names& names) {
  return parse(node.as<std::string>(), [&](const std::string& name) -> Expression {
    const auto found = names.find(name);
    return found == names.end() ? nullptr : found->second;
  });
}

void declare_quantities(const YAML::Node& root, Names& names, Description& result) {
  int next = result.nq;
  const auto declare = [&](const std::string& name) { names[name] = variable(next++); };
  const auto declare_three = [&](const std::string& name) {
    for (const char axis : {'x', 'y', 'z'}) declare(name + "." + axis);
  };
  for (const Coordinate& c : result.coordinates) {
    if (c.quaternion)
      declare_three("d(" + c.name + ")");
    else
      declare("d(" + c.name + ")");
  }
  std::vector<std::string> frames;
  for (const YAML::Node& frame : root["frames"]) frames.push_back(frame["name"].as<std::string>());
  for (const std::string& frame : frames) declare_three("position(" + frame + ")");
  for (const YAML::Node& input : root["inputs"]) {
    result.inputs.push_back(given_number<Input>(input, names));
    declare(result.inputs.back().name);
  }
  for (const YAML::Node& state : root["states"]) {
    result.states.push_back(given_number<Integrated>(state, names));
    declare(result.states.back().name);
  }
  if (!root["forces"] && !root["outputs"] && !root["states"]) return;
  for (const std::string& frame : frames) {
    declare_three("velocity(" + frame + ")");
    for (const char row : {'x', 'y', 'z'})
      for (const char column : {'x', 'y', 'z'}) declare("rotation(" + frame + ")." + row + column);
    declare_three("angular_velocity(" + frame + ")");
  }
  // What a force is along may be of all paths.
  for (const bool of_path : {true, false}) {
    for (const YAML::Node& force : root["forces"]) {
      if (of_path ? !frames_along(force) : !force["along"]) continue;
      const std::string name = force["name"].as<std::string>();
      declare("length(" + name + ")");
      declare("rate(" + name + ")");
    }
  }
  for (const std::string& from : frames)
    for (const std::string& to : frames)
      names["distance(" + from + "," + to + ")"] = distance_between(from, to, names);
}

void read_coordinate_forces(const YAML::Node& node, const Names& names, Coordinate& coordinate) {
  const auto read = [&](const YAML::Node& from, double& to) {
    if (from) to = constant_value(expression_of(from, names));
  };
  read(node["damping"], coordinate.damping);
  read(node["stiffness"], coordinate.stiffness);
  read(node["rest"], coordinate.rest);
  const YAML::Node friction = node["friction"];
  if (!friction) return;
  read(friction["force"], coordinate.friction);
  read(friction["velocity"], coordinate.friction_velocity);
}

void read_forces(const YAML::Node& root, Names& names, Description& result) {
  std::map<std::string, std::size_t> paths;
  for (const YAML::Node& force : root["forces"]) {
    const YAML::Node points = frames_along(force);
    if (!points) continue;
    paths[force["name"].as<std::string>()] = result.paths.size();
    result.paths.push_back(read_path(points, root, names));
  }
  for (const YAML::Node& force : root["forces"]) {
    if (!force["along"]) continue;
    paths[force["name"].as<std::string>()] = result.paths.size();
    result.paths.push_back({{}, expression_of(force["along"], names), {}});
  }
  for (const YAML::Node& force : root["forces"]) {
    if (force["on"]) {
      result.forces.emplace_back(SpeedForce{speed_index(force["on"].as<std::string>(), result),
                                            expression_of(force["value"], names)});
    } else if (force["potential"]) {
      result.forces.emplace_back(Potential{expression_of(force["potential"], names)});
    } else if (force["along"]) {
      const std::string name = force["name"].as<std::string>();
      Names own = names;
      own["rate"] = names.at("rate(" + name + ")");
      result.forces.emplace_back(ForceAlong{paths.at(name), expression_of(force["value"], own)});
    } else if (frames_along(force)) {
      const std::string name = force["name"].as<std::string>();
      Names own = names;
      own["length"] = names.at("length(" + name + ")");
      own["rate"] = names.at("rate(" + name + ")");
      const Expression tension = expression_of(force["tension"], own);
      result.forces.emplace_back(Tension{paths.at(name), tension});
      names["tension(" + name + ")"] = tension;
    } else if (force["contact"]) {
      const ContactText contact(force["contact"], root, names);
      for (const FrameForce& wrench : contact.forces()) result.forces.emplace_back(wrench);
    } else {
      FrameForce at;
      at.frame = frame_index(root, force["at"].as<std::string>());
      at.world_axes = force["axes"] && force["axes"].as<std::string>() == "world";
      at.force = three_or_zero(force["force"], names);
      at.torque = three_or_zero(force["torque"], names);
      result.forces.emplace_back(std::move(at));
    }
    result.force_names.resize(result.forces.size(), force["name"].as<std::string>());
  }
}

void read_outputs(const YAML::Node& root, Names& names, Description& result) {
  for (const YAML::Node& output : root["outputs"]) {
    const std::string name = output["name"].as<std::string>();
    const Expression value = expression_of(output["value"], names);
    names[name] = value;
    result.outputs.push_back({name, value});
  }
}

void read_state_rates(const YAML::Node& root, const Names& names, Description& result) {
  std::size_t i = 0;
  for (const YAML::Node& state : root["states"])
    result.states[i++].rate = expression_of(state["rate"], names);
}

}  // namespace alembert::oracles
