// Inverse dynamics by the reduced form (README.md, 2), over the tree of elementary motions: O(n).
#include "dynamics/recursions/reduced.hpp"

#include "dynamics/recursions/armature.hpp"
#include "dynamics/recursions/body_forces.hpp"
#include "dynamics/tree/symbols.hpp"

namespace alembert {

namespace {

/// Motion of a node's frame.
struct NodeMotion {
  FrameMotion frame;
  /// Angular velocity and its rate as stored: they are angular * om and angular * al (scaled_vectors.hpp).
  Vec3 om, al;
  Scale angular;
};

NodeMotion next(const NodeMotion& before, const MotionNode& node, const Scale& scale, const Scale& angular,
                ExprGraph& g) {
  const FrameMotion& from = before.frame;
  if (node.motion.kind == MotionKind::translation) {
    // acc + U t + 2 om x tdot + tddot
    const Vec3 doubled = g.integer(2) * node.velocity;
    const Scale back = inverse(scale);
    Vec3 acc = from.at(node.motion.offset);
    acc = acc + scaled_by(back, cross(from.om, doubled));
    acc = acc + scaled_by(back, node.acceleration);
    NodeMotion out = before;
    out.frame.acc = acc;
    return out;
  }
  const Vec3 acc = ScaledTurn(node, from.scale, scale).outward(from.acc);
  Vec3 om, al;
  const bool scaled = before.angular != kUnscaled || angular != kUnscaled;
  if (node.motion.kind == MotionKind::rotation || !scaled) {
    // om = E^T om_p + omJ;  al = E^T al_p + (E^T om_p) x omJ + d(omJ)/dt
    om = node.motion.to_child(from.om);
    al = node.motion.to_child(from.al) + cross(om, node.velocity);
  } else {
    // The same about an axis, which the rotation leaves as it is: al = E^T (al_p + om_p x omJ) + d(omJ)/dt
    const ScaledTurn turn(node, before.angular, angular, false);
    om = turn.outward(before.om);
    al = turn.outward(before.al + scaled_by(inverse(before.angular), cross(from.om, node.velocity)));
  }
  om = om + node.velocity;
  al = al + node.acceleration;
  const FrameMotion frame(scaled_by(angular, om), scaled_by(angular, al), acc, scale);
  return {frame, om, al, angular};
}

/// Q, to which the forces of the tree's masses and of the wrenches are added.
std::vector<Expr> tree_forces(const Mechanism& mechanism, const MotionTree& tree,
                              const std::vector<WrenchSymbols>& wrenches, std::vector<Expr> Q,
                              ExprGraph& graph) {
  const std::size_t count = tree.nodes.size();
  const Vec3 zero = zeros<3, 1>(graph);
  const Vec3 acceleration{{-mechanism.gravity[0], -mechanism.gravity[1], -mechanism.gravity[2]}};
  const NodeMotion root{FrameMotion(zero, zero, acceleration), zero, zero, kUnscaled};

  std::vector<NodeMotion> motions;
  motions.reserve(count);
  const std::vector<Scale> scales = node_scales(tree), angular = angular_scales(tree);
  for (std::size_t i = 0; i < count; ++i) {
    const MotionNode& node = tree.nodes[i];
    const NodeMotion& from = node.parent < 0 ? root : motions[static_cast<std::size_t>(node.parent)];
    motions.push_back(next(from, node, scales[i], angular[i], graph));
  }

  // External wrenches are given in world axes: the world rotations of the nodes are made only if there are
  // any.
  std::vector<Pose> poses;
  if (!wrenches.empty()) {
    for (const MotionNode& node : tree.nodes) {
      const Pose from = node.parent < 0 ? identity_pose(graph) : poses[static_cast<std::size_t>(node.parent)];
      poses.push_back(node.motion.kind == MotionKind::translation ? from : moved(from, node.motion));
    }
  }

  std::vector<Vec3> force(count, zero), moment(count, zero);  // as stored
  for (std::size_t i = 0; i < count; ++i) {
    const FrameMotion& s = motions[i].frame;
    if (tree.masses[i].is_zero()) continue;
    const ForceMoment inertia = inertia_forces(s, tree.masses[i], graph);
    force[i] = force[i] + inertia.force;
    moment[i] = moment[i] + inertia.moment;
  }
  for (const WrenchSymbols& wrench : wrenches) {
    const BodyPlace& place = tree.places[static_cast<std::size_t>(wrench.body)];
    if (place.node < 0) continue;
    const std::size_t i = static_cast<std::size_t>(place.node);
    const Mat3 world_to_node = transpose(poses[i].rotation);
    const Vec3 f = world_to_node * wrench.force;
    const Vec3 c = center_at_node(mechanism.bodies[static_cast<std::size_t>(wrench.body)], place);
    force[i] = force[i] - scaled_by(scales[i], f);
    moment[i] = moment[i] - scaled_by(scales[i], world_to_node * wrench.torque + cross(c, f));
  }

  for (std::size_t i = count; i-- > 0;) {
    const MotionNode& node = tree.nodes[i];
    const bool linear = node.motion.kind == MotionKind::translation;
    const Scale& own = scales[i];
    for (const TwistPartial& partial : node.partials) {
      if (partial.speed == mechanism.nv) continue;  // time
      const Vec3 direction = scaled_by(inverse(own), partial.direction);
      Q[static_cast<std::size_t>(partial.speed)] += dot(direction, linear ? force[i] : moment[i]);
    }
    if (node.parent < 0) continue;
    const std::size_t p = static_cast<std::size_t>(node.parent);
    if (linear) {
      force[p] = force[p] + force[i];
      moment[p] = moment[p] + (moment[i] + scaled_cross(node.motion.offset, force[i], own));
    } else {
      const ScaledTurn turn(node, scales[p], own);
      force[p] = force[p] + turn.inward(force[i]);
      moment[p] = moment[p] + turn.inward(moment[i]);
    }
  }
  return Q;
}

}  // namespace

std::vector<Expr> reduced_inverse_dynamics(const Mechanism& mechanism, const MotionTree& tree,
                                           ExprGraph& graph) {
  return tree_forces(mechanism, tree, wrench_symbols(mechanism, graph), armature_forces(mechanism), graph);
}

std::vector<Expr> gravity_forces(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph) {
  MotionTree still = tree;
  for (MotionNode& node : still.nodes) node.velocity = node.acceleration = zeros<3, 1>(graph);
  const std::vector<Expr> none(static_cast<std::size_t>(mechanism.nv), graph.zero());
  return tree_forces(mechanism, still, {}, none, graph);
}

}  // namespace alembert
