// Numeric Lagrangian (see the header).
#include "oracles/taylor/numeric_lagrangian.hpp"

#include <Eigen/Dense>

namespace alembert::oracles {

namespace {

using T = Jet<double>;  // along the motion
using TT = Jet<T>;      // and along a coordinate of a curve or surface

RigidMotion<T> product_of(const std::vector<Factor>& factors, const std::vector<T>& q, const T& t);

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

RigidMotion<T> product_of(const std::vector<Factor>& factors, const std::vector<T>& q, const T& t) {
  RigidMotion<T> result;
  for (const Factor& factor : factors) result = result * std::visit(FactorMotion{q, t}, factor.value);
  return result;
}

Eigen::Matrix3d inertia_of(const Body& body) {
  const auto& i = body.inertia;
  Eigen::Matrix3d inertia;
  inertia << i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2];
  return inertia;
}

/// Motion of one body's centre of mass (world) and orientation (rates in body axes).
struct BodyMotion {
  Eigen::Matrix3d R;
  Eigen::Vector3d com, velocity, acceleration, omega, alpha;
};

Eigen::Vector3d vee(const Eigen::Matrix3d& a) {
  return 0.5 * Eigen::Vector3d(a(2, 1) - a(1, 2), a(0, 2) - a(2, 0), a(1, 0) - a(0, 1));
}

BodyMotion motion_of(const Body& body, const RigidMotion<T>& pose) {
  Eigen::Matrix3d R, Rd, Rdd;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      const T& entry = pose.column[static_cast<std::size_t>(c)][static_cast<std::size_t>(r)];
      R(r, c) = entry.value;
      Rd(r, c) = entry.first;
      Rdd(r, c) = entry.second;
    }
  }
  const Vector3<T> com =
      rotated(pose, Vector3<T>{T(body.com[0]), T(body.com[1]), T(body.com[2])}) + pose.translation;
  BodyMotion m;
  m.R = R;
  m.com = {com[0].value, com[1].value, com[2].value};
  m.velocity = {com[0].first, com[1].first, com[2].first};
  m.acceleration = {com[0].second, com[1].second, com[2].second};
  // skew(om) = R^T R', so skew(al) = R'^T R' + R^T R'', whose first term is symmetric.
  m.omega = vee(R.transpose() * Rd);
  m.alpha = vee(R.transpose() * Rdd);
  return m;
}

std::vector<BodyMotion> motions_of(const Description& description, const std::vector<T>& q, const T& t) {
  const auto poses = world_poses(description, q, t);
  std::vector<BodyMotion> motions;
  for (std::size_t i = 0; i < poses.size(); ++i)
    motions.push_back(motion_of(description.bodies[i], poses[i]));
  return motions;
}

/// q along the motion: its rates are N(q) u, and N(q') u + N(q) u' (N is linear).
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

/// Rates of all bodies' motion with speed k: the velocities of a motion with that speed 1, others 0, time at
/// rest.
std::vector<BodyMotion> partial_velocities(const Description& description, const State& state, int k) {
  std::vector<double> unit(state.speeds.size(), 0.0);
  unit[static_cast<std::size_t>(k)] = 1;
  const std::vector<double> qd = coordinate_rates(description, state.q, unit);
  std::vector<T> q;
  for (std::size_t i = 0; i < qd.size(); ++i) q.emplace_back(state.q[i], qd[i], 0.0);
  return motions_of(description, q, T(state.time));
}

}  // namespace

std::vector<RigidMotion<T>> world_poses(const Description& description, const std::vector<T>& q, const T& t) {
  std::vector<RigidMotion<T>> poses;
  for (const Body& body : description.bodies) {
    const RigidMotion<T> relative = product_of(body.transform, q, t);
    poses.push_back(body.parent < 0 ? relative : poses[static_cast<std::size_t>(body.parent)] * relative);
  }
  return poses;
}

Dynamics numeric_lagrangian(const Description& description, const State& state) {
  const T time(state.time, 1.0, 0.0);
  const std::vector<double> no_rates(state.rates.size(), 0.0);
  const auto moving = motions_of(description, trajectory(description, state, state.rates), time);
  const auto coasting = motions_of(description, trajectory(description, state, no_rates), time);
  std::vector<std::vector<BodyMotion>> partial;
  for (int k = 0; k < description.nv; ++k) partial.push_back(partial_velocities(description, state, k));

  const Eigen::Vector3d gravity(description.gravity[0], description.gravity[1], description.gravity[2]);
  Dynamics result{Eigen::VectorXd::Zero(description.nv),
                  Eigen::MatrixXd::Zero(description.nv, description.nv),
                  Eigen::VectorXd::Zero(description.nv)};
  for (std::size_t i = 0; i < description.bodies.size(); ++i) {
    const Body& body = description.bodies[i];
    const Eigen::Matrix3d inertia = inertia_of(body);
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), torque = Eigen::Vector3d::Zero();
    if (const auto found = state.wrenches.find(body.name); found != state.wrenches.end()) {
      force = {found->second[0], found->second[1], found->second[2]};
      torque = {found->second[3], found->second[4], found->second[5]};
    }
    const auto effort = [&](const BodyMotion& m, const BodyMotion& direction) {
      const Eigen::Vector3d linear = body.mass * (m.acceleration - gravity) - force;
      const Eigen::Vector3d angular =
          inertia * m.alpha + m.omega.cross(inertia * m.omega) - m.R.transpose() * torque;
      return linear.dot(direction.velocity) + angular.dot(direction.omega);
    };
    for (int k = 0; k < description.nv; ++k) {
      const BodyMotion& dk = partial[static_cast<std::size_t>(k)][i];
      result.tau[k] += effort(moving[i], dk);
      result.bias[k] += effort(coasting[i], dk);
      for (int l = 0; l < description.nv; ++l) {
        const BodyMotion& dl = partial[static_cast<std::size_t>(l)][i];
        result.mass_matrix(k, l) +=
            body.mass * dk.velocity.dot(dl.velocity) + dk.omega.dot(inertia * dl.omega);
      }
    }
  }
  return result;
}

std::pair<double, double> energy(const Description& description, const State& state) {
  const std::vector<double> no_rates(state.rates.size(), 0.0);
  const auto motions =
      motions_of(description, trajectory(description, state, no_rates), T(state.time, 1.0, 0.0));
  const Eigen::Vector3d gravity(description.gravity[0], description.gravity[1], description.gravity[2]);
  std::pair<double, double> result{0, 0};
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Body& body = description.bodies[i];
    const BodyMotion& m = motions[i];
    result.first += 0.5 * (body.mass * m.velocity.squaredNorm() + m.omega.dot(inertia_of(body) * m.omega));
    result.second -= body.mass * gravity.dot(m.com);
  }
  return result;
}

}  // namespace alembert::oracles
