// Peels screws off the products of motions (see the header).
#include "dynamics/screw_peeling.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "dynamics/constant_motions.hpp"
#include "dynamics/state_checks.hpp"
#include "symbolic/passes.hpp"

namespace alembert {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kSame = 1e-10;         ///< twists at two states, relative
constexpr double kSameProduct = 1e-11;  ///< products of motions at a state, relative
constexpr unsigned kGroups = 3;         ///< draws of the runtime parameters
constexpr unsigned kDraws = 4;          ///< states a draw of them

/// Random states in groups that share the runtime parameters.
std::vector<std::vector<std::vector<double>>> random_states(const Mechanism& mechanism, ExprGraph& graph) {
  std::vector<std::vector<std::vector<double>>> groups;
  for (unsigned group = 0; group < kGroups; ++group) {
    std::vector<std::vector<double>> states;
    std::vector<double> draw;  // in [-1, 1), one for each symbol
    for (unsigned k = 0; k < kDraws; ++k) {
      std::vector<double> state = state_values(mechanism, graph, 101 + 17 * group + k);
      if (k == 0) draw = state_values(mechanism, graph, 501 + group);
      const auto time = graph.symbol_index(mechanism.time.ref().node());
      state[time] = 0.3 + 0.21 * (4 * group + k);
      std::size_t p = 0;
      for (const Parameter& parameter : mechanism.parameters) {
        if (!parameter.runtime) continue;
        const Coordinate& any = mechanism.coordinates[p++ % mechanism.coordinates.size()];
        const double x =
            std::sin(draw[graph.symbol_index(any.symbols[0].ref().node())] + static_cast<double>(p));
        const auto index = graph.symbol_index(graph.symbol(parameter.name).ref().node());
        state[index] = parameter.value * (1 + 0.1 * x);
        if (parameter.value == 0) state[index] = 0.1 * x;
      }
      states.push_back(std::move(state));
    }
    groups.push_back(std::move(states));
  }
  return groups;
}

struct NumericTwist {
  Vector3d om = Vector3d::Zero(), v = Vector3d::Zero();
};
struct SymbolicTwist {
  Vec3 om, v;
};

/// One motion with the derivatives along the speeds (time among them).
struct Part {
  Motion motion;
  std::vector<SpeedPartial> partials;
};

enum class Side { left, right };

class Peeler {
 public:
  Peeler(const Mechanism& mechanism, const SpeedDerivatives& derivatives, ExprGraph& graph)
      : mechanism_(mechanism),
        derivatives_(derivatives),
        graph_(graph),
        groups_(random_states(mechanism, graph)) {
    for (const Coordinate& coordinate : mechanism.coordinates) {
      for (int k = 0; k < coordinate.nv(); ++k) {
        variables_.push_back(coordinate.type == CoordinateType::real ? coordinate.symbols[0] : Expr());
      }
    }
    variables_.push_back(mechanism.time);
  }

  std::optional<std::vector<Motion>> run(const std::vector<Motion>& motions) {
    for (const Motion& motion : motions)
      core_.push_back({motion, twist_partials(motion, mechanism_, derivatives_, graph_)});
    if (is_plain() || has_pieces()) return std::nullopt;
    while (peel_one()) {
    }
    if (left_.empty() && right_.empty()) return std::nullopt;
    std::vector<Motion> out;
    for (const Motion& motion : left_) append_motion(out, motion, graph_);
    for (const Part& part : core_) append_motion(out, part.motion, graph_);
    for (auto motion = right_.rbegin(); motion != right_.rend(); ++motion)
      append_motion(out, *motion, graph_);
    out = gathered_constants(out, derivatives_, graph_);
    if (!equal(motions, out)) return std::nullopt;
    return out;
  }

