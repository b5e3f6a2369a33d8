// Rigid links with numbers: made from the tree of motions, their frames placed, their inertias split (see the
// header).
#include "dynamics/rigid_links.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "symbolic/passes.hpp"

namespace alembert {

namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;

constexpr double kNegligible = 1e-12;

Matrix4d turn(int axis, double angle) {
  Matrix4d m = Matrix4d::Identity();
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  m(i, i) = m(j, j) = std::cos(angle);
  m(j, i) = std::sin(angle);
  m(i, j) = -m(j, i);
  return m;
}

Matrix4d shift(const Vector3d& t) {
  Matrix4d m = Matrix4d::Identity();
  m.topRightCorner<3, 1>() = t;
  return m;
}

/// Values of expressions without symbols, in units; nothing if one has a symbol.
std::optional<std::vector<double>> numbers(std::span<const Expr> values, double unit = 1) {
  if (!std::all_of(values.begin(), values.end(), [](const Expr& e) { return e.is_constant(); }))
    return std::nullopt;
  std::vector<double> out = evaluate(values, {});
  for (double& x : out) {
    x /= unit;
    if (std::abs(x) < 1e-16) x = 0;
  }
  return out;
}

std::optional<Matrix4d> constant_pose(const Motion& motion, const Units& units, ExprGraph& graph) {
  const Pose pose = moved(identity_pose(graph), motion);
  const auto R = numbers(pose.rotation.entries), t = numbers(pose.origin.entries, units.length);
  if (!R || !t) return std::nullopt;
  Matrix4d m = Matrix4d::Identity();
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) m(r, c) = (*R)[static_cast<std::size_t>(3 * r + c)];
    m(r, 3) = (*t)[static_cast<std::size_t>(r)];
  }
  return m;
}

/// A pose as Rz(first_angle) Tz(first_shift) Rx(twist) Tx(length) Rz(last_angle) Tz(last_shift).
struct CommonNormal {
  double first_angle = 0, first_shift = 0, twist = 0, length = 0, last_angle = 0, last_shift = 0;
};

CommonNormal common_normal(const Matrix4d& pose) {
  CommonNormal d;
  const Vector3d z0 = Vector3d::UnitZ(), z1 = pose.block<3, 1>(0, 2), t = pose.topRightCorner<3, 1>();
  Vector3d x = z0.cross(z1);
  const double size = std::max(1.0, t.norm());
  if (x.norm() > kNegligible) {
    x.normalize();
    d.twist = std::atan2(x.dot(z0.cross(z1)), z0.dot(z1));
    Matrix3d axes;
    axes << z0, x, z1;
    const Vector3d parts = axes.partialPivLu().solve(t);
    d.first_shift = parts[0];
    d.length = parts[1];
    d.last_shift = parts[2];
    d.first_angle = std::atan2(x[1], x[0]);
  } else {
    d.twist = z1[2] > 0 ? 0 : std::numbers::pi;
    d.first_shift = t[2];
    d.length = std::hypot(t[0], t[1]);
    if (d.length > kNegligible * size) d.first_angle = std::atan2(t[1], t[0]);
  }
  for (double* length : {&d.first_shift, &d.length, &d.last_shift}) {
    if (std::abs(*length) < kNegligible * size) *length = 0;
  }
  const Matrix4d rest = turn(0, -d.twist) * turn(2, -d.first_angle) * pose;
  d.last_angle = std::atan2(rest(1, 0), rest(0, 0));
  return d;
}

}  // namespace

Matrix4d rigid_inverse(const Matrix4d& pose) {
  Matrix4d m = Matrix4d::Identity();
  m.topLeftCorner<3, 3>() = pose.topLeftCorner<3, 3>().transpose();
  m.topRightCorner<3, 1>() = -m.topLeftCorner<3, 3>() * pose.topRightCorner<3, 1>();
  return m;
}

