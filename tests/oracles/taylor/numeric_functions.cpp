// Results of functions by jets and by differences of them (see the header).
#include "oracles/taylor/numeric_functions.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>

#include "oracles/taylor/numeric_constraints.hpp"
#include "oracles/taylor/numeric_lagrangian.hpp"
#include "oracles/taylor/poses.hpp"

namespace alembert::oracles {

namespace {

using T = Jet<double>;
using Point = std::array<double, 3>;

/// Where something is in the world, at which of its points, and how that moves.
struct Motion {
  Eigen::Matrix<double, 3, 4> pose;
  Eigen::Matrix<double, 6, 1> velocity;  // angular, of the point
};

/// Along whatever the pose moves along.
Motion motion_at(const RigidMotion<T>& pose, const Point& point) {
  const Vector3<T> at = rotated(pose, Vector3<T>{T(point[0]), T(point[1]), T(point[2])}) + pose.translation;
  Motion motion;
  Eigen::Matrix3d rate;
  for (Eigen::Index r = 0; r < 3; ++r) {
    const auto row = static_cast<std::size_t>(r);
    for (Eigen::Index c = 0; c < 3; ++c) {
      const T& entry = pose.column[static_cast<std::size_t>(c)][row];
      motion.pose(r, c) = entry.value;
      rate(r, c) = entry.first;
    }
    motion.pose(r, 3) = pose.translation[row].value;
    motion.velocity[3 + r] = at[row].first;
  }
  // skew(angular velocity in world axes) = R' R^T
  const Eigen::Matrix3d spin = rate * motion.pose.leftCols<3>().transpose();
  motion.velocity.head<3>() << spin(2, 1), spin(0, 2), spin(1, 0);
  return motion;
}

/// Motions of bodies at their centres of mass, and of frames at their origins.
struct Motions {
  std::vector<Motion> bodies, frames;
};
Motions motions(const Description& description, const std::vector<T>& q, const T& t) {
  const std::vector<RigidMotion<T>> poses = world_poses(description, q, t);
  Motions result;
  for (std::size_t i = 0; i < poses.size(); ++i)
    result.bodies.push_back(motion_at(poses[i], description.bodies[i].com));
  for (const Frame& frame : description.frames) {
    RigidMotion<T> pose = product_of(frame.transform, q, t);
    if (frame.body >= 0) pose = poses[static_cast<std::size_t>(frame.body)] * pose;
    result.frames.push_back(motion_at(pose, {}));
  }
  return result;
}

Eigen::MatrixXd pose_rows(const std::vector<Motion>& motions) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(motions.size()), 12);
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    rows.row(i) = motions[static_cast<std::size_t>(i)].pose.reshaped<Eigen::RowMajor>().transpose();
  return rows;
}

Eigen::MatrixXd inertia_rows(const Description& description) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(description.bodies.size()), 10);
  Eigen::Index i = 0;
  for (const Body& body : description.bodies) {
    rows.row(i++) << body.mass, body.com[0], body.com[1], body.com[2], body.inertia[0], body.inertia[1],
        body.inertia[2], body.inertia[3], body.inertia[4], body.inertia[5];
  }
  return rows;
}

/// The state moved by `distance` along speed k: real coordinates by adding, quaternions by turning about an
/// axis of the child.
State moved(const Description& description, State state, int k, double distance) {
  for (const Coordinate& c : description.coordinates) {
    const int axis = k - c.first_speed;
    if (axis < 0 || axis >= (c.quaternion ? 3 : 1)) continue;
    double* q = &state.q[static_cast<std::size_t>(c.first_q)];
    if (!c.quaternion) {
      q[0] += distance;
      continue;
    }
    const Eigen::Quaterniond turned =
        Eigen::Quaterniond(q[3], q[0], q[1], q[2]) *
        Eigen::Quaterniond(Eigen::AngleAxisd(distance, Eigen::Vector3d::Unit(axis)));
    for (int i = 0; i < 4; ++i) q[i] = turned.coeffs()[i];
  }
  return state;
}

