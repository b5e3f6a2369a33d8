// Numeric Lagrangian (see the header).
#include "oracles/taylor/numeric_lagrangian.hpp"

#include <Eigen/Dense>

#include "oracles/taylor/applied_forces.hpp"

namespace alembert::oracles {

namespace {

/// Symmetric: xx yy zz xy xz yz.
template <class R>
Vector3<R> inertia_times(const std::array<double, 6>& i, const Vector3<R>& v) {
  return {R(i[0]) * v[0] + R(i[3]) * v[1] + R(i[4]) * v[2], R(i[3]) * v[0] + R(i[1]) * v[1] + R(i[5]) * v[2],
          R(i[4]) * v[0] + R(i[5]) * v[1] + R(i[2]) * v[2]};
}

/// Motion of one body's centre of mass (world) and orientation (rates in body axes).
template <class R>
struct BodyMotion {
  std::array<Vector3<R>, 3> axes;
  Vector3<R> com, velocity, acceleration, omega, alpha;

  Vector3<R> in_body(const Vector3<R>& v) const {
    return {dot(axes[0], v), dot(axes[1], v), dot(axes[2], v)};
  }
  Vector3<R> in_world(const Vector3<R>& v) const { return v[0] * axes[0] + v[1] * axes[1] + v[2] * axes[2]; }
};

template <class R>
BodyMotion<R> motion_of(const Body& body, const RigidMotion<Jet<R>>& pose) {
  using T = Jet<R>;
  BodyMotion<R> m;
  std::array<Vector3<R>, 3> first, second;
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t r = 0; r < 3; ++r) {
      m.axes[c][r] = pose.column[c][r].value;
      first[c][r] = pose.column[c][r].first;
      second[c][r] = pose.column[c][r].second;
    }
  }
  const Vector3<T> com =
      rotated(pose, Vector3<T>{T(body.com[0]), T(body.com[1]), T(body.com[2])}) + pose.translation;
  for (std::size_t i = 0; i < 3; ++i) {
    m.com[i] = com[i].value;
    m.velocity[i] = com[i].first;
    m.acceleration[i] = com[i].second;
    // skew(om) = R^T R', so skew(al) = R'^T R' + R^T R'', whose first term is symmetric.
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    m.omega[i] = R(0.5) * (dot(m.axes[k], first[j]) - dot(m.axes[j], first[k]));
    m.alpha[i] = R(0.5) * (dot(m.axes[k], second[j]) - dot(m.axes[j], second[k]));
  }
  return m;
}

template <class R>
std::vector<BodyMotion<R>> motions_of(const Description& description, const std::vector<Jet<R>>& q,
                                      const Jet<R>& t) {
  const auto poses = world_poses(description, q, t);
  std::vector<BodyMotion<R>> motions;
  for (std::size_t i = 0; i < poses.size(); ++i)
    motions.push_back(motion_of(description.bodies[i], poses[i]));
  return motions;
}

/// By speed, rates of all bodies' motion with it.
template <class R>
std::vector<std::vector<BodyMotion<R>>> partial_velocities(const Description& description,
                                                           const StateOf<R>& state) {
  std::vector<std::vector<BodyMotion<R>>> partial;
  for (int k = 0; k < description.nv; ++k) {
    partial.push_back(
        motions_of(description, unit_motion(description, state, k), Jet<R>(state.time, R(0.0), R(0.0))));
  }
  return partial;
}

template <class R>
Vector3<R> three_of(const double* x) {
  return {R(x[0]), R(x[1]), R(x[2])};
}

/// Force (world) at the centre of mass and torque (body axes) that a body's motion takes.
template <class R>
struct Effort {
  Vector3<R> force, torque;
  Effort(const Description& description, const Body& body, const BodyMotion<R>& m,
         const std::map<std::string, Wrench>& wrenches) {
    force = R(body.mass) * (m.acceleration + R(-1.0) * three_of<R>(description.gravity.data()));
    torque = inertia_times(body.inertia, m.alpha) + cross(m.omega, inertia_times(body.inertia, m.omega));
    const auto found = wrenches.find(body.name);
    if (found == wrenches.end()) return;
    force = force + R(-1.0) * three_of<R>(found->second.data());
    torque = torque + R(-1.0) * m.in_body(three_of<R>(found->second.data() + 3));
  }
  R along(const BodyMotion<R>& direction) const {
    return dot(force, direction.velocity) + dot(torque, direction.omega);
  }
};

/// By speed: forces that the motion with these rates takes.
template <class R>
std::vector<R> forces_of(const Description& description, const StateOf<R>& state, const std::vector<R>& rates,
                         const std::vector<std::vector<BodyMotion<R>>>& partial,
                         const std::map<std::string, Wrench>& wrenches) {
  const auto moving =
      motions_of(description, trajectory(description, state, rates), Jet<R>(state.time, R(1.0), R(0.0)));
  std::vector<R> tau(partial.size(), R(0.0));
  for (std::size_t i = 0; i < description.bodies.size(); ++i) {
    const Effort<R> effort(description, description.bodies[i], moving[i], wrenches);
    for (std::size_t k = 0; k < tau.size(); ++k) tau[k] = tau[k] + effort.along(partial[k][i]);
  }
  return tau;
}

Eigen::Vector3d eigen(const Vector3<double>& v) {
  return {v[0], v[1], v[2]};
}

}  // namespace

