// Derivatives of the forces by recursions along the tree of motions (README.md, 7): O(n^2).
#include "dynamics/recursions/derivative_recursion.hpp"

#include <map>
#include <optional>
#include <span>
#include <utility>

#include "differentiation/forward.hpp"
#include "differentiation/jacobian.hpp"
#include "dynamics/recursions/body_forces.hpp"
#include "dynamics/recursions/composite.hpp"
#include "dynamics/recursions/meeting_frames.hpp"
#include "dynamics/recursions/reduced.hpp"
#include "dynamics/tree/spatial_vectors.hpp"

namespace alembert {

namespace {

/// What a change of a coordinate or a speed does to what moves with a frame, seen in the frame: accelerations
/// change by acceleration.angular x r + acceleration.linear + 2 angular x dr/dt, and all turns by `turn` in the
/// world.
struct Change {
  Twist acceleration;  ///< angular: of the rate of om, plus om x `angular`; linear: of that of the origin
  Vec3 angular;        ///< of the angular velocity om
  Vec3 turn;
};

/// One speed that moves a node.
struct Mover {
  std::size_t speed;
  Vec3 twist;                       ///< as in TwistPartial
  std::vector<SpeedPartial> bends;  ///< of the twist, along the speeds
  Change by_coordinate, by_speed;
};

/// The power of a change along one unit motion: momentum . acceleration + g . angular + e . turn.
struct Response {
  Wrench momentum;
  Vec3 g, e;
  Expr to(const Change& change) const {
    const Expr steady = dot(change.acceleration, momentum);
    return steady + (dot(g, change.angular) + dot(e, change.turn));
  }
};

/// Forces whose directions are fixed in the world, with c from the origin to where they act.
struct WorldForces {
  Wrench wrench;  ///< sums of f and of c x f
  Vec3 torque;    ///< sum of free torques
  Mat3 S;         ///< sum of f c^T + c f^T
};

/// All that moves with a frame, and how; r and dr/dt of its particles are from the origin, in axes that do
/// not turn.
struct MovingComposite {
  Composite body;
  Wrench momentum;  ///< p, integral of dr/dt dm, and L, of r x dr/dt dm
  Mat3 S;           ///< rate of K
  WorldForces external;
};

class Recursion {
 public:
  Recursion(const Mechanism& mechanism, const WrittenTree& written, const SpeedDerivatives& derivatives,
            ExprGraph& graph, FarPairs far)
      : mechanism_(mechanism),
        tree_(written.tree),
        moments_(written.moments),
        derivatives_(derivatives),
        graph_(graph),
        none_(zeros<3, 1>(graph)),
        two_(graph.integer(2)),
        nv_(static_cast<std::size_t>(mechanism.nv)),
        along_(nv_ * nv_, graph.zero()),
        by_(nv_ * nv_, graph.zero()) {
    move();
    collect_own();
    meet(far);
  }

  /// D_l Q_k, then dQ_k/du_l.
  std::vector<Expr> run() {
    for (std::size_t i = tree_.nodes.size(); i-- > 0;) {
      for (const Mover& mover : movers_[i]) add_pairs(i, mover);
      if (node(i).parent >= 0) add_to_parent(i);
    }
    std::vector<Expr> both = along_;
    both.insert(both.end(), by_.begin(), by_.end());
    return both;
  }

 private:
  /// A node in a meeting frame: velocity of its origin from that frame's, and the changes by its movers.
  struct Met {
    Vec3 velocity;
    std::vector<Change> by_coordinates, by_speeds;
  };

  const MotionNode& node(std::size_t i) const { return tree_.nodes[i]; }
  std::size_t parent(std::size_t i) const { return static_cast<std::size_t>(node(i).parent); }
  bool is_linear(std::size_t i) const { return node(i).motion.kind == MotionKind::translation; }
  std::size_t size() const { return tree_.nodes.size(); }

  void move();
  std::vector<Mover> movers(const FrameMotion& from, const MotionNode& at, const FrameMotion& frame) const;
  void collect_own();
  MovingComposite own(std::size_t i) const;
  void add_to_parent(std::size_t i);
  void meet(FarPairs far);
  void add_met(int frame, std::size_t i, const Vec3& velocity);

  Wrench change_of_wrench(std::size_t i, const Change& change) const;
  Response response(std::size_t i, const Vec3& twist) const;
  Response carried(const Response& x, std::size_t i) const;
  Response at_meeting(const Response& x, std::size_t i) const;
  void add_pairs(std::size_t i, const Mover& mover);

