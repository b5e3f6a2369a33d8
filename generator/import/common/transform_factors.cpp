#include "import/common/transform_factors.hpp"

#include <algorithm>
#include <cmath>

#include "import/common/snapped_angle.hpp"

namespace alembert {
namespace {

using Vector = std::array<double, 3>;

double length_of(const Vector& v) {
  return std::hypot(v[0], v[1], v[2]);
}

/// Roll, pitch and yaw: the rotation is Rz(yaw) Ry(pitch) Rx(roll). About a coordinate axis, the angle about it.
Vector angles_of(const Eigen::Quaterniond& turn) {
  constexpr double kRounding = 1e-12;
  const Eigen::Vector3d axis = turn.vec();
  for (int i = 0; i < 3; ++i) {
    if (std::abs(axis[(i + 1) % 3]) > kRounding || std::abs(axis[(i + 2) % 3]) > kRounding) continue;
    Vector out{};
    const double sign = turn.w() < 0 ? -1 : 1;
    out[static_cast<std::size_t>(i)] = 2 * std::atan2(sign * axis[i], sign * turn.w());
    return out;
  }
  Eigen::Matrix3d r = turn.toRotationMatrix();
  for (double& entry : r.reshaped())
    if (std::abs(entry) < kRounding) entry = 0;
  const double yaw = std::atan2(r(1, 0), r(0, 0)), c = std::cos(yaw), s = std::sin(yaw);
  const double pitch = std::atan2(-r(2, 0), std::hypot(r(0, 0), r(1, 0)));
  // From what yaw leaves: right where yaw and roll turn about one axis, too.
  return {std::atan2(s * r(0, 2) - c * r(1, 2), c * r(1, 1) - s * r(0, 1)), pitch, yaw};
}

}  // namespace

Vector without_rounding(Vector v, double summed) {
  // A dozen decimals; some dozens of roundings.
  constexpr double kOfItself = 1e-12, kOfSummed = 1e-14;
  const double rounding = std::max(kOfItself * length_of(v), kOfSummed * summed);
  for (double& x : v)
    if (std::abs(x) < rounding) x = 0;
  return v;
}

Vector shift_without_rounding(const RigidPose& pose) {
  return without_rounding({pose.shift.x(), pose.shift.y(), pose.shift.z()}, pose.summed);
}

std::optional<std::size_t> coordinate_axis_of(const Vector& v) {
  for (std::size_t i = 0; i < 3; ++i)
    if (v[i] > 0 && v[(i + 1) % 3] == 0 && v[(i + 2) % 3] == 0) return i;
  return std::nullopt;
}

void TransformFactors::add_pose(YamlNode& factors, const Vector& xyz, const Vector& rpy, double summed,
                                const SourceLocation& where) const {
  add_shift(factors, without_rounding(xyz, summed), where);
  add_turns(factors, rpy, where);
}

void TransformFactors::add_pose(YamlNode& factors, const RigidPose& pose, const SourceLocation& where) const {
  add_shift(factors, shift_without_rounding(pose), where);
  add_turns(factors, angles_of(pose.turn), where);
}

void TransformFactors::add_shift(YamlNode& factors, const Vector& shift, const SourceLocation& where) const {
  if (shift != Vector{}) factors.items.push_back(&nodes_.single("translate", nodes_.numbers(shift, where)));
}

void TransformFactors::add_turns(YamlNode& factors, const Vector& rpy, const SourceLocation& where) const {
  for (const std::size_t axis : {2U, 1U, 0U}) {
    const SnappedAngle angle(rpy[axis], snap_angles_);
    if (!angle.is_zero()) add_rotation(factors, letter(axis, where), angle.text(), where);
  }
}

void TransformFactors::add_rotation(YamlNode& factors, const YamlNode& axis, std::string angle,
                                    const SourceLocation& where) const {
  YamlNode& rotation = nodes_.mapping(where);
  nodes_.put(rotation, "axis", axis);
  nodes_.put(rotation, "angle", nodes_.text(std::move(angle), where));
  factors.items.push_back(&nodes_.single("rotate", rotation));
}

void TransformFactors::add_shift_along(YamlNode& factors, const Vector& axis, const std::string& position,
                                       const SourceLocation& where) const {
  const Vector direction = without_rounding(axis);
  const double length = length_of(direction);
  const bool is_sum = position.find(' ') != std::string::npos;
  const std::string factor = is_sum ? "(" + position + ")" : position;
  const auto along = [&](double x) {
    x /= length;
    return x == 0 ? "0" : x == 1 ? position : x == -1 ? "-" + factor : number_text(x) + "*" + factor;
  };
  factors.items.push_back(&nodes_.single(
      "translate", nodes_.list({along(direction[0]), along(direction[1]), along(direction[2])}, where)));
}

void TransformFactors::add_joint(YamlNode& factors, const char* type, const Vector& vector,
                                 const std::string& coordinate, const SourceLocation& where) const {
  YamlNode& node = nodes_.mapping(where);
  nodes_.put(node, "type", nodes_.text(type, where));
  nodes_.put(node, "axis", axis(vector, where));
  nodes_.put(node, "coordinates", nodes_.list({coordinate}, where));
  factors.items.push_back(&nodes_.single("joint", node));
}

void TransformFactors::add_free(YamlNode& factors, const std::vector<std::string>& names,
                                const SourceLocation& where) const {
  add_joint_of(factors, "free", nodes_.list({names[0], names[1], names[2], names[3]}, where), where);
}

void TransformFactors::add_spherical(YamlNode& factors, const std::string& name,
                                     const SourceLocation& where) const {
  add_joint_of(factors, "spherical", nodes_.list({name}, where), where);
}

void TransformFactors::add_joint_of(YamlNode& factors, const char* type, const YamlNode& coordinates,
                                    const SourceLocation& where) const {
  YamlNode& node = nodes_.mapping(where);
  nodes_.put(node, "type", nodes_.text(type, where));
  nodes_.put(node, "coordinates", coordinates);
  factors.items.push_back(&nodes_.single("joint", node));
}

void TransformFactors::add_frame(YamlNode& frames, const std::string& name, const std::string& body,
                                 const RigidPose& pose, const SourceLocation& where) const {
  YamlNode& node = nodes_.add_named(frames, name, where);
  nodes_.put(node, "body", nodes_.text(body, where));
  YamlNode& factors = nodes_.sequence(where);
  add_pose(factors, pose, where);
  if (!factors.items.empty()) nodes_.put(node, "transform", factors);
}

const YamlNode& TransformFactors::axis(const Vector& vector, const SourceLocation& where) const {
  const Vector clean = without_rounding(vector);
  const std::optional<std::size_t> along = coordinate_axis_of(clean);
  return along ? letter(*along, where) : nodes_.numbers(clean, where);
}

}  // namespace alembert
