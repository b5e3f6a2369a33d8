// Twists of a product of motions, with numbers and with expressions (see the header).
#include "dynamics/motion_core.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "symbolic/passes.hpp"

namespace alembert {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Part = MotionCore::Part;

constexpr double kSame = 1e-10;  ///< twists at two states, relative

struct NumericTwist {
  Vector3d om = Vector3d::Zero(), v = Vector3d::Zero();
  double om_size = 0, v_size = 0;  ///< of all that they are sums of: what rounding is relative to
};

void append_pose(std::vector<Expr>& out, const Motion& motion, ExprGraph& graph) {
  const Pose pose = moved(identity_pose(graph), motion);
  out.insert(out.end(), pose.rotation.entries.begin(), pose.rotation.entries.end());
  out.insert(out.end(), pose.origin.entries.begin(), pose.origin.entries.end());
}

/// Twists of a product along each of `speeds`, at one state. Nothing if one is not finite.
std::optional<std::vector<NumericTwist>> twists_at(std::span<const Part> parts, std::span<const double> state,
                                                   std::span<const int> speeds, Side side, ExprGraph& graph) {
  std::vector<Expr> wanted;
  for (const Part& part : parts) {
    append_pose(wanted, part.motion, graph);
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
  for (const Part& part : parts) {
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
        twist.v_size += d.norm();
      } else {
        twist.om += d;
        twist.om_size += d.norm();
        twist.v += p.cross(d);
        twist.v_size += p.norm() * d.norm();
      }
    }
  }
  if (side == Side::right) {
    for (NumericTwist& twist : twists) {
      twist.v = R.transpose() * (twist.v - p.cross(twist.om));
      twist.v_size += p.norm() * twist.om_size;
      twist.om = R.transpose() * twist.om;
    }
  }
  return twists;
}

void append_parts(std::vector<Expr>& out, const Motion& motion) {
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

void take_parts(const std::vector<Expr>& values, std::size_t& at, Motion& motion) {
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

}  // namespace

MotionCore::MotionCore(const std::vector<Motion>& motions, const Mechanism& mechanism,
                       const SpeedDerivatives& derivatives, ExprGraph& graph, const PeelingStates& states)
    : mechanism_(mechanism), derivatives_(derivatives), graph_(graph), states_(states) {
  for (const Motion& motion : motions)
    parts_.push_back({motion, twist_partials(motion, mechanism, derivatives, graph)});
}

std::vector<int> MotionCore::moving_speeds() const {
  std::vector<int> speeds;
  for (const Part& part : parts_) {
    for (const SpeedPartial& partial : part.partials) speeds.push_back(partial.speed);
  }
  std::sort(speeds.begin(), speeds.end());
  speeds.erase(std::unique(speeds.begin(), speeds.end()), speeds.end());
  return speeds;
}

std::vector<Expr> MotionCore::poses(std::span<const Part> parts) const {
  std::vector<Expr> out;
  for (const Part& part : parts) append_pose(out, part.motion, graph_);
  return out;
}

std::vector<char> MotionCore::constant_twists(std::span<const int> speeds, Side side) const {
  std::vector<char> constant(speeds.size(), 1);
  for (const auto& group : states_.groups()) {
    std::optional<std::vector<NumericTwist>> first;
    std::size_t finite = 0;
    for (const std::vector<double>& state : group) {
      const auto here = twists_at(parts_, state, speeds, side, graph_);
      if (!here) continue;
      ++finite;
      if (!first) first = here;
      for (std::size_t k = 0; k < speeds.size(); ++k) {
        const NumericTwist &x = (*first)[k], &y = (*here)[k];
        const double om_size = std::max(1e-3, x.om_size);
        const double v_size = std::max(1e-3 * states_.length(), x.v_size);
        if ((x.om - y.om).norm() > kSame * om_size || (x.v - y.v).norm() > kSame * v_size) constant[k] = 0;
      }
    }
    if (finite < 2) return std::vector<char>(speeds.size(), 0);
  }
  return constant;
}

std::vector<Expr> MotionCore::reference_values() const {
  return {graph_.zero(), graph_.pi(Rational(1, 2)), graph_.pi(Rational(1, 4)),
          graph_.rational(Rational(3, 10))};
}

/// The motions with coordinates replaced; nothing where one has no value then. With `partials` those of the
/// derivatives are replaced, else they are made anew.
std::optional<std::vector<Part>> MotionCore::held(std::span<const std::pair<Expr, Expr>> replacements,
                                                  bool partials) const {
  std::vector<Part> out = parts_;
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
      if (std::equal(replaced.begin(), replaced.begin() + static_cast<std::ptrdiff_t>(own), values.begin()) &&
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

std::optional<Twist> MotionCore::constant_twist(int speed, Side side) const {
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
    Twist twist{zeros<3, 1>(graph_), zeros<3, 1>(graph_)};
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
    const double length = states_.length();
    flat = states_.recognised(simplify(flat), std::array{1.0, 1.0, 1.0, length, length, length});
    if (!states_.finite_everywhere(flat)) continue;
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

bool MotionCore::hold(Expr variable, Expr reference) {
  const std::array<std::pair<Expr, Expr>, 1> replacement{{{variable, reference}}};
  auto rest = held(replacement, false);
  if (!rest || !states_.finite_everywhere(poses(*rest))) return false;
  parts_ = std::move(*rest);
  return true;
}

}  // namespace alembert
