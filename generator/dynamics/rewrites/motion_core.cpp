// Twists of a product of motions, in a finite field and as expressions (see the header).
#include "dynamics/rewrites/motion_core.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "symbolic/evaluate_modular.hpp"
#include "symbolic/modular.hpp"
#include "symbolic/simplify.hpp"
#include "symbolic/substitute.hpp"

namespace alembert {

namespace {

using Part = MotionCore::Part;
using modular::add, modular::is_zero, modular::multiply, modular::negate;

/// Vectors and matrices over the field.
using ModularVector = std::array<Modular, 3>;
using ModularMatrix = std::array<Modular, 9>;  // row by row

ModularVector plus(const ModularVector& x, const ModularVector& y) {
  return {add(x[0], y[0]), add(x[1], y[1]), add(x[2], y[2])};
}
ModularVector cross(const ModularVector& x, const ModularVector& y) {
  ModularVector out;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    out[i] = add(multiply(x[j], y[k]), negate(multiply(x[k], y[j])));
  }
  return out;
}
ModularVector times(const ModularMatrix& R, const ModularVector& x, bool transposed = false) {
  ModularVector out{};
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c)
      out[r] = add(out[r], multiply(R[transposed ? 3 * c + r : 3 * r + c], x[c]));
  }
  return out;
}
ModularMatrix times(const ModularMatrix& R, const ModularMatrix& E) {
  ModularMatrix out{};
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t k = 0; k < 3; ++k)
        out[3 * r + c] = add(out[3 * r + c], multiply(R[3 * r + k], E[3 * k + c]));
    }
  }
  return out;
}

struct ModularTwist {
  ModularVector om{}, v{};
  friend bool operator==(const ModularTwist&, const ModularTwist&) = default;
};

void append_pose(std::vector<Expr>& out, const Motion& motion, ExprGraph& graph) {
  const Pose pose = moved(identity_pose(graph), motion);
  out.insert(out.end(), pose.rotation.entries.begin(), pose.rotation.entries.end());
  out.insert(out.end(), pose.origin.entries.begin(), pose.origin.entries.end());
}

/// Twists of a product along each of `speeds`, at one point. Seen from the left they depend on the motions
/// before only, from the right on those after.
std::vector<ModularTwist> twists_at(std::span<const Part> parts, std::span<const Modular> point,
                                    std::span<const int> speeds, Side side, ExprGraph& graph) {
  std::vector<Expr> wanted;
  for (const Part& part : parts) {
    append_pose(wanted, part.motion, graph);
    for (const SpeedPartial& partial : part.partials)
      wanted.insert(wanted.end(), partial.values.begin(), partial.values.end());
  }
  const std::vector<Modular> values = evaluate_modular(wanted, point);
  struct Numbers {
    ModularMatrix E;
    ModularVector p;
    std::vector<ModularVector> directions;
  };
  std::vector<Numbers> numbers;
  const Modular* next = values.data();
  for (const Part& part : parts) {
    Numbers here;
    std::copy(next, next + 9, here.E.begin());
    next += 9;
    std::copy(next, next + 3, here.p.begin());
    next += 3;
    for (std::size_t k = 0; k < part.partials.size(); ++k, next += 3)
      here.directions.push_back({next[0], next[1], next[2]});
    numbers.push_back(std::move(here));
  }
  std::vector<ModularTwist> twists(speeds.size());
  const auto add_twists = [&](const Part& part, const Numbers& here, auto seen) {
    for (std::size_t k = 0; k < part.partials.size(); ++k) {
      ModularTwist& twist = twists[static_cast<std::size_t>(
          std::lower_bound(speeds.begin(), speeds.end(), part.partials[k].speed) - speeds.begin())];
      const bool linear = part.motion.kind == MotionKind::translation;
      const ModularTwist more =
          seen(linear ? ModularTwist{{}, here.directions[k]} : ModularTwist{here.directions[k], {}});
      twist = {plus(twist.om, more.om), plus(twist.v, more.v)};
    }
  };
  const Modular one{1, 0};
  ModularMatrix R{one, {}, {}, {}, one, {}, {}, {}, one};
  ModularVector p{};
  if (side == Side::left) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      p = plus(p, times(R, numbers[i].p));
      R = times(R, numbers[i].E);
      add_twists(parts[i], numbers[i], [&](const ModularTwist& twist) {
        const ModularVector om = times(R, twist.om);
        return ModularTwist{om, plus(times(R, twist.v), cross(p, om))};
      });
    }
  } else {
    for (std::size_t i = parts.size(); i-- > 0;) {
      add_twists(parts[i], numbers[i], [&](const ModularTwist& twist) {
        return ModularTwist{times(R, twist.om, true), times(R, plus(twist.v, cross(twist.om, p)), true)};
      });
      p = plus(numbers[i].p, times(numbers[i].E, p));
      R = times(numbers[i].E, R);
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
  std::optional<std::vector<ModularTwist>> first;
  for (const std::vector<Modular>& point : states_.points()) {
    std::vector<ModularTwist> here = twists_at(parts_, point, speeds, side, graph_);
    if (!first) {
      first = std::move(here);
      continue;
    }
    for (std::size_t k = 0; k < speeds.size(); ++k) {
      if (!((*first)[k] == here[k])) constant[k] = 0;
    }
    if (std::find(constant.begin(), constant.end(), 1) == constant.end()) break;
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
    Twist twist = zero_twist(graph_);
    for (const Part& part : *parts) {
      pose = moved(std::move(pose), part.motion);
      for (const SpeedPartial& partial : part.partials) {
        if (partial.speed != speed) continue;
        const Vec3 direction{{partial.values[0], partial.values[1], partial.values[2]}};
        twist = twist + inward(pose, twist_along(part.motion, direction));
      }
    }
    if (side == Side::right) twist = outward(pose, twist);
    std::vector<Expr> flat(twist.angular.entries.begin(), twist.angular.entries.end());
    flat.insert(flat.end(), twist.linear.entries.begin(), twist.linear.entries.end());
    const double length = states_.length();
    flat = states_.recognised(simplify(flat), std::array{1.0, 1.0, 1.0, length, length, length});
    if (!states_.finite_everywhere(flat)) continue;
    // An axis that a runtime parameter moves can get where it has no direction, or no angles to turn it by.
    if (!std::all_of(flat.begin(), flat.begin() + 3, [](Expr e) { return e.is_constant(); }))
      return std::nullopt;
    for (std::size_t i = 0; i < 3; ++i) {
      twist.angular[i] = flat[i];
      twist.linear[i] = flat[3 + i];
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
