// Velocities and accelerations from the world outward, in world axes (see the header). By a motion from a frame that
// has angular velocity om, its rate al, velocity v and acceleration a,
//
//   shift by r    v + om x r + dr/dt, a + al x r + om x (om x r) + 2 om x dr/dt + d^2r/dt^2
//   turn by w     om + w, al + om x w + dw/dt
//
// where dr/dt, w and their rates are componentwise in the axes of the frame that the motion leads from (shift) or
// to (turn).
#include "dynamics/recursions/moving_bodies.hpp"

#include <algorithm>

#include "differentiation/jacobian.hpp"
#include "dynamics/tree/state_values.hpp"
#include "symbolic/evaluate.hpp"

namespace alembert {
namespace {

struct FrameMovement {
  Pose pose;
  Vec3 om, v, al, a;
};

Vec3 three(const std::vector<Expr>& values) {
  return {{values[0], values[1], values[2]}};
}

class Movements {
 public:
  Movements(const Mechanism& mechanism, const MotionTree& tree, const SpeedDerivatives& derivatives,
            ExprGraph& graph, SpeedRates rates)
      : mechanism_(mechanism), tree_(tree), derivatives_(derivatives), graph_(graph), rates_(rates) {
    for (const MotionNode& node : tree.nodes)
      nodes_.push_back(
          next(node.parent < 0 ? world() : nodes_[static_cast<std::size_t>(node.parent)], node.motion));
  }

  std::vector<FrameMovement> frames() const {
    std::vector<FrameMovement> all;
    for (const Frame& frame : mechanism_.frames) {
      FrameMovement& at =
          all.emplace_back(frame.body < 0 ? world() : body(static_cast<std::size_t>(frame.body)));
      for (const Motion& motion : elementary_motions(frame.transform, mechanism_, graph_))
        at = next(at, motion);
    }
    return all;
  }
  /// Bodies at their centres of mass.
  std::vector<FrameMovement> centers() const {
    std::vector<FrameMovement> all;
    for (std::size_t b = 0; b < mechanism_.bodies.size(); ++b)
      all.push_back(next(body(b), translation_motion(mechanism_.bodies[b].mass_properties.com)));
    return all;
  }

 private:
  FrameMovement world() const {
    const Vec3 none = zeros<3, 1>(graph_);
    return {identity_pose(graph_), none, none, none, none};
  }
  FrameMovement body(std::size_t index) const {
    const BodyPlace& place = tree_.places[index];
    FrameMovement at = place.node < 0 ? world() : nodes_[static_cast<std::size_t>(place.node)];
    for (const Motion& motion : place.tail) at = next(at, motion);
    return at;
  }

  FrameMovement next(const FrameMovement& from, const Motion& motion) const {
    const std::vector<SpeedPartial> partials = twist_partials(motion, mechanism_, derivatives_, graph_);
    const Vec3 velocity = three(derivatives_.first_rate(partials, 3));
    const Vec3 acceleration =
        three(rates_ == SpeedRates::included ? derivatives_.second_rate(partials, 3)
                                             : derivatives_.quadratic_rate(partials, 3));
    FrameMovement to = from;
    to.pose = moved(from.pose, motion);
    if (motion.kind == MotionKind::translation) {
      const Mat3& R = from.pose.rotation;
      const Vec3 r = R * motion.offset, dr = R * velocity;
      to.v = from.v + cross(from.om, r) + dr;
      to.a = from.a + cross(from.al, r) + cross(from.om, cross(from.om, r));
      to.a = to.a + graph_.integer(2) * cross(from.om, dr) + R * acceleration;
    } else {
      const Vec3 w = to.pose.rotation * velocity;
      to.om = from.om + w;
      to.al = from.al + cross(from.om, w) + to.pose.rotation * acceleration;
    }
    return to;
  }

