// Peels screws off the products of motions (see the header).
#include "dynamics/rewrites/screw_peeling.hpp"

#include <algorithm>
#include <array>

#include "dynamics/rewrites/motion_core.hpp"
#include "dynamics/rewrites/peeling_states.hpp"
#include "dynamics/tree/constant_motions.hpp"
#include "symbolic/simplify.hpp"

namespace alembert {

namespace {

/// Peels the screws off one product of motions.
class Peeler {
 public:
  Peeler(const std::vector<Motion>& motions, const Mechanism& mechanism, const SpeedDerivatives& derivatives,
         ExprGraph& graph)
      : given_(motions),
        derivatives_(derivatives),
        graph_(graph),
        states_(mechanism, motions, graph),
        core_(motions, mechanism, derivatives, graph, states_) {
    for (const Coordinate& coordinate : mechanism.coordinates) {
      for (int k = 0; k < coordinate.nv(); ++k) {
        variables_.push_back(coordinate.type == CoordinateType::real ? coordinate.symbols[0] : Expr());
      }
    }
    variables_.push_back(mechanism.time);
  }

  std::optional<std::vector<Motion>> run() {
    if (is_plain()) return std::nullopt;
    while (peel_one()) {
    }
    if (left_.empty() && right_.empty()) return std::nullopt;
    std::vector<Motion> out;
    for (const Motion& motion : left_) append_motion(out, motion, graph_);
    for (const MotionCore::Part& part : core_.parts()) append_motion(out, part.motion, graph_);
    for (auto motion = right_.rbegin(); motion != right_.rend(); ++motion)
      append_motion(out, *motion, graph_);
    out = gathered_constants(out, derivatives_, states_.length(), graph_);
    if (!states_.agree(given_, out)) return std::nullopt;
    return out;
  }

 private:
  /// Whether every moving motion is a plane rotation or a shift in a constant direction, each of
  /// coordinates of its own.
  bool is_plain() const {
    std::vector<int> seen;
    for (const MotionCore::Part& part : core_.parts()) {
      const Motion& motion = part.motion;
      for (const SpeedPartial& partial : part.partials) {
        if (std::find(seen.begin(), seen.end(), partial.speed) != seen.end()) return false;
        if (motion.kind == MotionKind::rotation && motion.quaternion < 0) return false;
        if (motion.kind == MotionKind::translation &&
            !std::all_of(partial.values.begin(), partial.values.end(),
                         [](Expr e) { return e.is_constant(); }))
          return false;
      }
      for (const SpeedPartial& partial : part.partials) seen.push_back(partial.speed);
    }
    return true;
  }

  /// exp(xi (q - reference)) as motions, left to right.
  std::vector<Motion> screw(const Twist& twist, Expr travel) const {
    std::vector<Motion> out;
    if (twist.angular == zeros<3, 1>(graph_)) {
      out.push_back(translation_motion(travel * twist.linear));
      return out;
    }
    const Expr square = dot(twist.angular, twist.angular);
    const Expr pitch = dot(twist.angular, twist.linear) / square;
    std::vector<Expr> flat;
    const Vec3 across = cross(twist.angular, twist.linear);
    for (std::size_t i = 0; i < 3; ++i) flat.push_back(across[i] / square);
    for (std::size_t i = 0; i < 3; ++i) flat.push_back(pitch * twist.angular[i]);
    flat.push_back(sqrt(square));
    const double length = states_.length();
    flat =
        states_.recognised(simplify(flat), std::array{length, length, length, length, length, length, 1.0});
    const Vec3 point{{flat[0], flat[1], flat[2]}}, slide{{flat[3], flat[4], flat[5]}};
    const Expr rate = flat[6];

    append_motion(out, translation_motion(point + travel * slide), graph_);
    const auto nonzero = [&](std::size_t i) { return !twist.angular[i].is_zero(); };
    const int axes = nonzero(0) + nonzero(1) + nonzero(2);
    if (axes == 1) {
      const std::size_t axis = nonzero(0) ? 0 : nonzero(1) ? 1 : 2;
      append_motion(out, axis_rotation_motion(static_cast<int>(axis), twist.angular[axis] * travel), graph_);
    } else {
      // The axis is turned into z and back.
      std::vector<Motion> to_z =
          turned_to_z({{twist.angular[0] / rate, twist.angular[1] / rate, twist.angular[2] / rate}}, graph_);
      for (const Motion& motion : to_z) append_motion(out, motion, graph_);
      append_motion(out, axis_rotation_motion(2, rate * travel), graph_);
      for (auto motion = to_z.rbegin(); motion != to_z.rend(); ++motion)
        append_motion(out, motion->inverse(), graph_);
    }
    append_motion(out, translation_motion(graph_.integer(-1) * point), graph_);
    return out;
  }

  bool peel_one() {
    const std::vector<int> speeds = core_.moving_speeds();
    if (speeds.empty()) return false;
    for (const Side side : {Side::left, Side::right}) {
      const std::vector<char> constant = core_.constant_twists(speeds, side);
      for (std::size_t k = 0; k < speeds.size(); ++k) {
        const Expr variable = variables_[static_cast<std::size_t>(speeds[k])];
        if (!constant[k] || !variable.valid()) continue;
        if (peel(speeds[k], variable, side)) return true;
      }
    }
    return false;
  }

  bool peel(int speed, Expr variable, Side side) {
    const std::optional<Twist> twist = core_.constant_twist(speed, side);
    if (!twist) return false;
    for (const Expr& reference : core_.reference_values()) {
      if (!core_.hold(variable, reference)) continue;
      const std::vector<Motion> screws = screw(*twist, variable - reference);
      if (side == Side::left) {
        left_.insert(left_.end(), screws.begin(), screws.end());
      } else {
        right_.insert(right_.end(), screws.rbegin(), screws.rend());
      }
      return true;
    }
    return false;
  }

  const std::vector<Motion>& given_;
  const SpeedDerivatives& derivatives_;
  ExprGraph& graph_;
  PeelingStates states_;
  MotionCore core_;
  std::vector<Expr> variables_;       ///< by speed; none for the speeds of a quaternion
  std::vector<Motion> left_, right_;  ///< peeled, from the outside in
};

}  // namespace

std::optional<std::vector<Motion>> peeled_motions(const std::vector<Motion>& motions,
                                                  const Mechanism& mechanism,
                                                  const SpeedDerivatives& derivatives, ExprGraph& graph) {
  return Peeler(motions, mechanism, derivatives, graph).run();
}

}  // namespace alembert
