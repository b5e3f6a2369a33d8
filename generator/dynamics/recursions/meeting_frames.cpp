// Which momenta meet which twists in a common frame, by an estimate of the operations, and the poses for it
// (see the header).
#include "dynamics/recursions/meeting_frames.hpp"

#include <algorithm>

namespace alembert {

namespace {

/// Estimated multiplications and additions.
using Cost = long long;

/// A momentum through a pose, and that of a rotation in its own frame, whose f has two components only.
struct TurningCosts {
  Cost carried, own;
};
constexpr TurningCosts kGeneric{42, 36};
constexpr TurningCosts kSparse{20, 20};
constexpr Cost kOwnCarried = -10;  ///< what two components save in carrying, where f is shared with h

std::size_t index(int node) {
  return static_cast<std::size_t>(node);
}

Cost nonzeros(const Vec3& v) {
  return std::count_if(v.entries.begin(), v.entries.end(), [](const Expr& x) { return !x.is_zero(); });
}

/// What the vectors that pass a motion take.
struct MotionCosts {
  Cost carried;  ///< a momentum to the parent's frame
  Cost posed;    ///< a pose from one frame to the next
};
MotionCosts costs_of(const Motion& motion, bool scaled) {
  switch (motion.kind) {
    case MotionKind::translation:
      return {4 * nonzeros(motion.offset), 6 * nonzeros(motion.offset)};
    case MotionKind::axis_rotation:
      if (is_quarter_turn(motion)) return {0, 0};
      return {scaled ? 8 : 12, 18};
    case MotionKind::rotation:
      return {30, 45};
  }
  return {};
}

/// How the axes of a frame look in the meeting frame.
enum class Look { same, constant, generic };
Look beyond(Look look, const MotionNode& node) {
  if (!node.partials.empty()) return Look::generic;
  return look == Look::generic ? Look::generic : Look::constant;
}

/// A frame's own unit motions.
struct UnitCosts {
  Cost number = 0;        ///< of unit motions
  Cost direct = 0;        ///< components of a momentum in the own frame along all of them
  Cost twists = 0;        ///< twists in a generic frame
  Cost met = 0;           ///< components of a momentum there along all of them
  Cost met_constant = 0;  ///< the same where the pose is constant
};
UnitCosts costs_of(const MotionNode& node, std::span<const UnitMotion> units) {
  UnitCosts costs;
  const bool linear = node.motion.kind == MotionKind::translation;
  for (const UnitMotion& unit : units) {
    const Cost n = nonzeros(unit.direction);
    ++costs.number;
    costs.direct += n > 1 ? 2 * n - 1 : 0;
    costs.twists += (n > 1 ? 6 * n - 3 : 0) + (linear ? 0 : 9);
    costs.met += linear ? 5 : 11;
    costs.met_constant += linear ? 3 : 7;
  }
  return costs;
}

class Planner {
 public:
  Planner(const MotionTree& tree, const UnitMotions& units, const Scaling& scaling, TurningCosts turning)
      : tree_(tree), turning_(turning), count_(tree.nodes.size()) {
    for (std::size_t k = 0; k < count_; ++k) {
      motions_.push_back(costs_of(tree.nodes[k].motion, scaling.is_scaled(k)));
      units_.push_back(costs_of(tree.nodes[k], units[k]));
      numbers_.push_back(units_[k].number);
      const int parent = tree.nodes[k].parent;
      wanted_.push_back(units_[k].number > 0 || (parent >= 0 && wanted_[index(parent)]));
    }
    carried_.assign(count_, 0);
    for (std::size_t k = count_; k-- > 0;) {
      const int parent = tree.nodes[k].parent;
      if (parent < 0) continue;
      numbers_[index(parent)] += numbers_[k];
      carried_[index(parent)] += carried_[k] + to_parent(k) + numbers_[k] * units_[index(parent)].direct;
    }
  }

  MeetingPlan plan() {
    MeetingPlan none(count_, -1), best = none;
    // The best meeting frame of each subtree, or those of its branches.
    std::vector<Cost> gains(count_, 0);
    std::vector<int> chosen(count_, -1);
    for (std::size_t k = count_; k-- > 0;) {
      const Cost own = gain(k);
      if (own > 0 && own >= gains[k]) {
        gains[k] = own;
        chosen[k] = static_cast<int>(k);
      }
      const int parent = tree_.nodes[k].parent;
      if (parent >= 0) gains[index(parent)] += gains[k];
    }
    for (std::size_t k = 0; k < count_; ++k) {
      const int parent = tree_.nodes[k].parent;
      const int above = parent < 0 ? -1 : chosen[index(parent)];
      if (above >= 0) chosen[k] = above;  // from here on: the meeting frame that the node lies beyond
    }
    for (std::size_t k = 0; k < count_; ++k) {
      if (chosen[k] != static_cast<int>(k)) continue;
      gain(k);
      best[k] = static_cast<int>(k);
      for (std::size_t i = k + 1; i < count_; ++i) {
        const int parent = tree_.nodes[i].parent;
        if (parent >= 0 && best[index(parent)] == static_cast<int>(k) && posed_[i])
          best[i] = static_cast<int>(k);
      }
    }
    return best;
  }

