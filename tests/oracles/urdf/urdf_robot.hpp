// A robot as its URDF says, read apart from `alembert import`: links, joints, inertias, drives, and what mimics what.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "oracles/taylor/rigid_motion.hpp"

namespace alembert::oracles {

using WideVector = Vector3<long double>;

struct UrdfBody {
  std::string name;
  long double mass = 0;
  WideVector com{};
  std::array<long double, 6> inertia{};  ///< xx yy zz xy xz yz about the centre of mass, in the link's axes
};

enum class UrdfMotion { fixed, turn, shift, planar, free, ball };

struct UrdfLinkage {
  std::string name;
  UrdfMotion motion = UrdfMotion::fixed;
  int parent = -1, child = -1;  ///< bodies; parent -1: the world
  RigidMotion<long double> origin;
  WideVector axis{1.0L, 0.0L, 0.0L};  ///< of length 1
  int follows = -1;                   ///< the linkage whose position it follows, itself without follower
  long double multiplier = 1, offset = 0;
  long double damping = 0, friction = 0;  ///< of a turn or a shift
  long double rotor = 0;                  ///< inertia that its drive has for it
};

struct UrdfTree {
  std::vector<UrdfBody> bodies;
  std::vector<UrdfLinkage> linkages;  ///< in the order of the file, the root's first
  std::vector<std::size_t> order;     ///< linkages, parents before children
};

/// Throws std::runtime_error at what is no tree. A mimic on a fixed joint, or of a joint that is not there or has
/// no single position, is none; one of a fixed joint fixes its own.
UrdfTree read_urdf_tree(const std::string& file, bool floating);

}  // namespace alembert::oracles
