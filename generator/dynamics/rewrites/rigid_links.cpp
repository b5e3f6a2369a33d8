// Rigid links with numbers: made from the tree of motions, their frames placed, their inertias split (see the
// header).
#include "dynamics/rewrites/rigid_links.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <bit>

namespace alembert {

namespace {

using Vector4e = Eigen::Matrix<Extended, 4, 1>;

/// Feet of common normals farther than so many lengths of the links are not gone to.
constexpr int kFar = 8;
/// Parts of an inertia that are so many times as large as the whole cancel too much.
constexpr int kMuchLarger = 64;

Matrix4e turn(int axis, const Extended& angle) {
  Matrix4e m = Matrix4e::Identity();
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  m(i, i) = m(j, j) = cos(angle);
  m(j, i) = sin(angle);
  m(i, j) = -m(j, i);
  return m;
}

Matrix4e shift(const Vector3e& t) {
  Matrix4e m = Matrix4e::Identity();
  m.topRightCorner<3, 1>() = t;
  return m;
}

/// Values of expressions without symbols; nothing if one has a symbol.
std::optional<std::vector<Extended>> numbers(std::span<const Expr> values) {
  if (!std::all_of(values.begin(), values.end(), [](const Expr& e) { return e.is_constant(); }))
    return std::nullopt;
  return evaluate_extended(values, std::span<const Extended>());
}

std::optional<Matrix4e> constant_pose(const Motion& motion, ExprGraph& graph) {
  const Pose pose = moved(identity_pose(graph), motion);
  const auto R = numbers(pose.rotation.entries), t = numbers(pose.origin.entries);
  if (!R || !t) return std::nullopt;
  Matrix4e m = Matrix4e::Identity();
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) m(r, c) = (*R)[static_cast<std::size_t>(3 * r + c)];
    m(r, 3) = (*t)[static_cast<std::size_t>(r)];
  }
  return m;
}

/// A pose as Rz(first_angle) Tz(first_shift) Rx(twist) Tx(length) Rz(last_angle) Tz(last_shift).
struct CommonNormal {
  Extended first_angle = 0, first_shift = 0, twist = 0, length = 0, last_angle = 0, last_shift = 0;
  bool parallel = false;
};

CommonNormal common_normal(const Matrix4e& pose) {
  CommonNormal d;
  const Vector3e z0 = Vector3e::UnitZ(), z1 = pose.block<3, 1>(0, 2), t = pose.topRightCorner<3, 1>();
  Vector3e x = z0.cross(z1);
  const Extended size = t.norm(), sine = x.norm();
  d.parallel = sine <= kAngleRounding;
  if (!d.parallel) {
    x /= sine;
    d.twist = atan2(Extended(x.dot(z0.cross(z1))), Extended(z0.dot(z1)));
    // t = first_shift z0 + length x + last_shift z1
    d.first_shift = t.dot(z1.cross(x)) / sine;
    d.length = t.dot(x);
    d.last_shift = t.dot(x.cross(z0)) / sine;
    d.first_angle = atan2(x[1], x[0]);
  } else {
    d.twist = z1[2] > 0 ? Extended(0) : Extended(2 * kRightAngle);
    d.first_shift = t[2];
    d.length = hypot(t[0], t[1]);
    if (d.length > kExtendedRounding * size) d.first_angle = atan2(t[1], t[0]);
  }
  for (Extended* length : {&d.first_shift, &d.length, &d.last_shift}) {
    if (abs(*length) <= kExtendedRounding * size) *length = 0;
  }
  const Matrix4e rest = turn(0, -d.twist) * turn(2, -d.first_angle) * pose;
  d.last_angle = atan2(rest(1, 0), rest(0, 0));
  return d;
}

}  // namespace

Matrix4e rigid_inverse(const Matrix4e& pose) {
  Matrix4e m = Matrix4e::Identity();
  m.topLeftCorner<3, 3>() = pose.topLeftCorner<3, 3>().transpose();
  m.topRightCorner<3, 1>() = -m.topLeftCorner<3, 3>() * pose.topRightCorner<3, 1>();
  return m;
}

