// What the readers of factors share: axes, and the joints that stand for several factors.
#pragma once

#include <string>

#include "mechanism/loading.hpp"

namespace alembert {

/// Reads a list of factors (transforms.cpp). `what` names it: `the transform of body 'arm'`.
Transform read_transform(Loading& loading, const YamlNode& list, const std::string& what);

/// A constant direction: a coordinate axis with a sign, or a unit vector.
struct Axis {
  int coordinate_axis = 2;  ///< 0, 1, 2, or -1 if `direction` is none of them
  bool negative = false;    ///< against the coordinate axis
  Vec3 direction;           ///< of length one
};

/// Reads x, y, z or a list of three constants, which is normalised exactly: v / sqrt(v.v).
Axis read_axis(Loading& loading, const YamlNode& node, const std::string& what);
Axis coordinate_axis(ExprGraph& graph, int index);
Factor rotation_about(const Axis& axis, const Expr& angle, const SourceLocation& where);
Factor shift_along(const Axis& axis, const Expr& distance, const SourceLocation& where);
/// Rotation by a quaternion coordinate; a second use of it is an error.
Factor rotation_by_quaternion(Loading& loading, const YamlNode& name, const std::string& what);

}  // namespace alembert
