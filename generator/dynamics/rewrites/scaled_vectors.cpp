// Scaled components of vectors (see the header).
#include "dynamics/rewrites/scaled_vectors.hpp"

#include <algorithm>
#include <cmath>

#include "symbolic/evaluate.hpp"

namespace alembert {

namespace {

constexpr double kSmallCosine = 0.05;
/// Beyond it a turn is done in full: floats have room for its square.
constexpr double kSmallestScale = 0x1p-32;

struct Axes {
  std::size_t a, i, j;
};
Axes axes_of(const Motion& motion) {
  const std::size_t a = static_cast<std::size_t>(motion.axis);
  return {a, (a + 1) % 3, (a + 2) % 3};
}

double smallest(const Scale& scale) {
  return std::min({std::abs(scale[0]), std::abs(scale[1]), std::abs(scale[2])});
}

/// The axis whose components a rotation scales for the turn ahead: the one that the turn mixes with the
/// rotation's own.
std::size_t axis_ahead(const MotionNode& rotation, const MotionNode& turn) {
  return static_cast<std::size_t>(3 - rotation.motion.axis - turn.motion.axis);
}

/// What a motion makes of a scale: a scaled turn that times `factor` / `divisor`, a moving rotation the one of its
/// second axis `ratio` times that of its first.
struct ScaleChange {
  bool scaled;
  double factor, divisor, ratio;
};
Scale scale_beyond(const MotionNode& node, Scale scale, const ScaleChange& change) {
  const Motion& motion = node.motion;
  switch (motion.kind) {
    case MotionKind::translation:
      return scale;
    case MotionKind::rotation:
      return kUnscaled;
    case MotionKind::axis_rotation:
      break;
  }
  const auto [a, i, j] = axes_of(motion);
  if (change.scaled) {
    scale[i] = change.factor * scale[i] / change.divisor;
    scale[j] = change.factor * scale[j] / change.divisor;
  } else if (!node.partials.empty()) {
    scale[j] = scale[i] * change.ratio;
  } else if (motion.cosine.is_zero()) {
    std::swap(scale[i], scale[j]);
  } else if (!motion.sine.is_zero()) {
    scale[i] = scale[j] = 1;
  }
  return scale;
}

double cosine_of(const MotionNode& turn, bool scaled) {
  return scaled ? value_of(turn.motion.cosine) : 1;
}

/// D (t x D^-1 f): the moment of a stored force, as stored.
Vec3 scaled_cross(const Vec3& t, const Vec3& f, const Scale& scale) {
  Vec3 out;
  for (std::size_t x = 0; x < 3; ++x) {
    const std::size_t y = (x + 1) % 3, z = (x + 2) % 3;
    const Expr first = times(scale[x] / scale[z], t[y]) * f[z];
    const Expr second = times(scale[x] / scale[y], t[z]) * f[y];
    out[x] = first - second;
  }
  return out;
}

}  // namespace

std::vector<int> scalable_turns(const MotionTree& tree) {
  std::vector<int> out;
  for (std::size_t k = 0; k < tree.nodes.size(); ++k) {
    const MotionNode& node = tree.nodes[k];
    const Motion& motion = node.motion;
    if (motion.kind != MotionKind::axis_rotation || !node.partials.empty()) continue;
    if (!motion.angle.is_constant() || is_quarter_turn(motion)) continue;
    if (std::abs(value_of(motion.cosine)) >= kSmallCosine) out.push_back(static_cast<int>(k));
  }
  return out;
}

Scaling::Scaling(const MotionTree& tree, const std::vector<int>& turns, const std::vector<int>& ahead)
    : nodes_(tree.nodes.size()) {
  for (const int k : turns) nodes_[static_cast<std::size_t>(k)].scaled = true;
  for (const int k : ahead) {
    const MotionNode& turn = tree.nodes[static_cast<std::size_t>(k)];
    if (!is_scaled(static_cast<std::size_t>(k)) || turn.parent < 0) continue;
    const MotionNode& before = tree.nodes[static_cast<std::size_t>(turn.parent)];
    int& its = nodes_[static_cast<std::size_t>(turn.parent)].ahead;
    if (before.motion.kind == MotionKind::axis_rotation && !before.partials.empty() &&
        before.motion.axis != turn.motion.axis && its < 0)
      its = k;
  }
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    Node& node = nodes_[k];
    node.vectors = scale_after(tree, k);
    if (node.scaled && smallest(node.vectors) < kSmallestScale) {
      node.scaled = false;
      node.vectors = scale_after(tree, k);
    }
    const int parent = tree.nodes[k].parent;
    if (tree.nodes[k].motion.kind == MotionKind::translation && parent >= 0)
      node.angular = of_angular(static_cast<std::size_t>(parent));
    scale_ahead(tree, k, node.angular);
  }
}