RigidLinks::RigidLinks(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph) : tree_(&tree) {
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const MotionNode& node = tree.nodes[i];
    int link = node.parent < 0 ? -1 : link_of_node_[static_cast<std::size_t>(node.parent)];
    Matrix4e pose =
        node.parent < 0 ? Matrix4e::Identity() : pose_of_node_[static_cast<std::size_t>(node.parent)];
    const auto constant = node.partials.empty() ? constant_pose(node.motion, graph) : std::nullopt;
    if (constant) {
      pose = pose * *constant;
    } else {
      RigidLink next;
      next.node = static_cast<int>(i);
      next.parent = link;
      next.before = pose;
      next.moves = !node.partials.empty();
      next.turns = next.moves && node.motion.kind == MotionKind::axis_rotation;
      next.grounded = !next.moves && (link < 0 || links_[static_cast<std::size_t>(link)].grounded);
      link = static_cast<int>(links_.size());
      links_.push_back(next);
      pose = Matrix4e::Identity();
    }
    if (link >= 0) {
      const LinkInertia here = terms_.of_node(mechanism, tree, i, graph);
      links_[static_cast<std::size_t>(link)].inertia += here.seen_through(pose);
    }
    link_of_node_.push_back(link);
    pose_of_node_.push_back(pose);
  }
  measure();
  place();
  keep_frames();
}

void RigidLinks::measure() {
  for (std::size_t i = links_.size(); i-- > 0;) {
    RigidLink& link = links_[i];
    std::vector<const Matrix4e*> inertias{&link.inertia.number};
    for (const auto& [term, S] : link.inertia.terms) inertias.push_back(&S);
    for (const Matrix4e* S : inertias) {
      const Extended mass = abs((*S)(3, 3));
      if (mass == 0) continue;
      link.size = std::max(link.size, Extended(S->topRightCorner<3, 1>().cwiseAbs().maxCoeff() / mass));
      link.size = std::max(link.size, Extended(sqrt(S->topLeftCorner<3, 3>().cwiseAbs().maxCoeff() / mass)));
    }
    const Extended shift = link.before.topRightCorner<3, 1>().norm();
    length_ = std::max({length_, link.size, shift});
    if (link.parent < 0) continue;
    Extended& parent = links_[static_cast<std::size_t>(link.parent)].size;
    parent = std::max({parent, shift, link.size});
  }
}

bool RigidLinks::turns_about_fixed_axis(std::size_t i) const {
  const int parent = links_[i].parent;
  return links_[i].turns && (parent < 0 || links_[static_cast<std::size_t>(parent)].grounded);
}