template <class R>
DynamicsOf<R> numeric_lagrangian(const Description& description, const State& given) {
  const auto state = lifted<R>(given);
  const auto partial = partial_velocities(description, state);
  const auto forces = [](const std::vector<R>& tau) {
    return VectorOf<R>(Eigen::Map<const VectorOf<R>>(tau.data(), static_cast<Eigen::Index>(tau.size())));
  };
  const std::vector<R> no_rates(state.rates.size(), R(0.0));
  DynamicsOf<R> result{forces(forces_of(description, state, state.rates, partial, given.wrenches)),
                       MatrixOf<R>::Zero(description.nv, description.nv),
                       forces(forces_of(description, state, no_rates, partial, given.wrenches))};
  for (int k = 0; k < description.nv; ++k) {
    for (int l = 0; l < description.nv; ++l) {
      for (std::size_t i = 0; i < description.bodies.size(); ++i) {
        const Body& body = description.bodies[i];
        const BodyMotion<R>&dk = partial[static_cast<std::size_t>(k)][i],
              &dl = partial[static_cast<std::size_t>(l)][i];
        result.mass_matrix(k, l) += R(body.mass) * dot(dk.velocity, dl.velocity) +
                                    dot(dk.omega, inertia_times(body.inertia, dl.omega));
      }
    }
  }
  const std::vector<double> armatures = description.armatures();
  const VectorOf<R> applied = forces(applied_forces(description, state));
  result.tau -= applied;
  result.bias -= applied;
  for (int k = 0; k < description.nv; ++k) {
    const double a = armatures[static_cast<std::size_t>(k)];
    result.tau[k] += a * state.rates[static_cast<std::size_t>(k)];
    result.mass_matrix(k, k) += a;
  }
  return result;
}

template <class R>
std::vector<R> numeric_forces(const Description& description, const StateOf<R>& state,
                              const std::map<std::string, Wrench>& wrenches) {
  std::vector<R> forces =
      forces_of(description, state, state.rates, partial_velocities(description, state), wrenches);
  const std::vector<double> armatures = description.armatures();
  const std::vector<R> applied = applied_forces(description, state);
  for (std::size_t k = 0; k < forces.size(); ++k)
    forces[k] = forces[k] + R(armatures[k]) * state.rates[k] - applied[k];
  return forces;
}

template <class R>
std::pair<R, R> energy(const Description& description, const State& given) {
  const auto state = lifted<R>(given);
  const std::vector<R> no_rates(state.rates.size(), R(0.0));
  const auto motions =
      motions_of(description, trajectory(description, state, no_rates), Jet<R>(state.time, R(1.0), R(0.0)));
  std::pair<R, R> result{0, 0};
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Body& body = description.bodies[i];
    const BodyMotion<R>& m = motions[i];
    result.first += R(0.5) * (R(body.mass) * dot(m.velocity, m.velocity) +
                              dot(m.omega, inertia_times(body.inertia, m.omega)));
    result.second -= R(body.mass) * dot(three_of<R>(description.gravity.data()), m.com);
  }
  const std::vector<double> armatures = description.armatures();
  for (std::size_t k = 0; k < armatures.size(); ++k)
    result.first += 0.5 * armatures[k] * state.speeds[k] * state.speeds[k];
  result.second += potential_of_forces(description, state);
  return result;
}

template Dynamics numeric_lagrangian(const Description&, const State&);
template DynamicsOf<long double> numeric_lagrangian(const Description&, const State&);
template std::pair<double, double> energy(const Description&, const State&);
template std::pair<long double, long double> energy(const Description&, const State&);
template std::vector<Jet<double>> numeric_forces(const Description&, const StateOf<Jet<double>>&,
                                                 const std::map<std::string, Wrench>&);
template std::vector<Jet<long double>> numeric_forces(const Description&, const StateOf<Jet<long double>>&,
                                                      const std::map<std::string, Wrench>&);

std::vector<BodyState> body_states(const Description& description, const State& state) {
  const std::vector<double> no_rates(state.speeds.size(), 0.0);
  const auto poses =
      world_poses(description, trajectory(description, state, no_rates), Jet<double>(state.time, 1.0, 0.0));
  std::vector<BodyState> states;
  for (const RigidMotion<Jet<double>>& pose : poses) {
    const BodyMotion<double> m = motion_of(Body{}, pose);  // its centre of mass at the origin
    Eigen::Matrix3d R;
    R << eigen(m.axes[0]), eigen(m.axes[1]), eigen(m.axes[2]);
    states.push_back({R, eigen(m.com), eigen(m.velocity), eigen(m.in_world(m.omega))});
  }
  return states;
}

BodyAccelerations body_accelerations(const Description& description, const State& state,
                                     const Eigen::VectorXd& rates) {
  const std::vector<double> given(rates.begin(), rates.end());
  const auto motions =
      motions_of(description, trajectory(description, state, given), Jet<double>(state.time, 1.0, 0.0));
  BodyAccelerations result(6, static_cast<Eigen::Index>(motions.size()));
  Eigen::Index i = 0;
  for (const BodyMotion<double>& m : motions) {
    result.col(i).head<3>() = eigen(m.acceleration);
    result.col(i++).tail<3>() = eigen(m.in_world(m.alpha));
  }
  return result;
}

}  // namespace alembert::oracles
