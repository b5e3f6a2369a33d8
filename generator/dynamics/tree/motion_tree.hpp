// Stage `kinematics`: typed mechanism in, tree of elementary motions out.
//
// Every transform is a product of elementary motions: a translation, a plane rotation about a coordinate
// axis, or a rotation by a full matrix, each any function of the coordinates and time. A node of the tree is
// the frame reached after one such motion; bodies hang on nodes. A node's twist and its rate come from
// derivatives along the speeds, so the recursions of README.md, 2 need no joint types, and frames
// without mass cost nothing but their motion.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "dynamics/tree/motion.hpp"
#include "dynamics/tree/speed_derivatives.hpp"
#include "mechanism/model.hpp"
#include "symbolic/matrix.hpp"

namespace alembert {

/// Derivative of a motion along one speed: direction of the twist (angular for rotations, in the next frame's
/// axes; linear for translations).
struct TwistPartial {
  int speed;  ///< Mechanism::nv for time
  Vec3 direction;
  friend bool operator==(const TwistPartial&, const TwistPartial&) = default;
};

/// A frame of the tree.
struct MotionNode {
  int parent = -1;  ///< -1: world
  Motion motion;
  std::vector<TwistPartial> partials;
  Vec3 velocity;      ///< angular velocity (rotations) or dt/dt (translations) relative to the parent frame
  Vec3 acceleration;  ///< its componentwise rate
  std::vector<int> bodies;
  friend bool operator==(const MotionNode&, const MotionNode&) = default;
};

/// Mass properties about a node's origin, in its axes: mass, first moment h = m c, inertia J.
struct NodeMass {
  Expr mass;
  Vec3 moment;
  Mat3 inertia;
  bool is_zero() const;
  friend bool operator==(const NodeMass&, const NodeMass&) = default;
};

/// Where a body is: the node its mass is fixed to and the constant motions from that node to the body's own
/// frame.
struct BodyPlace {
  int node = -1;  ///< -1: fixed to the world
  std::vector<Motion> tail;
  friend bool operator==(const BodyPlace&, const BodyPlace&) = default;
};

struct MotionTree {
  std::vector<MotionNode> nodes;  ///< parents first
  std::vector<BodyPlace> places;  ///< one for each body
  std::vector<NodeMass> masses;   ///< one for each node: of all that is fixed to it
  friend bool operator==(const MotionTree&, const MotionTree&) = default;
};

/// The twist of a motion along each speed it depends on (and along time): three values each, as in
/// TwistPartial.
std::vector<SpeedPartial> twist_partials(const Motion& motion, const Mechanism& mechanism,
                                         const SpeedDerivatives& derivatives, ExprGraph& graph);

/// Throws as elementary_motions does.
MotionTree motion_tree(const Mechanism& mechanism, const SpeedDerivatives& derivatives, ExprGraph& graph);
/// The same tree from the motions of each body's transform.
MotionTree motion_tree(const Mechanism& mechanism, std::span<const std::vector<Motion>> motions_of_body,
                       const SpeedDerivatives& derivatives, ExprGraph& graph);

/// Mass of a body about the origin of its node.
NodeMass mass_at_node(const Body& body, const BodyPlace& place, ExprGraph& graph);
/// Centre of mass of a body in the axes of its node.
Vec3 center_at_node(const Body& body, const BodyPlace& place);

}  // namespace alembert