void RigidLinks::place() {
  std::vector<std::vector<std::size_t>> children(links_.size());
  for (std::size_t i = 0; i < links_.size(); ++i) {
    if (links_[i].parent >= 0) children[static_cast<std::size_t>(links_[i].parent)].push_back(i);
  }
  // The frame after a motion becomes frame * G, where G commutes with the motion (or renames its axis).
  const auto reframe = [&](std::size_t i, const Matrix4e& G) {
    RigidLink& link = links_[i];
    link.before = link.before * G;
    link.adjusted = link.adjusted * G;
    const Matrix4e back = rigid_inverse(G);
    link.inertia = link.inertia.seen_through(back);
    for (const std::size_t child : children[i]) links_[child].before = back * links_[child].before;
  };
  for (std::size_t i = 0; i < links_.size(); ++i) {
    if (!links_[i].turns) continue;
    switch (tree_->nodes[static_cast<std::size_t>(links_[i].node)].motion.axis) {
      case 0:
        reframe(i, turn(1, kRightAngle));
        break;
      case 1:
        reframe(i, turn(0, Extended(-kRightAngle)));
        break;
      default:
        break;
    }
  }
  const auto is_near = [&](std::size_t parent, std::size_t child, const Extended& foot) {
    return abs(foot) <= kFar * std::max(links_[parent].size, links_[child].size);
  };
  for (std::size_t i = 0; i < links_.size(); ++i) {
    RigidLink& link = links_[i];
    if (!link.turns) continue;
    std::optional<CommonNormal> near;
    std::optional<std::size_t> far;  // a child whose axis is nearly parallel
    for (const std::size_t child : children[i]) {
      if (!links_[child].turns) continue;
      const CommonNormal d = common_normal(links_[child].before);
      if (is_near(i, child, d.first_shift) && is_near(i, child, d.last_shift)) {
        near = d;
        link.main_child = static_cast<int>(child);
        break;
      }
      if (!far) far = child;
    }
    if (near) {
      reframe(i, turn(2, near->first_angle) * shift({0, 0, near->first_shift}));
    } else if (far) {
      // Its origin beside this one, along x.
      const Vector3e t = links_[*far].before.topRightCorner<3, 1>();
      const bool beside = hypot(t[0], t[1]) > kExtendedRounding * t.norm();
      reframe(i, turn(2, beside ? atan2(t[1], t[0]) : Extended(0)) * shift({0, 0, t[2]}));
    } else if (children[i].empty() && link.parent >= 0) {
      const CommonNormal d = common_normal(link.before);
      if (is_near(static_cast<std::size_t>(link.parent), i, d.last_shift))
        reframe(i, shift({0, 0, -d.last_shift}));
      // Nothing follows, so the frame may turn until an entry of the inertia vanishes; turned runtime terms
      // would be mixed.
      if (!link.inertia.terms.empty()) continue;
      const Matrix4e& S = link.inertia.number;
      const Extended size = kExtendedRounding * mass_scale(S, link.size) * link.size;
      if (abs(S(0, 3)) > size && abs(S(1, 3)) > size) {
        reframe(i, turn(2, atan2(S(1, 3), S(0, 3))));
      } else if (abs(S(0, 3)) <= size && abs(S(1, 3)) <= size && abs(S(0, 1)) > size * link.size) {
        reframe(i, turn(2, atan2(Extended(2 * S(0, 1)), Extended(S(0, 0) - S(1, 1))) / 2));
      }
    }
  }
  for (std::size_t i = 0; i < links_.size(); ++i) {
    RigidLink& link = links_[i];
    if (!link.turns) continue;
    const CommonNormal d = common_normal(link.before);
    link.angle_offset = d.last_angle;
    link.before = link.before * turn(2, -d.last_angle);
    if (link.parent >= 0 && links_[static_cast<std::size_t>(link.parent)].main_child == static_cast<int>(i)) {
      link.twist = d.twist;
      link.twisted = abs(sin(2 * d.twist)) > kAngleRounding;  // right angles only rename axes
      link.length = d.length;
      link.offset = d.last_shift;
      // Parallel axes share the slide; it all happens here.
      link.before = turn(0, d.twist) * shift({d.length, 0, d.last_shift});
      if (d.parallel) {
        link.offset = d.first_shift * cos(d.twist) + d.last_shift;
        link.before = turn(0, d.twist) * shift({d.length, 0, link.offset});
      }
    }
  }
}

bool RigidLinks::has_frame(std::size_t i, MassFrame frame) const {
  return frame == MassFrame::joint || links_[i].main_child >= 0;
}

LinkInertia RigidLinks::in_frame(std::size_t i, MassFrame which, const LinkInertia& inertia) const {
  return inertia.seen_through(frame(i, which).back);
}

LinkInertia RigidLinks::to_parent(std::size_t i, const LinkInertia& moved) const {
  return moved.seen_through(links_[i].before);
}

