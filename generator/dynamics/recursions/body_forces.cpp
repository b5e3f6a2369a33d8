// Forces of rigid bodies (see the header).
#include "dynamics/recursions/body_forces.hpp"

#include "dynamics/tree/symbols.hpp"

namespace alembert {

FrameMotion::FrameMotion(const Vec3& angular, const Vec3& angular_rate, const Vec3& linear,
                         const Scale& factors)
    : om(angular), al(angular_rate), acc(linear), scale(factors) {
  xx = om[0] * om[0];
  yy = om[1] * om[1];
  zz = om[2] * om[2];
  xy = om[0] * om[1];
  xz = om[0] * om[2];
  yz = om[1] * om[2];
  U(0, 0) = -(yy + zz);
  U(1, 1) = -(xx + zz);
  U(2, 2) = -(xx + yy);
  U(0, 1) = xy - al[2];
  U(1, 0) = xy + al[2];
  U(0, 2) = xz + al[1];
  U(2, 0) = xz - al[1];
  U(1, 2) = yz - al[0];
  U(2, 1) = yz + al[0];
}

Vec3 FrameMotion::at(const Vec3& t) const {
  Vec3 out = acc;
  for (std::size_t r = 0; r < 3; ++r) {
    Expr sum = U(r, 0) * times(1 / scale[r], t[0]);
    sum += U(r, 1) * times(1 / scale[r], t[1]);
    sum += U(r, 2) * times(1 / scale[r], t[2]);
    out[r] = acc[r] + sum;
  }
  return out;
}

FrameMotion outward(const FrameMotion& from, const MotionNode& to, ExprGraph& graph) {
  if (to.motion.kind == MotionKind::translation) {
    Vec3 acc = from.at(to.motion.offset);
    acc = acc + cross(from.om, graph.integer(2) * to.velocity);
    acc = acc + to.acceleration;
    return FrameMotion(from.om, from.al, acc);
  }
  const Vec3 om = to.motion.to_child(from.om);
  const Vec3 al = to.motion.to_child(from.al) + cross(om, to.velocity);
  return FrameMotion(om + to.velocity, al + to.acceleration, to.motion.to_child(from.acc));
}

namespace {

/// D (J al + om x J om). With the pseudo-inertia K it is the antisymmetric part of U K; its diagonal part may
/// be written with J instead.
Vec3 rotational_moment(const FrameMotion& s, const Mat3& J, const MomentForms& forms, ExprGraph& g) {
  const Expr half = g.rational(Rational(1, 2));
  Expr trace = J(0, 0) + J(1, 1);
  trace += J(2, 2);
  const Expr half_trace = half * trace;
  const std::array<Expr, 3> K{half_trace - J(0, 0), half_trace - J(1, 1), half_trace - J(2, 2)};
  const std::array<Expr, 3> squares{s.xx, s.yy, s.zz};
  const std::array<Expr, 3> products{s.yz, s.xz, s.xy};
  Vec3 n = zeros<3, 1>(g);
  for (std::size_t x = 0; x < 3; ++x) {
    const std::size_t y = (x + 1) % 3, z = (x + 2) % 3;
    // (U K)_zy - (U K)_yz, off-diagonal entries of K (which are those of -J) first
    const double d = s.scale[x];
    n[x] -= s.U(z, x) * times(d, J(x, y));
    n[x] += s.U(y, x) * times(d, J(x, z));
    const Expr difference = squares[z] - squares[y];  // U_zz - U_yy
    n[x] -= difference * times(d, J(y, z));
    switch (forms[x]) {
      case MomentForm::pseudo_inertia:
        n[x] += s.U(z, y) * times(d, K[y]);
        n[x] -= s.U(y, z) * times(d, K[z]);
        break;
      case MomentForm::inertia:
        n[x] += s.al[x] * times(d, J(x, x));
        n[x] += products[x] * times(d, J(z, z) - J(y, y));
        break;
    }
  }
  return n;
}

}  // namespace

Wrench inertia_forces(const FrameMotion& motion, const NodeMass& mass, const MomentForms& forms,
                      ExprGraph& graph) {
  const Scale& d = motion.scale;
  const Vec3& h = mass.moment;
  Wrench out{rotational_moment(motion, mass.inertia, forms, graph), {}};
  for (std::size_t x = 0; x < 3; ++x) {
    const std::size_t y = (x + 1) % 3, z = (x + 2) % 3;
    Expr sum = motion.U(x, 0) * times(d[x], h[0]);
    sum += motion.U(x, 1) * times(d[x], h[1]);
    sum += motion.U(x, 2) * times(d[x], h[2]);
    const Expr translational = times(d[x] * d[x], mass.mass) * motion.acc[x];
    out.force[x] = translational + sum;
    Expr lever = times(d[x] * d[z], h[y]) * motion.acc[z];
    lever -= times(d[x] * d[y], h[z]) * motion.acc[y];
    out.moment[x] += lever;
  }
  return out;
}

std::vector<BodyWrench> external_wrenches_by_body(const Mechanism& mechanism, const MotionTree& tree,
                                                  ExprGraph& graph) {
  const std::vector<WrenchSymbols> given = wrench_symbols(mechanism, graph);
  std::vector<BodyWrench> out;
  if (given.empty()) return out;
  std::vector<Pose> poses;  // rotations only: wrenches are given in world axes
  for (const MotionNode& node : tree.nodes) {
    const Pose from = node.parent < 0 ? identity_pose(graph) : poses[static_cast<std::size_t>(node.parent)];
    poses.push_back(node.motion.kind == MotionKind::translation ? from : moved(from, node.motion));
  }
  for (const auto& [body, wrench] : given) {
    const std::size_t b = static_cast<std::size_t>(body);
    const BodyPlace& place = tree.places[b];
    const Pose pose = place.node < 0 ? identity_pose(graph) : poses[static_cast<std::size_t>(place.node)];
    const Mat3 to_node = transpose(pose.rotation);
    const Vec3 center = center_at_node(mechanism.bodies[b], place);
    out.push_back({b, center, {to_node * wrench.moment, to_node * wrench.force}});
  }
  return out;
}

std::vector<NodeWrench> external_wrenches(const Mechanism& mechanism, const MotionTree& tree,
                                          ExprGraph& graph) {
  std::vector<NodeWrench> out;
  for (const auto& [body, point, wrench] : external_wrenches_by_body(mechanism, tree, graph)) {
    const int node = tree.places[body].node;
    if (node >= 0) out.push_back({static_cast<std::size_t>(node), point, wrench});
  }
  return out;
}

}  // namespace alembert
