// Inverse dynamics by the reduced form (README.md, 2), over the tree of elementary motions: O(n).
#include "dynamics/recursions/reduced.hpp"

#include "dynamics/recursions/armature.hpp"

namespace alembert {

namespace {

/// Motion of a node's frame.
struct NodeMotion {
  FrameMotion frame;
  /// Angular velocity and its rate as stored: they are angular * om and angular * al (scaled_vectors.hpp).
  Vec3 om, al;
  Scale angular;
};

NodeMotion next(const NodeMotion& before, const WrittenTree& written, std::size_t i, ExprGraph& g) {
  const MotionNode& node = written.tree.nodes[i];
  const Scale &scale = written.scaling.of_vectors(i), &angular = written.scaling.of_angular(i);
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
  const Vec3 acc = ScaledTurn(node.motion, written.scaling.is_scaled(i), from.scale, scale).outward(from.acc);
  Vec3 om, al;
  const bool scaled = before.angular != kUnscaled || angular != kUnscaled;
  if (node.motion.kind == MotionKind::rotation || !scaled) {
    // om = E^T om_p + omJ;  al = E^T al_p + (E^T om_p) x omJ + d(omJ)/dt
    om = node.motion.to_child(from.om);
    al = node.motion.to_child(from.al) + cross(om, node.velocity);
  } else {
    // The same about an axis, which the rotation leaves as it is: al = E^T (al_p + om_p x omJ) + d(omJ)/dt
    const ScaledTurn turn(node.motion, false, before.angular, angular);
    om = turn.outward(before.om);
    al = turn.outward(before.al + scaled_by(inverse(before.angular), cross(from.om, node.velocity)));
  }
  om = om + node.velocity;
  al = al + node.acceleration;
  const FrameMotion frame(scaled_by(angular, om), scaled_by(angular, al), acc, scale);
  return {frame, om, al, angular};
}

/// By node, of a mechanism that falls upward as fast as things fall.
std::vector<NodeMotion> node_motions(const Mechanism& mechanism, const WrittenTree& written,
                                     ExprGraph& graph) {
  const Vec3 zero = zeros<3, 1>(graph);
  const NodeMotion root{motion_of_world(mechanism, graph), zero, zero, kUnscaled};
  std::vector<NodeMotion> motions;
  const std::size_t count = written.tree.nodes.size();
  motions.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const int parent = written.tree.nodes[i].parent;
    const NodeMotion& from = parent < 0 ? root : motions[static_cast<std::size_t>(parent)];
    motions.push_back(next(from, written, i, graph));
  }
  return motions;
}

/// Q, to which the forces of the tree's masses and of the wrenches are added.
std::vector<Expr> tree_forces(const Mechanism& mechanism, const WrittenTree& written,
                              const std::vector<NodeWrench>& wrenches, std::vector<Expr> Q,
                              ExprGraph& graph) {
  const auto& [tree, moments, scaling] = written;
  const std::size_t count = tree.nodes.size();
  const std::vector<NodeMotion> motions = node_motions(mechanism, written, graph);

  std::vector<Wrench> loads(count, zero_wrench(graph));  // as stored
  for (std::size_t i = 0; i < count; ++i) {
    if (!tree.masses[i].is_zero())
      loads[i] = loads[i] + inertia_forces(motions[i].frame, tree.masses[i], moments[i], graph);
  }
  for (const auto& [i, point, wrench] : wrenches) {
    const Wrench there = at_offset(wrench, point);
    const Scale& scale = scaling.of_vectors(i);
    loads[i] = {loads[i].moment - scaled_by(scale, there.moment),
                loads[i].force - scaled_by(scale, there.force)};
  }

  for (std::size_t i = count; i-- > 0;) {
    const MotionNode& node = tree.nodes[i];
    const Scale& own = scaling.of_vectors(i);
    for (const TwistPartial& partial : node.partials) {
      if (partial.speed == mechanism.nv) continue;  // time
      const Vec3 direction = scaled_by(inverse(own), partial.direction);
      Q[static_cast<std::size_t>(partial.speed)] += power_along(node.motion, direction, loads[i]);
    }
    if (node.parent < 0) continue;
    const std::size_t p = static_cast<std::size_t>(node.parent);
    const ScaledTurn turn(node.motion, scaling.is_scaled(i), scaling.of_vectors(p), own);
    loads[p] = loads[p] + turn.inward(loads[i]);
  }
  return Q;
}

}  // namespace

FrameMotion motion_of_world(const Mechanism& mechanism, ExprGraph& graph) {
  const Vec3 zero = zeros<3, 1>(graph);
  return {zero, zero, {{-mechanism.gravity[0], -mechanism.gravity[1], -mechanism.gravity[2]}}};
}

std::vector<FrameMotion> frame_motions(const Mechanism& mechanism, const WrittenTree& written,
                                       ExprGraph& graph) {
  std::vector<FrameMotion> out;
  for (const NodeMotion& motion : node_motions(mechanism, written, graph)) out.push_back(motion.frame);
  return out;
}

std::vector<Expr> reduced_inverse_dynamics(const Mechanism& mechanism, const WrittenTree& written,
                                           ExprGraph& graph) {
  return tree_forces(mechanism, written, external_wrenches(mechanism, written.tree, graph),
                     armature_forces(mechanism), graph);
}

std::vector<Expr> gravity_forces(const Mechanism& mechanism, const WrittenTree& written, ExprGraph& graph) {
  WrittenTree still = written;
  for (MotionNode& node : still.tree.nodes) node.velocity = node.acceleration = zeros<3, 1>(graph);
  const std::vector<Expr> none(static_cast<std::size_t>(mechanism.nv), graph.zero());
  return tree_forces(mechanism, still, {}, none, graph);
}

}  // namespace alembert