RigidLinks::RigidLinks(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph)
    : tree_(&tree), units_(units_of(mechanism, tree, graph)), terms_(units_) {
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const MotionNode& node = tree.nodes[i];
    int link = node.parent < 0 ? -1 : link_of_node_[static_cast<std::size_t>(node.parent)];
    Matrix4d pose =
        node.parent < 0 ? Matrix4d::Identity() : pose_of_node_[static_cast<std::size_t>(node.parent)];
    const auto constant = node.partials.empty() ? constant_pose(node.motion, units_, graph) : std::nullopt;
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
      pose = Matrix4d::Identity();
    }
    if (link >= 0) {
      const LinkInertia here = terms_.of_node(mechanism, tree, i, graph);
      links_[static_cast<std::size_t>(link)].inertia += here.seen_through(pose);
    }
    link_of_node_.push_back(link);
    pose_of_node_.push_back(pose);
  }
  place();
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
  const auto reframe = [&](std::size_t i, const Matrix4d& G) {
    RigidLink& link = links_[i];
    link.before = link.before * G;
    link.adjusted = link.adjusted * G;
    const Matrix4d back = rigid_inverse(G);
    link.inertia = link.inertia.seen_through(back);
    for (const std::size_t child : children[i]) links_[child].before = back * links_[child].before;
  };
  for (std::size_t i = 0; i < links_.size(); ++i) {
    if (!links_[i].turns) continue;
    switch (tree_->nodes[static_cast<std::size_t>(links_[i].node)].motion.axis) {
      case 0:
        reframe(i, turn(1, std::numbers::pi / 2));
        break;
      case 1:
        reframe(i, turn(0, -std::numbers::pi / 2));
        break;
      default:
        break;
    }
  }
  for (std::size_t i = 0; i < links_.size(); ++i) {
    RigidLink& link = links_[i];
    if (!link.turns) continue;
    const auto child =
        std::find_if(children[i].begin(), children[i].end(), [&](std::size_t c) { return links_[c].turns; });
    if (child != children[i].end()) {
      link.main_child = static_cast<int>(*child);
      const CommonNormal d = common_normal(links_[*child].before);
      reframe(i, turn(2, d.first_angle) * shift({0, 0, d.first_shift}));
    } else if (children[i].empty() && link.parent >= 0) {
      const CommonNormal d = common_normal(link.before);
      reframe(i, shift({0, 0, -d.last_shift}));
      // Nothing follows, so the frame may turn until an entry of the inertia vanishes; turned runtime terms
      // would be mixed.
      if (!link.inertia.terms.empty()) continue;
      const Matrix4d& S = link.inertia.number;
      const double size = kNegligible * S.cwiseAbs().maxCoeff();
      if (std::abs(S(0, 3)) > size && std::abs(S(1, 3)) > size) {
        reframe(i, turn(2, std::atan2(S(1, 3), S(0, 3))));
      } else if (std::abs(S(0, 3)) <= size && std::abs(S(1, 3)) <= size && std::abs(S(0, 1)) > size) {
        reframe(i, turn(2, 0.5 * std::atan2(2 * S(0, 1), S(0, 0) - S(1, 1))));
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
      link.length = d.length;
      link.offset = d.last_shift;
      // Parallel axes share the slide; it all happens here.
      link.before = turn(0, d.twist) * shift({d.length, 0, d.last_shift});
      if (std::abs(std::sin(d.twist)) < kNegligible) {
        link.offset = d.first_shift * std::cos(d.twist) + d.last_shift;
        link.before = turn(0, d.twist) * shift({d.length, 0, link.offset});
      }
    }
  }
}

bool RigidLinks::has_frame(std::size_t i, MassFrame frame) const {
  return frame == MassFrame::joint || links_[i].main_child >= 0;
}

Matrix4d RigidLinks::pose_in_link(std::size_t i, MassFrame frame) const {
  if (frame == MassFrame::joint) return Matrix4d::Identity();
  const RigidLink& child = links_[static_cast<std::size_t>(links_[i].main_child)];
  Matrix4d pose = turn(0, child.twist);
  if (frame == MassFrame::twist) return pose;
  pose = pose * shift({child.length, 0, 0});
  return frame == MassFrame::length ? pose : Matrix4d(pose * shift({0, 0, child.offset}));
}

LinkInertia RigidLinks::in_frame(std::size_t i, MassFrame frame, const LinkInertia& inertia) const {
  return inertia.seen_through(rigid_inverse(pose_in_link(i, frame)));
}

LinkInertia RigidLinks::to_parent(std::size_t i, const LinkInertia& moved) const {
  return moved.seen_through(links_[i].before);
}

std::vector<Matrix4d> RigidLinks::movable(std::size_t i) const {
  // Pairs of points and directions (homogeneous, in the frame after the motion) that the motion leaves still.
  std::vector<Eigen::Vector4d> still;
  if (!links_[i].moves) return {};
  const Motion& motion = tree_->nodes[static_cast<std::size_t>(links_[i].node)].motion;
  switch (motion.kind) {
    case MotionKind::translation:
      still = {Eigen::Vector4d::UnitX(), Eigen::Vector4d::UnitY(), Eigen::Vector4d::UnitZ()};
      break;
    case MotionKind::axis_rotation:
      still = {Eigen::Vector4d::UnitZ(), Eigen::Vector4d::UnitW()};
      break;
    case MotionKind::rotation:
      if (motion.fixed_axis) {
        const auto axis = numbers(motion.fixed_axis->entries);
        if (axis) still.emplace_back((*axis)[0], (*axis)[1], (*axis)[2], 0);
      }
      still.emplace_back(Eigen::Vector4d::UnitW());
      break;
  }
  std::vector<Matrix4d> basis;
  for (std::size_t a = 0; a < still.size(); ++a) {
    for (std::size_t b = a; b < still.size(); ++b) {
      basis.emplace_back(still[a] * still[b].transpose() + still[b] * still[a].transpose());
    }
  }
  return basis;
}

