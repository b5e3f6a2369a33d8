// Builds the tree of elementary motions and places the bodies on it (see the header).
#include "dynamics/tree/motion_tree.hpp"

#include <algorithm>

#include "dynamics/tree/motion.hpp"
#include "symbolic/simplify.hpp"

namespace alembert {

namespace {

/// Angular directions of a rotation matrix: skew(om_k) = E^T D_k E.
std::vector<SpeedPartial> rotation_partials(const Mat3& e, const SpeedDerivatives& derivatives) {
  std::vector<SpeedPartial> partials = derivatives.partials(e.entries);
  for (SpeedPartial& partial : partials) {
    const auto column_dot = [&](std::size_t i, std::size_t j) {  // column i of E with column j of D_k E
      Expr sum = e(0, i) * partial.values[j];
      sum += e(1, i) * partial.values[3 + j];
      sum += e(2, i) * partial.values[6 + j];
      return sum;
    };
    const std::array<Expr, 3> direction{column_dot(2, 1), column_dot(0, 2), column_dot(1, 0)};
    partial.values = simplify(direction);
  }
  return partials;
}

MotionNode make_node(int parent, const Motion& motion, std::span<const SpeedPartial> partials,
                     const SpeedDerivatives& derivatives) {
  MotionNode node;
  node.parent = parent;
  node.motion = motion;
  for (const SpeedPartial& partial : partials) node.partials.push_back({partial.speed, vec3(partial.values)});
  node.velocity = vec3(derivatives.first_rate(partials, 3));
  node.acceleration = vec3(derivatives.second_rate(partials, 3));
  return node;
}

/// Where children of a body attach: a node and the constant motions they begin with.
struct Attachment {
  int node = -1;
  std::vector<Motion> prefix;
};

}  // namespace

std::vector<SpeedPartial> twist_partials(const Motion& motion, const Mechanism& mechanism,
                                         const SpeedDerivatives& derivatives, ExprGraph& g) {
  switch (motion.kind) {
    case MotionKind::translation:
      return derivatives.partials(motion.offset.entries);
    case MotionKind::axis_rotation: {
      const std::array<Expr, 1> angle{motion.angle};
      std::vector<SpeedPartial> partials = derivatives.partials(angle);
      for (SpeedPartial& partial : partials) {
        std::vector<Expr> direction(3, g.zero());
        direction[static_cast<std::size_t>(motion.axis)] = partial.values[0];
        partial.values = std::move(direction);
      }
      return partials;
    }
    case MotionKind::rotation: {
      if (motion.fixed_axis) {
        const std::array<Expr, 1> angle{motion.angle};
        std::vector<SpeedPartial> partials = derivatives.partials(angle);
        for (SpeedPartial& partial : partials) {
          const Vec3 direction = partial.values[0] * *motion.fixed_axis;
          partial.values.assign(direction.entries.begin(), direction.entries.end());
        }
        return partials;
      }
      if (motion.quaternion >= 0) {
        std::vector<SpeedPartial> partials;
        const int first = mechanism.coordinates[static_cast<std::size_t>(motion.quaternion)].first_speed;
        for (int k = 0; k < 3; ++k) {
          std::vector<Expr> direction(3, g.zero());
          direction[static_cast<std::size_t>(k)] = g.one();
          partials.push_back({first + k, std::move(direction)});
        }
        return partials;
      }
      return rotation_partials(motion.matrix, derivatives);
    }
  }
  return {};
}

MotionTree motion_tree(const Mechanism& mechanism, const SpeedDerivatives& derivatives, ExprGraph& graph) {
  std::vector<std::vector<Motion>> motions;
  for (const Body& body : mechanism.bodies)
    motions.push_back(elementary_motions(body.transform, mechanism, graph));
  return motion_tree(mechanism, motions, derivatives, graph);
}

MotionTree motion_tree(const Mechanism& mechanism, std::span<const std::vector<Motion>> motions_of_body,
                       const SpeedDerivatives& derivatives, ExprGraph& graph) {
  MotionTree tree;
  std::vector<int> children(mechanism.bodies.size(), 0);
  for (const Body& body : mechanism.bodies) {
    if (body.parent >= 0) ++children[static_cast<std::size_t>(body.parent)];
  }
  std::vector<Attachment> attachments(mechanism.bodies.size());

  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const Body& body = mechanism.bodies[b];
    Attachment from;
    if (body.parent >= 0) from = attachments[static_cast<std::size_t>(body.parent)];
    std::vector<Motion> motions = from.prefix;
    for (const Motion& motion : motions_of_body[b]) append_motion(motions, motion, graph);

    std::vector<std::vector<SpeedPartial>> partials;
    std::size_t moving = 0;  // motions up to the last one that moves
    for (std::size_t i = 0; i < motions.size(); ++i) {
      partials.push_back(twist_partials(motions[i], mechanism, derivatives, graph));
      if (!partials.back().empty()) moving = i + 1;
    }
    int node = from.node;
    const auto descend = [&](const Motion& motion, std::span<const SpeedPartial> motion_partials) {
      tree.nodes.push_back(make_node(node, motion, motion_partials, derivatives));
      node = static_cast<int>(tree.nodes.size()) - 1;
    };
    for (std::size_t i = 0; i < moving; ++i) descend(motions[i], partials[i]);

    BodyPlace place;
    place.node = node;
    place.tail.assign(motions.begin() + static_cast<std::ptrdiff_t>(moving), motions.end());
    if (node >= 0) tree.nodes[static_cast<std::size_t>(node)].bodies.push_back(static_cast<int>(b));

    // One child takes the constant tail along and merges it; several children share it as frames of their
    // own.
    if (children[b] >= 2) {
      for (const Motion& motion : place.tail) descend(motion, {});
      attachments[b] = {node, {}};
    } else {
      attachments[b] = {node, place.tail};
    }
    tree.places.push_back(std::move(place));
  }
  for (const MotionNode& node : tree.nodes) {
    NodeMass sum{graph.zero(), zeros<3, 1>(graph), zeros<3, 3>(graph)};
    for (const int body : node.bodies) {
      const NodeMass mass = mass_at_node(mechanism.bodies[static_cast<std::size_t>(body)],
                                         tree.places[static_cast<std::size_t>(body)], graph);
      sum.mass += mass.mass;
      sum.moment = sum.moment + mass.moment;
      sum.inertia = sum.inertia + mass.inertia;
    }
    tree.masses.push_back(std::move(sum));
  }
  return tree;
}

