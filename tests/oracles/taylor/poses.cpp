// Poses from factors (see the header).
#include "oracles/taylor/poses.hpp"

namespace alembert::oracles {

namespace {

using T = Jet<double>;  // along the motion
using TT = Jet<T>;      // and along a coordinate of a curve or surface

/// Coordinates as jets along coordinate `along`.
std::vector<TT> lifted(const std::vector<T>& q, int along) {
  std::vector<TT> result;
  for (std::size_t i = 0; i < q.size(); ++i) {
    result.emplace_back(q[i], T(static_cast<int>(i) == along ? 1.0 : 0.0), T(0.0));
  }
  return result;
}

struct Derivatives {
  Vector3<T> value, first, second;
};

Derivatives along(const Expression3& point, int coordinate, const std::vector<T>& q, const T& t) {
  const std::vector<TT> moved = lifted(q, coordinate);
  const TT time(t, T(0.0), T(0.0));
  Derivatives d;
  for (std::size_t i = 0; i < 3; ++i) {
    const TT f = evaluate(point[i], moved, time);
    d.value[i] = f.value;
    d.first[i] = f.first;
    d.second[i] = f.second;
  }
  return d;
}

Vector3<T> values(const Expression3& e, const std::vector<T>& q, const T& t) {
  return {evaluate(e[0], q, t), evaluate(e[1], q, t), evaluate(e[2], q, t)};
}

struct FactorMotion {
  const std::vector<T>& q;
  const T& t;

  RigidMotion<T> operator()(const Translation& f) const {
    RigidMotion<T> result;
    result.translation = values(f.offset, q, t);
    return result;
  }
  RigidMotion<T> operator()(const Rotation& f) const { return rotation(f.axis, evaluate(f.angle, q, t)); }
  RigidMotion<T> operator()(const QuaternionRotation& f) const {
    const T* x = &q[static_cast<std::size_t>(f.first_q)];
    return quaternion_rotation(x[0], x[1], x[2], x[3]);
  }
  RigidMotion<T> operator()(const Matrix& f) const {
    RigidMotion<T> result;
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) result.column[c][r] = evaluate(f.entry[4 * r + c], q, t);
      result.translation[r] = evaluate(f.entry[4 * r + 3], q, t);
    }
    return result;
  }
  RigidMotion<T> operator()(const Curve& f) const {
    const Derivatives d = along(f.point, f.along, q, t);
    const Vector3<T> b = normalized(d.first);
    const Vector3<T> n = normalized(cross(b, f.reference ? values(*f.reference, q, t) : d.second));
    RigidMotion<T> frame;
    frame.column = {b, cross(n, b), n};
    frame.translation = d.value;
    return frame;
  }
  RigidMotion<T> operator()(const Surface& f) const { return surface_frame(f, q, t); }
  RigidMotion<T> operator()(const Mate& f) const {
    return surface_frame(f.first, q, t) * rotation({0, 0, 1}, evaluate(f.spin, q, t)) *
           inverse(surface_frame(f.second, q, t));
  }
  RigidMotion<T> operator()(const Inverse& f) const { return inverse(product_of(f.of, q, t)); }
};

}  // namespace

RigidMotion<T> surface_frame(const Surface& surface, const std::vector<T>& q, const T& t) {
  const Derivatives u = along(surface.point, surface.u, q, t);
  const Derivatives v = along(surface.point, surface.v, q, t);
  const Vector3<T> p0 = normalized(u.first);
  Vector3<T> n = normalized(cross(u.first, v.first));
  if (surface.flip) n = T(-1.0) * n;
  RigidMotion<T> frame;
  frame.column = {p0, cross(n, p0), n};
  frame.translation = u.value;
  return frame;
}

RigidMotion<T> product_of(const std::vector<Factor>& factors, const std::vector<T>& q, const T& t) {
  RigidMotion<T> result;
  for (const Factor& factor : factors) result = result * std::visit(FactorMotion{q, t}, factor.value);
  return result;
}

std::vector<RigidMotion<T>> world_poses(const Description& description, const std::vector<T>& q, const T& t) {
  std::vector<RigidMotion<T>> poses;
  for (const Body& body : description.bodies) {
    const RigidMotion<T> relative = product_of(body.transform, q, t);
    poses.push_back(body.parent < 0 ? relative : poses[static_cast<std::size_t>(body.parent)] * relative);
  }
  return poses;
}

// Its rates are N(q) u, and N(q') u + N(q) u' (N is linear).
std::vector<T> trajectory(const Description& description, const State& state,
                          const std::vector<double>& rates) {
  const std::vector<double> qd = coordinate_rates(description, state.q, state.speeds);
  const std::vector<double> by_rates = coordinate_rates(description, state.q, rates);
  std::vector<double> by_speeds = coordinate_rates(description, qd, state.speeds);
  for (const Coordinate& c : description.coordinates) {
    if (!c.quaternion) by_speeds[static_cast<std::size_t>(c.first_q)] = 0;
  }
  std::vector<T> q;
  for (std::size_t i = 0; i < state.q.size(); ++i)
    q.emplace_back(state.q[i], qd[i], by_speeds[i] + by_rates[i]);
  return q;
}

std::vector<T> unit_motion(const Description& description, const State& state, int k) {
  std::vector<double> unit(state.speeds.size(), 0.0);
  unit[static_cast<std::size_t>(k)] = 1;
  const std::vector<double> qd = coordinate_rates(description, state.q, unit);
  std::vector<T> q;
  for (std::size_t i = 0; i < qd.size(); ++i) q.emplace_back(state.q[i], qd[i], 0.0);
  return q;
}

}  // namespace alembert::oracles