std::optional<RigidLinks::Split> RigidLinks::split(std::size_t i, const Regrouping& how,
                                                   const LinkInertia& inertia) const {
  Split out{in_frame(i, how.frame, inertia), {}, {}};
  const auto size_of = [](const Matrix4d& S) { return std::max(S.cwiseAbs().maxCoeff(), 1e-300); };
  const auto snap = [](Matrix4d& S, double size) {
    S = S.unaryExpr([&](double x) { return std::abs(x) < 1e-14 * size ? 0.0 : x; });
  };
  const double size = size_of(out.remaining.number);
  if (how.zeros != 0) {
    if (how.moves_terms && how.points != 0) return std::nullopt;
    const std::vector<Matrix4d> basis = movable(i);
    std::vector<Matrix4d> columns;
    const Matrix4d back = rigid_inverse(pose_in_link(i, how.frame));
    for (const Matrix4d& d : basis) columns.emplace_back(back * d * back.transpose());
    std::vector<std::size_t> points;
    for (std::size_t k = 0; k < kMassFrames.size(); ++k) {
      if ((how.points >> k & 1u) == 0) continue;
      const Eigen::Vector4d at = (back * pose_in_link(i, kMassFrames[k])).col(3);
      columns.emplace_back(at * at.transpose());
      points.push_back(k);
    }
    const Eigen::Index n = static_cast<Eigen::Index>(columns.size());
    if (std::popcount(how.zeros) != static_cast<int>(n)) return std::nullopt;
    Eigen::MatrixXd A(n, n);
    std::vector<std::pair<int, int>> zeros;
    for (std::size_t e = 0; e < kInertiaEntries.size(); ++e) {
      if ((how.zeros >> e & 1u) == 0) continue;
      const auto [r, c] = kInertiaEntries[e];
      const Eigen::Index row = static_cast<Eigen::Index>(zeros.size());
      for (Eigen::Index k = 0; k < n; ++k) A(row, k) = columns[static_cast<std::size_t>(k)](r, c);
      zeros.emplace_back(r, c);
    }
    Eigen::FullPivLU<Eigen::MatrixXd> lu(A);
    lu.setThreshold(1e-6);
    if (!lu.isInvertible()) return std::nullopt;
    // The amounts of the columns that leave `remaining`, from which they are taken.
    const auto leaving = [&](Matrix4d& remaining) {
      Eigen::VectorXd b(n);
      for (Eigen::Index row = 0; row < n; ++row) {
        const auto [r, c] = zeros[static_cast<std::size_t>(row)];
        b[row] = remaining(r, c);
      }
      const Eigen::VectorXd x = lu.solve(b);
      for (std::size_t k = 0; k < columns.size(); ++k)
        remaining -= x[static_cast<Eigen::Index>(k)] * columns[k];
      for (const auto& [r, c] : zeros) remaining(r, c) = remaining(c, r) = 0;
      return x;
    };
    const Eigen::VectorXd numbers = leaving(out.remaining.number);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const double amount = numbers[static_cast<Eigen::Index>(k)];
      if (k < basis.size()) {
        out.moved.number += amount * basis[k];
      } else {
        out.points[points[k - basis.size()]] = amount;
      }
    }
    if (how.moves_terms) {
      for (auto& [term, S] : out.remaining.terms) {
        const double size_here = size_of(S);
        const Eigen::VectorXd amounts = leaving(S);
        Matrix4d moved = Matrix4d::Zero();
        for (std::size_t k = 0; k < basis.size(); ++k)
          moved += amounts[static_cast<Eigen::Index>(k)] * basis[k];
        snap(moved, size_here);
        snap(S, size_here);
        if (!moved.isZero(0)) out.moved.terms.emplace(term, moved);
      }
    }
  }
  snap(out.remaining.number, size);
  for (auto term = out.remaining.terms.begin(); term != out.remaining.terms.end();) {
    snap(term->second, size_of(term->second));
    term = term->second.isZero(0) ? out.remaining.terms.erase(term) : std::next(term);
  }
  return out;
}

RigidLinks::Flow RigidLinks::flow(const std::vector<Regrouping>& regroupings) const {
  Flow out;
  for (const RigidLink& link : links_) out.inertias.push_back(link.inertia);
  out.splits.resize(links_.size());
  for (std::size_t i = links_.size(); i-- > 0;) {
    auto split = this->split(i, regroupings[i], out.inertias[i]);
    if (!split) split = this->split(i, Regrouping{}, out.inertias[i]);
    out.splits[i] = *split;
    if (links_[i].parent >= 0) {
      out.inertias[static_cast<std::size_t>(links_[i].parent)] += to_parent(i, out.splits[i].moved);
    }
  }
  return out;
}

}  // namespace alembert
