// YAML in, Description out (see the header). Files are taken to be well formed: judging bad ones is not an
// oracle's work.
#include "oracles/description/description.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>

#include "oracles/description/force_section.hpp"

namespace alembert::oracles {

namespace {

class Reader {
 public:
  Reader(const YAML::Node& root, const std::map<std::string, double>& values)
      : root_(root), values_(values) {}

  Description read() {
    result_.name = root_["name"].as<std::string>();
    read_parameters();
    if (root_["gravity"]) result_.gravity = constants(root_["gravity"]);
    for (const YAML::Node& node : root_["coordinates"]) read_coordinate(node);
    declare_quantities(root_, names_, result_);
    for (const auto& definition : root_["definitions"]) {
      names_[definition.first.as<std::string>()] = expression(definition.second);
    }
    read_bodies();
    for (const YAML::Node& node : root_["frames"]) read_frame(node);
    for (const YAML::Node& node : root_["constraints"]) read_constraint(node);
    read_forces(root_, names_, result_);
    read_outputs(root_, names_, result_);
    read_state_rates(root_, names_, result_);
    return result_;
  }

 private:
  Expression expression(const YAML::Node& node) const { return expression_of(node, names_); }
  double constant(const YAML::Node& node) { return constant_value(expression(node)); }
  Expression3 expressions(const YAML::Node& node) {
    return {expression(node[0]), expression(node[1]), expression(node[2])};
  }
  std::array<double, 3> constants(const YAML::Node& node) {
    return {constant(node[0]), constant(node[1]), constant(node[2])};
  }
  std::array<double, 3> axis(const YAML::Node& node) {
    if (!node) return {0, 0, 1};  // the default axis of a joint
    if (node.IsScalar()) {
      const std::string letter = node.as<std::string>();
      if (letter == "x") return {1, 0, 0};
      if (letter == "y") return {0, 1, 0};
      if (letter == "z") return {0, 0, 1};
      throw std::runtime_error("unknown axis '" + letter + "'");
    }
    std::array<double, 3> v = constants(node);
    const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (double& entry : v) entry /= length;
    return v;
  }

  void read_parameters() {
    for (const auto& entry : root_["parameters"]) {
      const std::string name = entry.first.as<std::string>();
      double value = constant(entry.second.IsMap() ? entry.second["value"] : entry.second);
      if (entry.second.IsMap() && entry.second["runtime"] && entry.second["runtime"].as<bool>()) {
        const auto other = values_.find(name);
        if (other != values_.end()) value = other->second;
        result_.runtime_parameters[name] = value;
      }
      result_.parameters.emplace_back(name, value);
      names_[name] = number(value);
    }
  }

  void read_coordinate(const YAML::Node& node) {
    Coordinate c;
    c.name = node.IsScalar() ? node.as<std::string>() : node["name"].as<std::string>();
    c.quaternion = node.IsMap() && node["type"] && node["type"].as<std::string>() == "quaternion";
    c.first_q = result_.nq;
    c.first_speed = result_.nv;
    c.initial = c.quaternion ? std::vector<double>{0, 0, 0, 1} : std::vector<double>{0};
    if (node.IsMap() && node["initial"]) {
      const YAML::Node initial = node["initial"];
      if (initial.IsSequence()) {
        for (std::size_t i = 0; i < c.initial.size(); ++i) c.initial[i] = constant(initial[i]);
      } else {
        c.initial[0] = constant(initial);
      }
    }
    if (node.IsMap() && node["limits"])
      c.limits = {{constant(node["limits"][0]), constant(node["limits"][1])}};
    if (node.IsMap() && node["armature"]) c.armature = constant(node["armature"]);
    if (node.IsMap()) read_coordinate_forces(node, names_, c);
    if (!c.quaternion) names_[c.name] = variable(c.first_q);
    coordinates_[c.name] = result_.coordinates.size();
    result_.nq += c.quaternion ? 4 : 1;
    result_.nv += c.quaternion ? 3 : 1;
    result_.coordinates.push_back(std::move(c));
  }

  const Coordinate& coordinate(const YAML::Node& node) const {
    return result_.coordinates.at(coordinates_.at(node.as<std::string>()));
  }
  Expression real_coordinate(const YAML::Node& node) const { return names_.at(node.as<std::string>()); }

  std::vector<Factor> transform(const YAML::Node& list) {
    std::vector<Factor> factors;
    for (const YAML::Node& node : list) append_factor(node, factors);
    return factors;
  }

