// Frames in which momenta and twists meet: the tree of motions in; for far pairs of unit motions the common
// frame in which their entry of M is a dot product, and the poses and twists for it, out.
//
// To carry the momentum (f, n) of a unit motion inward takes some 30 operations a joint. In one common frame
// an entry of M takes 11, M_ij = a_j . n_i + (p_j x a_j) . f_i, once the axis a_j through p_j is known there.
// So near pairs are carried and far ones meet. A meeting frame is that of some node. Around it a connected
// part of its subtree is `posed` in it: each momentum is carried inward to the first posed node, often its
// own, turned into the meeting frame, and meets there the twists of all motions from that node to the root.
#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "dynamics/rewrites/scaled_vectors.hpp"
#include "dynamics/tree/motion.hpp"
#include "dynamics/tree/motion_tree.hpp"
#include "dynamics/tree/spatial_vectors.hpp"

namespace alembert {

/// How the momentum of a unit motion comes to those far inward of it.
enum class FarPairs {
  carry,       ///< from joint to joint
  meet,        ///< in a common frame, where that is estimated to take less (meeting_frames.hpp)
  meet_sooner  ///< the same, with an estimate that is in favour of common frames
};

/// A unit motion of one frame: its twist, and the speeds that make it with their weights.
struct UnitMotion {
  Vec3 direction;
  std::vector<std::pair<int, Expr>> weights;
};
using UnitMotions = std::vector<std::vector<UnitMotion>>;  ///< of each node

/// For each node the one in whose frame it is posed: itself for a meeting frame, -1 for none.
using MeetingPlan = std::vector<int>;

/// The plan that takes the fewest operations by an estimate; -1 for all where carrying takes no more. Between
/// simple joints poses and momenta have zeros; `meet_sooner` counts on them.
MeetingPlan plan_meetings(const MotionTree& tree, const UnitMotions& units, FarPairs far,
                          const Scaling& scaling = {});

/// Poses and twists in the meeting frames of a plan.
class MeetingFrames {
 public:
  /// The tree must outlive it.
  MeetingFrames(const MotionTree& tree, const UnitMotions& units, MeetingPlan plan, ExprGraph& graph);

  bool is_posed(std::size_t node) const { return plan_[node] >= 0; }
  /// From a posed node to its meeting frame.
  Wrench at_meeting(std::size_t node, const Wrench& momentum) const;
  /// Component of a momentum that is in the meeting frame of `posed` along a unit motion of `node`, which is
  /// `posed` or lies inward of it.
  Expr along(std::size_t posed, std::size_t node, std::size_t unit, const Wrench& momentum) const;
  /// The meeting frame of a posed node, and the pose there of that node or of one inward of it.
  int meeting_of(std::size_t posed) const { return plan_[posed]; }
  const Pose& pose(int meeting, std::size_t node) const {
    return inside_.at({meeting, static_cast<int>(node)}).pose;
  }
  /// How the origin of a node that meets others in a frame moves, seen from the frame's own origin and in its axes.
  struct Moving {
    int meeting;
    std::size_t node;
    Vec3 velocity;
  };
  /// Of all that meet, where the origins of translated frames move at `shift_rates` from those before them.
  std::vector<Moving> velocities(const std::vector<Vec3>& shift_rates, ExprGraph& graph) const;

 private:
  /// A node in a meeting frame, posed in it or inward of it.
  struct Inside {
    Pose pose;
    std::vector<Twist> twists;
  };
  void add_twists(int meeting, std::size_t node, const Pose& pose, std::span<const UnitMotion> units);

  const MotionTree& tree_;
  MeetingPlan plan_;
  std::vector<Pose> poses_;                       ///< of posed nodes
  std::map<std::pair<int, int>, Inside> inside_;  ///< by meeting frame and node
};

}  // namespace alembert
