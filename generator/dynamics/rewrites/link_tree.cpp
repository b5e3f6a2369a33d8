// Rigid links back to a tree of motions (rigid_links.hpp): constants as numbers, exact where they are
// multiples of a right angle.
#include <Eigen/Dense>

#include "dynamics/rewrites/rigid_links.hpp"

namespace alembert {

namespace {

/// Exact at multiples of a right angle.
Expr angle_number(ExprGraph& graph, const Extended& x) {
  const Extended quarter_turns = x / kRightAngle;
  const Extended nearest = round(quarter_turns);
  if (abs(quarter_turns - nearest) > kAngleRounding) return rounded_number(graph, x);
  const std::int64_t k = nearest.convert_to<std::int64_t>();
  if (k == 0) return graph.zero();
  return k % 2 == 0 ? graph.pi(Rational(k / 2)) : graph.pi(Rational(k, 2));
}

/// Builds the nodes one after another.
class TreeBuilder {
 public:
  TreeBuilder(ExprGraph& graph, const Extended& length) : graph_(graph), length_(length) {}

  /// A constant rotation about a coordinate axis; the parent itself where there is none.
  int turn(int parent, int axis, const Extended& angle) {
    const Expr a = angle_number(graph_, angle);
    if (a.is_zero()) return parent;
    return add(parent, axis_rotation_motion(axis, a));
  }
  int shift(int parent, const Vector3e& t) {
    const Motion motion = shift(t);
    if (motion.offset == zeros<3, 1>(graph_)) return parent;
    return add(parent, motion);
  }
  Motion shift(const Vector3e& t) const {
    const auto entry = [&](int i) {
      return abs(t[i]) <= kExtendedRounding * length_ ? graph_.zero() : rounded_number(graph_, t[i]);
    };
    return translation_motion({{entry(0), entry(1), entry(2)}});
  }
  /// A constant pose: its shift, then its rotation by Euler angles z x z.
  int pose(int parent, const Matrix4e& pose) {
    int node = shift(parent, pose.topRightCorner<3, 1>());
    const Extended across = hypot(pose(0, 2), pose(1, 2));
    const bool tilted = across > kAngleRounding;
    const Extended tilt = tilted ? atan2(across, pose(2, 2)) : Extended(pose(2, 2) > 0 ? 0 : 2 * kRightAngle);
    const Extended first = tilted ? atan2(pose(0, 2), Extended(-pose(1, 2))) : Extended(0);
    // What the first two leave. Entries are rounded, so that a small tilt has few digits of its direction;
    // the sum of the turns before and after it has all.
    const Extended c = cos(first), s = sin(first);
    const Extended last =
        atan2(Extended(cos(tilt) * (c * pose(1, 0) - s * pose(0, 0)) + sin(tilt) * pose(2, 0)),
              Extended(c * pose(0, 0) + s * pose(1, 0)));
    node = turn(node, 2, first);
    node = turn(node, 0, tilt);
    return turn(node, 2, last);
  }
  int add(int parent, const Motion& motion) {
    MotionNode node;
    node.parent = parent;
    node.motion = motion;
    node.velocity = zeros<3, 1>(graph_);
    node.acceleration = zeros<3, 1>(graph_);
    return add(node);
  }
  int add(const MotionNode& node) {
    tree.nodes.push_back(node);
    tree.nodes.back().bodies.clear();
    tree.masses.push_back({graph_.zero(), zeros<3, 1>(graph_), zeros<3, 3>(graph_)});
    return static_cast<int>(tree.nodes.size()) - 1;
  }

  MotionTree tree;

