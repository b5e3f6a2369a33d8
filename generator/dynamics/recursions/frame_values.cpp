#include "dynamics/recursions/frame_values.hpp"

#include "dynamics/recursions/outputs.hpp"
#include "symbolic/substitute.hpp"

namespace alembert {
namespace {

/// The nearest node that is above both or one of them; -1 for the world.
int common_node(int a, int b, const MotionTree& tree) {
  while (a != b) {  // parents come first
    int& lower = a > b ? a : b;
    lower = tree.nodes[static_cast<std::size_t>(lower)].parent;
  }
  return a;
}

/// The frame's origin in the axes of a node above it.
Vec3 origin_seen_from(int above, const FramePlace& place, const MotionTree& tree, ExprGraph& graph) {
  std::vector<int> path;
  for (int node = place.node; node != above; node = tree.nodes[static_cast<std::size_t>(node)].parent)
    path.push_back(node);
  Pose pose = identity_pose(graph);
  for (std::size_t i = path.size(); i-- > 0;)
    pose = moved(std::move(pose), tree.nodes[static_cast<std::size_t>(path[i])].motion);
  for (const Motion& motion : place.motions) pose = moved(std::move(pose), motion);
  return pose.origin;
}

/// From the nearest part that both frames move with: what moves them alike does not change the distance.
Expr distance_between(const FrameDistance& distance, const Mechanism& mechanism, const MotionTree& tree,
                      ExprGraph& graph) {
  const FramePlace from = frame_place(distance.from, mechanism, tree, graph);
  const FramePlace to = frame_place(distance.to, mechanism, tree, graph);
  const int above = common_node(from.node, to.node, tree);
  const Vec3 apart = origin_seen_from(above, to, tree, graph) - origin_seen_from(above, from, tree, graph);
  return sqrt(dot(apart, apart));
}

}  // namespace

FramePlace frame_place(int frame, const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph) {
  const Frame& given = mechanism.frames[static_cast<std::size_t>(frame)];
  FramePlace place;
  if (given.body >= 0) {
    const BodyPlace& body = tree.places[static_cast<std::size_t>(given.body)];
    place = {body.node, body.tail};
  }
  for (const Motion& motion : elementary_motions(given.transform, mechanism, graph))
    place.motions.push_back(motion);
  return place;
}

std::vector<FrameTwist> frame_twists(const SpeedDerivatives& derivatives, std::span<const Expr> pose) {
  std::vector<FrameTwist> twists;
  for (const SpeedPartial& partial : derivatives.partials(pose)) {
    // skew(om) = (D_k R) R^T, so om_x is row 2 of D_k R with row 1 of R, and so on.
    const auto row_dot = [&](std::size_t changed, std::size_t kept) {
      Expr sum = partial.values[4 * changed] * pose[4 * kept];
      sum += partial.values[4 * changed + 1] * pose[4 * kept + 1];
      sum += partial.values[4 * changed + 2] * pose[4 * kept + 2];
      return sum;
    };
    const Expr x = row_dot(2, 1), y = row_dot(0, 2), z = row_dot(1, 0);
    twists.push_back(
        {partial.speed, {{{x, y, z}}, {{partial.values[3], partial.values[7], partial.values[11]}}}});
  }
  return twists;
}

std::vector<std::pair<Expr, Expr>> frame_values(const Mechanism& mechanism, const MotionTree& tree,
                                                const SpeedDerivatives& derivatives, ExprGraph& graph) {
  std::vector<std::pair<Expr, Expr>> values;
  for (const FrameDistance& distance : mechanism.distances)
    values.emplace_back(distance.symbol, distance_between(distance, mechanism, tree, graph));
  if (mechanism.frame_symbols.empty()) return values;
  const std::vector<Expr> poses = frame_poses(mechanism, tree, graph);
  for (const FrameSymbols& of_frame : mechanism.frame_symbols) {
    const std::span<const Expr> pose =
        std::span(poses).subspan(12 * static_cast<std::size_t>(of_frame.frame), 12);
    const auto moving = [&](Vec3 Twist::*part) {
      Twist sum = zero_twist(graph);
      for (const FrameTwist& along : frame_twists(derivatives, pose))
        sum = sum + derivatives.speed(along.speed) * along.twist;
      const Vec3& vector = sum.*part;
      return std::vector<Expr>(vector.entries.begin(), vector.entries.end());
    };
    std::vector<Expr> found;
    switch (of_frame.quantity) {
      case FrameQuantity::position:
        found = {pose[3], pose[7], pose[11]};
        break;
      case FrameQuantity::velocity:
        found = moving(&Twist::linear);
        break;
      case FrameQuantity::rotation:
        for (std::size_t r = 0; r < 3; ++r)
          for (std::size_t c = 0; c < 3; ++c) found.push_back(pose[4 * r + c]);
        break;
      case FrameQuantity::angular_velocity:
        found = moving(&Twist::angular);
        break;
    }
    for (std::size_t i = 0; i < found.size(); ++i) values.emplace_back(of_frame.symbols[i], found[i]);
  }
  return values;
}

std::vector<std::pair<Expr, Expr>> moving_values(const Mechanism& mechanism, const MotionTree& tree,
                                                 const SpeedDerivatives& derivatives, ExprGraph& graph) {
  std::vector<std::pair<Expr, Expr>> values = frame_values(mechanism, tree, derivatives, graph);
  for (const Force& force : mechanism.forces) {
    if (!force.rate.valid()) continue;
    const std::vector<Expr> length = substitute(std::span(&force.length, 1), values);
    values.emplace_back(force.rate, derivatives.first_rate(derivatives.partials(length), 1).front());
  }
  return values;
}

std::vector<Expr> with_moving_values(std::span<const Expr> given, const Mechanism& mechanism,
                                     const MotionTree& tree, const SpeedDerivatives& derivatives,
                                     ExprGraph& graph) {
  const std::vector<std::pair<Expr, Expr>> moving = moving_values(mechanism, tree, derivatives, graph);
  return substitute(substitute(given, moving), input_laws(mechanism, moving, graph));
}

std::vector<std::pair<Expr, Expr>> input_laws(const Mechanism& mechanism,
                                              std::span<const std::pair<Expr, Expr>> moving,
                                              ExprGraph& graph) {
  std::vector<std::pair<Expr, Expr>> laws;
  for (const Parameter& parameter : mechanism.parameters) {
    if (parameter.law)
      laws.emplace_back(graph.symbol(parameter.name), substitute({&*parameter.law, 1}, moving).front());
  }
  return laws;
}

}  // namespace alembert
