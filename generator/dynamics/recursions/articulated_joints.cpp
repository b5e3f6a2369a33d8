// Which speed is taken where (see the header).
#include "dynamics/recursions/articulated_joints.hpp"

#include <utility>

namespace alembert {
namespace {

Twist own_twist(const MotionNode& node, int speed, ExprGraph& g) {
  Twist twist = zero_twist(g);
  for (const TwistPartial& partial : node.partials)
    if (partial.speed == speed) twist = twist + twist_along(node.motion, partial.direction);
  return twist;
}

/// The speed as one joint at the outermost of its nodes, with the sum of their twists: only that frame's motion
/// matters if there is no mass, and no branch, on the way from the innermost. Otherwise nothing.
std::optional<ArticulatedJoint> taken_outermost(const MotionTree& tree, const std::vector<int>& children,
                                                int speed, std::vector<std::size_t> nodes, ExprGraph& g) {
  Twist sum = zero_twist(g);
  std::vector<std::size_t> path;  // from the outermost to the frame before
  for (std::size_t at = nodes.back();;) {
    if (at == nodes.back()) {
      Twist twist = own_twist(tree.nodes[at], speed, g);
      for (std::size_t k = path.size(); k-- > 0;) twist = outward(tree.nodes[path[k]].motion, twist);
      sum = sum + twist;
      nodes.pop_back();
      if (nodes.empty()) return ArticulatedJoint{speed, sum};
    }
    path.push_back(at);
    if (tree.nodes[at].parent < 0) return std::nullopt;  // the rest is on another branch
    at = static_cast<std::size_t>(tree.nodes[at].parent);
    if (children[at] != 1 || !tree.masses[at].is_zero()) return std::nullopt;
  }
}

/// Nothing if another speed moves a node on the way.
std::optional<SharedJoint> taken_together(const MotionTree& tree, int nv, int speed,
                                          const std::vector<std::size_t>& nodes, ExprGraph& g) {
  const auto parent = [&](int node) { return tree.nodes[static_cast<std::size_t>(node)].parent; };
  // Parents have smaller numbers: the meeting frame is found by always going on from the larger.
  int base = tree.nodes[nodes[0]].parent;
  for (const std::size_t node : nodes)
    for (int other = tree.nodes[node].parent; other != base;) {
      int& larger = other > base ? other : base;
      larger = parent(larger);
    }
  SharedJoint joint{speed, base, {}};
  for (const std::size_t node : nodes)
    for (int at = static_cast<int>(node); at != base; at = parent(at)) {
      const MotionNode& on_way = tree.nodes[static_cast<std::size_t>(at)];
      for (const TwistPartial& partial : on_way.partials)
        if (partial.speed != speed && partial.speed != nv) return std::nullopt;
      joint.path.try_emplace(static_cast<std::size_t>(at), own_twist(on_way, speed, g));
    }
  return joint;
}

}  // namespace

std::optional<ArticulatedJoints> articulated_joints(const MotionTree& tree, int nv, ExprGraph& g) {
  const std::size_t count = tree.nodes.size();
  std::vector<int> children(count, 0);
  std::vector<std::vector<std::size_t>> nodes_of(static_cast<std::size_t>(nv));
  for (std::size_t i = 0; i < count; ++i) {
    const MotionNode& node = tree.nodes[i];
    if (node.parent >= 0) ++children[static_cast<std::size_t>(node.parent)];
    for (const TwistPartial& partial : node.partials) {
      if (partial.speed == nv) continue;  // time
      std::vector<std::size_t>& nodes = nodes_of[static_cast<std::size_t>(partial.speed)];
      if (nodes.empty() || nodes.back() != i) nodes.push_back(i);
    }
  }
  ArticulatedJoints joints{std::vector<std::vector<ArticulatedJoint>>(count), {}};
  std::vector<bool> on_way(count, false);
  for (int speed = 0; speed < nv; ++speed) {
    const std::vector<std::size_t>& nodes = nodes_of[static_cast<std::size_t>(speed)];
    if (nodes.empty()) return std::nullopt;
    if (const auto joint = taken_outermost(tree, children, speed, nodes, g)) {
      joints.of_node[nodes.back()].push_back(*joint);
      continue;
    }
    std::optional<SharedJoint> shared = taken_together(tree, nv, speed, nodes, g);
    if (!shared) return std::nullopt;
    for (const auto& [node, twist] : shared->path) {
      if (on_way[node]) return std::nullopt;
      on_way[node] = true;
    }
    joints.shared.push_back(std::move(*shared));
  }
  return joints;
}

}  // namespace alembert
