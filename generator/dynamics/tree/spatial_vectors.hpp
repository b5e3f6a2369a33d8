// Motion and force vectors: pairs of an angular and a linear part about the origin of a frame, in its axes, and
// how they change with the frame. In: a vector and a motion or pose between two frames. Out: the same vector in
// the other frame. Source: R. Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 2.
//
// `inward` is from a frame to the one before it (its parent), `outward` the other way.
#pragma once

#include "dynamics/tree/motion.hpp"

namespace alembert {

/// A motion vector: a velocity or an acceleration, `linear` that of the point at the origin.
struct Twist {
  Vec3 angular, linear;
  const Expr& operator[](std::size_t i) const { return i < 3 ? angular[i] : linear[i - 3]; }
};
/// A force vector: a force with its moment, or a momentum with the angular momentum, about the origin.
struct Wrench {
  Vec3 moment, force;
  Expr& operator[](std::size_t i) { return i < 3 ? moment[i] : force[i - 3]; }
  const Expr& operator[](std::size_t i) const { return i < 3 ? moment[i] : force[i - 3]; }
};

Twist zero_twist(ExprGraph& graph);
Wrench zero_wrench(ExprGraph& graph);
Twist operator+(const Twist& x, const Twist& y);
Wrench operator+(const Wrench& x, const Wrench& y);
Twist operator*(Expr factor, const Twist& x);
Wrench operator*(Expr factor, const Wrench& x);
/// Power: angular . moment + linear . force.
Expr dot(const Twist& x, const Wrench& y);

/// About the point at `offset` from the origin: linear + angular x offset.
Twist about_point(const Twist& x, const Vec3& offset);
/// About the point from which the origin is at `offset`: moment + offset x force.
Wrench at_offset(const Wrench& x, const Vec3& offset);

Twist outward(const Motion& motion, const Twist& x);
Wrench inward(const Motion& motion, const Wrench& x);
Twist outward(const Pose& pose, const Twist& x);
Twist inward(const Pose& pose, const Twist& x);
Wrench inward(const Pose& pose, const Wrench& x);

/// The twist of a motion along `direction`, which is angular for rotations and linear for translations.
Twist twist_along(const Motion& motion, const Vec3& direction);
/// Its power: direction . moment, or direction . force.
Expr power_along(const Motion& motion, const Vec3& direction, const Wrench& x);

}  // namespace alembert
