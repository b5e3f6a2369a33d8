// <joint>: type, links, axis and mimicked joint, which make the equations; limits and what resists, which do
// not.
#include "import/urdf/joint_elements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "import/urdf/link_elements.hpp"

namespace alembert {
namespace {

constexpr std::pair<std::string_view, UrdfJointType> kJointTypes[] = {
    {"revolute", UrdfJointType::revolute},   {"continuous", UrdfJointType::continuous},
    {"prismatic", UrdfJointType::prismatic}, {"fixed", UrdfJointType::fixed},
    {"floating", UrdfJointType::floating},   {"planar", UrdfJointType::planar},
    {"spherical", UrdfJointType::spherical},
};

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

UrdfJointType read_type(const XmlText& xml, pugi::xml_attribute attribute, const std::string& what) {
  const std::string text = attribute.value();
  std::vector<std::string> known;
  for (const auto& [name, type] : kJointTypes) {
    if (name == lower_case(text)) {
      if (name != text)
        xml.warn({xml.where(attribute),
                  fmt::format("the type '{}' of {} is written '{}'", text, what, name),
                  {},
                  "case"});
      return type;
    }
    known.emplace_back(name);
  }
  throw InputError(xml.where(attribute),
                   fmt::format("unknown type '{}' of {}{}", printable(text), what, did_you_mean(text, known)),
                   "joints are revolute, continuous, prismatic, fixed, floating, planar, spherical");
}

std::size_t find_link(const XmlText& xml, pugi::xml_node element, std::string_view what,
                      const Indices& links) {
  xml.check_spelling(element, what, {}, {"link"});
  const pugi::xml_attribute attribute = xml.require_attribute(element, "link", what);
  if (const auto found = links.find(attribute.value()); found != links.end()) return found->second;
  throw InputError(xml.where(attribute),
                   fmt::format("unknown link '{}' as {}{}", printable(attribute.value()), what,
                               did_you_mean(attribute.value(), keys(links))));
}

void read_axis(const XmlText& xml, pugi::xml_node element, UrdfJoint& joint, const std::string& what) {
  constexpr double kUnit = 1e-3;  // decimals of a unit vector are nearer
  const std::string of = "the axis of " + what;
  const pugi::xml_node axis = xml.find(element, "axis", what);
  if (axis) xml.check_spelling(axis, of, {}, {"xyz"});
  const pugi::xml_attribute xyz = axis.attribute("xyz");
  if (!xyz) {
    xml.warn({xml.where(axis ? axis : element),
              axis ? fmt::format("no attribute 'xyz' of {}; it is x", of)
                   : fmt::format("no <axis> in {}; its axis is x", what),
              {},
              "no axis"});
    return;
  }
  joint.axis = xml.numbers<3>(xyz, of);
  const double length = std::hypot(joint.axis[0], joint.axis[1], joint.axis[2]);
  if (length == 0) throw InputError(xml.where(xyz), of + " has length 0");
  if (std::abs(length - 1) > kUnit)
    xml.warn({xml.where(xyz),
              fmt::format("{} has length {:.6g}; its direction is used", of, length),
              {},
              "axis length"});
}

void read_limits(const XmlText& xml, pugi::xml_node element, UrdfJoint& joint, const std::string& what) {
  const std::string of = "the limits of " + what;
  const pugi::xml_node limit = element.child("limit");
  if (!limit) {
    xml.warn({xml.where(element),
              fmt::format("no <limit> in {}; its coordinate has no limits", what),
              {},
              "no limit"});
    return;
  }
  xml.check_spelling(limit, of, {}, {"lower", "upper", "effort", "velocity"});
  const pugi::xml_attribute lower = limit.attribute("lower"), upper = limit.attribute("upper");
  const std::array<double, 2> limits{lower ? xml.number(lower, of) : 0, upper ? xml.number(upper, of) : 0};
  if (limits[0] < limits[1]) {
    joint.limits = limits;
  } else if (lower && upper) {
    throw InputError(xml.where(lower),
                     fmt::format("{} leave no room: lower {:.6g}, upper {:.6g}", of, limits[0], limits[1]));
  }
}

/// What says nothing where it is not positive.
void read_drive(const XmlText& xml, pugi::xml_node element, UrdfJoint& joint, const std::string& what) {
  const pugi::xml_node limit = element.child("limit");
  const auto read = [&](const char* name, std::optional<double>& largest) {
    const pugi::xml_attribute given = limit.attribute(name);
    if (!given) return;
    const double value = xml.number(given, fmt::format("the {} of {}", name, what));
    if (value > 0) largest = value;
    if (value < 0)
      xml.warn({xml.where(given),
                fmt::format("the {} of {} is negative; it is left out", name, what),
                {},
                "negative limit"});
  };
  xml.tolerate("it is left out", [&] { read("effort", joint.effort); });
  xml.tolerate("it is left out", [&] { read("velocity", joint.velocity); });
}

void read_mimic(const XmlText& xml, pugi::xml_node element, UrdfJoint& joint, const std::string& what) {
  const pugi::xml_node mimic = xml.find(element, "mimic", what);
  if (!mimic) return;
  const std::string of = "the mimic of " + what;
  if (!has_position(joint)) {
    xml.warn({xml.where(mimic),
              joint.type == UrdfJointType::fixed
                  ? fmt::format("{} is fixed; its <mimic> is passed over", what)
                  : fmt::format("{} has no single position; its <mimic> is passed over", what),
              {},
              "mimics none"});
    return;
  }
  xml.check_spelling(mimic, of, {}, {"joint", "multiplier", "offset"});
  const pugi::xml_attribute name = mimic.attribute("joint");
  if (!name) {
    xml.warn({xml.where(mimic),
              fmt::format("no attribute 'joint' of {}; the joint is independent", of),
              {},
              "mimics none"});
    return;
  }
  joint.mimic = UrdfMimic{name.value(), std::nullopt, 1, 0, xml.where(name)};
  if (const pugi::xml_attribute m = mimic.attribute("multiplier"))
    joint.mimic->multiplier = xml.number(m, "the multiplier in " + of);
  if (const pugi::xml_attribute o = mimic.attribute("offset"))
    joint.mimic->offset = xml.number(o, "the offset in " + of);
}

void read_resistance(const XmlText& xml, pugi::xml_node element, UrdfJoint& joint, const std::string& what) {
  const pugi::xml_node dynamics = element.child("dynamics");
  xml.check_spelling(dynamics, "the dynamics of " + what, {}, {"damping", "friction"});
  for (const auto& [name, to] : {std::pair("damping", &joint.damping), {"friction", &joint.friction}})
    if (const pugi::xml_attribute value = dynamics.attribute(name))
      *to = xml.number(value, fmt::format("the {} of {}", name, what));
  if (has_position(joint) || joint.type == UrdfJointType::fixed) return;
  if (joint.damping != 0 || joint.friction != 0)
    xml.warn({xml.where(dynamics),
              fmt::format("{} has no single position; its damping and friction are left out", what)});
  joint.damping = joint.friction = 0;
}

}  // namespace

std::vector<std::string> keys(const Indices& indices) {
  std::vector<std::string> names;
  for (const auto& [name, index] : indices) names.push_back(name);
  return names;
}

bool has_position(const UrdfJoint& joint) {
  return joint.type == UrdfJointType::revolute || joint.type == UrdfJointType::continuous ||
         joint.type == UrdfJointType::prismatic;
}

void read_transmission(const XmlText& xml, pugi::xml_node element, std::vector<UrdfJoint>& joints,
                       const Indices& names) {
  const auto read = [&](const pugi::xml_node& node, double& to, bool is_inertia) {
    if (!node) return;
    const std::string what = fmt::format("<{}> of a transmission", node.name());
    xml.tolerate("it is left out", [&] {
      const pugi::xml_attribute attribute = node.attribute("value");
      const double value =
          attribute ? xml.number(attribute, what) : xml.number_list(node, what, 1, 1).front();
      if (is_inertia && value < 0) throw InputError(xml.where(node), what + " is negative");
      if (value != 0) to = value;
    });
  };
  constexpr const char *kReduction = "mechanicalReduction", *kRotor = "drake:rotor_inertia";
  // One joint and one actuator, or as many of each, in order; joints of a differential share the first.
  std::vector<pugi::xml_node> drives(element.children("actuator").begin(),
                                     element.children("actuator").end());
  const auto driven = element.children("joint");
  const bool paired = static_cast<std::size_t>(std::distance(driven.begin(), driven.end())) == drives.size();
  std::size_t k = 0;
  for (const pugi::xml_node of : driven) {
    const pugi::xml_node drive = drives.empty() ? pugi::xml_node() : drives[paired ? k : 0];
    ++k;
    const std::string name = of.attribute("name").value();
    const auto found = names.find(name);
    if (found == names.end()) {
      if (drive.child(kRotor))
        xml.warn({xml.where(of),
                  fmt::format("a transmission drives an unknown joint '{}'{}: its rotor is left out",
                              printable(name), did_you_mean(name, keys(names)))});
      continue;
    }
    UrdfJoint& joint = joints[found->second];
    for (const pugi::xml_node& holder : {element, drive, of})
      read(holder.child(kReduction), joint.reduction, false);
    read(drive.child("drake:gear_ratio"), joint.reduction, false);
    read(drive.child(kRotor), joint.rotor_inertia, true);
  }
}

UrdfJoint read_joint(const XmlText& xml, pugi::xml_node element, const Indices& links) {
  UrdfJoint joint;
  const pugi::xml_attribute name = element.attribute("name");
  joint.name = name.value();
  joint.where = name ? xml.where(name) : xml.where(element);
  if (joint.name.empty()) xml.warn({joint.where, "a joint without a name", {}, "no name"});
  const std::string what = fmt::format("joint '{}'", printable(joint.name));
  xml.check_spelling(
      element, what,
      {"origin", "parent", "child", "axis", "limit", "mimic", "dynamics", "calibration", "safety_controller"},
      {"name", "type"});
  const pugi::xml_attribute type = xml.require_attribute(element, "type", what);
  joint.type = read_type(xml, type, what);
  joint.type_where = xml.where(type);
  joint.parent = find_link(xml, xml.require(element, "parent", what), "the parent of " + what, links);
  joint.child = find_link(xml, xml.require(element, "child", what), "the child of " + what, links);
  joint.origin = read_origin(xml, element, what);
  if (has_position(joint) || joint.type == UrdfJointType::planar) read_axis(xml, element, joint, what);
  read_mimic(xml, element, joint, what);
  const bool limited = joint.type == UrdfJointType::revolute || joint.type == UrdfJointType::prismatic;
  if (limited && (!joint.mimic || element.child("limit")))
    xml.tolerate("they are left out", [&] { read_limits(xml, element, joint, what); });
  if (has_position(joint)) read_drive(xml, element, joint, what);
  xml.tolerate("it is left out", [&] { read_resistance(xml, element, joint, what); });
  return joint;
}

}  // namespace alembert