std::vector<Matrix4e> RigidLinks::movable(std::size_t i) const {
  // Pairs of points and directions (homogeneous, in the frame after the motion) that the motion leaves still.
  std::vector<Vector4e> still;
  if (!links_[i].moves) return {};
  const Motion& motion = tree_->nodes[static_cast<std::size_t>(links_[i].node)].motion;
  switch (motion.kind) {
    case MotionKind::translation:
      still = {Vector4e::UnitX(), Vector4e::UnitY(), Vector4e::UnitZ()};
      break;
    case MotionKind::axis_rotation:
      still = {Vector4e::UnitZ(), Vector4e::UnitW()};
      break;
    case MotionKind::rotation:
      if (motion.fixed_axis) {
        const auto axis = numbers(motion.fixed_axis->entries);
        if (axis) still.emplace_back((*axis)[0], (*axis)[1], (*axis)[2], Extended(0));
      }
      still.emplace_back(Vector4e::UnitW());
      break;
  }
  std::vector<Matrix4e> basis;
  for (std::size_t a = 0; a < still.size(); ++a) {
    for (std::size_t b = a; b < still.size(); ++b) {
      basis.emplace_back(still[a] * still[b].transpose() + still[b] * still[a].transpose());
    }
  }
  return basis;
}

void RigidLinks::keep_frames() {
  for (std::size_t i = 0; i < links_.size(); ++i) {
    std::vector<Matrix4e> poses{Matrix4e::Identity()};
    if (links_[i].main_child >= 0) {
      const RigidLink& child = links_[static_cast<std::size_t>(links_[i].main_child)];
      poses.push_back(turn(0, child.twist));
      poses.emplace_back(poses.back() * shift({child.length, 0, 0}));
      poses.emplace_back(poses.back() * shift({0, 0, child.offset}));
    }
    movable_.push_back(movable(i));
    std::vector<Frame>& frames = frames_.emplace_back();
    for (const Matrix4e& pose : poses) {
      const Matrix4e back = rigid_inverse(pose);
      frames.push_back({pose, back, {}});
      for (const Matrix4e& d : movable_.back())
        frames.back().movable.emplace_back(back * d * back.transpose());
    }
  }
}

RigidLinks::Splits::Splits(const RigidLinks& links, std::size_t i, const Regrouping& how,
                           const LinkInertia& inertia)
    : length_(links.links_[i].size),
      solvers_(links.solvers_[{i, how.frame, how.points}]),
      moves_terms_(how.moves_terms),
      possible_(!(how.moves_terms && how.points != 0)),
      inertia_(links.in_frame(i, how.frame, inertia)),
      basis_(links.movable_[i]),
      columns_(links.frame(i, how.frame).movable) {
  const auto drop = [&](Matrix4e& S) { drop_rounding(S, mass_scale(S, length_), length_); };
  drop(inertia_.number);
  for (auto& [term, S] : inertia_.terms) drop(S);
  for (std::size_t k = 0; k < kMassFrames.size(); ++k) {
    if ((how.points >> k & 1u) == 0) continue;
    const Vector4e at = (links.frame(i, how.frame).back * links.frame(i, kMassFrames[k]).pose).col(3);
    columns_.emplace_back(at * at.transpose());
    points_.push_back(k);
  }
  for (std::size_t e = 0; e < kInertiaEntries.size(); ++e) {
    const std::pair<int, int> at = kInertiaEntries[e];
    if (std::ranges::any_of(columns_,
                            [&](const Matrix4e& column) { return column(at.first, at.second) != 0; }))
      reached_ |= 1u << e;
  }
}

Extended RigidLinks::Splits::as_mass(int row, int column, const Extended& entry) const {
  Extended out = entry;
  if (row < 3 && length_ > 0) out /= length_;
  if (column < 3 && length_ > 0) out /= length_;
  return out;
}

const RigidLinks::Splits::Solvers::mapped_type& RigidLinks::Splits::solver(
    const std::vector<std::pair<int, int>>& entries, unsigned zeros) const {
  const auto [known, fresh] = solvers_.try_emplace(zeros);
  if (!fresh) return known->second;
  const Eigen::Index n = static_cast<Eigen::Index>(columns_.size());
  Eigen::Matrix<Extended, Eigen::Dynamic, Eigen::Dynamic> A(n, n);
  for (Eigen::Index row = 0; row < n; ++row) {
    const auto [r, c] = entries[static_cast<std::size_t>(row)];
    for (Eigen::Index k = 0; k < n; ++k)
      A(row, k) = as_mass(r, c, columns_[static_cast<std::size_t>(k)](r, c));
  }
  known->second.setThreshold(kExtendedRounding);
  known->second.compute(A);
  return known->second;
}