 private:
  /// Whether every moving motion is a plane rotation or a shift in a constant direction, each of coordinates
  /// of its own.
  bool is_plain() const {
    std::vector<int> seen;
    for (const Part& part : core_) {
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

  /// Whether a function that is put together from pieces, such as a spline, is in the motions: states near
  /// the initial one show some of its pieces only.
  bool has_pieces() const {
    std::vector<Expr> poses;
    for (const Part& part : core_) append_pose(poses, part.motion);
    const std::vector<std::uint32_t> nodes = postorder(poses);
    return std::any_of(nodes.begin(), nodes.end(),
                       [&](std::uint32_t id) { return graph_.node(id).op == Op::sign; });
  }

  std::vector<int> moving_speeds() const {
    std::vector<int> speeds;
    for (const Part& part : core_) {
      for (const SpeedPartial& partial : part.partials) speeds.push_back(partial.speed);
    }
    std::sort(speeds.begin(), speeds.end());
    speeds.erase(std::unique(speeds.begin(), speeds.end()), speeds.end());
    return speeds;
  }

  /// Twists of the whole core along each of `speeds`, at one state. Nothing if one is not finite.
  std::optional<std::vector<NumericTwist>> twists_at(std::span<const double> state,
                                                     std::span<const int> speeds, Side side) const {
    std::vector<Expr> wanted;
    for (const Part& part : core_) {
      append_pose(wanted, part.motion);
      for (const SpeedPartial& partial : part.partials)
        wanted.insert(wanted.end(), partial.values.begin(), partial.values.end());
    }
    const std::vector<double> values = evaluate(wanted, state);
    if (!std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); }))
      return std::nullopt;
    std::vector<NumericTwist> twists(speeds.size());
    Matrix3d R = Matrix3d::Identity();
    Vector3d p = Vector3d::Zero();
    const double* next = values.data();
    const auto vector = [&] {
      const Vector3d v(next[0], next[1], next[2]);
      next += 3;
      return v;
    };
    for (const Part& part : core_) {
      Matrix3d E;
      for (int r = 0; r < 3; ++r) E.row(r) = vector().transpose();
      p += R * vector();
      R = R * E;
      for (const SpeedPartial& partial : part.partials) {
        NumericTwist& twist = twists[static_cast<std::size_t>(
            std::lower_bound(speeds.begin(), speeds.end(), partial.speed) - speeds.begin())];
        const Vector3d d = R * vector();
        if (part.motion.kind == MotionKind::translation) {
          twist.v += d;
        } else {
          twist.om += d;
          twist.v += p.cross(d);
        }
      }
    }
    if (side == Side::right) {
      for (NumericTwist& twist : twists) {
        twist.v = R.transpose() * (twist.v - p.cross(twist.om));
        twist.om = R.transpose() * twist.om;
      }
    }
    return twists;
  }

  /// Which of `speeds` have one twist in all states (for each draw of the runtime parameters).
  std::vector<char> constant_twists(std::span<const int> speeds, Side side) const {
    std::vector<char> constant(speeds.size(), 1);
    for (const auto& group : groups_) {
      std::optional<std::vector<NumericTwist>> first;
      std::size_t finite = 0;
      for (const std::vector<double>& state : group) {
        const auto here = twists_at(state, speeds, side);
        if (!here) continue;
        ++finite;
        if (!first) first = here;
        for (std::size_t k = 0; k < speeds.size(); ++k) {
          const NumericTwist &x = (*first)[k], &y = (*here)[k];
          const double size = std::max({1e-3, x.om.norm(), x.v.norm()});
          if ((x.om - y.om).norm() > kSame * size || (x.v - y.v).norm() > kSame * size) constant[k] = 0;
        }
      }
      if (finite < 2) return std::vector<char>(speeds.size(), 0);
    }
    return constant;
  }

  void append_pose(std::vector<Expr>& out, const Motion& motion) const {
    const Pose pose = moved(identity_pose(graph_), motion);
    out.insert(out.end(), pose.rotation.entries.begin(), pose.rotation.entries.end());
    out.insert(out.end(), pose.origin.entries.begin(), pose.origin.entries.end());
  }

  /// Values at which a coordinate may be held: those that keep constants exact first.
  std::vector<Expr> reference_values() const {
    return {graph_.zero(), graph_.pi(Rational(1, 2)), graph_.pi(Rational(1, 4)),
            graph_.rational(Rational(3, 10))};
  }

  /// The core with coordinates replaced; nothing where it has no value then.
  std::optional<std::vector<Part>> held(std::span<const std::pair<Expr, Expr>> replacements,
                                        bool partials) const {
    std::vector<Part> out = core_;
    try {
      for (Part& part : out) {
        Motion& motion = part.motion;
        std::vector<Expr> values;
        append_parts(values, motion);
        const std::size_t own = values.size();
        for (const SpeedPartial& partial : part.partials)
          values.insert(values.end(), partial.values.begin(), partial.values.end());
        std::vector<Expr> replaced = substitute(values, replacements);
        if (replaced != values) replaced = simplify(replaced);
        if (std::equal(replaced.begin(), replaced.begin() + static_cast<std::ptrdiff_t>(own),
                       values.begin()) &&
            (!partials || replaced == values))
          continue;
        std::size_t at = 0;
        take_parts(replaced, at, motion);
        for (SpeedPartial& partial : part.partials) {
          for (Expr& e : partial.values) e = replaced[at++];
        }
        if (!partials) part.partials = twist_partials(motion, mechanism_, derivatives_, graph_);
      }
    } catch (const std::domain_error&) {
      return std::nullopt;
    }
    return out;
  }

