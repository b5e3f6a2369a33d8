// Inverse dynamics by the reduced form (method.md section 3), over the tree of elementary motions: O(n).
#include <optional>

#include "dynamics/formulations.hpp"

namespace alembert {

namespace {

/// Motion of a frame and the products of its angular velocity, made once.
struct FrameMotion {
  Vec3 om, al, acc;
  Expr xx, yy, zz, xy, xz, yz;  ///< om om^T
  Mat3 U;                       ///< skew(al) + skew(om)^2

  FrameMotion(const Vec3& angular, const Vec3& angular_rate, const Vec3& linear)
      : om(angular), al(angular_rate), acc(linear) {
    xx = om[0] * om[0];
    yy = om[1] * om[1];
    zz = om[2] * om[2];
    xy = om[0] * om[1];
    xz = om[0] * om[2];
    yz = om[1] * om[2];
    U(0, 0) = -(yy + zz);
    U(1, 1) = -(xx + zz);
    U(2, 2) = -(xx + yy);
    U(0, 1) = xy - al[2];
    U(1, 0) = xy + al[2];
    U(0, 2) = xz + al[1];
    U(2, 0) = xz - al[1];
    U(1, 2) = yz - al[0];
    U(2, 1) = yz + al[0];
  }
};

FrameMotion next(const FrameMotion& from, const MotionNode& node, ExprGraph& g) {
  if (node.motion.kind == MotionKind::translation) {
    // acc + U t + 2 om x tdot + tddot
    const Vec3 doubled = g.integer(2) * node.velocity;
    Vec3 acc = from.acc + from.U * node.motion.offset;
    acc = acc + cross(from.om, doubled);
    acc = acc + node.acceleration;
    FrameMotion out = from;
    out.acc = acc;
    return out;
  }
  // om = E^T om_p + omJ;  al = E^T al_p + (E^T om_p) x omJ + d(omJ)/dt
  const Vec3 om = node.motion.to_child(from.om);
  Vec3 al = node.motion.to_child(from.al) + cross(om, node.velocity);
  al = al + node.acceleration;
  return {om + node.velocity, al, node.motion.to_child(from.acc)};
}

/// Moment of the inertia forces of rotation about the frame's origin: J al + om x J om.
Vec3 rotational_moment(const FrameMotion& s, const Mat3& J, MomentForm form, ExprGraph& g) {
  const Expr half = g.rational(Rational(1, 2));
  Expr trace = J(0, 0) + J(1, 1);
  trace += J(2, 2);
  const Expr half_trace = half * trace;
  const Expr Kxx = half_trace - J(0, 0), Kyy = half_trace - J(1, 1), Kzz = half_trace - J(2, 2);
  const Expr Kxy = -J(0, 1), Kxz = -J(0, 2), Kyz = -J(1, 2);
  Vec3 n = zeros<3, 1>(g);
  const auto add = [](Expr& sum, Expr x, Expr y) { sum += x * y; };
  add(n[0], s.U(2, 0), Kxy);
  add(n[0], s.U(1, 0), -Kxz);
  add(n[0], s.zz - s.yy, Kyz);
  add(n[1], s.xx - s.zz, Kxz);
  add(n[1], s.U(0, 1), Kyz);
  add(n[1], s.U(2, 1), -Kxy);
  add(n[2], s.yy - s.xx, Kxy);
  add(n[2], s.U(1, 2), Kxz);
  add(n[2], s.U(0, 2), -Kyz);
  switch (form) {
    case MomentForm::pseudo_inertia:
      add(n[0], s.U(2, 1), Kyy);
      add(n[0], s.U(1, 2), -Kzz);
      add(n[1], s.U(0, 2), Kzz);
      add(n[1], s.U(2, 0), -Kxx);
      add(n[2], s.U(1, 0), Kxx);
      add(n[2], s.U(0, 1), -Kyy);
      break;
    case MomentForm::inertia:
      add(n[0], s.al[0], J(0, 0));
      add(n[0], s.yz, J(2, 2) - J(1, 1));
      add(n[1], s.al[1], J(1, 1));
      add(n[1], s.xz, J(0, 0) - J(2, 2));
      add(n[2], s.al[2], J(2, 2));
      add(n[2], s.xy, J(1, 1) - J(0, 0));
      break;
  }
  return n;
}

}  // namespace

std::vector<Expr> reduced_inverse_dynamics(const Mechanism& mechanism, const MotionTree& tree,
                                           const SpeedDerivatives& derivatives, MomentForm form,
                                           ExprGraph& graph) {
  const std::size_t count = tree.nodes.size();
  const Vec3 zero = zeros<3, 1>(graph);
  const FrameMotion root(zero, zero, {{-mechanism.gravity[0], -mechanism.gravity[1], -mechanism.gravity[2]}});

  std::vector<FrameMotion> motions;
  motions.reserve(count);
  for (const MotionNode& node : tree.nodes) {
    const FrameMotion& from = node.parent < 0 ? root : motions[static_cast<std::size_t>(node.parent)];
    motions.push_back(next(from, node, graph));
  }

  // External wrenches are given in world axes: the world rotations of the nodes are made only if there are
  // any.
  const std::vector<WrenchSymbols> wrenches = wrench_symbols(mechanism, graph);
  std::vector<Pose> poses;
  if (!wrenches.empty()) {
    for (const MotionNode& node : tree.nodes) {
      const Pose from = node.parent < 0 ? identity_pose(graph) : poses[static_cast<std::size_t>(node.parent)];
      poses.push_back(node.motion.kind == MotionKind::translation ? from : moved(from, node.motion));
    }
  }

  std::vector<Vec3> force(count, zero), moment(count, zero);
  for (std::size_t i = 0; i < count; ++i) {
    const FrameMotion& s = motions[i];
    for (const int b : tree.nodes[i].bodies) {
      const std::size_t body = static_cast<std::size_t>(b);
      const NodeMass mass = mass_at_node(mechanism.bodies[body], tree.places[body], graph);
      // f = m acc + U h;  n = J al + om x J om + h x acc
      force[i] = force[i] + (mass.mass * s.acc + s.U * mass.moment);
      moment[i] = moment[i] + (rotational_moment(s, mass.inertia, form, graph) + cross(mass.moment, s.acc));
    }
  }
  for (const WrenchSymbols& wrench : wrenches) {
    const BodyPlace& place = tree.places[static_cast<std::size_t>(wrench.body)];
    if (place.node < 0) continue;
    const std::size_t i = static_cast<std::size_t>(place.node);
    const Mat3 world_to_node = transpose(poses[i].rotation);
    const Vec3 f = world_to_node * wrench.force;
    const Vec3 c = center_at_node(mechanism.bodies[static_cast<std::size_t>(wrench.body)], place);
    force[i] = force[i] - f;
    moment[i] = moment[i] - (world_to_node * wrench.torque + cross(c, f));
  }

  std::vector<Expr> Q(static_cast<std::size_t>(mechanism.nv), graph.zero());
  for (std::size_t i = count; i-- > 0;) {
    const MotionNode& node = tree.nodes[i];
    const bool linear = node.motion.kind == MotionKind::translation;
    for (const TwistPartial& partial : node.partials) {
      if (partial.speed == derivatives.time_index()) continue;
      Q[static_cast<std::size_t>(partial.speed)] += dot(partial.direction, linear ? force[i] : moment[i]);
    }
    if (node.parent < 0) continue;
    const std::size_t p = static_cast<std::size_t>(node.parent);
    if (linear) {
      force[p] = force[p] + force[i];
      moment[p] = moment[p] + (moment[i] + cross(node.motion.offset, force[i]));
    } else {
      force[p] = force[p] + node.motion.to_parent(force[i]);
      moment[p] = moment[p] + node.motion.to_parent(moment[i]);
    }
  }
  return Q;
}

}  // namespace alembert
