// What the readers of factors share: axes, and the joints that stand for several factors.
#pragma once

#include <string>

#include "mechanism/loading.hpp"

namespace alembert {

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

/// Appends the factors that a joint stands for (joints.cpp).
void append_joint(Loading& loading, const YamlNode& node, const std::string& what, Transform& transform);

/// All expressions of a factor; those of a quaternion by its first symbol.
std::vector<Expr> expressions_of(const Factor& factor, const Mechanism& mechanism);
/// Whether an expression has a symbol below it.
bool depends_on(const Vec3& point, const Expr& symbol);
/// Throws where a body's transform moves with more than six speeds, at a shape that moves in its body, and at
/// a coordinate that moves no body.
void check_coordinates(const Loading& loading, const std::vector<const Body*>& bodies_in_file_order);

}  // namespace alembert