  static void append_parts(std::vector<Expr>& out, const Motion& motion) {
    switch (motion.kind) {
      case MotionKind::translation:
        out.insert(out.end(), motion.offset.entries.begin(), motion.offset.entries.end());
        break;
      case MotionKind::axis_rotation:
        out.push_back(motion.angle);
        break;
      case MotionKind::rotation:
        out.insert(out.end(), motion.matrix.entries.begin(), motion.matrix.entries.end());
        if (motion.fixed_axis) out.push_back(motion.angle);
        break;
    }
  }
  static void take_parts(const std::vector<Expr>& values, std::size_t& at, Motion& motion) {
    switch (motion.kind) {
      case MotionKind::translation:
        for (Expr& e : motion.offset.entries) e = values[at++];
        break;
      case MotionKind::axis_rotation:
        motion.angle = values[at++];
        motion.cosine = cos(motion.angle);
        motion.sine = sin(motion.angle);
        break;
      case MotionKind::rotation:
        for (Expr& e : motion.matrix.entries) e = values[at++];
        if (motion.fixed_axis) motion.angle = values[at++];
        break;
    }
  }

  /// The constant twist along a speed, from the expressions with every coordinate held.
  std::optional<SymbolicTwist> constant_twist(int speed, Side side) const {
    for (const Expr& reference : reference_values()) {
      std::vector<std::pair<Expr, Expr>> replacements;
      for (const Coordinate& coordinate : mechanism_.coordinates) {
        for (std::size_t a = 0; a < coordinate.symbols.size(); ++a) {
          const bool real = coordinate.type == CoordinateType::real;
          replacements.emplace_back(coordinate.symbols[a], real     ? reference
                                                           : a == 3 ? graph_.one()
                                                                    : graph_.zero());
        }
      }
      replacements.emplace_back(mechanism_.time, reference);
      const auto parts = held(replacements, true);
      if (!parts) continue;
      Pose pose = identity_pose(graph_);
      SymbolicTwist twist{zeros<3, 1>(graph_), zeros<3, 1>(graph_)};
      for (const Part& part : *parts) {
        pose = moved(std::move(pose), part.motion);
        for (const SpeedPartial& partial : part.partials) {
          if (partial.speed != speed) continue;
          const Vec3 d = pose.rotation * Vec3{{partial.values[0], partial.values[1], partial.values[2]}};
          if (part.motion.kind == MotionKind::translation) {
            twist.v = twist.v + d;
          } else {
            twist.om = twist.om + d;
            twist.v = twist.v + cross(pose.origin, d);
          }
        }
      }
      if (side == Side::right) {
        const Mat3 back = transpose(pose.rotation);
        twist.v = back * (twist.v - cross(pose.origin, twist.om));
        twist.om = back * twist.om;
      }
      std::vector<Expr> flat(twist.om.entries.begin(), twist.om.entries.end());
      flat.insert(flat.end(), twist.v.entries.begin(), twist.v.entries.end());
      flat = recognised(simplify(flat));
      if (!finite_everywhere(flat)) continue;
      // An axis that a runtime parameter moves can get where it has no direction, or no angles to turn it by.
      if (!std::all_of(flat.begin(), flat.begin() + 3, [](Expr e) { return e.is_constant(); }))
        return std::nullopt;
      for (std::size_t i = 0; i < 3; ++i) {
        twist.om[i] = flat[i];
        twist.v[i] = flat[3 + i];
      }
      return twist;
    }
    return std::nullopt;
  }

  bool finite_everywhere(std::span<const Expr> values) const {
    return std::all_of(groups_.begin(), groups_.end(), [&](const auto& group) {
      const std::vector<double> here = evaluate(values, group[0]);
      return std::all_of(here.begin(), here.end(), [](double x) { return std::isfinite(x); });
    });
  }

  /// What is zero for every draw of the parameters up to rounding is zero; numbers that are short fractions
  /// are these.
  std::vector<Expr> recognised(std::vector<Expr> values) const {
    std::vector<double> size(values.size(), 0);
    for (const auto& group : groups_) {
      const std::vector<double> here = evaluate(values, group[0]);
      for (std::size_t i = 0; i < values.size(); ++i) size[i] = std::max(size[i], std::abs(here[i]));
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (size[i] < 1e-14)
        values[i] = graph_.zero();
      else if (values[i].is_constant())
        values[i] = short_number(values[i]);
    }
    return values;
  }

