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

/// Scales that component for the turn ahead, if there is one.
void scale_ahead(const MotionTree& tree, const MotionNode& rotation, Scale& own) {
  if (rotation.ahead < 0) return;
  const MotionNode& turn = tree.nodes[static_cast<std::size_t>(rotation.ahead)];
  own[axis_ahead(rotation, turn)] /= value_of(turn.motion.cosine);
}

/// Whether a turn is the one that the rotation before it has scaled for.
bool is_expected(const MotionTree& tree, std::size_t k) {
  const int before = tree.nodes[k].parent;
  return before >= 0 && tree.nodes[static_cast<std::size_t>(before)].ahead == static_cast<int>(k);
}

Scale scale_after(const MotionTree& tree, std::size_t k, const Scale& parent) {
  const MotionNode& node = tree.nodes[k];
  const Motion& motion = node.motion;
  switch (motion.kind) {
    case MotionKind::translation:
      return parent;
    case MotionKind::rotation:
      return kUnscaled;
    case MotionKind::axis_rotation:
      break;
  }
  const auto [a, i, j] = axes_of(motion);
  Scale own = parent;
  if (node.scaled) {
    const double c = value_of(motion.cosine);
    own[i] = c * parent[i];
    own[j] = c * parent[j];
    // What was divided by c ahead is as before, to the last digit.
    if (is_expected(tree, k))
      own[axis_ahead(tree.nodes[static_cast<std::size_t>(node.parent)], node)] = parent[a];
  } else if (!node.partials.empty()) {
    own[j] = own[i];
    scale_ahead(tree, node, own);
  } else if (motion.cosine.is_zero()) {
    std::swap(own[i], own[j]);
  } else if (!motion.sine.is_zero()) {
    own[i] = own[j] = 1;
  }
  return own;
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

void mark_scaled(MotionTree& tree, const std::vector<int>& turns, const std::vector<int>& ahead) {
  for (MotionNode& node : tree.nodes) {
    node.scaled = false;
    node.ahead = -1;
  }
  for (const int k : turns) tree.nodes[static_cast<std::size_t>(k)].scaled = true;
  for (const int k : ahead) {
    const MotionNode& turn = tree.nodes[static_cast<std::size_t>(k)];
    if (!turn.scaled || turn.parent < 0) continue;
    MotionNode& before = tree.nodes[static_cast<std::size_t>(turn.parent)];
    if (before.motion.kind == MotionKind::axis_rotation && !before.partials.empty() &&
        before.motion.axis != turn.motion.axis && before.ahead < 0)
      before.ahead = k;
  }
  std::vector<Scale> scales;
  for (std::size_t k = 0; k < tree.nodes.size(); ++k) {
    MotionNode& node = tree.nodes[k];
    const Scale& parent = node.parent < 0 ? kUnscaled : scales[static_cast<std::size_t>(node.parent)];
    Scale own = scale_after(tree, k, parent);
    if (node.scaled && smallest(own) < kSmallestScale) {
      node.scaled = false;
      own = scale_after(tree, k, parent);
    }
    scales.push_back(own);
  }
}

std::vector<Scale> node_scales(const MotionTree& tree) {
  std::vector<Scale> scales;
  for (std::size_t k = 0; k < tree.nodes.size(); ++k) {
    const int parent = tree.nodes[k].parent;
    scales.push_back(scale_after(tree, k, parent < 0 ? kUnscaled : scales[static_cast<std::size_t>(parent)]));
  }
  return scales;
}

std::vector<Scale> angular_scales(const MotionTree& tree) {
  std::vector<Scale> scales;
  for (const MotionNode& node : tree.nodes) {
    Scale own = kUnscaled;
    if (node.motion.kind == MotionKind::translation && node.parent >= 0)
      own = scales[static_cast<std::size_t>(node.parent)];
    scale_ahead(tree, node, own);
    scales.push_back(own);
  }
  return scales;
}

Expr ScaledTurn::cosine(std::size_t k) const {
  const Expr given = node_.motion.cosine;
  const double ratio = parent_[k] / own_[k];
  // Where the rotation before has scaled for this turn.
  if (ratio != 1 && given.is_constant() && std::abs(ratio * value_of(given) - 1) < 1e-15)
    return given.graph().one();
  return times(ratio, given);
}

Vec3 ScaledTurn::outward(const Vec3& v) const {
  const Motion& motion = node_.motion;
  switch (motion.kind) {
    case MotionKind::translation:
      return v;
    case MotionKind::rotation:
      return motion.to_child(scaled_by(parent_, v));
    case MotionKind::axis_rotation:
      break;
  }
  const auto [a, i, j] = axes_of(motion);
  Vec3 out = v;
  if (scaled_) {
    const double tangent = value_of(motion.sine) / value_of(motion.cosine);
    out[i] = v[i] + times(tangent * (parent_[j] / parent_[i]), v[j]);
    out[j] = v[j] - times(tangent * (parent_[i] / parent_[j]), v[i]);
    return out;
  }
  const Expr ci = cosine(i), sj = times(parent_[j] / own_[i], motion.sine);
  const Expr cj = cosine(j), si = times(parent_[i] / own_[j], motion.sine);
  const Expr civ = ci * v[i], sjv = sj * v[j];
  out[i] = civ + sjv;
  const Expr cjv = cj * v[j], siv = si * v[i];
  out[j] = cjv - siv;
  return out;
}

Vec3 ScaledTurn::inward(const Vec3& v) const {
  const Motion& motion = node_.motion;
  switch (motion.kind) {
    case MotionKind::translation:
      return v;
    case MotionKind::rotation:
      return scaled_by(parent_, motion.to_parent(scaled_by(inverse(own_), v)));
    case MotionKind::axis_rotation:
      break;
  }
  const auto [a, i, j] = axes_of(motion);
  Vec3 out = v;
  if (scaled_) {
    const double tangent = value_of(motion.sine) / value_of(motion.cosine);
    out[i] = v[i] - times(tangent * (parent_[i] / parent_[j]), v[j]);
    out[j] = v[j] + times(tangent * (parent_[j] / parent_[i]), v[i]);
    return out;
  }
  const Expr ci = times(parent_[i] / own_[i], motion.cosine), sj = times(parent_[i] / own_[j], motion.sine);
  const Expr cj = times(parent_[j] / own_[j], motion.cosine), si = times(parent_[j] / own_[i], motion.sine);
  const Expr civ = ci * v[i], sjv = sj * v[j];
  out[i] = civ - sjv;
  const Expr siv = si * v[i], cjv = cj * v[j];
  out[j] = siv + cjv;
  return out;
}

Wrench ScaledTurn::inward(const Wrench& x) const {
  if (node_.motion.kind == MotionKind::translation)
    return {x.moment + scaled_cross(node_.motion.offset, x.force, own_), x.force};
  return {inward(x.moment), inward(x.force)};
}

Scale carried_inward(const MotionNode& node, const Scale& scale, const Scale& parent, bool begun) {
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
  Scale out = scale;
  if (node.scaled && begun) {
    const double c = value_of(motion.cosine);
    out[i] = scale[i] / c;
    out[j] = scale[j] / c;
  } else if (!node.partials.empty()) {
    out[j] = begun ? scale[i] * (parent[j] / parent[i]) : scale[i];
  } else if (motion.cosine.is_zero()) {
    std::swap(out[i], out[j]);
  } else if (!motion.sine.is_zero()) {
    out[i] = out[j] = 1;
  }
  return out;
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
