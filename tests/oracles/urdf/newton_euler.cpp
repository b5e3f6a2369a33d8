// The outward and the inward pass (see the header).
#include "oracles/urdf/newton_euler.hpp"

namespace alembert::oracles {

namespace {

constexpr double kGravity = 9.81;  // of a description that says nothing else

/// A constant on any scalar.
template <class S>
struct On {
  static S scalar(long double x) { return static_cast<S>(x); }
};
template <class R>
struct On<Jet<R>> {
  static Jet<R> scalar(long double x) { return {On<R>::scalar(x), R(0.0), R(0.0)}; }
};
template <class S>
Vector3<S> on(const WideVector& v) {
  return {On<S>::scalar(v[0]), On<S>::scalar(v[1]), On<S>::scalar(v[2])};
}
template <class S>
RigidMotion<S> on(const RigidMotion<long double>& pose) {
  RigidMotion<S> result;
  for (std::size_t k = 0; k < 3; ++k) result.column[k] = on<S>(pose.column[k]);
  result.translation = on<S>(pose.translation);
  return result;
}

bool has_quaternion(const UrdfLinkage& linkage) {
  return linkage.motion == UrdfMotion::free || linkage.motion == UrdfMotion::ball;
}

/// What a linkage moves along and about, in its own frame (a quaternion's axes: in the child's), one for each
/// speed.
struct Directions {
  std::vector<WideVector> along, about;
};
Directions directions_of(const UrdfLinkage& linkage) {
  const WideVector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, &a = linkage.axis;
  switch (linkage.motion) {
    case UrdfMotion::fixed:
      break;
    case UrdfMotion::turn:
      return {{}, {a}};
    case UrdfMotion::shift:
      return {{a}, {}};
    case UrdfMotion::free:
      return {{x, y, z}, {x, y, z}};
    case UrdfMotion::ball:
      return {{}, {x, y, z}};
    case UrdfMotion::planar: {
      // The coordinate axes after the normal, or x and y turned by the shortest rotation from z to it.
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        WideVector u{}, v{};
        u[j] = v[k] = 1;
        if (a[i] > 0 && a[j] == 0 && a[k] == 0) return {{u, v}, {a}};
      }
      const long double off = std::hypot(a[0], a[1]);
      const WideVector axis = off == 0 ? x : WideVector{-a[1] / off, a[0] / off, 0};
      const RigidMotion<long double> tilt = rotation_about<long double>(axis, std::atan2(off, a[2]));
      return {{tilt.column[0], tilt.column[1]}, {a}};
    }
  }
  return {};
}

struct Places {
  std::vector<std::size_t> q, speed;  ///< by linkage, where its coordinates and speeds begin
  std::size_t nv = 0;
};
Places places_of(const UrdfTree& tree) {
  Places places;
  std::size_t nq = 0;
  for (const UrdfLinkage& linkage : tree.linkages) {
    places.q.push_back(nq);
    places.speed.push_back(places.nv);
    if (linkage.follows >= 0) continue;
    const Directions directions = directions_of(linkage);
    const std::size_t speeds = directions.along.size() + directions.about.size();
    places.nv += speeds;
    nq += speeds + (has_quaternion(linkage) ? 1 : 0);
  }
  for (std::size_t i = 0; i < tree.linkages.size(); ++i) {
    if (tree.linkages[i].follows < 0) continue;
    const auto of = static_cast<std::size_t>(tree.linkages[i].follows);
    places.q[i] = places.q[of];
    places.speed[i] = places.speed[of];
  }
  return places;
}

template <class S>
Vector3<S> tensor_times(const std::array<long double, 6>& inertia, const Vector3<S>& v) {
  std::array<S, 6> i;
  for (std::size_t k = 0; k < 6; ++k) i[k] = On<S>::scalar(inertia[k]);
  return {i[0] * v[0] + i[3] * v[1] + i[4] * v[2], i[3] * v[0] + i[1] * v[1] + i[5] * v[2],
          i[4] * v[0] + i[5] * v[1] + i[2] * v[2]};
}
template <class S>
Vector3<S> turned_back(const RigidMotion<S>& pose, const Vector3<S>& v) {
  return {dot(pose.column[0], v), dot(pose.column[1], v), dot(pose.column[2], v)};
}

/// A body's motion and what acts on it and all it carries, in world axes, about its origin.
template <class S>
struct Moving {
  RigidMotion<S> pose;
  Vector3<S> omega{}, alpha{}, acceleration{};  // of the origin
  Vector3<S> force{}, moment{};
  std::vector<Vector3<S>> along, about;  // of its linkage, by speed
};

template <class S>
Moving<S> carried(const UrdfLinkage& linkage, const Moving<S>& parent, const S* q, const S* u, const S* du) {
  const S factor = On<S>::scalar(linkage.follows < 0 ? 1 : linkage.multiplier);
  const S offset = On<S>::scalar(linkage.follows < 0 ? 0 : linkage.offset);
  const Directions directions = directions_of(linkage);
  const std::size_t shifts = directions.along.size();
  const RigidMotion<S> joint = parent.pose * on<S>(linkage.origin);
  Moving<S> out;
  RigidMotion<S> relative;
  Vector3<S> speed{S(0.0), S(0.0), S(0.0)}, rate = speed, omega = speed, alpha = speed;
  for (std::size_t i = 0; i < shifts; ++i) {
    const Vector3<S> along = on<S>(directions.along[i]);
    relative.translation = relative.translation + (factor * q[i] + offset) * along;
    out.along.push_back(rotated(joint, along));
    speed = speed + (factor * u[i]) * out.along[i];
    rate = rate + (factor * du[i]) * out.along[i];
  }
  if (has_quaternion(linkage)) {
    const S* const p = q + shifts;
    relative.column = quaternion_rotation(p[0], p[1], p[2], p[3]).column;
  } else if (!directions.about.empty()) {
    relative.column = rotation_about(on<S>(directions.about[0]), S(factor * q[shifts] + offset)).column;
  }
  out.pose = joint * relative;
  for (std::size_t i = 0; i < directions.about.size(); ++i) {
    // A single axis is not moved by a turn about it.
    out.about.push_back(rotated(out.pose, on<S>(directions.about[i])));
    omega = omega + (factor * u[shifts + i]) * out.about[i];
    alpha = alpha + (factor * du[shifts + i]) * out.about[i];
  }
  const Vector3<S> arm = out.pose.translation + S(-1.0) * parent.pose.translation;
  out.omega = parent.omega + omega;
  out.alpha = parent.alpha + alpha + cross(parent.omega, omega);
  out.acceleration = parent.acceleration + cross(parent.alpha, arm) +
                     cross(parent.omega, cross(parent.omega, arm)) + S(2.0) * cross(parent.omega, speed) +
                     rate;
  return out;
}

/// The forces of one body's own mass.
template <class S>
void add_own_forces(const UrdfBody& body, Moving<S>& m, double gravity) {
  const Vector3<S> arm = rotated(m.pose, on<S>(body.com));
  Vector3<S> acceleration = m.acceleration + cross(m.alpha, arm) + cross(m.omega, cross(m.omega, arm));
  acceleration[2] = acceleration[2] + S(gravity);
  const Vector3<S> omega = turned_back(m.pose, m.omega), alpha = turned_back(m.pose, m.alpha);
  m.force = On<S>::scalar(body.mass) * acceleration;
  m.moment =
      rotated(m.pose, tensor_times(body.inertia, alpha) + cross(omega, tensor_times(body.inertia, omega))) +
      cross(arm, m.force);
}

}  // namespace