 private:
  ExprGraph& graph_;
  Extended length_;  // shifts are rounding if they are nothing beside it
};

}  // namespace

RigidLinks::Skeleton RigidLinks::skeleton(ExprGraph& graph) const {
  TreeBuilder builder(graph, length_);
  std::vector<std::array<int, 4>> frames;  // node of each MassFrame of a link
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const RigidLink& link = links_[i];
    int node = -1;
    if (link.parent >= 0) {
      const std::size_t p = static_cast<std::size_t>(link.parent);
      if (links_[p].main_child == static_cast<int>(i)) {
        node = frames[p][3];
      } else {
        // Beside the main child: from its twisted frame, whose U is made anyway.
        const MassFrame from = has_frame(p, MassFrame::twist) ? MassFrame::twist : MassFrame::joint;
        node = builder.pose(frames[p][static_cast<std::size_t>(from)], frame(p, from).back * link.before);
      }
    } else {
      node = builder.pose(-1, link.before);
    }
    MotionNode moving = tree_->nodes[static_cast<std::size_t>(link.node)];
    moving.parent = node;
    if (link.turns) {
      const std::size_t axis = static_cast<std::size_t>(moving.motion.axis);
      const auto about_z = [&](Vec3& v) { v = {{graph.zero(), graph.zero(), v[axis]}}; };
      for (TwistPartial& partial : moving.partials) about_z(partial.direction);
      about_z(moving.velocity);
      about_z(moving.acceleration);
      moving.motion.axis = 2;
      moving.motion.angle = moving.motion.angle + angle_number(graph, link.angle_offset);
      moving.motion.cosine = cos(moving.motion.angle);
      moving.motion.sine = sin(moving.motion.angle);
    }
    std::array<int, 4> at{};
    at.fill(builder.add(moving));
    if (link.main_child >= 0) {
      const RigidLink& child = links_[static_cast<std::size_t>(link.main_child)];
      at[1] = builder.turn(at[0], 0, child.twist);
      at[2] = builder.shift(at[1], {child.length, 0, 0});
      at[3] = builder.shift(at[2], {0, 0, child.offset});
    }
    frames.push_back(at);
  }
  return {std::move(builder.tree), std::move(frames)};
}

std::vector<BodyPlace> RigidLinks::places(const Skeleton& skeleton, ExprGraph& graph) const {
  const TreeBuilder builder(graph, length_);
  std::vector<BodyPlace> out;
  for (const BodyPlace& place : tree_->places) {
    BodyPlace moved = place;
    if (place.node >= 0) {
      const std::size_t old = static_cast<std::size_t>(place.node);
      const int l = link_of_node_[old];
      if (l < 0) {
        moved.node = -1;
      } else {
        const std::size_t i = static_cast<std::size_t>(l);
        const Matrix4e pose = rigid_inverse(links_[i].adjusted) * pose_of_node_[old];
        const Motion shift = builder.shift(pose.topRightCorner<3, 1>());
        Motion turn;
        turn.kind = MotionKind::rotation;
        for (int r = 0; r < 3; ++r) {
          for (int c = 0; c < 3; ++c)
            turn.matrix(static_cast<std::size_t>(r), static_cast<std::size_t>(c)) =
                abs(pose(r, c)) <= kAngleRounding ? graph.zero() : rounded_number(graph, pose(r, c));
        }
        moved.node = skeleton.frames[i][0];
        moved.tail.insert(moved.tail.begin(), {shift, turn});
      }
    }
    out.push_back(std::move(moved));
  }
  return out;
}

WrittenTree RigidLinks::link_tree(const std::vector<Regrouping>& regroupings, ExprGraph& graph) const {
  const std::vector<Split>& splits = flow(regroupings).splits;
  const bool first = !skeleton_;
  if (first) skeleton_ = skeleton(graph);
  MotionTree tree = skeleton_->tree;
  std::vector<MomentForms> moments(tree.nodes.size());
  for (std::size_t i = 0; i < links_.size(); ++i) {
    // Frames that coincide share a node: what is fixed to them adds up.
    const auto put = [&](MassFrame frame, const LinkInertia& inertia) {
      const std::size_t node =
          static_cast<std::size_t>(skeleton_->frames[i][static_cast<std::size_t>(frame)]);
      NodeMass& mass = tree.masses[node];
      const NodeMass more = terms_.node_mass(inertia, graph);
      mass.mass += more.mass;
      mass.moment = mass.moment + more.moment;
      mass.inertia = mass.inertia + more.inertia;
      moments[node] = regroupings[i].forms;
    };
    for (std::size_t k = 0; k < kMassFrames.size(); ++k) {
      if (splits[i].points[k] == 0) continue;
      LinkInertia point;
      point.number(3, 3) = splits[i].points[k];
      put(kMassFrames[k], point);
    }
    put(regroupings[i].frame, splits[i].remaining);
  }
  if (first) skeleton_->tree.places = places(*skeleton_, graph);
  tree.places = skeleton_->tree.places;
  WrittenTree written(std::move(tree));
  written.moments = std::move(moments);
  return written;
}

}  // namespace alembert
