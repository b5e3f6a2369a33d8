// Motion and force vectors (see the header).
#include "dynamics/tree/spatial_vectors.hpp"

namespace alembert {

Twist zero_twist(ExprGraph& graph) {
  return {zeros<3, 1>(graph), zeros<3, 1>(graph)};
}
Wrench zero_wrench(ExprGraph& graph) {
  return {zeros<3, 1>(graph), zeros<3, 1>(graph)};
}
Twist operator+(const Twist& x, const Twist& y) {
  return {x.angular + y.angular, x.linear + y.linear};
}
Wrench operator+(const Wrench& x, const Wrench& y) {
  return {x.moment + y.moment, x.force + y.force};
}
Twist operator*(Expr factor, const Twist& x) {
  return {factor * x.angular, factor * x.linear};
}
Wrench operator*(Expr factor, const Wrench& x) {
  return {factor * x.moment, factor * x.force};
}
Expr dot(const Twist& x, const Wrench& y) {
  const Expr angular = dot(x.angular, y.moment);
  return angular + dot(x.linear, y.force);
}

Twist about_point(const Twist& x, const Vec3& offset) {
  return {x.angular, x.linear + cross(x.angular, offset)};
}
Wrench at_offset(const Wrench& x, const Vec3& offset) {
  return {x.moment + cross(offset, x.force), x.force};
}

Twist outward(const Motion& motion, const Twist& x) {
  if (motion.kind == MotionKind::translation) return about_point(x, motion.offset);
  return {motion.to_child(x.angular), motion.to_child(x.linear)};
}
Wrench inward(const Motion& motion, const Wrench& x) {
  if (motion.kind == MotionKind::translation) return at_offset(x, motion.offset);
  return {motion.to_parent(x.moment), motion.to_parent(x.force)};
}

Twist outward(const Pose& pose, const Twist& x) {
  const Mat3 back = transpose(pose.rotation);
  const Twist there = about_point(x, pose.origin);
  return {back * there.angular, back * there.linear};
}
Twist inward(const Pose& pose, const Twist& x) {
  const Vec3& p = pose.origin;
  return about_point({pose.rotation * x.angular, pose.rotation * x.linear}, {{-p[0], -p[1], -p[2]}});
}
Wrench inward(const Pose& pose, const Wrench& x) {
  return at_offset({pose.rotation * x.moment, pose.rotation * x.force}, pose.origin);
}

Twist twist_along(const Motion& motion, const Vec3& direction) {
  const Vec3 none = zeros<3, 1>(direction[0].graph());
  return motion.kind == MotionKind::translation ? Twist{none, direction} : Twist{direction, none};
}
Expr power_along(const Motion& motion, const Vec3& direction, const Wrench& x) {
  return dot(direction, motion.kind == MotionKind::translation ? x.force : x.moment);
}

}  // namespace alembert
