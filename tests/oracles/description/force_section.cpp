// Names and forces in the order of the file (see the header).
#include "oracles/description/force_section.hpp"

#include <stdexcept>

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

void read_input(const YAML::Node& node, const Names& names, Description& result) {
  Input input;
  input.name = node.IsScalar() ? node.as<std::string>() : node["name"].as<std::string>();
  const auto constant = [&](const YAML::Node& of) { return constant_value(expression_of(of, names)); };
  if (node.IsMap() && node["initial"]) input.initial = constant(node["initial"]);
  if (node.IsMap() && node["limits"])
    input.limits = {{constant(node["limits"][0]), constant(node["limits"][1])}};
  result.inputs.push_back(std::move(input));
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

Expression3 three_or_zero(const YAML::Node& node, const Names& names) {
  if (!node) return {number(0), number(0), number(0)};
  return {expression_of(node[0], names), expression_of(node[1], names), expression_of(node[2], names)};
}

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
    read_input(input, names, result);
    declare(result.inputs.back().name);
  }
  if (!root["forces"]) return;
  for (const std::string& frame : frames) {
    declare_three("velocity(" + frame + ")");
    for (const char row : {'x', 'y', 'z'})
      for (const char column : {'x', 'y', 'z'}) declare("rotation(" + frame + ")." + row + column);
    declare_three("angular_velocity(" + frame + ")");
  }
  for (const YAML::Node& force : root["forces"]) {
    if (!frames_along(force)) continue;
    const std::string name = force["name"].as<std::string>();
    declare("length(" + name + ")");
    declare("rate(" + name + ")");
    FramePath path;
    for (const YAML::Node& frame : frames_along(force))
      path.push_back(frame_index(root, frame.as<std::string>()));
    result.paths.push_back(std::move(path));
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

void read_forces(const YAML::Node& root, const Names& names, Description& result) {
  std::size_t path = 0;
  for (const YAML::Node& force : root["forces"]) {
    if (force["on"]) {
      result.forces.emplace_back(SpeedForce{speed_index(force["on"].as<std::string>(), result),
                                            expression_of(force["value"], names)});
    } else if (force["potential"]) {
      result.forces.emplace_back(Potential{expression_of(force["potential"], names)});
    } else if (frames_along(force)) {
      const std::string name = force["name"].as<std::string>();
      Names own = names;
      own["length"] = names.at("length(" + name + ")");
      own["rate"] = names.at("rate(" + name + ")");
      result.forces.emplace_back(Tension{path++, expression_of(force["tension"], own)});
    } else {
      FrameForce at;
      at.frame = frame_index(root, force["at"].as<std::string>());
      at.world_axes = force["axes"] && force["axes"].as<std::string>() == "world";
      at.force = three_or_zero(force["force"], names);
      at.torque = three_or_zero(force["torque"], names);
      result.forces.emplace_back(std::move(at));
    }
  }
}

void read_outputs(const YAML::Node& root, const Names& names, Description& result) {
  Names known = names;
  for (const YAML::Node& output : root["outputs"]) {
    const std::string name = output["name"].as<std::string>();
    known[name] = expression_of(output["value"], known);
    result.outputs.push_back({name, known[name]});
  }
}

}  // namespace alembert::oracles