  Expr along_motion(std::size_t i, const Vec3& twist, const Wrench& x) const {
    return power_along(node(i).motion, twist, x);
  }
  void add(std::vector<Expr>& to, std::size_t k, std::size_t l, Expr value) { to[k * nv_ + l] += value; }

  const Mechanism& mechanism_;
  const MotionTree& tree_;
  const std::vector<MomentForms>& moments_;
  const SpeedDerivatives& derivatives_;
  ExprGraph& graph_;
  Vec3 none_;
  Expr two_;
  std::size_t nv_;
  std::vector<Expr> along_, by_;

  std::vector<FrameMotion> frames_;
  std::vector<Vec3> shift_rates_;  ///< of translations: velocity of the origin from the parent's
  std::vector<std::vector<Mover>> movers_;
  std::vector<MovingComposite> composites_;
  std::vector<Wrench> loads_;  ///< that the motions of nodes bear
  std::optional<MeetingFrames> meetings_;
  std::map<std::pair<int, std::size_t>, Met> met_;  ///< by meeting frame and node
};

void Recursion::move() {
  const FrameMotion root = motion_of_world(mechanism_, graph_);
  for (std::size_t i = 0; i < size(); ++i) {
    const FrameMotion& from = node(i).parent < 0 ? root : frames_[parent(i)];
    shift_rates_.push_back(is_linear(i) ? cross(from.om, node(i).motion.offset) + node(i).velocity : none_);
    FrameMotion frame = outward(from, node(i), graph_);
    movers_.push_back(movers(from, node(i), frame));
    frames_.push_back(frame);
  }
}

std::vector<Mover> Recursion::movers(const FrameMotion& from, const MotionNode& at,
                                     const FrameMotion& frame) const {
  const auto along = [&](const std::vector<SpeedPartial>& partials, int speed) {
    for (const SpeedPartial& partial : partials)
      if (partial.speed == speed) return vec3(partial.values);
    return none_;
  };
  const std::vector<SpeedPartial> of_velocity = derivatives_.partials(at.velocity.entries);
  const std::vector<SpeedPartial> of_acceleration = derivatives_.partials(at.acceleration.entries);
  std::vector<Expr> speeds;
  for (const TwistPartial& partial : at.partials)
    if (partial.speed != derivatives_.time_index()) speeds.push_back(derivatives_.speed(partial.speed));
  const Jacobian by_speeds = jacobian_forward(at.acceleration.entries, speeds);

  std::vector<Mover> out;
  for (const TwistPartial& partial : at.partials) {
    if (partial.speed == derivatives_.time_index()) continue;
    const std::size_t column = out.size();
    const Vec3& xi = partial.direction;
    const Vec3 velocity = along(of_velocity, partial.speed);
    const Vec3 acceleration = along(of_acceleration, partial.speed);
    const Vec3 by_speed{{by_speeds(0, column), by_speeds(1, column), by_speeds(2, column)}};
    Mover mover{static_cast<std::size_t>(partial.speed),
                xi,
                derivatives_.partials(xi.entries),
                {{none_, none_}, none_, none_},
                {{none_, none_}, none_, none_}};
    if (at.motion.kind == MotionKind::translation) {
      mover.by_coordinate.acceleration.linear = from.U * xi + cross(from.om, two_ * velocity) + acceleration;
      mover.by_speed.acceleration.linear = cross(from.om, two_ * xi) + by_speed;
    } else {
      const Vec3 sum = at.motion.to_child(from.om) + frame.om;
      const Vec3 bent = velocity - cross(at.velocity, xi);
      const Vec3 bent_rate = acceleration - cross(at.acceleration, xi);
      mover.by_coordinate = {{frame.U * xi + cross(sum, bent) + bent_rate, cross(frame.acc, xi)},
                             cross(frame.om, xi) + bent,
                             xi};
      mover.by_speed = {{cross(sum, xi) + by_speed, none_}, xi, none_};
    }
    out.push_back(std::move(mover));
  }
  return out;
}

MovingComposite Recursion::own(std::size_t i) const {
  const Vec3& om = frames_[i].om;
  const Composite body = composite(tree_.masses[i], graph_);
  Mat3 turning;
  for (std::size_t c = 0; c < 3; ++c) {
    const Vec3 column = cross(om, {{body.K(0, c), body.K(1, c), body.K(2, c)}});
    for (std::size_t r = 0; r < 3; ++r) turning(r, c) = column[r];
  }
  return {body,
          {times_inertia(body.K, om), cross(om, body.h)},
          turning + transpose(turning),
          {{none_, none_}, none_, zeros<3, 3>(graph_)}};
}

void Recursion::collect_own() {
  for (std::size_t i = 0; i < size(); ++i) {
    composites_.push_back(own(i));
    loads_.push_back(tree_.masses[i].is_zero()
                         ? zero_wrench(graph_)
                         : inertia_forces(frames_[i], tree_.masses[i], moments_[i], graph_));
  }
  for (const auto& [i, point, wrench] : external_wrenches(mechanism_, tree_, graph_)) {
    const Vec3 torque = none_ - wrench.moment;
    const Wrench force = at_offset({none_, none_ - wrench.force}, point);
    WorldForces& all = composites_[i].external;
    all = {all.wrench + force, all.torque + torque, plus_products(all.S, force.force, point)};
    loads_[i] = {loads_[i].moment + (torque + force.moment), loads_[i].force + force.force};
  }
}

void Recursion::add_to_parent(std::size_t i) {
  const Motion& motion = node(i).motion;
  MovingComposite x = composites_[i];
  if (is_linear(i)) {
    const Vec3 &t = motion.offset, &w = shift_rates_[i];
    WorldForces& forces = x.external;
    x.body = shifted(x.body, t, graph_);
    x.S = plus_products(plus_products(x.S, x.momentum.force, t), x.body.h, w);
    x.momentum = inward(motion, x.momentum);
    x.momentum = {x.momentum.moment + cross(x.body.h, w), x.momentum.force + x.body.mass * w};
    forces.wrench = inward(motion, forces.wrench);
    forces.S = plus_products(forces.S, forces.wrench.force, t);
  } else {
    const WorldForces& forces = x.external;
    x = {
        turned(x.body, motion),
        inward(motion, x.momentum),
        turned_symmetric(x.S, motion),
        {inward(motion, forces.wrench), motion.to_parent(forces.torque), turned_symmetric(forces.S, motion)}};
  }
  MovingComposite& sum = composites_[parent(i)];
  const WorldForces &one = sum.external, &other = x.external;
  sum = {plus(sum.body, x.body),
         sum.momentum + x.momentum,
         plus_symmetric(sum.S, x.S),
         {one.wrench + other.wrench, one.torque + other.torque, plus_symmetric(one.S, other.S)}};
  loads_[parent(i)] = loads_[parent(i)] + inward(motion, loads_[i]);
}

Wrench Recursion::change_of_wrench(std::size_t i, const Change& change) const {
  const auto& [body, momentum, S, external] = composites_[i];
  const auto& [rate, linear] = change.acceleration;
  Wrench out{cross(body.h, linear), body.mass * linear};
  out.force = out.force + cross(rate, body.h) + cross(two_ * change.angular, momentum.force);
  out.moment = out.moment + times_inertia(body.K, rate) + times_inertia(S, change.angular) +
               cross(change.angular, momentum.moment);
  // World forces turn backwards in the frame.
  const Expr half = graph_.rational(Rational(1, 2));
  out.force = out.force + cross(external.wrench.force, change.turn);
  out.moment = out.moment + cross(external.torque + half * external.wrench.moment, change.turn) -
               half * times_inertia(external.S, change.turn);
  return out;
}

Response Recursion::response(std::size_t i, const Vec3& twist) const {
  const auto& [body, momentum, S, external] = composites_[i];
  if (is_linear(i))
    return {{cross(body.h, twist), body.mass * twist},
            cross(two_ * momentum.force, twist),
            cross(twist, external.wrench.force)};
  const Expr half = graph_.rational(Rational(1, 2));
  return {{times_inertia(body.K, twist), cross(twist, body.h)},
          times_inertia(S, twist) + cross(momentum.moment, twist),
          cross(twist, external.torque + half * external.wrench.moment) -
              half * times_inertia(external.S, twist)};
}

Response Recursion::carried(const Response& x, std::size_t i) const {
  const Motion& motion = node(i).motion;
  const Wrench momentum = inward(motion, x.momentum);
  if (is_linear(i)) return {momentum, x.g + cross(two_ * shift_rates_[i], momentum.force), x.e};
  return {momentum, motion.to_parent(x.g), motion.to_parent(x.e)};
}

void Recursion::meet(FarPairs far) {
  UnitMotions units;
  for (const std::vector<Mover>& movers : movers_) {
    units.emplace_back();
    for (const Mover& mover : movers)
      units.back().push_back({mover.twist, {{static_cast<int>(mover.speed), graph_.one()}}});
  }
  meetings_.emplace(tree_, units, plan_meetings(tree_, units, far), graph_);
  for (const auto& [frame, node, velocity] : meetings_->velocities(shift_rates_, graph_))
    add_met(frame, node, velocity);
}

void Recursion::add_met(int frame, std::size_t i, const Vec3& velocity) {
  const Pose& pose = meetings_->pose(frame, i);
  const auto met = [&](const Change& change) {
    const Vec3 angular = pose.rotation * change.angular;
    Twist acceleration = inward(pose, change.acceleration);
    acceleration.linear = acceleration.linear + cross(two_ * velocity, angular);
    return Change{acceleration, angular, pose.rotation * change.turn};
  };
  Met out{velocity, {}, {}};
  for (const Mover& mover : movers_[i]) {
    out.by_coordinates.push_back(met(mover.by_coordinate));
    out.by_speeds.push_back(met(mover.by_speed));
  }
  met_.emplace(std::pair(frame, i), std::move(out));
}

Response Recursion::at_meeting(const Response& x, std::size_t i) const {
  const int frame = meetings_->meeting_of(i);
  if (frame == static_cast<int>(i)) return x;
  const Wrench momentum = meetings_->at_meeting(i, x.momentum);
  const Mat3& rotation = meetings_->pose(frame, i).rotation;
  return {momentum, rotation * x.g + cross(two_ * met_.at({frame, i}).velocity, momentum.force),
          rotation * x.e};
}

void Recursion::add_pairs(std::size_t i, const Mover& mover) {
  const std::size_t l = mover.speed;
  Wrench along = change_of_wrench(i, mover.by_coordinate), by = change_of_wrench(i, mover.by_speed);
  const Wrench& load = loads_[i];
  for (const Mover& other : movers_[i]) {
    add(along_, other.speed, l, along_motion(i, other.twist, along));
    add(by_, other.speed, l, along_motion(i, other.twist, by));
  }
  for (const SpeedPartial& bend : mover.bends) {
    if (bend.speed == derivatives_.time_index()) continue;
    add(along_, l, static_cast<std::size_t>(bend.speed), along_motion(i, vec3(bend.values), load));
  }
  // Inward of the node the load turns, or shifts, too.
  if (is_linear(i)) {
    along.moment = along.moment + cross(mover.twist, load.force);
  } else {
    along = {along.moment + cross(mover.twist, load.moment), along.force + cross(mover.twist, load.force)};
  }
  Response power = response(i, mover.twist);
  for (std::size_t j = i; node(j).parent >= 0;) {
    if (meetings_->is_posed(j)) {
      const int frame = meetings_->meeting_of(j);
      const Wrench along_met = meetings_->at_meeting(j, along), by_met = meetings_->at_meeting(j, by);
      const Response power_met = at_meeting(power, j);
      for (int at = node(j).parent; at >= 0; at = node(static_cast<std::size_t>(at)).parent) {
        const std::size_t k = static_cast<std::size_t>(at);
        const Met& met = met_.at({frame, k});
        for (std::size_t b = 0; b < movers_[k].size(); ++b) {
          const std::size_t other = movers_[k][b].speed;
          add(along_, other, l, meetings_->along(j, k, b, along_met));
          add(by_, other, l, meetings_->along(j, k, b, by_met));
          add(along_, l, other, power_met.to(met.by_coordinates[b]));
          add(by_, l, other, power_met.to(met.by_speeds[b]));
        }
      }
      return;
    }
    along = inward(node(j).motion, along);
    by = inward(node(j).motion, by);
    power = carried(power, j);
    j = parent(j);
    for (const Mover& other : movers_[j]) {
      add(along_, other.speed, l, along_motion(j, other.twist, along));
      add(by_, other.speed, l, along_motion(j, other.twist, by));
      add(along_, l, other.speed, power.to(other.by_coordinate));
      add(by_, l, other.speed, power.to(other.by_speed));
    }
  }
}

}  // namespace

std::vector<Expr> recursive_force_derivatives(const Mechanism& mechanism, const WrittenTree& written,
                                              const SpeedDerivatives& derivatives, ExprGraph& graph,
                                              FarPairs far) {
  return Recursion(mechanism, written, derivatives, graph, far).run();
}

}  // namespace alembert