/// Takes amounts of the columns away, so that entries become zero. False if that cannot be, or if a part
/// would become much larger than the whole.
bool RigidLinks::Splits::take(Matrix4e& remaining, const Solvers::mapped_type& lu,
                              const std::vector<std::pair<int, int>>& zeros, Matrix4e& moved,
                              std::array<Extended, 4>* points) const {
  const Extended mass = mass_scale(remaining, length_);
  const Extended most = kMuchLarger * mass;
  Eigen::Matrix<Extended, Eigen::Dynamic, 1> b(static_cast<Eigen::Index>(zeros.size()));
  for (Eigen::Index row = 0; row < b.size(); ++row) {
    const auto [r, c] = zeros[static_cast<std::size_t>(row)];
    b[row] = as_mass(r, c, remaining(r, c));
  }
  const decltype(b) x = lu.solve(b);
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const Extended& amount = x[static_cast<Eigen::Index>(k)];
    remaining -= amount * columns_[k];
    if (k < basis_.size()) {
      moved += amount * basis_[k];
    } else {
      if (abs(amount) > most) return false;
      (*points)[points_[k - basis_.size()]] = abs(amount) <= kExtendedRounding * mass ? Extended(0) : amount;
    }
  }
  for (const auto& [r, c] : zeros) remaining(r, c) = remaining(c, r) = 0;
  if (mass_scale(remaining, length_) > most || mass_scale(moved, length_) > most) return false;
  drop_rounding(remaining, mass, length_);
  drop_rounding(moved, mass, length_);
  return true;
}

std::optional<RigidLinks::Split> RigidLinks::Splits::zeroing(unsigned zeros) const {
  Split out{inertia_, {}, {}};
  if (zeros != 0) {
    if (!possible_ || std::popcount(zeros) != static_cast<int>(columns_.size())) return std::nullopt;
    if ((zeros & ~reached_) != 0) return std::nullopt;  // a row of zeros: most sets of entries have one
    std::vector<std::pair<int, int>> entries;
    for (std::size_t e = 0; e < kInertiaEntries.size(); ++e) {
      if ((zeros >> e & 1u) != 0) entries.push_back(kInertiaEntries[e]);
    }
    const Solvers::mapped_type& lu = solver(entries, zeros);
    if (!lu.isInvertible() || !take(out.remaining.number, lu, entries, out.moved.number, &out.points))
      return std::nullopt;
    if (moves_terms_) {
      for (auto& [term, S] : out.remaining.terms) {
        Matrix4e moved = Matrix4e::Zero();
        if (!take(S, lu, entries, moved, nullptr)) return std::nullopt;
        if (!moved.isZero(0)) out.moved.terms.emplace(term, moved);
      }
    }
  }
  std::erase_if(out.remaining.terms, [](const auto& term) { return term.second.isZero(0); });
  return out;
}

const RigidLinks::Flow& RigidLinks::flow(const std::vector<Regrouping>& regroupings) const {
  const std::size_t n = links_.size();
  std::vector<bool> changed(n, known_.regroupings.empty());
  known_.flow.inertias.resize(n);
  known_.flow.splits.resize(n);
  known_.handed.resize(n);
  for (std::size_t i = n; i-- > 0;) {
    if (!changed[i] && known_.regroupings[i].splits_like(regroupings[i])) continue;
    LinkInertia& inertia = known_.flow.inertias[i] = links_[i].inertia;
    for (std::size_t child = n; child-- > i + 1;) {
      if (links_[child].parent == static_cast<int>(i)) inertia += known_.handed[child];
    }
    auto split = this->split(i, regroupings[i], inertia);
    if (!split) split = this->split(i, Regrouping{}, inertia);
    known_.flow.splits[i] = *std::move(split);
    if (links_[i].parent < 0) continue;
    known_.handed[i] = to_parent(i, known_.flow.splits[i].moved);
    changed[static_cast<std::size_t>(links_[i].parent)] = true;
  }
  known_.regroupings = regroupings;
  return known_.flow;
}

}  // namespace alembert
