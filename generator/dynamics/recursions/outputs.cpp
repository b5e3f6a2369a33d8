// Output functions besides the dynamics: energies, poses of bodies and frames, Jacobians of both, inertias of bodies.
#include "dynamics/recursions/outputs.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "dynamics/recursions/frame_values.hpp"
#include "dynamics/tree/spatial_vectors.hpp"
#include "symbolic/count_operations.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {

namespace {

std::vector<Pose> node_poses(const MotionTree& tree, ExprGraph& graph) {
  std::vector<Pose> poses;
  for (const MotionNode& node : tree.nodes) {
    const Pose from = node.parent < 0 ? identity_pose(graph) : poses[static_cast<std::size_t>(node.parent)];
    poses.push_back(moved(from, node.motion));
  }
  return poses;
}

Pose body_pose(std::span<const Pose> nodes, const BodyPlace& place, ExprGraph& graph) {
  Pose pose = place.node < 0 ? identity_pose(graph) : nodes[static_cast<std::size_t>(place.node)];
  for (const Motion& motion : place.tail) pose = moved(std::move(pose), motion);
  return pose;
}

void append_rows(std::vector<Expr>& out, const Pose& pose) {
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) out.push_back(pose.rotation(r, c));
    out.push_back(pose.origin[r]);
  }
}

}  // namespace

std::vector<Expr> energies(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph) {
  const Expr half = graph.rational(Rational(1, 2));
  const std::vector<Pose> poses = node_poses(tree, graph);
  std::vector<Twist> twists;
  Expr kinetic = graph.zero(), potential = graph.zero();
  for (const MotionNode& node : tree.nodes) {
    const Twist from = node.parent < 0 ? zero_twist(graph) : twists[static_cast<std::size_t>(node.parent)];
    twists.push_back(outward(node.motion, from) + twist_along(node.motion, node.velocity));
  }
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const Body& body = mechanism.bodies[b];
    const BodyPlace& place = tree.places[b];
    Vec3 center = center_at_node(body, place);
    if (place.node >= 0) {
      const std::size_t i = static_cast<std::size_t>(place.node);
      const auto& [om, v] = twists[i];
      const NodeMass mass = mass_at_node(body, place, graph);
      // T = 1/2 m v.v + v.(om x h) + 1/2 om.J om
      const Expr translation = half * (mass.mass * dot(v, v));
      const Expr coupling = dot(v, cross(om, mass.moment));
      const Expr rotation = half * dot(om, mass.inertia * om);
      kinetic += translation + coupling;
      kinetic += rotation;
      center = poses[i].origin + poses[i].rotation * center;
    }
    potential -= body.mass_properties.mass * dot(mechanism.gravity, center);
  }
  for (const Coordinate& coordinate : mechanism.coordinates) {
    if (coordinate.armature.is_zero()) continue;
    for (const Expr u : coordinate.speed_symbols) {
      const Expr square = u * u;
      kinetic += half * (coordinate.armature * square);
    }
  }
  return {kinetic, potential};
}

std::vector<Expr> body_poses(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph) {
  const std::vector<Pose> nodes = node_poses(tree, graph);
  std::vector<Expr> out;
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b)
    append_rows(out, body_pose(nodes, tree.places[b], graph));
  return out;
}

std::vector<Expr> frame_poses(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph) {
  const std::vector<Pose> nodes = node_poses(tree, graph);
  std::vector<Expr> out;
  for (const Frame& frame : mechanism.frames) {
    Pose pose = frame.body < 0 ? identity_pose(graph)
                               : body_pose(nodes, tree.places[static_cast<std::size_t>(frame.body)], graph);
    for (const Motion& motion : elementary_motions(frame.transform, mechanism, graph))
      pose = moved(std::move(pose), motion);
    append_rows(out, pose);
  }
  return out;
}

std::vector<Expr> frame_jacobians(const Mechanism& mechanism, const SpeedDerivatives& derivatives,
                                  std::span<const Expr> poses, ExprGraph& graph) {
  const std::size_t nv = static_cast<std::size_t>(mechanism.nv);
  std::vector<Expr> out(mechanism.frames.size() * 6 * nv, graph.zero());
  for (std::size_t f = 0; f < mechanism.frames.size(); ++f) {
    const std::span<const Expr> pose = poses.subspan(12 * f, 12);
    for (const FrameTwist& along : frame_twists(derivatives, pose)) {
      if (along.speed == derivatives.time_index()) continue;
      const std::size_t k = static_cast<std::size_t>(along.speed);
      for (std::size_t r = 0; r < 6; ++r) out[(6 * f + r) * nv + k] = along.twist[r];
    }
  }
  return out;
}

