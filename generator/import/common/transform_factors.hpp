// Poses, axes and rotations in, factors of transforms out.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "import/common/description_nodes.hpp"
#include "import/common/rigid_pose.hpp"

namespace alembert {

/// Components that are rounding are 0: of decimals, beside the vector itself, and of sums, beside what is summed.
/// \param summed  the longest vector that this one is a sum of, whoever added them up
std::array<double, 3> without_rounding(std::array<double, 3> v, double summed = 0);
std::array<double, 3> shift_without_rounding(const RigidPose& pose);
/// The coordinate axis that a vector points along, if it does.
std::optional<std::size_t> coordinate_axis_of(const std::array<double, 3>& v);

class TransformFactors {
 public:
  /// Angles within `snap_angles` radians of a multiple of pi/12 are that multiple.
  TransformFactors(DescriptionNodes& nodes, double snap_angles) : nodes_(nodes), snap_angles_(snap_angles) {}

  /// Appends a shift by xyz and the rotation Rz(yaw) Ry(pitch) Rx(roll), rpy being roll, pitch and yaw.
  /// \param summed  see without_rounding
  void add_pose(YamlNode& factors, const std::array<double, 3>& xyz, const std::array<double, 3>& rpy,
                double summed, const SourceLocation& where) const;
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
  /// Appends a quaternion.
  void add_spherical(YamlNode& factors, const std::string& name, const SourceLocation& where) const;
  /// Appends an item of `frames`: one of this name that lies so in a body.
  void add_frame(YamlNode& frames, const std::string& name, const std::string& body, const RigidPose& pose,
                 const SourceLocation& where) const;
  /// `x`, `y`, `z`, or the vector.
  const YamlNode& axis(const std::array<double, 3>& vector, const SourceLocation& where) const;
  const YamlNode& letter(std::size_t axis, const SourceLocation& where) const {
    return nodes_.text(std::string(1, "xyz"[axis]), where);
  }

 private:
  void add_joint_of(YamlNode& factors, const char* type, const YamlNode& coordinates,
                    const SourceLocation& where) const;
  void add_shift(YamlNode& factors, const std::array<double, 3>& shift, const SourceLocation& where) const;
  void add_turns(YamlNode& factors, const std::array<double, 3>& rpy, const SourceLocation& where) const;

  DescriptionNodes& nodes_;
  double snap_angles_;
};

}  // namespace alembert