int speeds_of(const UrdfTree& tree) {
  return static_cast<int>(places_of(tree).nv);
}

template <class S>
std::vector<S> newton_euler(const UrdfTree& tree, const StateOf<S>& state, double gravity) {
  const Places places = places_of(tree);
  const Vector3<S> zero{S(0.0), S(0.0), S(0.0)};
  Moving<S> world;
  world.omega = world.alpha = world.acceleration = zero;
  std::vector<Moving<S>> bodies(tree.bodies.size());
  for (const std::size_t i : tree.order) {
    const UrdfLinkage& linkage = tree.linkages[i];
    const auto child = static_cast<std::size_t>(linkage.child);
    bodies[child] =
        carried(linkage, linkage.parent < 0 ? world : bodies[static_cast<std::size_t>(linkage.parent)],
                state.q.data() + places.q[i], state.speeds.data() + places.speed[i],
                state.rates.data() + places.speed[i]);
    add_own_forces(tree.bodies[child], bodies[child], gravity);
  }
  std::vector<S> tau(places.nv, S(0.0));
  for (auto i = tree.order.rbegin(); i != tree.order.rend(); ++i) {
    const UrdfLinkage& linkage = tree.linkages[*i];
    const Moving<S>& m = bodies[static_cast<std::size_t>(linkage.child)];
    const S factor = On<S>::scalar(linkage.follows < 0 ? 1 : linkage.multiplier);
    S* at = tau.data() + places.speed[*i];
    for (std::size_t k = 0; k < m.along.size(); ++k) at[k] = at[k] + factor * dot(m.along[k], m.force);
    for (std::size_t k = 0; k < m.about.size(); ++k) {
      S& entry = at[m.along.size() + k];
      entry = entry + factor * dot(m.about[k], m.moment);
    }
    if (linkage.rotor != 0)
      at[0] = at[0] + On<S>::scalar(linkage.rotor) * factor * factor * state.rates[places.speed[*i]];
    if (linkage.damping != 0 || linkage.friction != 0) {
      using std::tanh;
      constexpr double kWidth = 0.01;  // of the friction, as importers take it
      const S rate = factor * state.speeds[places.speed[*i]];
      at[0] = at[0] + factor * (On<S>::scalar(linkage.damping) * rate +
                                On<S>::scalar(linkage.friction) * tanh(rate / S(kWidth)));
    }
    if (linkage.parent < 0) continue;
    Moving<S>& parent = bodies[static_cast<std::size_t>(linkage.parent)];
    const Vector3<S> arm = m.pose.translation + S(-1.0) * parent.pose.translation;
    parent.force = parent.force + m.force;
    parent.moment = parent.moment + m.moment + cross(arm, m.force);
  }
  return tau;
}

