#include "import/urdf/joint_factors.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "import/common/snapped_angle.hpp"

namespace alembert {
namespace {

using Vector = std::array<double, 3>;

/// Shorter shifts, and smaller components of axes, are rounding of whoever wrote the file.
constexpr double kNoLength = 1e-12;

Vector without_rounding(Vector v, double length) {
  for (double& x : v)
    if (std::abs(x) < kNoLength * length) x = 0;
  return v;
}

Vector clean_axis(const UrdfJoint& joint) {
  const Vector& a = joint.axis;
  return without_rounding(a, std::hypot(a[0], a[1], a[2]));
}

/// The coordinate axis that a vector points along, if it does.
std::optional<std::size_t> coordinate_axis_of(const Vector& v) {
  for (std::size_t i = 0; i < 3; ++i)
    if (v[i] > 0 && v[(i + 1) % 3] == 0 && v[(i + 2) % 3] == 0) return i;
  return std::nullopt;
}

}  // namespace

void JointFactors::add_origin(YamlNode& factors, const UrdfPose& pose) const {
  const Vector shift = without_rounding(pose.xyz, 1);
  if (shift != Vector{})
    factors.items.push_back(&nodes_.single("translate", nodes_.numbers(shift, pose.where)));
  for (const std::size_t axis : {2U, 1U, 0U}) {
    const SnappedAngle angle(pose.rpy[axis], snap_angles_);
    if (!angle.is_zero()) add_rotation(factors, letter(axis, pose.where), angle.text(), pose.where);
  }
}

void JointFactors::add_rotation(YamlNode& factors, const YamlNode& axis, std::string angle,
                                const SourceLocation& where) const {
  YamlNode& rotation = nodes_.mapping(where);
  nodes_.put(rotation, "axis", axis);
  nodes_.put(rotation, "angle", nodes_.text(std::move(angle), where));
  factors.items.push_back(&nodes_.single("rotate", rotation));
}

const YamlNode& JointFactors::axis_of(const UrdfJoint& joint) const {
  const Vector axis = clean_axis(joint);
  const std::optional<std::size_t> along = coordinate_axis_of(axis);
  return along ? letter(*along, joint.where) : nodes_.numbers(axis, joint.where);
}

void JointFactors::add_joint(YamlNode& factors, const UrdfJoint& joint,
                             const std::vector<std::string>& names) const {
  switch (joint.type) {
    case UrdfJointType::fixed:
      return;
    case UrdfJointType::planar:
      return add_planar(factors, joint, names);
    case UrdfJointType::floating:
      return add_free(factors, names, joint.where);
    case UrdfJointType::revolute:
    case UrdfJointType::continuous:
    case UrdfJointType::prismatic:
      break;
  }
  if (joint.mimic) return add_mimic(factors, joint, names[0]);
  const char* type = joint.type == UrdfJointType::prismatic ? "prismatic" : "revolute";
  YamlNode& node = nodes_.mapping(joint.where);
  nodes_.put(node, "type", nodes_.text(type, joint.type_where));
  nodes_.put(node, "axis", axis_of(joint));
  nodes_.put(node, "coordinates", nodes_.list({names[0]}, joint.where));
  factors.items.push_back(&nodes_.single("joint", node));
}

void JointFactors::add_mimic(YamlNode& factors, const UrdfJoint& joint, const std::string& position) const {
  if (joint.type != UrdfJointType::prismatic)
    return add_rotation(factors, axis_of(joint), position, joint.where);
  const Vector axis = clean_axis(joint);
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  const auto along = [&](double x) {
    x /= length;
    return x == 0 ? "0" : x == 1 ? position : x == -1 ? "-" + position : number_text(x) + "*" + position;
  };
  factors.items.push_back(&nodes_.single(
      "translate", nodes_.list({along(axis[0]), along(axis[1]), along(axis[2])}, joint.where)));
}

void JointFactors::add_free(YamlNode& factors, const std::vector<std::string>& names,
                            const SourceLocation& where) const {
  YamlNode& node = nodes_.mapping(where);
  nodes_.put(node, "type", nodes_.text("free", where));
  nodes_.put(node, "coordinates", nodes_.list({names[0], names[1], names[2], names[3]}, where));
  factors.items.push_back(&nodes_.single("joint", node));
}

void JointFactors::add_planar(YamlNode& factors, const UrdfJoint& joint,
                              const std::vector<std::string>& names) const {
  const Vector axis = clean_axis(joint);
  const SourceLocation& where = joint.where;
  if (const std::optional<std::size_t> normal = coordinate_axis_of(axis)) {
    std::array<std::string, 3> shift{"0", "0", "0"};
    shift[(*normal + 1) % 3] = names[0];
    shift[(*normal + 2) % 3] = names[1];
    factors.items.push_back(&nodes_.single("translate", nodes_.list({shift[0], shift[1], shift[2]}, where)));
    return add_rotation(factors, letter(*normal, where), names[2], where);
  }
  const double off = std::hypot(axis[0], axis[1]);
  const YamlNode& about = off == 0 ? letter(0, where) : nodes_.numbers({-axis[1], axis[0], 0}, where);
  const std::string tilt = SnappedAngle(std::atan2(off, axis[2]), snap_angles_).text();
  add_rotation(factors, about, tilt, where);
  factors.items.push_back(&nodes_.single("translate", nodes_.list({names[0], names[1], "0"}, where)));
  add_rotation(factors, letter(2, where), names[2], where);
  add_rotation(factors, about, fmt::format("-({})", tilt), where);
}

}  // namespace alembert