  void append_factor(const YAML::Node& node, std::vector<Factor>& out) {
    if (node["translate"]) {
      out.push_back({Translation{expressions(node["translate"])}});
    } else if (const YAML::Node rotate = node["rotate"]) {
      if (rotate["quaternion"]) {
        out.push_back({QuaternionRotation{coordinate(rotate["quaternion"]).first_q}});
      } else {
        out.push_back({Rotation{axis(rotate["axis"]), expression(rotate["angle"])}});
      }
    } else if (const YAML::Node rows = node["matrix"]) {
      Matrix matrix;
      for (std::size_t i = 0; i < 12; ++i) matrix.entry[i] = expression(rows[i / 4][i % 4]);
      out.push_back({std::move(matrix)});
    } else if (const YAML::Node curve = node["curve"]) {
      Curve c{expressions(curve["point"]), coordinate(curve["along"]).first_q, std::nullopt};
      if (curve["frame"] && curve["frame"].IsMap()) c.reference = expressions(curve["frame"]["reference"]);
      out.push_back({std::move(c)});
    } else if (node["surface"]) {
      out.push_back({surface(node["surface"])});
    } else if (const YAML::Node mate = node["mate"]) {
      out.push_back({Mate{surface(mate[0]["surface"]), surface(mate[1]["surface"]),
                          node["spin"] ? expression(node["spin"]) : number(0)}});
    } else if (node["inverse"]) {
      out.push_back({Inverse{transform(node["inverse"])}});
    } else if (node["joint"]) {
      append_joint(node["joint"], out);
    } else {
      throw std::runtime_error("unknown transform factor");
    }
  }

  Surface surface(const YAML::Node& node) {
    return {expressions(node["point"]), coordinate(node["along"][0]).first_q,
            coordinate(node["along"][1]).first_q, node["flip"] && node["flip"].as<bool>()};
  }

  static Factor shift_along(const std::array<double, 3>& axis, const Expression& distance) {
    return {Translation{{product(number(axis[0]), distance), product(number(axis[1]), distance),
                         product(number(axis[2]), distance)}}};
  }

  void append_joint(const YAML::Node& joint, std::vector<Factor>& out) {
    const std::string type = joint["type"].as<std::string>();
    const YAML::Node names = joint["coordinates"];
    const auto q = [&](int i) { return real_coordinate(names[i]); };
    if (type == "revolute") {
      out.push_back({Rotation{axis(joint["axis"]), q(0)}});
    } else if (type == "prismatic") {
      out.push_back(shift_along(axis(joint["axis"]), q(0)));
    } else if (type == "helical") {
      out.push_back({Rotation{axis(joint["axis"]), q(0)}});
      out.push_back(shift_along(axis(joint["axis"]), product(expression(joint["pitch"]), q(0))));
    } else if (type == "cylindrical") {
      out.push_back({Rotation{axis(joint["axis"]), q(0)}});
      out.push_back(shift_along(axis(joint["axis"]), q(1)));
    } else if (type == "universal") {
      const bool own = static_cast<bool>(joint["axes"]);
      out.push_back({Rotation{own ? axis(joint["axes"][0]) : std::array<double, 3>{1, 0, 0}, q(0)}});
      out.push_back({Rotation{own ? axis(joint["axes"][1]) : std::array<double, 3>{0, 1, 0}, q(1)}});
    } else if (type == "planar") {
      out.push_back({Translation{{q(0), q(1), number(0)}}});
      out.push_back({Rotation{{0, 0, 1}, q(2)}});
    } else if (type == "spherical") {
      out.push_back({QuaternionRotation{coordinate(names[0]).first_q}});
    } else if (type == "free") {
      out.push_back({Translation{{q(0), q(1), q(2)}}});
      out.push_back({QuaternionRotation{coordinate(names[3]).first_q}});
    } else {
      throw std::runtime_error("unknown joint type '" + type + "'");
    }
  }

  Body body(const YAML::Node& node) {
    Body b;
    b.name = node["name"].as<std::string>();
    b.transform = transform(node["transform"]);
    if (node["mass"]) b.mass = constant(node["mass"]);
    if (node["com"]) b.com = constants(node["com"]);
    static const char* const kEntries[] = {"xx", "yy", "zz", "xy", "xz", "yz"};
    for (std::size_t i = 0; i < 6; ++i) {
      if (node["inertia"] && node["inertia"][kEntries[i]])
        b.inertia[i] = constant(node["inertia"][kEntries[i]]);
    }
    b.external_wrench = node["external_wrench"] && node["external_wrench"].as<bool>();
    return b;
  }

  /// In the order of the file, but ancestors that come later stand just before the first that needs them.
  void read_bodies() {
    std::map<std::string, YAML::Node> waiting;
    for (const YAML::Node& node : root_["bodies"]) waiting.emplace(node["name"].as<std::string>(), node);
    for (const YAML::Node& node : root_["bodies"]) read_body(node["name"].as<std::string>(), waiting);
  }
  void read_body(const std::string& name, std::map<std::string, YAML::Node>& waiting) {
    const auto found = waiting.find(name);
    if (found == waiting.end()) return;
    const YAML::Node node = found->second;
    waiting.erase(found);
    const std::string parent = node["parent"] ? node["parent"].as<std::string>() : "world";
    read_body(parent, waiting);
    Body b = body(node);
    b.parent = body_index(parent);
    result_.bodies.push_back(std::move(b));
  }

