// Generalized forces by virtual work: Mechanism::forces in; by speed k, with D_k the derivative along it, which
// leaves inputs as they are,
//
//   along a speed    value, to that speed
//   potential V      -D_k V
//   along e          value D_k e
//   tension T        -T D_k L for a path of length L
//   wrench (f, n)    f . D_k p + n . om_k for a frame at p, om_k being its angular velocity for that speed
//
// out, and the potential energy; Mechanism::outputs and the rates of states in and their values out.
#include "dynamics/recursions/applied_forces.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <span>
#include <utility>

#include "differentiation/jacobian.hpp"
#include "dynamics/recursions/frame_values.hpp"
#include "dynamics/recursions/outputs.hpp"
#include "dynamics/tree/state_values.hpp"
#include "mechanism/force_names.hpp"
#include "mechanism/parameter_places.hpp"
#include "symbolic/count_operations.hpp"
#include "symbolic/evaluate.hpp"
#include "symbolic/substitute.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {
namespace {

/// A wrench about the origin of a frame, in its axes or the world's.
struct AppliedWrench {
  int frame;
  bool frame_axes;
  Wrench wrench;
  FramePlace place;
};

class AppliedForcesBuilder {
 public:
  AppliedForcesBuilder(const Mechanism& mechanism, const MotionTree& tree,
                       const SpeedDerivatives& derivatives, ExprGraph& graph)
      : mechanism_(mechanism),
        tree_(tree),
        derivatives_(derivatives),
        graph_(graph),
        poses_(frame_poses(mechanism, tree, graph)),
        moving_(moving_values(mechanism, tree, derivatives, graph)),
        laws_(input_laws(mechanism, moving_, graph)),
        Q_(static_cast<std::size_t>(mechanism.nv), graph.zero()),
        potential_(graph.zero()) {}

  AppliedForces build() {
    for (const Force& force : mechanism_.forces) {
      add(force);
      std::vector<Expr> all = Q_;
      for (const AppliedWrench& given : wrenches_)
        for (std::size_t i = 0; i < 6; ++i) all.push_back(given.wrench[i]);
      check_values(all, force.where, "force '" + force.name + "'");
    }
    std::vector<Expr> outputs, rates;
    for (const Output& output : mechanism_.outputs) outputs.push_back(output.value);
    for (const auto& [state, place] : placed_parameters(mechanism_, ParameterRole::state)) {
      rates.push_back(inserted(state.rate));
      check_values(std::span(&rates.back(), 1), state.where, "the rate of state '" + state.name + "'");
    }
    return {shortest(), potential_, inserted(outputs), rates};
  }

  std::vector<Expr> build_each() {
    std::vector<Expr> rows;
    for (const std::string& name : force_names(mechanism_)) {
      std::ranges::fill(Q_, graph_.zero());
      wrenches_.clear();
      for (const Force& force : mechanism_.forces)
        if (force.name == name) add(force);
      std::ranges::copy(shortest(), std::back_inserter(rows));
    }
    return rows;
  }

  /// By body, about its node.
  std::vector<Wrench> build_wrenches() {
    const std::size_t frames = mechanism_.frames.size();
    in_world_.assign(frames, zero_wrench(graph_));
    std::vector<Wrench> in_frame = in_world_;
    for (const Force& force : mechanism_.forces) {
      if (force.kind == ForceKind::potential)
        pull(force.value, -graph_.one());
      else if (force.kind == ForceKind::path || force.kind == ForceKind::along)
        pull(force.length, strength_along(force));
      else if (force.kind == ForceKind::wrench) {
        Wrench& sum = (force.frame_axes ? in_frame : in_world_)[static_cast<std::size_t>(force.frame)];
        sum = sum + Wrench{inserted(force.torque), inserted(force.force)};
      }
    }
    std::vector<Wrench> of_bodies(mechanism_.bodies.size(), zero_wrench(graph_));
    for (std::size_t f = 0; f < frames; ++f) {
      const int body = mechanism_.frames[f].body;
      if (body < 0) continue;
      const Mat3 to_frame = transpose(rotation(static_cast<int>(f)));
      Wrench wrench = in_frame[f] + Wrench{to_frame * in_world_[f].moment, to_frame * in_world_[f].force};
      const FramePlace place = frame_place(static_cast<int>(f), mechanism_, tree_, graph_);
      for (std::size_t m = place.motions.size(); m-- > 0;) wrench = inward(place.motions[m], wrench);
      Wrench& sum = of_bodies[static_cast<std::size_t>(body)];
      sum = sum + wrench;
    }
    return of_bodies;
  }

 private:
  using Values = std::vector<std::pair<Expr, Expr>>;

  static std::vector<Expr> replaced(std::vector<Expr> given, const Values& values) {
    return values.empty() ? given : substitute(given, values);
  }
  /// A function of the coordinates, with inputs as symbols: its derivatives leave them as they are.
  Expr with_inputs(const Expr& given) const { return replaced({given}, moving_).front(); }
  Expr without_inputs(const Expr& given) const { return replaced({given}, laws_).front(); }
  std::vector<Expr> inserted(std::vector<Expr> values) const {
    return replaced(replaced(std::move(values), moving_), laws_);
  }
  Expr inserted(const Expr& given) const { return inserted(std::vector<Expr>{given}).front(); }

