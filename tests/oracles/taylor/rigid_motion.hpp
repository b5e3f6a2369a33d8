// Vectors, rotations and rigid motions over any scalar type, as far as the numeric Lagrangian needs them.
#pragma once

#include <array>
#include <cmath>

namespace alembert::oracles {

template <class S>
using Vector3 = std::array<S, 3>;

template <class S>
Vector3<S> operator+(const Vector3<S>& a, const Vector3<S>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <class S>
Vector3<S> operator*(const S& s, const Vector3<S>& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
template <class S>
S dot(const Vector3<S>& a, const Vector3<S>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class S>
Vector3<S> cross(const Vector3<S>& a, const Vector3<S>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class S>
Vector3<S> normalized(const Vector3<S>& a) {
  using std::sqrt;
  return (S(1.0) / sqrt(dot(a, a))) * a;
}

/// [R p; 0 1]: rotation (by columns) and translation.
template <class S>
struct RigidMotion {
  std::array<Vector3<S>, 3> column{Vector3<S>{S(1.0), S(0.0), S(0.0)}, Vector3<S>{S(0.0), S(1.0), S(0.0)},
                                   Vector3<S>{S(0.0), S(0.0), S(1.0)}};
  Vector3<S> translation{S(0.0), S(0.0), S(0.0)};
};

template <class S>
Vector3<S> rotated(const RigidMotion<S>& a, const Vector3<S>& v) {
  return v[0] * a.column[0] + v[1] * a.column[1] + v[2] * a.column[2];
}
template <class S>
RigidMotion<S> operator*(const RigidMotion<S>& a, const RigidMotion<S>& b) {
  RigidMotion<S> c;
  for (std::size_t k = 0; k < 3; ++k) c.column[k] = rotated(a, b.column[k]);
  c.translation = rotated(a, b.translation) + a.translation;
  return c;
}
template <class S>
RigidMotion<S> inverse(const RigidMotion<S>& a) {
  RigidMotion<S> b;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t k = 0; k < 3; ++k) b.column[k][r] = a.column[r][k];
    b.translation[r] = -dot(a.column[r], a.translation);
  }
  return b;
}

/// Rotation about a unit vector (Rodrigues).
template <class S>
RigidMotion<S> rotation_about(const Vector3<S>& n, const S& angle) {
  using std::cos, std::sin;
  const S c = cos(angle), s = sin(angle);
  const S one_minus_c = S(1.0) - c;
  RigidMotion<S> result;
  for (std::size_t k = 0; k < 3; ++k) {
    Vector3<S> e{S(0.0), S(0.0), S(0.0)};
    e[k] = S(1.0);
    result.column[k] = c * e + s * cross(n, e) + (one_minus_c * n[k]) * n;
  }
  return result;
}
template <class S>
RigidMotion<S> rotation(const std::array<double, 3>& axis, const S& angle) {
  return rotation_about(Vector3<S>{S(axis[0]), S(axis[1]), S(axis[2])}, angle);
}

/// Rotation by a unit quaternion in the order x y z w.
template <class S>
RigidMotion<S> quaternion_rotation(const S& x, const S& y, const S& z, const S& w) {
  const Vector3<S> v{x, y, z};
  RigidMotion<S> result;
  for (std::size_t k = 0; k < 3; ++k) {
    Vector3<S> e{S(0.0), S(0.0), S(0.0)};
    e[k] = S(1.0);
    // e + 2 w (v x e) + 2 v x (v x e)
    const Vector3<S> ve = cross(v, e);
    result.column[k] = e + (S(2.0) * w) * ve + S(2.0) * cross(v, ve);
  }
  return result;
}

}  // namespace alembert::oracles
