// Elementary motions: applying, inverting and merging them, and making them out of the factors of a
// transform.
#include "dynamics/tree/motion.hpp"

#include <algorithm>

#include "dynamics/tree/contact_frames.hpp"
#include "dynamics/tree/motion_tree.hpp"
#include "support/overloaded.hpp"

namespace alembert {

bool is_quarter_turn(const Motion& motion) {
  return motion.cosine.is_zero() || motion.sine.is_zero();
}

Mat3 turned_symmetric(const Mat3& K, const Motion& motion) {
  if (motion.kind == MotionKind::rotation) {
    const Mat3 half = motion.matrix * K;
    Mat3 out;
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = r; c < 3; ++c) {
        Expr sum = half(r, 0) * motion.matrix(c, 0);
        sum += half(r, 1) * motion.matrix(c, 1);
        sum += half(r, 2) * motion.matrix(c, 2);
        out(r, c) = sum;
        out(c, r) = sum;
      }
    }
    return out;
  }
  const std::size_t a = static_cast<std::size_t>(motion.axis), i = (a + 1) % 3, j = (a + 2) % 3;
  const Expr c = motion.cosine, s = motion.sine;
  const Expr two_c = c + c;
  Expr z = s * (K(i, i) - K(j, j));
  z += two_c * K(i, j);
  const Expr sz = s * z;
  Mat3 out = K;
  out(i, i) = K(i, i) - sz;
  out(j, j) = K(j, j) + sz;
  const Expr cz = c * z;
  out(i, j) = out(j, i) = cz - K(i, j);
  const Expr c_i = c * K(i, a), s_j = s * K(j, a), s_i = s * K(i, a), c_j = c * K(j, a);
  out(i, a) = out(a, i) = c_i - s_j;
  out(j, a) = out(a, j) = s_i + c_j;
  return out;
}

Mat3 turned(const Mat3& A, const Motion& motion) {
  if (motion.kind == MotionKind::rotation) return motion.matrix * A * transpose(motion.matrix);
  const std::size_t a = static_cast<std::size_t>(motion.axis), i = (a + 1) % 3, j = (a + 2) % 3;
  const Expr c = motion.cosine, s = motion.sine;
  Mat3 out = A;
  Expr z = s * (A(i, i) - A(j, j));
  z += c * (A(i, j) + A(j, i));
  const Expr sz = s * z, cz = c * z;
  out(i, i) = A(i, i) - sz;
  out(j, j) = A(j, j) + sz;
  out(i, j) = cz - A(j, i);
  out(j, i) = cz - A(i, j);
  const auto turn_pair = [&](const Expr& x, const Expr& y, Expr& new_x, Expr& new_y) {
    const Expr cx = c * x, sy = s * y, sx = s * x, cy = c * y;
    new_x = cx - sy;
    new_y = sx + cy;
  };
  turn_pair(A(i, a), A(j, a), out(i, a), out(j, a));
  turn_pair(A(a, i), A(a, j), out(a, i), out(a, j));
  return out;
}

Motion translation_motion(const Vec3& offset) {
  Motion motion;
  motion.kind = MotionKind::translation;
  motion.offset = offset;
  return motion;
}

Motion axis_rotation_motion(int axis, Expr angle) {
  Motion motion;
  motion.kind = MotionKind::axis_rotation;
  motion.axis = axis;
  motion.angle = angle;
  motion.cosine = cos(angle);
  motion.sine = sin(angle);
  return motion;
}

namespace {

Motion rotation(const Mat3& matrix) {
  Motion motion;
  motion.kind = MotionKind::rotation;
  motion.matrix = matrix;
  return motion;
}

/// Rodrigues: E = cos 1 + (1 - cos) a a^T + sin skew(a).
Motion vector_rotation(const Vec3& a, Expr angle) {
  ExprGraph& g = angle.graph();
  const Expr c = cos(angle), s = sin(angle);
  const Expr versine = g.one() - c;
  Mat3 m;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Expr outer = a[i] * a[j];
      m(i, j) = outer * versine;
      if (i == j) {
        m(i, j) += c;
      } else {
        const std::size_t k = 3 - i - j;
        const Expr part = a[k] * s;
        m(i, j) += (i + 1) % 3 == j ? -part : part;
      }
    }
  }
  Motion motion = rotation(m);
  motion.fixed_axis = a;
  motion.angle = angle;
  return motion;
}

/// Rotation by a unit quaternion x y z w.
Motion quaternion_rotation(const Mechanism& mechanism, int coordinate) {
  const std::vector<Expr>& q = mechanism.coordinates[static_cast<std::size_t>(coordinate)].symbols;
  const Expr x = q[0], y = q[1], z = q[2], w = q[3];
  ExprGraph& g = x.graph();
  const Expr two = g.integer(2);
  const auto diagonal = [&](Expr a, Expr b) {
    const Expr squares = a * a + b * b;
    return g.one() - two * squares;
  };
  const auto off_diagonal = [&](Expr a, Expr b, Expr c) {  // 2 (a b + c w)
    const Expr product = a * b;
    return two * (product + c * w);
  };
  Mat3 m;
  m(0, 0) = diagonal(y, z);
  m(0, 1) = off_diagonal(x, y, -z);
  m(0, 2) = off_diagonal(x, z, y);
  m(1, 0) = off_diagonal(x, y, z);
  m(1, 1) = diagonal(x, z);
  m(1, 2) = off_diagonal(y, z, -x);
  m(2, 0) = off_diagonal(x, z, -y);
  m(2, 1) = off_diagonal(y, z, x);
  m(2, 2) = diagonal(x, y);
  Motion motion = rotation(m);
  motion.quaternion = coordinate;
  return motion;
}