  void add(int speed, const Expr& value, std::vector<Expr>& Q) const {
    if (speed != derivatives_.time_index()) Q[static_cast<std::size_t>(speed)] += value;
  }

  void add(const Force& force) {
    switch (force.kind) {
      case ForceKind::on_speed:
        add(force.speed, inserted(force.value), Q_);
        break;
      case ForceKind::potential: {
        const Expr energy = with_inputs(force.value);
        potential_ += without_inputs(energy);
        for (const SpeedPartial& partial : derivatives_.partials(std::span(&energy, 1)))
          add(partial.speed, -without_inputs(partial.values.front()), Q_);
        break;
      }
      case ForceKind::along:
      case ForceKind::path: {
        const Expr length = with_inputs(force.length), strength = strength_along(force);
        for (const SpeedPartial& lever : derivatives_.partials(std::span(&length, 1)))
          add(lever.speed, strength * without_inputs(lever.values.front()), Q_);
        break;
      }
      case ForceKind::wrench:
        add_wrench(force);
        break;
    }
  }

  /// Along what is in Force::length: a tension shortens it.
  Expr strength_along(const Force& force) const {
    const Expr value = inserted(force.value);
    return force.kind == ForceKind::path ? -value : value;
  }
  Mat3 rotation(int frame) const {
    const std::span<const Expr> pose = pose_of(frame);
    return {{pose[0], pose[1], pose[2], pose[4], pose[5], pose[6], pose[8], pose[9], pose[10]}};
  }
  std::span<const Expr> pose_of(int frame) const {
    return std::span(poses_).subspan(12 * static_cast<std::size_t>(frame), 12);
  }
  Vec3 inserted(const Vec3& given) const {
    const std::vector<Expr> x = inserted(std::vector<Expr>(given.entries.begin(), given.entries.end()));
    return {{x[0], x[1], x[2]}};
  }

  /// To frames, `strength` times the derivatives of a function of where they are: by a distance along the line
  /// between both, by a position as it is, and by a rotation R its columns' R_c x (derivative by R_c).
  void pull(const Expr& of, const Expr& strength) {
    const auto derivatives_by = [&](const std::vector<Expr>& symbols) {
      const std::vector<Expr> roots{of};
      std::vector<Expr> found = inserted(jacobian(roots, symbols).entries);
      for (Expr& one : found) one = strength * one;
      return found;
    };
    const auto at = [&](int frame) -> Wrench& { return in_world_[static_cast<std::size_t>(frame)]; };
    for (const FrameDistance& distance : mechanism_.distances) {
      const Expr by = derivatives_by({distance.symbol}).front(), length = inserted(distance.symbol);
      // Points that are always at one place pull in no direction.
      if (by.is_zero() || length.is_zero()) continue;
      const Vec3 force = (by / length) * (origin(distance.to) - origin(distance.from));
      at(distance.to).force = at(distance.to).force + force;
      at(distance.from).force = at(distance.from).force - force;
    }
    for (const FrameSymbols& symbols : mechanism_.frame_symbols) {
      Wrench& sum = at(symbols.frame);
      if (symbols.quantity == FrameQuantity::position) {
        const std::vector<Expr> by = derivatives_by(symbols.symbols);
        sum.force = sum.force + Vec3{{by[0], by[1], by[2]}};
      } else if (symbols.quantity == FrameQuantity::rotation) {
        const std::vector<Expr> by = derivatives_by(symbols.symbols);
        const Mat3 R = rotation(symbols.frame);
        for (std::size_t c = 0; c < 3; ++c)
          sum.moment = sum.moment + cross(Vec3{{R(0, c), R(1, c), R(2, c)}}, {{by[c], by[3 + c], by[6 + c]}});
      }
    }
  }

  Vec3 origin(int frame) const {
    const std::span<const Expr> pose = pose_of(frame);
    return {{pose[3], pose[7], pose[11]}};
  }

  void add_wrench(const Force& force) {
    AppliedWrench wrench{force.frame,
                         force.frame_axes,
                         {inserted(force.torque), inserted(force.force)},
                         frame_place(force.frame, mechanism_, tree_, graph_)};
    const bool moves = std::ranges::any_of(wrench.place.motions, [&](const Motion& motion) {
      const Pose pose = moved(identity_pose(graph_), motion);
      return derivatives_.moves(pose.rotation.entries) || derivatives_.moves(pose.origin.entries);
    });
    if (wrench.place.node < 0 || moves)
      add_by_twists(wrench, Q_);
    else
      wrenches_.push_back(std::move(wrench));
  }

  /// Its power along each speed, in world axes.
  void add_by_twists(const AppliedWrench& given, std::vector<Expr>& Q) const {
    Wrench wrench = given.wrench;
    if (given.frame_axes) {
      const Mat3 R = rotation(given.frame);
      wrench = {R * wrench.moment, R * wrench.force};
    }
    for (const FrameTwist& along : frame_twists(derivatives_, pose_of(given.frame)))
      add(along.speed, dot(along.twist, wrench), Q);
  }

