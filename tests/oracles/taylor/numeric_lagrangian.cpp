// Numeric Lagrangian (see the header).
#include "oracles/taylor/numeric_lagrangian.hpp"

#include <Eigen/Dense>

#include "oracles/taylor/poses.hpp"

namespace alembert::oracles {

namespace {

using T = Jet<double>;  // along the motion

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

/// Rates of all bodies' motion with speed k.
std::vector<BodyMotion> partial_velocities(const Description& description, const State& state, int k) {
  return motions_of(description, unit_motion(description, state, k), T(state.time));
}

}  // namespace

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
  const std::vector<double> armatures = description.armatures();
  for (int k = 0; k < description.nv; ++k) {
    const double a = armatures[static_cast<std::size_t>(k)];
    result.tau[k] += a * state.rates[static_cast<std::size_t>(k)];
    result.mass_matrix(k, k) += a;
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
  const std::vector<double> armatures = description.armatures();
  for (std::size_t k = 0; k < armatures.size(); ++k)
    result.first += 0.5 * armatures[k] * state.speeds[k] * state.speeds[k];
  return result;
}

std::vector<BodyState> body_states(const Description& description, const State& state) {
  const std::vector<double> no_rates(state.speeds.size(), 0.0);
  const auto poses =
      world_poses(description, trajectory(description, state, no_rates), T(state.time, 1.0, 0.0));
  std::vector<BodyState> states;
  for (const RigidMotion<T>& pose : poses) {
    const BodyMotion m = motion_of(Body{}, pose);  // its centre of mass at the origin
    states.push_back({m.R, m.com, m.velocity, m.R * m.omega});
  }
  return states;
}

BodyAccelerations body_accelerations(const Description& description, const State& state,
                                     const Eigen::VectorXd& rates) {
  const std::vector<double> given(rates.begin(), rates.end());
  const auto motions =
      motions_of(description, trajectory(description, state, given), T(state.time, 1.0, 0.0));
  BodyAccelerations result(6, static_cast<Eigen::Index>(motions.size()));
  Eigen::Index i = 0;
  for (const BodyMotion& m : motions) {
    result.col(i).head<3>() = m.acceleration;
    result.col(i++).tail<3>() = m.R * m.alpha;
  }
  return result;
}

}  // namespace alembert::oracles
