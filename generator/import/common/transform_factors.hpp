// Poses, axes and rotations in, factors of transforms out.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "import/common/description_nodes.hpp"
#include "import/common/rigid_pose.hpp"

namespace alembert {

/// Components that are rounding of whoever wrote the file, beside a length, are 0.
std::array<double, 3> without_rounding(std::array<double, 3> v, double length);
/// The coordinate axis that a vector points along, if it does.
std::optional<std::size_t> coordinate_axis_of(const std::array<double, 3>& v);

class TransformFactors {
 public:
  /// Angles within `snap_angles` radians of a multiple of pi/12 are that multiple.
  TransformFactors(DescriptionNodes& nodes, double snap_angles) : nodes_(nodes), snap_angles_(snap_angles) {}

  /// Appends a shift by xyz and the rotation Rz(yaw) Ry(pitch) Rx(roll), rpy being roll, pitch and yaw.
  void add_pose(YamlNode& factors, const std::array<double, 3>& xyz, const std::array<double, 3>& rpy,
                const SourceLocation& where) const;
  void add_pose(YamlNode& factors, const RigidPose& pose, const SourceLocation& where) const;
  void add_rotation(YamlNode& factors, const YamlNode& axis, std::string angle,
                    const SourceLocation& where) const;
  /// Appends a shift by a position along an axis.
  void add_shift_along(YamlNode& factors, const std::array<double, 3>& axis, const std::string& position,
                       const SourceLocation& where) const;
  /// Appends a joint of one coordinate, revolute or prismatic.
  void add_joint(YamlNode& factors, const char* type, const std::array<double, 3>& axis,
                 const std::string& coordinate, const SourceLocation& where) const;
  /// Appends three shifts and a quaternion.
  void add_free(YamlNode& factors, const std::vector<std::string>& names, const SourceLocation& where) const;
  /// `x`, `y`, `z`, or the vector.
  const YamlNode& axis(const std::array<double, 3>& vector, const SourceLocation& where) const;
  const YamlNode& letter(std::size_t axis, const SourceLocation& where) const {
    return nodes_.text(std::string(1, "xyz"[axis]), where);
  }

 private:
  DescriptionNodes& nodes_;
  double snap_angles_;
};

}  // namespace alembert