  int body_index(const std::string& name) const {
    for (std::size_t i = 0; i < result_.bodies.size(); ++i) {
      if (result_.bodies[i].name == name) return static_cast<int>(i);
    }
    if (name != "world") throw std::runtime_error("unknown body '" + name + "'");
    return -1;
  }

  void read_frame(const YAML::Node& node) {
    Frame frame;
    frame.name = node["name"].as<std::string>();
    frame.body = body_index(node["body"].as<std::string>());
    frame.transform = transform(node["transform"]);
    result_.frames.push_back(std::move(frame));
  }

  /// `of` and `on` name a body and its parent, in either order, and the coordinates along their surfaces.
  void find_rolling_mate(const YAML::Node& of, const YAML::Node& on, Constraint& constraint) const {
    const auto fits = [this](const Surface& surface, const YAML::Node& side) {
      return surface.u == coordinate(side[1]).first_q && surface.v == coordinate(side[2]).first_q;
    };
    for (const auto& [child, parent] : {std::pair(of, on), std::pair(on, of)}) {
      const int body = body_index(child[0].as<std::string>());
      if (body < 0) continue;
      const Body& candidate = result_.bodies[static_cast<std::size_t>(body)];
      if (candidate.parent != body_index(parent[0].as<std::string>())) continue;
      for (std::size_t i = 0; i < candidate.transform.size(); ++i) {
        const Mate* mate = std::get_if<Mate>(&candidate.transform[i].value);
        if (mate == nullptr || !fits(mate->first, parent) || !fits(mate->second, child)) continue;
        constraint.body = body;
        constraint.factor = i;
        return;
      }
    }
    throw std::runtime_error("no mate for rolling constraint '" + constraint.name + "'");
  }

  void read_constraint(const YAML::Node& node) {
    Constraint constraint;
    constraint.name = node["name"].as<std::string>();
    const std::string type = node["type"].as<std::string>();
    if (type == "rolling") {
      constraint.kind = ConstraintKind::rolling;
      find_rolling_mate(node["of"], node["on"], constraint);
    } else {
      constraint.kind = type == "pfaffian" ? ConstraintKind::pfaffian : ConstraintKind::holonomic;
      for (const YAML::Node& equation : node[type == "pfaffian" ? "rows" : "equations"])
        constraint.equations.push_back(expression(equation));
    }
    result_.constraints.push_back(std::move(constraint));
  }

  YAML::Node root_;
  const std::map<std::string, double>& values_;  ///< of runtime parameters
  Description result_;
  Names names_;
  std::map<std::string, std::size_t> coordinates_;
};

}  // namespace

std::vector<double> Description::armatures() const {
  std::vector<double> result;
  for (const Coordinate& c : coordinates) result.insert(result.end(), c.quaternion ? 3 : 1, c.armature);
  return result;
}

std::size_t Description::constraint_rows() const {
  std::size_t rows = 0;
  for (const Constraint& constraint : constraints) rows += constraint.rows();
  return rows;
}

bool Description::has_forces() const {
  const auto forced = [](const Coordinate& c) {
    return c.damping != 0 || c.friction != 0 || c.stiffness != 0;
  };
  return !forces.empty() || std::any_of(coordinates.begin(), coordinates.end(), forced);
}

bool Description::outputs_of_speeds() const {
  const int frame = static_cast<int>(frames.size()), given = static_cast<int>(inputs.size() + states.size());
  const int moving = nq + nv + 3 * frame + given, path = moving + 15 * frame;  // where variables begin
  const auto is_of_speeds = [&](int variable) {
    if (variable < moving) return variable >= nq && variable < nq + nv;
    if (variable >= path) return (variable - path) % 2 == 1;
    const int part = (variable - moving) % 15;
    return part < 3 || part >= 12;
  };
  const std::function<bool(const Expression&)> below = [&](const Expression& e) {
    if (!e) return false;
    if (e->operation == Operation::coordinate) return is_of_speeds(e->coordinate);
    return std::any_of(e->operand.begin(), e->operand.end(), below);
  };
  return std::any_of(outputs.begin(), outputs.end(),
                     [&](const Output& output) { return below(output.value); });
}

double Description::parameter(const std::string& wanted) const {
  for (const auto& [key, value] : parameters) {
    if (key == wanted) return value;
  }
  throw std::runtime_error("no parameter '" + wanted + "'");
}

Description parse_description(const std::string& yaml, const std::map<std::string, double>& values) {
  Description description = Reader(YAML::Load(yaml), values).read();
  description.text = yaml;
  return description;
}

Description read_description(const std::string& path, const std::map<std::string, double>& values) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::ostringstream text;
  text << file.rdbuf();
  return parse_description(text.str(), values);
}

}  // namespace alembert::oracles
