// Poses from factors (see the header).
#include "oracles/taylor/poses.hpp"

namespace alembert::oracles {

namespace {

/// Along the motion, and along a coordinate of a curve or surface.
template <class R>
using Twofold = Jet<Jet<R>>;

/// Coordinates as jets along coordinate `along`.
template <class R>
std::vector<Twofold<R>> along_coordinate(const std::vector<Jet<R>>& q, int along) {
  std::vector<Twofold<R>> result;
  for (std::size_t i = 0; i < q.size(); ++i) {
    result.emplace_back(q[i], Jet<R>(static_cast<int>(i) == along ? 1.0 : 0.0), Jet<R>(0.0));
  }
  return result;
}

template <class R>
struct Derivatives {
  Vector3<Jet<R>> value, first, second;
};

template <class R>
Derivatives<R> along(const Expression3& point, int coordinate, const std::vector<Jet<R>>& q,
                     const Jet<R>& t) {
  const std::vector<Twofold<R>> moved = along_coordinate(q, coordinate);
  const Twofold<R> time(t, Jet<R>(0.0), Jet<R>(0.0));
  Derivatives<R> d;
  for (std::size_t i = 0; i < 3; ++i) {
    const Twofold<R> f = evaluate(point[i], moved, time);
    d.value[i] = f.value;
    d.first[i] = f.first;
    d.second[i] = f.second;
  }
  return d;
}

template <class R>
Vector3<Jet<R>> values(const Expression3& e, const std::vector<Jet<R>>& q, const Jet<R>& t) {
  return {evaluate(e[0], q, t), evaluate(e[1], q, t), evaluate(e[2], q, t)};
}

template <class R>
struct FactorMotion {
  using T = Jet<R>;
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
    const Derivatives<R> d = along(f.point, f.along, q, t);
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

template <class R>
RigidMotion<Jet<R>> surface_frame(const Surface& surface, const std::vector<Jet<R>>& q, const Jet<R>& t) {
  const Derivatives<R> u = along(surface.point, surface.u, q, t);
  const Derivatives<R> v = along(surface.point, surface.v, q, t);
  const Vector3<Jet<R>> p0 = normalized(u.first);
  Vector3<Jet<R>> n = normalized(cross(u.first, v.first));
  if (surface.flip) n = Jet<R>(-1.0) * n;
  RigidMotion<Jet<R>> frame;
  frame.column = {p0, cross(n, p0), n};
  frame.translation = u.value;
  return frame;
}

template <class R>
RigidMotion<Jet<R>> product_of(const std::vector<Factor>& factors, const std::vector<Jet<R>>& q,
                               const Jet<R>& t) {
  RigidMotion<Jet<R>> result;
  for (const Factor& factor : factors) result = result * std::visit(FactorMotion<R>{q, t}, factor.value);
  return result;
}

template <class R>
std::vector<RigidMotion<Jet<R>>> world_poses(const Description& description, const std::vector<Jet<R>>& q,
                                             const Jet<R>& t) {
  std::vector<RigidMotion<Jet<R>>> poses;
  for (const Body& body : description.bodies) {
    const RigidMotion<Jet<R>> relative = product_of(body.transform, q, t);
    poses.push_back(body.parent < 0 ? relative : poses[static_cast<std::size_t>(body.parent)] * relative);
  }
  return poses;
}

template <class R>
std::vector<RigidMotion<Jet<R>>> frame_poses(const Description& description, const std::vector<Jet<R>>& q,
                                             const Jet<R>& t) {
  const auto bodies = world_poses(description, q, t);
  std::vector<RigidMotion<Jet<R>>> poses;
  for (const Frame& frame : description.frames) {
    const RigidMotion<Jet<R>> relative = product_of(frame.transform, q, t);
    poses.push_back(frame.body < 0 ? relative : bodies[static_cast<std::size_t>(frame.body)] * relative);
  }
  return poses;
}

// skew(angular velocity) = R' R^T
template <class R>
Vector3<R> angular_velocity(const RigidMotion<Jet<R>>& pose) {
  const auto spin = [&](std::size_t row, std::size_t column) {
    R sum(0.0);
    for (const Vector3<Jet<R>>& axis : pose.column) sum = sum + axis[row].first * axis[column].value;
    return sum;
  };
  return {spin(2, 1), spin(0, 2), spin(1, 0)};
}

// Its rates are N(q) u, and N(q') u + N(q) u' (N is linear).
template <class R>
std::vector<Jet<R>> trajectory(const Description& description, const StateOf<R>& state,
                               const std::vector<R>& rates) {
  const std::vector<R> qd = coordinate_rates(description, state.q, state.speeds);
  const std::vector<R> by_rates = coordinate_rates(description, state.q, rates);
  std::vector<R> by_speeds = coordinate_rates(description, qd, state.speeds);
  for (const Coordinate& c : description.coordinates) {
    if (!c.quaternion) by_speeds[static_cast<std::size_t>(c.first_q)] = R(0.0);
  }
  std::vector<Jet<R>> q;
  for (std::size_t i = 0; i < state.q.size(); ++i)
    q.emplace_back(state.q[i], qd[i], by_speeds[i] + by_rates[i]);
  return q;
}

template <class R>
std::vector<Jet<R>> unit_motion(const Description& description, const StateOf<R>& state, int k) {
  std::vector<R> unit(state.speeds.size(), R(0.0));
  unit[static_cast<std::size_t>(k)] = R(1.0);
  const std::vector<R> qd = coordinate_rates(description, state.q, unit);
  std::vector<Jet<R>> q;
  for (std::size_t i = 0; i < qd.size(); ++i) q.emplace_back(state.q[i], qd[i], R(0.0));
  return q;
}

// What jets there are of.
#define ALEMBERT_POSES(R)                                                                                \
  template RigidMotion<Jet<R>> surface_frame(const Surface&, const std::vector<Jet<R>>&, const Jet<R>&); \
  template RigidMotion<Jet<R>> product_of(const std::vector<Factor>&, const std::vector<Jet<R>>&,        \
                                          const Jet<R>&);                                                \
  template std::vector<RigidMotion<Jet<R>>> world_poses(const Description&, const std::vector<Jet<R>>&,  \
                                                        const Jet<R>&);                                  \
  template std::vector<RigidMotion<Jet<R>>> frame_poses(const Description&, const std::vector<Jet<R>>&,  \
                                                        const Jet<R>&);                                  \
  template Vector3<R> angular_velocity(const RigidMotion<Jet<R>>&);                                      \
  template std::vector<Jet<R>> trajectory(const Description&, const StateOf<R>&, const std::vector<R>&); \
  template std::vector<Jet<R>> unit_motion(const Description&, const StateOf<R>&, int);
ALEMBERT_POSES(double)
ALEMBERT_POSES(long double)
ALEMBERT_POSES(Jet<double>)
ALEMBERT_POSES(Jet<long double>)
#undef ALEMBERT_POSES

}  // namespace alembert::oracles
