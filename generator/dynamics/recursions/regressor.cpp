// Regressors, from twists and accelerations of the bodies in their own axes (see the header).
//
// Letters as in body_forces.hpp. The power of the forces of a body along a twist (w, v) is
//
//   m acc.v + h.(U^T v + acc x w) + w.(J al + om x J om)
#include "dynamics/recursions/regressor.hpp"

#include <algorithm>
#include <map>

#include "dynamics/recursions/body_forces.hpp"
#include "dynamics/recursions/reduced.hpp"
#include "dynamics/tree/spatial_vectors.hpp"

namespace alembert {
namespace {

/// A body's frame: how it moves, and its twist at each speed 1 that moves it.
struct BodyFrame {
  FrameMotion motion;
  std::map<std::size_t, Twist> twists;
};

class BodyFrames {
 public:
  BodyFrames(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph)
      : mechanism_(mechanism), graph_(graph) {
    const Vec3 none = zeros<3, 1>(graph);
    const BodyFrame world{motion_of_world(mechanism, graph), {}};
    std::vector<BodyFrame> nodes;
    for (const MotionNode& node : tree.nodes)
      nodes.push_back(next(node.parent < 0 ? world : nodes[static_cast<std::size_t>(node.parent)], node));
    for (const BodyPlace& place : tree.places) {
      BodyFrame& frame =
          frames_.emplace_back(place.node < 0 ? world : nodes[static_cast<std::size_t>(place.node)]);
      for (const Motion& motion : place.tail) {
        MotionNode fixed;
        fixed.motion = motion;
        fixed.velocity = fixed.acceleration = none;
        frame = next(frame, fixed);
      }
    }
  }
  const BodyFrame& operator[](std::size_t body) const { return frames_[body]; }

 private:
  BodyFrame next(const BodyFrame& from, const MotionNode& to) const {
    BodyFrame out{outward(from.motion, to, graph_), {}};
    for (const auto& [speed, twist] : from.twists) out.twists.emplace(speed, outward(to.motion, twist));
    for (const TwistPartial& partial : to.partials) {
      if (partial.speed == mechanism_.nv) continue;
      const Twist own = twist_along(to.motion, partial.direction);
      const auto [at, is_new] = out.twists.try_emplace(static_cast<std::size_t>(partial.speed), own);
      if (!is_new) at->second = at->second + own;
    }
    return out;
  }

  const Mechanism& mechanism_;
  ExprGraph& graph_;
  std::vector<BodyFrame> frames_;
};

/// The power of a body's ten forces along a twist.
std::array<Expr, kStandardParameters> powers(const FrameMotion& of, const Twist& along) {
  const Vec3 &w = along.angular, &v = along.linear, &al = of.al;
  const Vec3 shifted = transpose(of.U) * v, h = shifted + cross(of.acc, w);
  // Of the inertia xx: J al + om x J om = (al_x, om_x om_z, -om_x om_y), and so on.
  const auto three = [&](Expr x, Expr y, Expr z) { return dot(w, {{x, y, z}}); };
  return {dot(of.acc, v),
          h[0],
          h[1],
          h[2],
          three(al[0], of.xz, -of.xy),
          three(-of.yz, al[1], of.xy),
          three(of.yz, -of.xz, al[2]),
          three(-of.U(2, 0), of.U(2, 1), of.xx - of.yy),
          three(of.U(1, 0), of.zz - of.xx, -of.U(1, 2)),
          three(of.yy - of.zz, -of.U(0, 1), of.U(0, 2))};
}

}  // namespace

std::size_t parameters_of(const Body& body) {
  const MassProperties& properties = body.mass_properties;
  if (properties.is_zero()) return 0;
  const bool centred =
      std::ranges::all_of(properties.com.entries, [](const Expr& entry) { return entry.is_zero(); });
  return properties.is_point() && centred ? 4 : kStandardParameters;
}

std::vector<Expr> force_regressor(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph) {
  const BodyFrames frames(mechanism, tree, graph);
  const std::size_t columns = kStandardParameters * mechanism.bodies.size();
  std::vector<Expr> Y(static_cast<std::size_t>(mechanism.nv) * columns, graph.zero());
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const std::size_t count = parameters_of(mechanism.bodies[b]);
    for (const auto& [speed, twist] : frames[b].twists) {
      const std::array<Expr, kStandardParameters> all = powers(frames[b].motion, twist);
      std::copy_n(all.begin(), count,
                  Y.begin() + static_cast<std::ptrdiff_t>(speed * columns + kStandardParameters * b));
    }
  }
  return Y;
}

std::vector<Expr> gravity_regressor(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph) {
  MotionTree still = tree;
  for (MotionNode& node : still.nodes) node.velocity = node.acceleration = zeros<3, 1>(graph);
  return force_regressor(mechanism, still, graph);
}

std::vector<Expr> energy_regressor(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph) {
  struct Moving {
    Pose pose;
    Twist twist;
  };
  const auto next = [](const Moving& from, const Motion& motion) {
    return Moving{moved(from.pose, motion), outward(motion, from.twist)};
  };
  const Moving world{identity_pose(graph), zero_twist(graph)};
  std::vector<Moving> nodes;
  for (const MotionNode& node : tree.nodes) {
    Moving& at = nodes.emplace_back(
        next(node.parent < 0 ? world : nodes[static_cast<std::size_t>(node.parent)], node.motion));
    at.twist = at.twist + twist_along(node.motion, node.velocity);
  }
  const Expr half = graph.rational(Rational(1, 2));
  const std::size_t columns = kStandardParameters * mechanism.bodies.size();
  std::vector<Expr> Y(2 * columns, graph.zero());
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    Moving at = tree.places[b].node < 0 ? world : nodes[static_cast<std::size_t>(tree.places[b].node)];
    for (const Motion& motion : tree.places[b].tail) at = next(at, motion);
    const auto& [om, v] = at.twist;
    const Vec3 h = cross(v, om);
    const Vec3 down = transpose(at.pose.rotation) * mechanism.gravity;
    const std::array<Expr, kStandardParameters> kinetic{half * dot(v, v),
                                                        h[0],
                                                        h[1],
                                                        h[2],
                                                        half * (om[0] * om[0]),
                                                        half * (om[1] * om[1]),
                                                        half * (om[2] * om[2]),
                                                        om[0] * om[1],
                                                        om[0] * om[2],
                                                        om[1] * om[2]};
    const std::array<Expr, 4> potential{-dot(mechanism.gravity, at.pose.origin), -down[0], -down[1],
                                        -down[2]};
    const std::size_t count = parameters_of(mechanism.bodies[b]);
    const auto first = Y.begin() + static_cast<std::ptrdiff_t>(kStandardParameters * b);
    std::copy_n(kinetic.begin(), count, first);
    std::copy_n(potential.begin(), std::min<std::size_t>(count, 4),
                first + static_cast<std::ptrdiff_t>(columns));
  }
  return Y;
}

}  // namespace alembert