/// d f(x)/dx at 0 by central differences of the eighth order, with the step after which a smaller one changes
/// the result least: large ones reach singular points and knots of splines, small ones lose digits.
template <class F>
Eigen::VectorXd central_difference(const F& f) {
  constexpr std::array<double, 4> kWeight{4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
  Eigen::VectorXd best = Eigen::VectorXd::Constant(f(0.0).size(), std::nan("")), last;
  double least = std::numeric_limits<double>::infinity();
  for (const double step : {4e-3, 5e-4, 6e-5, 8e-6}) {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(best.size());
    for (std::size_t i = 0; i < kWeight.size(); ++i) {
      const double x = static_cast<double>(i + 1) * step;
      result += kWeight[i] / step * (f(x) - f(-x));
    }
    const double change = last.size() == 0 ? least : relative_error(result, last);
    if (change < least) {
      least = change;
      best = last;
    }
    last = result;
  }
  return best;
}

Arrays derivatives_of_forces(const Description& description, const State& state) {
  Eigen::MatrixXd along(description.nv, description.nv), by_speeds(description.nv, description.nv);
  for (int k = 0; k < description.nv; ++k) {
    along.col(k) = central_difference(
        [&](double x) { return numeric_lagrangian(description, moved(description, state, k, x)).tau; });
    // Forces are quadratic in the speeds: this difference is exact.
    State faster = state, slower = state;
    faster.speeds[static_cast<std::size_t>(k)] += 1;
    slower.speeds[static_cast<std::size_t>(k)] -= 1;
    by_speeds.col(k) =
        (numeric_lagrangian(description, faster).tau - numeric_lagrangian(description, slower).tau) / 2;
  }
  return {{"tau_q", along}, {"tau_qd", by_speeds}};
}

Eigen::VectorXd column(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

std::map<std::string, Arrays> numeric_functions(const Description& description, const State& state) {
  std::map<std::string, Arrays> all;
  const Dynamics dynamics = numeric_lagrangian(description, state);
  all["inverse_dynamics"] = {{"tau", dynamics.tau}};
  all["mass_matrix"] = {{"M", dynamics.mass_matrix}};
  all["bias"] = {{"c", dynamics.bias}};
  all["mass_matrix_and_bias"] = {{"M", dynamics.mass_matrix}, {"c", dynamics.bias}};
  all["forward_dynamics"] = {{"qdd", column(state.rates)}};
  all["coordinate_rates"] = {{"qdot", column(coordinate_rates(description, state.q, state.speeds))}};
  const auto [kinetic, potential] = energy(description, state);
  all["energy"] = {{"e", Eigen::Vector2d(kinetic, potential)}};

  const Motions now = motions(description, unit_motion(description, state, 0), T(state.time));
  all["body_poses"] = {{"W", pose_rows(now.bodies)}};
  all["frame_poses"] = {{"F", pose_rows(now.frames)}};
  Eigen::MatrixXd bodies(6 * static_cast<Eigen::Index>(now.bodies.size()), description.nv);
  Eigen::MatrixXd frames(6 * static_cast<Eigen::Index>(now.frames.size()), description.nv);
  for (int k = 0; k < description.nv; ++k) {
    const Motions partial = motions(description, unit_motion(description, state, k), T(state.time));
    for (std::size_t i = 0; i < partial.bodies.size(); ++i)
      bodies.block<6, 1>(6 * static_cast<Eigen::Index>(i), k) = partial.bodies[i].velocity;
    for (std::size_t i = 0; i < partial.frames.size(); ++i)
      frames.block<6, 1>(6 * static_cast<Eigen::Index>(i), k) = partial.frames[i].velocity;
  }
  all["body_jacobians"] = {{"J", bodies}};
  all["frame_jacobians"] = {{"J", frames}};
  all["body_inertias"] = {{"inertias", inertia_rows(description)}};

  const ConstraintRows rows = numeric_constraints(description, state);
  all["constraints"] = {
      {"P", rows.P}, {"gamma", rows.gamma}, {"velocity", rows.velocity}, {"position", rows.position}};
  all["inverse_dynamics_derivatives"] = derivatives_of_forces(description, state);
  return all;
}

}  // namespace alembert::oracles