namespace {

/// A twist along one speed about the point `at`, in world axes.
struct PlacedTwist {
  Twist twist;
  Vec3 at;
  Twist about(const Vec3& point) const { return about_point(twist, point - at); }
};

/// A node: where its origin is, and its twists along each speed that moves it.
struct MovingFrame {
  Vec3 origin;  ///< from the last frame above it that nothing turns: near, however far that is from the world
  std::map<int, PlacedTwist> twists;
};

/// `handed_on`: twists are taken along to every node; otherwise they stay at the joint they began at.
std::vector<MovingFrame> moving_frames(const Mechanism& mechanism, const MotionTree& tree,
                                       std::span<const Pose> poses, bool handed_on, ExprGraph& graph) {
  const Vec3 none = zeros<3, 1>(graph);
  std::vector<MovingFrame> all;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const MotionNode& node = tree.nodes[i];
    const bool root = node.parent < 0;
    const Pose from = root ? identity_pose(graph) : poses[static_cast<std::size_t>(node.parent)];
    MovingFrame frame = root ? MovingFrame{none, {}} : all[static_cast<std::size_t>(node.parent)];
    const bool shifts = node.motion.kind == MotionKind::translation;
    const bool turned = std::ranges::any_of(
        frame.twists, [&](const auto& entry) { return !(entry.second.twist.angular == none); });
    if (shifts && turned) frame.origin = frame.origin + from.rotation * node.motion.offset;
    if (shifts && handed_on)
      for (auto& [speed, placed] : frame.twists) placed = {placed.about(frame.origin), frame.origin};
    for (const TwistPartial& partial : node.partials) {
      if (partial.speed == mechanism.nv) continue;  // time
      PlacedTwist& placed =
          frame.twists.try_emplace(partial.speed, PlacedTwist{{none, none}, frame.origin}).first->second;
      const Vec3 direction = poses[i].rotation * partial.direction;
      placed = {placed.about(frame.origin) + twist_along(node.motion, direction), frame.origin};
    }
    all.push_back(std::move(frame));
  }
  return all;
}

// A twist that so many bodies have is moved to the common origin. Velocities elsewhere are dot products then,
// of a row of the twist and one of the body, which can be loops.
constexpr int kManyBodies = 12;

// Longer trees are not tried with twists handed from frame to frame, which takes twice as much a pair of
// speed and body, and less only where frames coincide or turn little.
constexpr std::size_t kHandedOn = 64;

std::vector<Expr> jacobians_by(const Mechanism& mechanism, const MotionTree& tree,
                               std::span<const Pose> poses, std::span<const MovingFrame> frames,
                               ExprGraph& graph) {
  const Vec3 none = zeros<3, 1>(graph);
  const std::size_t nv = static_cast<std::size_t>(mechanism.nv);
  std::vector<int> bodies_of_speed(nv, 0);
  for (const BodyPlace& place : tree.places) {
    if (place.node < 0) continue;
    for (const auto& entry : frames[static_cast<std::size_t>(place.node)].twists)
      ++bodies_of_speed[static_cast<std::size_t>(entry.first)];
  }
  std::vector<Expr> out(mechanism.bodies.size() * 6 * nv, graph.zero());
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const BodyPlace& place = tree.places[b];
    if (place.node < 0) continue;
    const MovingFrame& frame = frames[static_cast<std::size_t>(place.node)];
    const Vec3 arm =
        poses[static_cast<std::size_t>(place.node)].rotation * center_at_node(mechanism.bodies[b], place);
    const Vec3 center = frame.origin + arm;
    // Twists about parallel axes differ in a velocity that all bodies have alike.
    std::vector<std::pair<const PlacedTwist*, Vec3>> done;
    for (auto entry = frame.twists.rbegin(); entry != frame.twists.rend(); ++entry) {
      const std::size_t k = static_cast<std::size_t>(entry->first);
      const PlacedTwist& placed = entry->second;
      const Twist& twist = placed.twist;
      const auto parallel = std::ranges::find_if(
          done, [&](const auto& other) { return other.first->twist.angular == twist.angular; });
      Vec3 linear;
      if (twist.angular == none) {
        linear = twist.linear;
      } else if (parallel != done.end()) {
        const auto& [there, its] = *parallel;
        linear = its + (placed.about(there->at).linear - there->twist.linear);
      } else if (placed.at == frame.origin) {
        linear = about_point(twist, arm).linear;
      } else if (bodies_of_speed[k] < kManyBodies) {
        linear = placed.about(center).linear;
      } else {
        linear = about_point(placed.about(none), center).linear;
      }
      if (parallel == done.end()) done.emplace_back(&placed, linear);
      for (std::size_t r = 0; r < 3; ++r) {
        out[(6 * b + r) * nv + k] = twist.angular[r];
        out[(6 * b + 3 + r) * nv + k] = linear[r];
      }
    }
  }
  return out;
}

}  // namespace

std::vector<Expr> body_jacobians(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph) {
  const std::vector<Pose> poses = node_poses(tree, graph);
  const auto jacobians = [&](bool handed_on) {
    return value_number(
        jacobians_by(mechanism, tree, poses, moving_frames(mechanism, tree, poses, handed_on, graph), graph));
  };
  std::vector<Expr> at_joints = jacobians(false);
  if (tree.nodes.size() > kHandedOn) return at_joints;
  std::vector<Expr> at_frames = jacobians(true);
  return count_operations(at_frames).weight < count_operations(at_joints).weight ? at_frames : at_joints;
}

std::vector<Expr> body_inertias(const Mechanism& mechanism) {
  std::vector<Expr> out;
  for (const Body& body : mechanism.bodies) {
    const auto& [mass, com, inertia] = body.mass_properties;
    out.push_back(mass);
    out.insert(out.end(), com.entries.begin(), com.entries.end());
    for (const auto& [r, c] : {std::pair(0, 0), {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}})
      out.push_back(inertia(static_cast<std::size_t>(r), static_cast<std::size_t>(c)));
  }
  return out;
}

}  // namespace alembert
