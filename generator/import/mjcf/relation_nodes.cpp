#include "import/mjcf/relation_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "import/common/loop_equations.hpp"
#include "import/common/snapped_angle.hpp"
#include "import/mjcf/sums.hpp"

namespace alembert {
/// The body that a body is fixed to, itself if it moves by joints of its own.
std::size_t MjcfRelationNodes::rigid_root(std::size_t body) const {
  while (body != 0 && model_.bodies[body].joints.empty()) body = model_.bodies[body].parent;
  return body;
}

void MjcfRelationNodes::add_coincidence(std::vector<std::string>& equations, const MjcfEquality& equality,
                                        const std::string& name) {
  const SourceLocation& where = equality.where;
  LoopEquations loop([&](int end, const std::string& suffix, const Eigen::Vector3d& offset) {
    const std::size_t body = end == 1 ? equality.first : *equality.second;
    const RigidPose& pose = end == 1 ? equality.first_pose : equality.second_pose;
    const std::string out = naming_.new_frame(fmt::format("{}_{}{}", name, end, suffix));
    bodies_.add_frame(frames_, out, body, pose * RigidPose{offset}, where);
    return out;
  });
  loop.origins_meet();
  if (equality.type == MjcfEqualityType::weld) loop.axes_meet();
  std::ranges::move(loop.take(), std::back_inserter(equations));
}

void MjcfRelationNodes::add_function(std::vector<std::string>& equations,
                                     const MjcfEquality& equality) const {
  const std::array<double, 5>& p = equality.polynomial;
  const std::string own = naming_.from_reference(equality.first);
  const std::string value =
      equality.second ? polynomial_text(p, naming_.from_reference(*equality.second)) : number_text(p[0]);
  equations.push_back(fmt::format("{} - {}", own, factor_text(value)));
}

void MjcfRelationNodes::add_tendons(std::vector<std::string>& equations, const MjcfEquality& equality) const {
  const auto length = [&](std::size_t tendon) {
    const MjcfTendon& of = model_.tendons[tendon];
    if (!of.fixed) throw InputError(equality.where, "an equality of spatial tendons cannot be expressed");
    double reference = 0;
    for (const MjcfTerm& term : of.terms) reference += term.factor * model_.joints[term.joint].reference;
    const std::string text = forces_.length(tendon);
    return reference == 0 ? text : fmt::format("{} - {}", text, factor_text(number_text(reference)));
  };
  const std::array<double, 5>& p = equality.polynomial;
  const std::string value =
      equality.second ? polynomial_text(p, length(*equality.second)) : number_text(p[0]);
  equations.push_back(fmt::format("{} - {}", length(equality.first), factor_text(value)));
}

void MjcfRelationNodes::add_constraints(YamlNode& list) {
  constexpr const char* kKinds[] = {"connect", "weld", "joint", "tendon"};
  for (std::size_t e = 0; e < model_.equalities.size(); ++e) {
    const MjcfEquality& equality = model_.equalities[e];
    if (naming_.is_function(e)) continue;
    const bool bodies = equality.type == MjcfEqualityType::connect || equality.type == MjcfEqualityType::weld;
    if (bodies && rigid_root(equality.first) == rigid_root(*equality.second)) {
      warnings_.push_back(
          {equality.where, "an equality of bodies that are fixed together says nothing; it is left out"});
      continue;
    }
    std::string name = equality.name;
    if (name.empty()) name = fmt::format("{}_{}", kKinds[static_cast<std::size_t>(equality.type)], e + 1);
    name = naming_.new_constraint(name);
    std::vector<std::string> equations;
    if (bodies)
      add_coincidence(equations, equality, name);
    else if (equality.type == MjcfEqualityType::joint)
      add_function(equations, equality);
    else
      add_tendons(equations, equality);
    nodes_.add_holonomic(list, name, equations, equality.where);
  }
}

YamlNode& MjcfRelationNodes::add_output(YamlNode& list, const std::string& name, const std::string& value,
                                        const SourceLocation& where) {
  YamlNode& output = nodes_.add_named(list, naming_.new_output(name), where);
  nodes_.put(output, "value", nodes_.text(value, where));
  return output;
}

void MjcfRelationNodes::add_vector(YamlNode& list, const std::string& name, const std::string (&values)[3],
                                   const SourceLocation& where) {
  for (int k = 0; k < 3; ++k) add_output(list, name + "_" + kAxes[k], values[k], where);
}

void MjcfRelationNodes::add_sensor(YamlNode& list, const MjcfSensor& sensor) {
  const std::string& kind = sensor.kind;
  std::string subject;
  if (kind.starts_with("frame") || kind == "gyro" || kind == "velocimeter")
    subject = naming_.frame(sensor.of);
  if (kind.starts_with("joint")) subject = naming_.coordinates(sensor.of)[0];
  if (kind.starts_with("tendon")) subject = naming_.tendon(sensor.of);
  if (kind.starts_with("actuator")) subject = naming_.actuator(sensor.of);
  const std::string name = !sensor.name.empty() ? sensor.name
                           : subject.empty()    ? kind
                                                : fmt::format("{}_{}", subject, kind);
  const auto vector = [&](const char* quantity, std::string(&out)[3]) {
    for (int k = 0; k < 3; ++k) out[k] = fmt::format("{}({}).{}", quantity, subject, kAxes[k]);
  };
  std::string v[3];
  if (kind == "framepos") {
    vector("position", v);
    if (sensor.reference)
      for (int k = 0; k < 3; ++k)
        v[k] += fmt::format(" - position({}).{}", naming_.frame(*sensor.reference), kAxes[k]);
  } else if (kind == "framelinvel" || kind == "velocimeter") {
    vector("velocity", v);
  } else if (kind == "frameangvel" || kind == "gyro") {
    vector("angular_velocity", v);
  } else if (kind.starts_with("frame")) {  // framexaxis and so on
    for (int k = 0; k < 3; ++k) v[k] = fmt::format("rotation({}).{}{}", subject, kAxes[k], kind[5]);
  } else if (kind == "clock") {
    add_output(list, name, "t", sensor.where);
    return;
  } else {
    const bool rate = kind.ends_with("vel");
    std::string value;
    if (kind.starts_with("joint")) {
      const JointText& text = naming_.text(sensor.of);
      value = rate ? text.speed : text.position;
    } else if (kind.starts_with("tendon")) {
      value = rate ? forces_.rate(sensor.of) : forces_.length(sensor.of);
    } else {
      const MjcfActuator& of = model_.actuators[sensor.of];
      value = rate ? forces_.actuator_rate(of) : forces_.actuator_length(of);
    }
    if (value.empty() || value == "0") {
      warnings_.push_back({sensor.where,
                           fmt::format("the sensor '{}' has no value here; it is left out", printable(name)),
                           {},
                           "sensor without value"});
      return;
    }
    add_output(list, name, value, sensor.where);
    return;
  }
  if (sensor.reference) turn_into(naming_.frame(*sensor.reference), v);
  if (kind == "gyro" || kind == "velocimeter") turn_into(subject, v);
  add_vector(list, name, v, sensor.where);
}

/// The length of a tendon that has limits, as an output.
void MjcfRelationNodes::add_limits(YamlNode& list, std::size_t tendon) {
  const MjcfTendon& of = model_.tendons[tendon];
  if (!of.limits) return;
  const std::string length = forces_.length(tendon);
  if (length.empty() || length == "0" || !((*of.limits)[0] < (*of.limits)[1])) {
    warnings_.push_back(
        {of.where, fmt::format("the limits of tendon '{}' are left out: its length, or the room that "
                               "they leave, is none",
                               printable(naming_.tendon(tendon)))});
    return;
  }
  YamlNode& output = add_output(list, naming_.tendon(tendon) + "_length", length, of.where);
  nodes_.put(output, "limits",
             nodes_.list({number_text((*of.limits)[0]), number_text((*of.limits)[1])}, of.where));
}

void MjcfRelationNodes::add_outputs(YamlNode& list) {
  for (const MjcfSensor& sensor : model_.sensors) add_sensor(list, sensor);
  for (std::size_t t = 0; t < model_.tendons.size(); ++t) add_limits(list, t);
}

}  // namespace alembert