 private:
  /// All momenta of a node's subtree through its motion.
  Cost to_parent(std::size_t k) const {
    const int parent = tree_.nodes[k].parent;
    if (motions_[k].carried == 0 || parent < 0 || !wanted_[index(parent)]) return 0;
    return numbers_[k] * motions_[k].carried + units_[k].number * kOwnCarried;
  }

  Cost met(std::size_t k, Look look) const {
    switch (look) {
      case Look::same:
        return units_[k].direct;
      case Look::constant:
        return units_[k].met_constant;
      case Look::generic:
        return units_[k].met;
    }
    return 0;
  }

  /// Operations that a meeting frame saves, and in posed_ what is best posed in it.
  Cost gain(std::size_t frame) {
    Cost inward = 0;        // all motions from the frame to the root, for one momentum
    Cost inner_twists = 0;  // their twists and poses
    Cost carried = carried_[frame];
    Look look = Look::same;
    for (std::size_t k = frame;;) {
      inward += met(k, look);
      if (look == Look::generic) inner_twists += units_[k].twists;
      const int parent = tree_.nodes[k].parent;
      if (parent < 0 || !wanted_[index(parent)]) break;
      if (look == Look::generic) inner_twists += motions_[k].posed;
      look = beyond(look, tree_.nodes[k]);
      carried += numbers_[frame] * (motions_[k].carried + units_[index(parent)].direct);
      k = index(parent);
    }

    // Outward: the look of each frame, and what a momentum that has come to the meeting frame from beyond
    // this node's motion takes there.
    looks_.assign(count_, Look::generic);
    inward_.assign(count_, 0);
    inside_.assign(count_, false);
    looks_[frame] = Look::same;
    inward_[frame] = inward;
    inside_[frame] = true;
    for (std::size_t k = frame + 1; k < count_; ++k) {
      const int parent = tree_.nodes[k].parent;
      if (parent < 0 || !inside_[index(parent)]) continue;
      inside_[k] = true;
      const Look before = looks_[index(parent)];
      looks_[k] = beyond(before, tree_.nodes[k]);
      inward_[k] = inward_[index(parent)] + met(k, before);
    }
    // Inward: everything in a node's subtree if the node is posed.
    cost_.assign(count_, 0);
    posed_.assign(count_, false);
    used_.assign(count_, false);
    for (std::size_t k = count_; k-- > frame;) {
      if (!inside_[k]) continue;
      const bool itself = k == frame;
      const int parent = tree_.nodes[k].parent;
      const Look before = itself ? Look::same : looks_[index(parent)];
      if (itself) {
        cost_[k] += units_[k].number * inward_[k];
        break;
      }
      const Cost turned =
          before == Look::same ? std::max<Cost>(0, motions_[k].carried + kOwnCarried) : turning_.own;
      cost_[k] += units_[k].number * (inward_[k] - met(k, before) + turned);
      if (before == Look::generic) cost_[k] += motions_[k].posed + (used_[k] ? units_[k].twists : 0);
      const std::size_t p = index(parent);
      const bool at_frame = p == frame;
      const Look further =
          at_frame || tree_.nodes[p].parent < 0 ? Look::same : looks_[index(tree_.nodes[p].parent)];
      const Cost beyond_parent =
          at_frame ? inward_[p] : inward_[p] - met(p, further) + units_[p].direct + turning_.carried;
      const Cost carry = carried_[k] + to_parent(k) + numbers_[k] * beyond_parent;
      if (cost_[k] < carry) {
        posed_[k] = true;
        used_[p] = true;
        cost_[p] += cost_[k];
      } else {
        cost_[p] += carry;
      }
    }
    return carried - (cost_[frame] + inner_twists);
  }