template <class R>
DynamicsOf<R> newton_euler_dynamics(const UrdfTree& tree, const State& given) {
  const auto n = static_cast<Eigen::Index>(given.speeds.size());
  StateOf<R> state = lifted<R>(given);
  const auto forces = [&](double gravity) {
    const std::vector<R> tau = newton_euler(tree, state, gravity);
    return VectorOf<R>(Eigen::Map<const VectorOf<R>>(tau.data(), n));
  };
  DynamicsOf<R> result{forces(kGravity), MatrixOf<R>(n, n), {}};
  state.rates.assign(given.rates.size(), R(0.0));
  result.bias = forces(kGravity);
  state.speeds.assign(given.speeds.size(), R(0.0));
  for (Eigen::Index k = 0; k < n; ++k) {
    state.rates[static_cast<std::size_t>(k)] = R(1.0);
    result.mass_matrix.col(k) = forces(0);
    state.rates[static_cast<std::size_t>(k)] = R(0.0);
  }
  return result;
}

template <class R>
std::pair<Eigen::MatrixXd, Eigen::MatrixXd> newton_euler_derivatives(const UrdfTree& tree,
                                                                     const Description& description,
                                                                     const State& given) {
  using T = Jet<R>;
  const auto n = static_cast<Eigen::Index>(given.speeds.size());
  std::pair<Eigen::MatrixXd, Eigen::MatrixXd> result{Eigen::MatrixXd(n, n), Eigen::MatrixXd(n, n)};
  const StateOf<T> fixed = lifted<T>(given);
  for (Eigen::Index k = 0; k < n; ++k) {
    StateOf<T> moved = fixed, faster = fixed;
    moved.q = unit_motion(description, lifted<R>(given), static_cast<int>(k));
    faster.speeds[static_cast<std::size_t>(k)].first = R(1.0);
    const std::vector<T> by_q = newton_euler(tree, moved, kGravity),
                         by_qd = newton_euler(tree, faster, kGravity);
    for (Eigen::Index i = 0; i < n; ++i) {
      result.first(i, k) = static_cast<double>(by_q[static_cast<std::size_t>(i)].first);
      result.second(i, k) = static_cast<double>(by_qd[static_cast<std::size_t>(i)].first);
    }
  }
  return result;
}

template DynamicsOf<double> newton_euler_dynamics(const UrdfTree&, const State&);
template DynamicsOf<long double> newton_euler_dynamics(const UrdfTree&, const State&);
template std::pair<Eigen::MatrixXd, Eigen::MatrixXd> newton_euler_derivatives<double>(const UrdfTree&,
                                                                                      const Description&,
                                                                                      const State&);
template std::pair<Eigen::MatrixXd, Eigen::MatrixXd> newton_euler_derivatives<long double>(const UrdfTree&,
                                                                                           const Description&,
                                                                                           const State&);

}  // namespace alembert::oracles
