#include "import/urdf/joint_factors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "import/common/snapped_angle.hpp"

namespace alembert {
namespace {

using Vector = std::array<double, 3>;

/// Of a joint in its parent. Exporters work origins out of numbers as large as the robot.
double longest_origin(const UrdfRobot& robot) {
  double out = 0;
  for (const UrdfJoint& joint : robot.joints) {
    const auto& [x, y, z] = joint.origin.xyz;
    out = std::max(out, std::hypot(x, y, z));
  }
  return out;
}

}  // namespace

JointFactors::JointFactors(DescriptionNodes& nodes, const UrdfRobot& robot, double snap_angles)
    : nodes_(nodes),
      factors_(nodes, snap_angles),
      snap_angles_(snap_angles),
      longest_(longest_origin(robot)) {}

void JointFactors::add_origin(YamlNode& factors, const UrdfPose& pose) const {
  factors_.add_pose(factors, pose.xyz, pose.rpy, longest_, pose.where);
}

void JointFactors::add_joint(YamlNode& factors, const UrdfJoint& joint,
                             const std::vector<std::string>& names) const {
  switch (joint.type) {
    case UrdfJointType::fixed:
      return;
    case UrdfJointType::planar:
      return add_planar(factors, joint, names);
    case UrdfJointType::floating:
      return factors_.add_free(factors, names, joint.where);
    case UrdfJointType::spherical:
      return factors_.add_spherical(factors, names[0], joint.where);
    case UrdfJointType::revolute:
    case UrdfJointType::continuous:
    case UrdfJointType::prismatic:
      break;
  }
  const bool slides = joint.type == UrdfJointType::prismatic;
  if (!joint.mimic) {
    factors_.add_joint(factors, slides ? "prismatic" : "revolute", joint.axis, names[0], joint.where);
  } else if (slides) {
    factors_.add_shift_along(factors, joint.axis, names[0], joint.where);
  } else {
    factors_.add_rotation(factors, factors_.axis(joint.axis, joint.where), names[0], joint.where);
  }
}

void JointFactors::add_planar(YamlNode& factors, const UrdfJoint& joint,
                              const std::vector<std::string>& names) const {
  const Vector axis = without_rounding(joint.axis);
  const SourceLocation& where = joint.where;
  if (const std::optional<std::size_t> normal = coordinate_axis_of(axis)) {
    std::array<std::string, 3> shift{"0", "0", "0"};
    shift[(*normal + 1) % 3] = names[0];
    shift[(*normal + 2) % 3] = names[1];
    factors.items.push_back(&nodes_.single("translate", nodes_.list({shift[0], shift[1], shift[2]}, where)));
    return factors_.add_rotation(factors, factors_.letter(*normal, where), names[2], where);
  }
  const double off = std::hypot(axis[0], axis[1]);
  const YamlNode& about =
      off == 0 ? factors_.letter(0, where) : nodes_.numbers({-axis[1], axis[0], 0}, where);
  const std::string tilt = SnappedAngle(std::atan2(off, axis[2]), snap_angles_).text();
  factors_.add_rotation(factors, about, tilt, where);
  factors.items.push_back(&nodes_.single("translate", nodes_.list({names[0], names[1], "0"}, where)));
  factors_.add_rotation(factors, factors_.letter(2, where), names[2], where);
  factors_.add_rotation(factors, about, fmt::format("-({})", tilt), where);
}

}  // namespace alembert