  /// All at once, handed from node to node towards the world.
  void add_inward(std::span<const AppliedWrench> wrenches, std::vector<Expr>& Q) const {
    std::vector<Wrench> loads(tree_.nodes.size(), zero_wrench(graph_));
    for (const AppliedWrench& given : wrenches) {
      const FramePlace& place = given.place;
      Wrench wrench = given.wrench;
      if (!given.frame_axes) {
        const Mat3 to_frame = transpose(rotation(given.frame));
        wrench = {to_frame * wrench.moment, to_frame * wrench.force};
      }
      for (std::size_t m = place.motions.size(); m-- > 0;) wrench = inward(place.motions[m], wrench);
      Wrench& load = loads[static_cast<std::size_t>(place.node)];
      load = load + wrench;
    }
    for (std::size_t i = loads.size(); i-- > 0;) {
      const MotionNode& node = tree_.nodes[i];
      for (const TwistPartial& partial : node.partials)
        add(partial.speed, power_along(node.motion, partial.direction, loads[i]), Q);
      if (node.parent < 0) continue;
      Wrench& load = loads[static_cast<std::size_t>(node.parent)];
      load = load + inward(node.motion, loads[i]);
    }
  }

  /// Wrenches by twists, or inward, or those in axes of the world by twists: whichever takes the fewest
  /// operations.
  std::vector<Expr> shortest() const {
    if (mechanism_.forces.empty()) return {};
    if (wrenches_.empty()) return value_number(Q_);
    std::vector<AppliedWrench> in_frames, in_world;
    for (const AppliedWrench& wrench : wrenches_)
      (wrench.frame_axes ? in_frames : in_world).push_back(wrench);
    std::vector<Expr> best;
    std::size_t least = 0;
    const auto offer = [&](std::span<const AppliedWrench> inward,
                           std::initializer_list<const std::vector<AppliedWrench>*> by_twists) {
      std::vector<Expr> Q = Q_;
      if (!inward.empty()) add_inward(inward, Q);
      for (const std::vector<AppliedWrench>* some : by_twists)
        for (const AppliedWrench& wrench : *some) add_by_twists(wrench, Q);
      Q = value_number(Q);
      const std::size_t operations = count_operations(Q).total();
      if (!best.empty() && operations >= least) return;
      least = operations;
      best = std::move(Q);
    };
    offer(wrenches_, {});
    offer({}, {&in_frames, &in_world});
    if (!in_frames.empty() && !in_world.empty()) offer(in_frames, {&in_world});
    return best;
  }

  void check_values(std::span<const Expr> all, const SourceLocation& where, const std::string& what) const {
    const std::vector<double> values = evaluate(all, state_values(mechanism_, graph_, 0));
    if (std::ranges::all_of(values, [](double x) { return std::isfinite(x); })) return;
    throw InputError(
        where, what +
                   " has no value at the initial state (a path between two points that coincide, the square "
                   "root of 0, a division by 0); write it another way, or choose another initial value");
  }

  const Mechanism& mechanism_;
  const MotionTree& tree_;
  const SpeedDerivatives& derivatives_;
  ExprGraph& graph_;
  std::vector<Expr> poses_;
  Values moving_, laws_;                 ///< what symbols stand for: those of frames and paths, inputs
  std::vector<Expr> Q_;                  ///< of all but ...
  std::vector<AppliedWrench> wrenches_;  ///< ... those on frames that are fixed to nodes
  Expr potential_;
  std::vector<Wrench> in_world_;  ///< on each frame, about its origin, in axes of the world
};

}  // namespace

std::vector<Expr> less_applied(std::vector<Expr> forces, const AppliedForces& applied) {
  for (std::size_t k = 0; k < applied.Q.size(); ++k) forces[k] -= applied.Q[k];
  return forces;
}

AppliedForces applied_forces(const Mechanism& mechanism, const MotionTree& tree,
                             const SpeedDerivatives& derivatives, ExprGraph& graph) {
  if (mechanism.forces.empty() && mechanism.outputs.empty() &&
      std::ranges::none_of(mechanism.parameters, &Parameter::is_state))
    return {{}, graph.zero(), {}, {}};
  return AppliedForcesBuilder(mechanism, tree, derivatives, graph).build();
}

std::vector<Wrench> applied_wrenches(const Mechanism& mechanism, const MotionTree& tree,
                                     const SpeedDerivatives& derivatives, ExprGraph& graph) {
  if (mechanism.forces.empty()) return {};
  return AppliedForcesBuilder(mechanism, tree, derivatives, graph).build_wrenches();
}

std::vector<Expr> force_contributions(const Mechanism& mechanism, const MotionTree& tree,
                                      const SpeedDerivatives& derivatives, ExprGraph& graph) {
  return AppliedForcesBuilder(mechanism, tree, derivatives, graph).build_each();
}

}  // namespace alembert