Vec3 turned_about(int axis, Expr cosine, Expr sine, const Vec3& v) {
  const std::size_t i = static_cast<std::size_t>(axis + 1) % 3, j = static_cast<std::size_t>(axis + 2) % 3;
  Vec3 out = v;
  const Expr ci = cosine * v[i], sj = sine * v[j];
  out[i] = ci - sj;
  const Expr si = sine * v[i], cj = cosine * v[j];
  out[j] = si + cj;
  return out;
}

bool is_identity(const Motion& motion, ExprGraph& g) {
  switch (motion.kind) {
    case MotionKind::translation:
      return motion.offset == zeros<3, 1>(g);
    case MotionKind::axis_rotation:
      return motion.angle.is_zero() || (motion.sine.is_zero() && motion.cosine.is_one());
    case MotionKind::rotation:
      return motion.matrix == identity3(g);
  }
  return false;
}

/// The elementary motions of a factor, not inverted.
std::vector<Motion> motions_of(const Factor& factor, const Mechanism& mechanism, ExprGraph& g) {
  using Motions = std::vector<Motion>;
  return std::visit(
      Overloaded{
          [](const Translation& f) { return Motions{translation_motion(f.offset)}; },
          [](const AxisRotation& f) { return Motions{axis_rotation_motion(f.axis, f.angle)}; },
          [](const VectorRotation& f) { return Motions{vector_rotation(f.axis, f.angle)}; },
          [&](const QuaternionRotation& f) { return Motions{quaternion_rotation(mechanism, f.coordinate)}; },
          [](const RigidMatrix& f) {
            return Motions{translation_motion(f.translation), rotation(f.rotation)};
          },
          [&](const CurveFrame& f) {
            return Motions{translation_motion(f.point), rotation(curve_rotation(f, factor.where, g))};
          },
          [&](const SurfaceFrame& f) {
            return Motions{translation_motion(f.point), rotation(surface_rotation(f, factor.where, g))};
          }},
      factor.value);
}

}  // namespace

Vec3 Motion::to_parent(const Vec3& v) const {
  switch (kind) {
    case MotionKind::translation:
      return v;
    case MotionKind::axis_rotation:
      return turned_about(axis, cosine, sine, v);
    case MotionKind::rotation:
      return matrix * v;
  }
  return v;
}

Vec3 Motion::to_child(const Vec3& v) const {
  switch (kind) {
    case MotionKind::translation:
      return v;
    case MotionKind::axis_rotation:
      return turned_about(axis, cosine, -sine, v);
    case MotionKind::rotation:
      return transpose(matrix) * v;
  }
  return v;
}

Motion Motion::inverse() const {
  switch (kind) {
    case MotionKind::translation:
      return translation_motion({{-offset[0], -offset[1], -offset[2]}});
    case MotionKind::axis_rotation:
      return axis_rotation_motion(axis, -angle);
    case MotionKind::rotation: {
      // The inverse of a quaternion's rotation does not turn with the body-frame speeds: its twist is derived
      // from the matrix.
      Motion motion = rotation(transpose(matrix));
      if (fixed_axis) {
        motion.fixed_axis = fixed_axis;
        motion.angle = -angle;
      }
      return motion;
    }
  }
  return *this;
}

void append_motion(std::vector<Motion>& motions, Motion motion, ExprGraph& g) {
  if (!motions.empty()) {
    const Motion& last = motions.back();
    if (last.kind == MotionKind::translation && motion.kind == MotionKind::translation) {
      motion = translation_motion(last.offset + motion.offset);
      motions.pop_back();
    } else if (last.kind == MotionKind::axis_rotation && motion.kind == MotionKind::axis_rotation &&
               last.axis == motion.axis) {
      motion = axis_rotation_motion(motion.axis, last.angle + motion.angle);
      motions.pop_back();
    }
  }
  if (!is_identity(motion, g)) motions.push_back(std::move(motion));
}

std::vector<Motion> elementary_motions(const Transform& transform, const Mechanism& mechanism,
                                       ExprGraph& graph) {
  std::vector<Motion> motions;
  for (const Factor& factor : transform.factors) {
    std::vector<Motion> own = motions_of(factor, mechanism, graph);
    if (factor.inverse) {
      std::reverse(own.begin(), own.end());
      for (Motion& motion : own) motion = motion.inverse();
    }
    for (const Motion& motion : own) append_motion(motions, motion, graph);
  }
  return motions;
}

Pose identity_pose(ExprGraph& graph) {
  return {identity3(graph), zeros<3, 1>(graph)};
}

Pose moved(Pose pose, const Motion& motion) {
  if (motion.kind == MotionKind::translation) {
    pose.origin = pose.origin + pose.rotation * motion.offset;
    return pose;
  }
  // Rows of R E are E^T applied to the rows of R.
  for (std::size_t r = 0; r < 3; ++r) {
    const Vec3 row{{pose.rotation(r, 0), pose.rotation(r, 1), pose.rotation(r, 2)}};
    const Vec3 turned = motion.to_child(row);
    for (std::size_t c = 0; c < 3; ++c) pose.rotation(r, c) = turned[c];
  }
  return pose;
}

}  // namespace alembert
