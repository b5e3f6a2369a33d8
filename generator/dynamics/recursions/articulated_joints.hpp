// Joints for articulated bodies: a tree of motions in; which speed is taken in which frame, out.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "dynamics/tree/motion_tree.hpp"
#include "dynamics/tree/spatial_vectors.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// A speed as one joint.
struct ArticulatedJoint {
  int speed;
  Twist twist;  ///< in the axes of the frame where it is taken
};

/// A speed that moves several bodies otherwise: those outward of `base` on `path`, by their own twists.
struct SharedJoint {
  int speed;
  int base;                           ///< -1: world
  std::map<std::size_t, Twist> path;  ///< nodes from the base outward to all that the speed moves, own axes
};

struct ArticulatedJoints {
  std::vector<std::vector<ArticulatedJoint>> of_node;
  std::vector<SharedJoint> shared;
};

/// Nothing if two speeds share bodies in a way that neither of these covers.
std::optional<ArticulatedJoints> articulated_joints(const MotionTree& tree, int nv, ExprGraph& g);

}  // namespace alembert