bool NodeMass::is_zero() const {
  const auto zero = [](const Expr& e) { return e.is_zero(); };
  return mass.is_zero() && std::all_of(moment.entries.begin(), moment.entries.end(), zero) &&
         std::all_of(inertia.entries.begin(), inertia.entries.end(), zero);
}

Vec3 center_at_node(const Body& body, const BodyPlace& place) {
  Vec3 center = body.mass_properties.com;
  for (auto motion = place.tail.rbegin(); motion != place.tail.rend(); ++motion) {
    center = motion->kind == MotionKind::translation ? motion->offset + center : motion->to_parent(center);
  }
  return center;
}

NodeMass mass_at_node(const Body& body, const BodyPlace& place, ExprGraph& graph) {
  const MassProperties& properties = body.mass_properties;
  Pose pose = identity_pose(graph);
  for (const Motion& motion : place.tail) pose = moved(std::move(pose), motion);
  const Vec3 c = center_at_node(body, place);
  const Expr m = properties.mass;
  Mat3 inertia = pose.rotation * properties.inertia * transpose(pose.rotation);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Expr &y = c[(i + 1) % 3], &z = c[(i + 2) % 3];
      const Expr part = i == j ? y * y + z * z : -(c[i] * c[j]);
      inertia(i, j) += m * part;
    }
  }
  std::vector<Expr> flat{inertia(0, 0), inertia(1, 1), inertia(2, 2), inertia(0, 1), inertia(0, 2),
                         inertia(1, 2), m * c[0],      m * c[1],      m * c[2]};
  if (!place.tail.empty()) flat = simplify(flat);
  const auto symmetric = [&](std::size_t i, std::size_t j) { return i == j ? flat[i] : flat[2 + i + j]; };
  NodeMass mass{m, {{flat[6], flat[7], flat[8]}}, zeros<3, 3>(graph)};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) mass.inertia(i, j) = symmetric(i, j);
  }
  return mass;
}

}  // namespace alembert
