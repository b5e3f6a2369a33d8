// The Coriolis matrix by a recursion along the tree of motions (README.md, 9): O(n^2).
#include "dynamics/recursions/coriolis_recursion.hpp"

#include <map>
#include <optional>
#include <utility>

#include "dynamics/recursions/composite.hpp"
#include "dynamics/tree/spatial_vectors.hpp"

namespace alembert {

namespace {

/// The rate of D_j r of a particle at r from the origin: rate.angular x r + rate.linear + twist x dr/dt, with dr/dt
/// in axes that do not turn.
struct RateOfUnit {
  Twist rate;
  Vec3 twist;
};

/// The momentum of a unit motion, and what makes its power along a RateOfUnit: momentum . rate + g . twist.
struct Along {
  Wrench momentum;
  Vec3 g;  ///< integral of dr/dt x D_i r dm
  Expr to(const RateOfUnit& of) const {
    const Expr steady = dot(of.rate, momentum);
    return steady + dot(g, of.twist);
  }
};

/// One speed that moves a node.
struct Unit {
  std::size_t speed;
  Vec3 direction;  ///< as in TwistPartial
  Vec3 bend;       ///< its componentwise rate
  RateOfUnit rate;
};

class CoriolisRecursion {
 public:
  CoriolisRecursion(const Mechanism& mechanism, const WrittenTree& written,
                    const SpeedDerivatives& derivatives, ExprGraph& graph, FarPairs far)
      : tree_(written.tree),
        derivatives_(derivatives),
        graph_(graph),
        none_(zeros<3, 1>(graph)),
        nv_(static_cast<std::size_t>(mechanism.nv)),
        C_(nv_ * nv_, graph.zero()) {
    move();
    for (const NodeMass& mass : tree_.masses) inner_.push_back(still(composite(mass, graph), graph));
    meet(far);
  }

  std::vector<Expr> run() {
    for (std::size_t i = tree_.nodes.size(); i-- > 0;) {
      for (const Unit& unit : units_[i]) add_pairs(i, unit);
      if (node(i).parent >= 0) add_to_parent(i);
    }
    return C_;
  }

 private:
  /// A node in a meeting frame: velocity of its origin from that frame's, and the rates of its units.
  struct Met {
    Vec3 velocity;
    std::vector<RateOfUnit> rates;
  };

  const MotionNode& node(std::size_t i) const { return tree_.nodes[i]; }
  std::size_t parent(std::size_t i) const { return static_cast<std::size_t>(node(i).parent); }
  bool is_linear(std::size_t i) const { return node(i).motion.kind == MotionKind::translation; }

  void move();
  void meet(FarPairs far);
  void add_met(int frame, std::size_t i, const Vec3& velocity);
  void add_to_parent(std::size_t i);
  void add_pairs(std::size_t i, const Unit& unit);
  /// The force and moment that give what moves with a frame the rates of D_j r, for a unit motion j.
  Wrench rate_of_momentum(std::size_t i, const Unit& unit) const;
  Along along(std::size_t i, const Vec3& direction) const;

  void add(std::size_t row, std::size_t column, Expr value) { C_[row * nv_ + column] += value; }

  const MotionTree& tree_;
  const SpeedDerivatives& derivatives_;
  ExprGraph& graph_;
  Vec3 none_;
  std::size_t nv_;
  std::vector<Expr> C_;