  /// exp(xi (q - reference)) as motions, left to right.
  std::vector<Motion> screw(const SymbolicTwist& twist, Expr travel) const {
    std::vector<Motion> out;
    if (twist.om == zeros<3, 1>(graph_)) {
      out.push_back(translation_motion(travel * twist.v));
      return out;
    }
    const Expr square = dot(twist.om, twist.om);
    const Expr pitch = dot(twist.om, twist.v) / square;
    std::vector<Expr> flat;
    const Vec3 across = cross(twist.om, twist.v);
    for (std::size_t i = 0; i < 3; ++i) flat.push_back(across[i] / square);
    for (std::size_t i = 0; i < 3; ++i) flat.push_back(pitch * twist.om[i]);
    flat.push_back(sqrt(square));
    flat = recognised(simplify(flat));
    const Vec3 point{{flat[0], flat[1], flat[2]}}, slide{{flat[3], flat[4], flat[5]}};
    const Expr rate = flat[6];

    append_motion(out, translation_motion(point + travel * slide), graph_);
    const auto nonzero = [&](std::size_t i) { return !twist.om[i].is_zero(); };
    const int axes = nonzero(0) + nonzero(1) + nonzero(2);
    if (axes == 1) {
      const std::size_t axis = nonzero(0) ? 0 : nonzero(1) ? 1 : 2;
      append_motion(out, axis_rotation_motion(static_cast<int>(axis), twist.om[axis] * travel), graph_);
    } else {
      // The axis is turned into z and back.
      std::vector<Motion> to_z =
          turned_to_z({{twist.om[0] / rate, twist.om[1] / rate, twist.om[2] / rate}}, graph_);
      for (const Motion& motion : to_z) append_motion(out, motion, graph_);
      append_motion(out, axis_rotation_motion(2, rate * travel), graph_);
      for (auto motion = to_z.rbegin(); motion != to_z.rend(); ++motion)
        append_motion(out, motion->inverse(), graph_);
    }
    append_motion(out, translation_motion(graph_.integer(-1) * point), graph_);
    return out;
  }

  bool peel_one() {
    const std::vector<int> speeds = moving_speeds();
    if (speeds.empty()) return false;
    for (const Side side : {Side::left, Side::right}) {
      const std::vector<char> constant = constant_twists(speeds, side);
      for (std::size_t k = 0; k < speeds.size(); ++k) {
        const Expr variable = variables_[static_cast<std::size_t>(speeds[k])];
        if (!constant[k] || !variable.valid()) continue;
        if (peel(speeds[k], variable, side)) return true;
      }
    }
    return false;
  }

  bool peel(int speed, Expr variable, Side side) {
    const std::optional<SymbolicTwist> twist = constant_twist(speed, side);
    if (!twist) return false;
    for (const Expr& reference : reference_values()) {
      const std::array<std::pair<Expr, Expr>, 1> replacement{{{variable, reference}}};
      auto rest = held(replacement, false);
      if (!rest) continue;
      std::vector<Expr> poses;
      for (const Part& part : *rest) append_pose(poses, part.motion);
      if (!finite_everywhere(poses)) continue;
      std::vector<Motion> screws = screw(*twist, variable - reference);
      core_ = std::move(*rest);
      if (side == Side::left) {
        left_.insert(left_.end(), screws.begin(), screws.end());
      } else {
        right_.insert(right_.end(), screws.rbegin(), screws.rend());
      }
      return true;
    }
    return false;
  }

  /// Whether two products of motions agree at all random states at which the first has a value.
  bool equal(const std::vector<Motion>& given, const std::vector<Motion>& other) const {
    const auto product = [&](const std::vector<Motion>& motions, std::vector<Expr>& out) {
      Pose pose = identity_pose(graph_);
      for (const Motion& motion : motions) pose = moved(std::move(pose), motion);
      out.insert(out.end(), pose.rotation.entries.begin(), pose.rotation.entries.end());
      out.insert(out.end(), pose.origin.entries.begin(), pose.origin.entries.end());
    };
    std::vector<Expr> entries;
    product(given, entries);
    product(other, entries);
    const std::size_t half = entries.size() / 2;
    for (const auto& group : groups_) {
      for (const std::vector<double>& state : group) {
        const std::vector<double> x = evaluate(entries, state);
        double size = 1;
        bool finite = true;
        for (std::size_t i = 0; i < half; ++i) {
          finite = finite && std::isfinite(x[i]);
          size = std::max(size, std::abs(x[i]));
        }
        if (!finite) continue;
        for (std::size_t i = 0; i < half; ++i) {
          if (!(std::abs(x[i] - x[half + i]) <= kSameProduct * size)) return false;
        }
      }
    }
    return true;
  }

  const Mechanism& mechanism_;
  const SpeedDerivatives& derivatives_;
  ExprGraph& graph_;
  std::vector<std::vector<std::vector<double>>> groups_;
  std::vector<Expr> variables_;       ///< by speed; none for the speeds of a quaternion
  std::vector<Motion> left_, right_;  ///< peeled, from the outside in
  std::vector<Part> core_;
};

}  // namespace

std::optional<std::vector<Motion>> peeled_motions(const std::vector<Motion>& motions,
                                                  const Mechanism& mechanism,
                                                  const SpeedDerivatives& derivatives, ExprGraph& graph) {
  return Peeler(mechanism, derivatives, graph).run(motions);
}

}  // namespace alembert