  const MotionTree& tree_;
  TurningCosts turning_;
  std::size_t count_;
  std::vector<MotionCosts> motions_;
  std::vector<UnitCosts> units_;
  std::vector<bool> wanted_;   ///< momenta are wanted in a node's frame or inward of it
  std::vector<Cost> numbers_;  ///< unit motions of a node's subtree
  std::vector<Cost> carried_;  ///< to carry the momenta of a node's subtree to its frame
  // Of one meeting frame:
  std::vector<Look> looks_;
  std::vector<Cost> inward_, cost_;
  std::vector<bool> inside_, posed_, used_;
};

/// A point of the axis about which a node turns: its origin, or that of a frame from which it is reached by
/// sliding along the axis.
std::size_t point_on_axis(const MotionTree& tree, std::size_t node) {
  const MotionNode& turn = tree.nodes[node];
  if (turn.motion.kind != MotionKind::axis_rotation || turn.parent < 0) return node;
  const std::size_t parent = index(turn.parent);
  const MotionNode& slide = tree.nodes[parent];
  if (slide.motion.kind != MotionKind::translation || slide.parent < 0) return node;
  for (std::size_t k = 0; k < 3; ++k) {
    if (k != static_cast<std::size_t>(turn.motion.axis) && !slide.motion.offset[k].is_zero()) return node;
  }
  return index(slide.parent);
}

}  // namespace

MeetingPlan plan_meetings(const MotionTree& tree, const UnitMotions& units, FarPairs far,
                          const Scaling& scaling) {
  switch (far) {
    case FarPairs::carry:
      return MeetingPlan(tree.nodes.size(), -1);
    case FarPairs::meet:
      return Planner(tree, units, scaling, kGeneric).plan();
    case FarPairs::meet_sooner:
      return Planner(tree, units, scaling, kSparse).plan();
  }
  return {};
}

MeetingFrames::MeetingFrames(const MotionTree& tree, const UnitMotions& units, MeetingPlan plan,
                             ExprGraph& graph)
    : tree_(tree), plan_(std::move(plan)), poses_(tree.nodes.size(), identity_pose(graph)) {
  for (std::size_t k = 0; k < plan_.size(); ++k) {
    const int frame = plan_[k];
    if (frame < 0) continue;
    if (index(frame) != k) {
      const MotionNode& node = tree.nodes[k];
      poses_[k] = moved(poses_[index(node.parent)], node.motion);
      add_twists(frame, k, poses_[k], units[k]);
      continue;
    }
    // The meeting frame and what lies inward of it.
    Pose pose = poses_[k];
    for (int at = frame; at >= 0; at = tree.nodes[index(at)].parent) {
      add_twists(frame, index(at), pose, units[index(at)]);
      pose = moved(std::move(pose), tree.nodes[index(at)].motion.inverse());
    }
  }
}

void MeetingFrames::add_twists(int meeting, std::size_t node, const Pose& pose,
                               std::span<const UnitMotion> units) {
  std::vector<Twist>& twists =
      inside_.emplace(std::pair(meeting, static_cast<int>(node)), Inside{pose, {}}).first->second.twists;
  // Any point of the axis will do; one before the slide has more zeros near the meeting frame.
  const std::size_t point = point_on_axis(tree_, node);
  const Vec3& origin = plan_[point] == meeting && plan_[node] == meeting ? poses_[point].origin : pose.origin;
  for (const UnitMotion& unit : units)
    twists.push_back(inward({pose.rotation, origin}, twist_along(tree_.nodes[node].motion, unit.direction)));
}

std::vector<MeetingFrames::Moving> MeetingFrames::velocities(const std::vector<Vec3>& shift_rates,
                                                             ExprGraph& graph) const {
  const Vec3 none = zeros<3, 1>(graph);
  const auto shift_rate = [&](int meeting, std::size_t node) {
    const bool linear = tree_.nodes[node].motion.kind == MotionKind::translation;
    return linear ? pose(meeting, node).rotation * shift_rates[node] : none;
  };
  std::vector<Moving> out;
  std::map<std::size_t, Vec3> of_posed;  // by node: each is posed in one frame
  for (std::size_t i = 0; i < tree_.nodes.size(); ++i) {
    const int meeting = plan_[i];
    if (meeting < 0) continue;
    if (static_cast<std::size_t>(meeting) != i) {
      const std::size_t parent = static_cast<std::size_t>(tree_.nodes[i].parent);
      out.push_back({meeting, i, of_posed.at(parent) + shift_rate(meeting, i)});
      of_posed.emplace(i, out.back().velocity);
      continue;
    }
    of_posed.emplace(i, none);
    Vec3 velocity = none;
    for (int at = meeting; at >= 0; at = tree_.nodes[static_cast<std::size_t>(at)].parent) {
      const std::size_t node = static_cast<std::size_t>(at);
      out.push_back({meeting, node, velocity});
      velocity = velocity - shift_rate(meeting, node);
    }
  }
  return out;
}

Wrench MeetingFrames::at_meeting(std::size_t node, const Wrench& momentum) const {
  return plan_[node] == static_cast<int>(node) ? momentum : inward(poses_[node], momentum);
}

Expr MeetingFrames::along(std::size_t posed, std::size_t node, std::size_t unit,
                          const Wrench& momentum) const {
  return dot(inside_.at({plan_[posed], static_cast<int>(node)}).twists[unit], momentum);
}

}  // namespace alembert