  std::vector<Vec3> om_;
  std::vector<Vec3> shift_rates_;  ///< of translations: velocity of the origin from the parent's
  std::vector<std::vector<Unit>> units_;
  std::vector<InnerMotion> inner_;
  std::optional<MeetingFrames> meetings_;
  std::map<std::pair<int, std::size_t>, Met> met_;  ///< by meeting frame and node
};

void CoriolisRecursion::move() {
  for (std::size_t i = 0; i < tree_.nodes.size(); ++i) {
    const Vec3& before = node(i).parent < 0 ? none_ : om_[parent(i)];
    const bool linear = is_linear(i);
    shift_rates_.push_back(linear ? cross(before, node(i).motion.offset) + node(i).velocity : none_);
    om_.push_back(linear ? before : node(i).motion.to_child(before) + node(i).velocity);
    std::vector<Unit>& units = units_.emplace_back();
    for (const TwistPartial& partial : node(i).partials) {
      if (partial.speed == derivatives_.time_index()) continue;
      const Vec3& xi = partial.direction;
      const std::vector<Expr> own = derivatives_.first_rate(derivatives_.partials(xi.entries), 3);
      const Vec3 bend{{own[0], own[1], own[2]}};
      const Vec3 rate = cross(om_.back(), xi) + bend;
      const std::size_t speed = static_cast<std::size_t>(partial.speed);
      if (linear)
        units.push_back({speed, xi, bend, {{none_, rate}, none_}});
      else
        units.push_back({speed, xi, bend, {{rate, none_}, xi}});
    }
  }
}

void CoriolisRecursion::add_to_parent(std::size_t i) {
  const MotionNode& at = node(i);
  InnerMotion& sum = inner_[parent(i)];
  sum = plus(sum, is_linear(i) ? shifted(inner_[i], at.motion.offset, at.velocity, graph_)
                               : turned(inner_[i], at.motion, at.velocity));
}

Wrench CoriolisRecursion::rate_of_momentum(std::size_t i, const Unit& unit) const {
  const auto& [body, p, P] = inner_[i];
  if (is_linear(i)) {
    const Vec3& linear = unit.rate.rate.linear;
    return {cross(body.h, linear), body.mass * linear};
  }
  // Of what is still in the frame, A r with A = skew(om) skew(xi) + skew(bend).
  const Vec3 &xi = unit.direction, &om = om_[i], &bend = unit.bend;
  const Expr along_axis = dot(xi, om);
  Mat3 A;
  for (std::size_t r = 0; r < 3; ++r) {
    const std::size_t s = (r + 1) % 3, t = (r + 2) % 3;
    A(r, r) = xi[r] * om[r] - along_axis;
    A(r, s) = xi[r] * om[s] - bend[t];
    A(r, t) = xi[r] * om[t] + bend[s];
  }
  const Mat3 AK = A * body.K;
  const Vec3 moment{{AK(2, 1) - AK(1, 2), AK(0, 2) - AK(2, 0), AK(1, 0) - AK(0, 1)}};
  // And xi x dr/dt of what moves there.
  const Vec3 moving = times_inertia(transpose(P), xi), force = A * body.h;
  return {moment + moving, force + cross(xi, p)};
}

Along CoriolisRecursion::along(std::size_t i, const Vec3& direction) const {
  const auto& [body, p, P] = inner_[i];
  const Vec3& om = om_[i];
  if (is_linear(i))
    return {{cross(body.h, direction), body.mass * direction}, cross(p + cross(om, body.h), direction)};
  // In axes that do not turn, r (om x r)^T is added to P.
  const Vec3 moving = times_inertia(P, direction), turning = body.K * cross(om, direction);
  return {{times_inertia(body.K, direction), cross(direction, body.h)}, moving + turning};
}

void CoriolisRecursion::meet(FarPairs far) {
  UnitMotions directions;
  for (const std::vector<Unit>& units : units_) {
    directions.emplace_back();
    for (const Unit& unit : units)
      directions.back().push_back({unit.direction, {{static_cast<int>(unit.speed), graph_.one()}}});
  }
  meetings_.emplace(tree_, directions, plan_meetings(tree_, directions, far), graph_);
  for (const auto& [frame, node, velocity] : meetings_->velocities(shift_rates_, graph_))
    add_met(frame, node, velocity);
}

void CoriolisRecursion::add_met(int frame, std::size_t i, const Vec3& velocity) {
  const Pose& pose = meetings_->pose(frame, i);
  Met out{velocity, {}};
  for (const Unit& unit : units_[i]) {
    const Vec3 twist = pose.rotation * unit.rate.twist;
    Twist rate = inward(pose, unit.rate.rate);
    rate.linear = rate.linear + cross(velocity, twist);
    out.rates.push_back({rate, twist});
  }
  met_.emplace(std::pair(frame, i), std::move(out));
}

void CoriolisRecursion::add_pairs(std::size_t i, const Unit& unit) {
  Wrench rate = rate_of_momentum(i, unit);
  for (const Unit& other : units_[i])
    add(other.speed, unit.speed, power_along(node(i).motion, other.direction, rate));
  Along own = along(i, unit.direction);
  for (std::size_t j = i; node(j).parent >= 0;) {
    if (meetings_->is_posed(j)) {
      const int frame = meetings_->meeting_of(j);
      const Wrench met_rate = meetings_->at_meeting(j, rate);
      if (frame != static_cast<int>(j)) {
        own.momentum = meetings_->at_meeting(j, own.momentum);
        own.g = meetings_->pose(frame, j).rotation * own.g;
        own.g = own.g + cross(met_.at({frame, j}).velocity, own.momentum.force);
      }
      for (int at = node(j).parent; at >= 0; at = node(static_cast<std::size_t>(at)).parent) {
        const std::size_t k = static_cast<std::size_t>(at);
        const Met& met = met_.at({frame, k});
        for (std::size_t b = 0; b < units_[k].size(); ++b) {
          add(units_[k][b].speed, unit.speed, meetings_->along(j, k, b, met_rate));
          add(unit.speed, units_[k][b].speed, own.to(met.rates[b]));
        }
      }
      return;
    }
    const Motion& motion = node(j).motion;
    rate = inward(motion, rate);
    own.momentum = inward(motion, own.momentum);
    own.g = is_linear(j) ? own.g + cross(shift_rates_[j], own.momentum.force) : motion.to_parent(own.g);
    j = parent(j);
    for (const Unit& other : units_[j]) {
      add(other.speed, unit.speed, power_along(node(j).motion, other.direction, rate));
      add(unit.speed, other.speed, own.to(other.rate));
    }
  }
}

}  // namespace

std::vector<Expr> recursive_coriolis_matrix(const Mechanism& mechanism, const WrittenTree& written,
                                            const SpeedDerivatives& derivatives, ExprGraph& graph,
                                            FarPairs far) {
  return CoriolisRecursion(mechanism, written, derivatives, graph, far).run();
}

}  // namespace alembert