/// Scales the component that the turn ahead mixes with a rotation's own, if there is one.
void Scaling::scale_ahead(const MotionTree& tree, std::size_t k, Scale& own) const {
  if (!scales_ahead(k)) return;
  const MotionNode& turn = tree.nodes[static_cast<std::size_t>(of(k).ahead)];
  own[axis_ahead(tree.nodes[k], turn)] /= value_of(turn.motion.cosine);
}

Scale Scaling::scale_after(const MotionTree& tree, std::size_t k) const {
  const MotionNode& node = tree.nodes[k];
  const bool root = node.parent < 0;
  const std::size_t before = root ? 0 : static_cast<std::size_t>(node.parent);
  const Scale& parent = root ? kUnscaled : of_vectors(before);
  const bool scaled = is_scaled(k);
  Scale own = scale_beyond(node, parent, {scaled, cosine_of(node, scaled), 1, 1});
  if (scaled && !root && of(before).ahead == static_cast<int>(k)) {
    // What was divided by c ahead is as before, to the last digit.
    own[axis_ahead(tree.nodes[before], node)] = parent[static_cast<std::size_t>(node.motion.axis)];
  }
  scale_ahead(tree, k, own);
  return own;
}

Expr ScaledTurn::cosine(std::size_t k) const {
  const Expr given = motion_.cosine;
  const double ratio = parent_[k] / own_[k];
  // Where the rotation before has scaled for this turn.
  if (ratio != 1 && given.is_constant() && std::abs(ratio * value_of(given) - 1) < 1e-15)
    return given.graph().one();
  return times(ratio, given);
}

Vec3 ScaledTurn::outward(const Vec3& v) const {
  switch (motion_.kind) {
    case MotionKind::translation:
      return v;
    case MotionKind::rotation:
      return motion_.to_child(scaled_by(parent_, v));
    case MotionKind::axis_rotation:
      break;
  }
  const auto [a, i, j] = axes_of(motion_);
  Vec3 out = v;
  if (scaled_) {
    const double tangent = value_of(motion_.sine) / value_of(motion_.cosine);
    out[i] = v[i] + times(tangent * (parent_[j] / parent_[i]), v[j]);
    out[j] = v[j] - times(tangent * (parent_[i] / parent_[j]), v[i]);
    return out;
  }
  const Expr ci = cosine(i), sj = times(parent_[j] / own_[i], motion_.sine);
  const Expr cj = cosine(j), si = times(parent_[i] / own_[j], motion_.sine);
  const Expr civ = ci * v[i], sjv = sj * v[j];
  out[i] = civ + sjv;
  const Expr cjv = cj * v[j], siv = si * v[i];
  out[j] = cjv - siv;
  return out;
}

Vec3 ScaledTurn::inward(const Vec3& v) const {
  switch (motion_.kind) {
    case MotionKind::translation:
      return v;
    case MotionKind::rotation:
      return scaled_by(parent_, motion_.to_parent(scaled_by(inverse(own_), v)));
    case MotionKind::axis_rotation:
      break;
  }
  const auto [a, i, j] = axes_of(motion_);
  Vec3 out = v;
  if (scaled_) {
    const double tangent = value_of(motion_.sine) / value_of(motion_.cosine);
    out[i] = v[i] - times(tangent * (parent_[i] / parent_[j]), v[j]);
    out[j] = v[j] + times(tangent * (parent_[j] / parent_[i]), v[i]);
    return out;
  }
  const Expr ci = times(parent_[i] / own_[i], motion_.cosine), sj = times(parent_[i] / own_[j], motion_.sine);
  const Expr cj = times(parent_[j] / own_[j], motion_.cosine), si = times(parent_[j] / own_[i], motion_.sine);
  const Expr civ = ci * v[i], sjv = sj * v[j];
  out[i] = civ - sjv;
  const Expr siv = si * v[i], cjv = cj * v[j];
  out[j] = siv + cjv;
  return out;
}

Wrench ScaledTurn::inward(const Wrench& x) const {
  if (motion_.kind == MotionKind::translation)
    return {x.moment + scaled_cross(motion_.offset, x.force, own_), x.force};
  return {inward(x.moment), inward(x.force)};
}

Scale carried_inward(const MotionNode& node, bool scaled, const Scale& scale, const Scale& parent,
                     bool begun) {
  const bool divides = scaled && begun;
  double ratio = 1;
  if (begun && node.motion.kind == MotionKind::axis_rotation) {
    const auto [a, i, j] = axes_of(node.motion);
    ratio = parent[j] / parent[i];
  }
  return scale_beyond(node, scale, {divides, 1, cosine_of(node, divides), ratio});
}

Expr times(double factor, Expr x) {
  return factor == 1 || x.is_zero() ? x : x.graph().real(factor) * x;
}

Vec3 scaled_by(const Scale& factor, const Vec3& v) {
  Vec3 out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = times(factor[k], v[k]);
  return out;
}

Scale inverse(const Scale& scale) {
  return {1 / scale[0], 1 / scale[1], 1 / scale[2]};
}

}  // namespace alembert