  const Mechanism& mechanism_;
  const MotionTree& tree_;
  const SpeedDerivatives& derivatives_;
  ExprGraph& graph_;
  SpeedRates rates_;
  std::vector<FrameMovement> nodes_;
};

void append(std::vector<Expr>& out, const Vec3& angular, const Vec3& linear) {
  out.insert(out.end(), angular.entries.begin(), angular.entries.end());
  out.insert(out.end(), linear.entries.begin(), linear.entries.end());
}

/// Six entries of each.
std::vector<Expr> six_of_each(const std::vector<FrameMovement>& all, Vec3 FrameMovement::*angular,
                              Vec3 FrameMovement::*linear) {
  std::vector<Expr> out;
  for (const FrameMovement& one : all) append(out, one.*angular, one.*linear);
  return out;
}
std::vector<Expr> velocities(const std::vector<FrameMovement>& all) {
  return six_of_each(all, &FrameMovement::om, &FrameMovement::v);
}
std::vector<Expr> accelerations(const std::vector<FrameMovement>& all) {
  return six_of_each(all, &FrameMovement::al, &FrameMovement::a);
}

}  // namespace

std::vector<Expr> frame_velocities(const Mechanism& mechanism, const MotionTree& tree,
                                   const SpeedDerivatives& derivatives, ExprGraph& graph) {
  return velocities(Movements(mechanism, tree, derivatives, graph, SpeedRates::left_out).frames());
}

std::vector<Expr> frame_accelerations(const Mechanism& mechanism, const MotionTree& tree,
                                      const SpeedDerivatives& derivatives, ExprGraph& graph,
                                      SpeedRates rates) {
  return accelerations(Movements(mechanism, tree, derivatives, graph, rates).frames());
}

std::vector<Expr> body_velocities(const Mechanism& mechanism, const MotionTree& tree,
                                  const SpeedDerivatives& derivatives, ExprGraph& graph) {
  return velocities(Movements(mechanism, tree, derivatives, graph, SpeedRates::left_out).centers());
}

std::vector<Expr> body_accelerations(const Mechanism& mechanism, const MotionTree& tree,
                                     const SpeedDerivatives& derivatives, ExprGraph& graph,
                                     SpeedRates rates) {
  return accelerations(Movements(mechanism, tree, derivatives, graph, rates).centers());
}

namespace {

/// At the defaults of runtime parameters.
std::size_t heaviest_body(const Mechanism& mechanism, ExprGraph& graph) {
  std::vector<Expr> masses;
  for (const Body& body : mechanism.bodies) masses.push_back(body.mass_properties.mass);
  const std::vector<double> values = evaluate(masses, state_values(mechanism, graph, 0));
  return static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
}

}  // namespace

CentroidalMomentum centroidal_momentum(const Mechanism& mechanism, const MotionTree& tree,
                                       const SpeedDerivatives& derivatives, ExprGraph& graph,
                                       MomentumFrom from) {
  const std::vector<FrameMovement> bodies =
      Movements(mechanism, tree, derivatives, graph, SpeedRates::left_out).centers();
  const Vec3 none = zeros<3, 1>(graph);
  Expr mass = graph.zero();
  Vec3 moment = none;
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const Expr m = mechanism.bodies[b].mass_properties.mass;
    mass += m;
    moment = moment + m * bodies[b].pose.origin;
  }
  const Vec3 com{{moment[0] / mass, moment[1] / mass, moment[2] / mass}};
  CentroidalMomentum out;
  out.com.assign(com.entries.begin(), com.entries.end());
  Vec3 angular = none, linear = none, angular_rate = none, linear_rate = none;
  FrameMovement base{identity_pose(graph), none, none, none, none};
  if (from == MomentumFrom::heaviest_body) base = bodies[heaviest_body(mechanism, graph)];
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const MassProperties& of = mechanism.bodies[b].mass_properties;
    const FrameMovement& at = bodies[b];
    const Mat3& R = at.pose.rotation;
    const Vec3 weighted_arm = of.mass * (at.pose.origin - com);
    const auto spin = [&](const Vec3& turn) { return R * (of.inertia * (transpose(R) * turn)); };
    const Vec3 own = spin(at.om);
    linear = linear + of.mass * at.v;
    angular = angular + own + cross(weighted_arm, at.v - base.v);
    linear_rate = linear_rate + of.mass * at.a;
    angular_rate = angular_rate + spin(at.al) + cross(at.om, own) + cross(weighted_arm, at.a - base.a);
  }
  append(out.h, angular, linear);
  append(out.bias, angular_rate, linear_rate);
  std::vector<Expr> speeds;
  for (int k = 0; k < mechanism.nv; ++k) speeds.push_back(derivatives.speed(k));
  const Jacobian by_speeds = jacobian(out.h, speeds);
  out.A.assign(by_speeds.entries.begin(), by_speeds.entries.end());
  return out;
}

}  // namespace alembert
