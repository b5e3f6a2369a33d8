// Results of functions by jets (see the header).
#include "oracles/taylor/numeric_functions.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <random>
#include <utility>

#include "oracles/taylor/applied_forces.hpp"
#include "oracles/taylor/constrained_functions.hpp"
#include "oracles/taylor/force_derivatives.hpp"
#include "oracles/taylor/numeric_constraints.hpp"
#include "oracles/taylor/numeric_lagrangian.hpp"
#include "oracles/taylor/numeric_reactions.hpp"
#include "oracles/taylor/poses.hpp"

namespace alembert::oracles {

namespace {

/// Where something is in the world, at which of its points, and how that moves.
template <class R>
struct Motion {
  Eigen::Matrix<R, 3, 4> pose;
  Eigen::Matrix<R, 6, 1> velocity, acceleration;  // angular, of the point
};

/// Along whatever the pose moves along.
template <class R>
Motion<R> motion_at(const RigidMotion<Jet<R>>& pose, const std::array<double, 3>& point) {
  using T = Jet<R>;
  const Vector3<T> at = rotated(pose, Vector3<T>{T(point[0]), T(point[1]), T(point[2])}) + pose.translation;
  Motion<R> motion;
  const Vector3<R> omega = angular_velocity(pose);
  // Of a column c, c'' = al x c + om x (om x c): the sum of c x c'' over all three is 2 al.
  Vector3<R> twice{R(0.0), R(0.0), R(0.0)};
  for (const Vector3<T>& column : pose.column)
    for (std::size_t r = 0; r < 3; ++r) {
      const std::size_t s = (r + 1) % 3, t = (r + 2) % 3;
      twice[r] = twice[r] + column[s].value * column[t].second - column[t].value * column[s].second;
    }
  for (Eigen::Index r = 0; r < 3; ++r) {
    const auto row = static_cast<std::size_t>(r);
    for (std::size_t c = 0; c < 3; ++c)
      motion.pose(r, static_cast<Eigen::Index>(c)) = pose.column[c][row].value;
    motion.pose(r, 3) = pose.translation[row].value;
    motion.velocity[r] = omega[row];
    motion.velocity[3 + r] = at[row].first;
    motion.acceleration[r] = twice[row] / R(2);
    motion.acceleration[3 + r] = at[row].second;
  }
  return motion;
}

/// Motions of bodies at their centres of mass, and of frames at their origins.
template <class R>
struct Motions {
  std::vector<Motion<R>> bodies, frames;
};
template <class R>
Motions<R> motions(const Description& description, const std::vector<Jet<R>>& q, const Jet<R>& t) {
  const auto poses = world_poses(description, q, t);
  Motions<R> result;
  for (std::size_t i = 0; i < poses.size(); ++i)
    result.bodies.push_back(motion_at(poses[i], description.bodies[i].com));
  for (const RigidMotion<Jet<R>>& frame : frame_poses(description, q, t))
    result.frames.push_back(motion_at(frame, {}));
  return result;
}

template <class R>
Eigen::MatrixXd pose_rows(const std::vector<Motion<R>>& motions) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(motions.size()), 12);
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    rows.row(i) = motions[static_cast<std::size_t>(i)]
                      .pose.template cast<double>()
                      .template reshaped<Eigen::RowMajor>()
                      .transpose();
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

/// By jets along each speed: coordinates move with it, a quaternion by turning about an axis of the child.
template <class R>
std::pair<MatrixOf<R>, MatrixOf<R>> derivatives_of_forces(const Description& description,
                                                          const State& given) {
  using T = Jet<R>;
  MatrixOf<R> along(description.nv, description.nv), by_speeds(description.nv, description.nv);
  const StateOf<T> fixed = lifted<T>(given);
  for (int k = 0; k < description.nv; ++k) {
    StateOf<T> moved = fixed, faster = fixed;
    moved.q = unit_motion(description, lifted<R>(given), k);
    faster.speeds[static_cast<std::size_t>(k)].first = R(1.0);
    const std::vector<T> by_q = numeric_forces(description, moved, given.wrenches);
    const std::vector<T> by_qd = numeric_forces(description, faster, given.wrenches);
    for (int i = 0; i < description.nv; ++i) {
      along(i, k) = by_q[static_cast<std::size_t>(i)].first;
      by_speeds(i, k) = by_qd[static_cast<std::size_t>(i)].first;
    }
  }
  return {along, by_speeds};
}

/// `of` a state whose jets are along one of the numbers in `values`: inputs or states.
template <class R, class Given, class Of>
Eigen::MatrixXd derivatives_by(const State& at, const std::vector<Given>& given,
                               std::map<std::string, Jet<R>> StateOf<Jet<R>>::*values, Eigen::Index rows,
                               Of of) {
  Eigen::MatrixXd result(rows, static_cast<Eigen::Index>(given.size()));
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    StateOf<Jet<R>> state = lifted<Jet<R>>(at);
    const Given& by = given[static_cast<std::size_t>(i)];
    (state.*values).try_emplace(by.name, by.initial).first->second.first = R(1.0);
    const std::vector<Jet<R>> moved = of(state);
    for (Eigen::Index k = 0; k < rows; ++k)
      result(k, i) = static_cast<double>(moved[static_cast<std::size_t>(k)].first);
  }
  return result;
}

template <class R>
Arrays derivatives_of_state_rates(const Description& description, const State& given) {
  using T = Jet<R>;
  const auto rows = static_cast<Eigen::Index>(description.states.size());
  const auto rates = [&](const StateOf<T>& state) { return state_rates(description, state); };
  Eigen::MatrixXd along(rows, description.nv), by_speeds(rows, description.nv);
  for (int k = 0; k < description.nv; ++k) {
    StateOf<T> moved = lifted<T>(given), faster = moved;
    moved.q = unit_motion(description, lifted<R>(given), k);
    faster.speeds[static_cast<std::size_t>(k)].first = R(1.0);
    const std::vector<T> by_q = rates(moved), by_qd = rates(faster);
    for (Eigen::Index i = 0; i < rows; ++i) {
      along(i, k) = static_cast<double>(by_q[static_cast<std::size_t>(i)].first);
      by_speeds(i, k) = static_cast<double>(by_qd[static_cast<std::size_t>(i)].first);
    }
  }
  return {{"r_q", along},
          {"r_qd", by_speeds},
          {"r_s", derivatives_by<R>(given, description.states, &StateOf<T>::states, rows, rates)}};
}

template <class R>
Eigen::MatrixXd jacobian(const std::vector<std::vector<Motion<R>>>& partial) {
  Eigen::MatrixXd J(6 * static_cast<Eigen::Index>(partial[0].size()),
                    static_cast<Eigen::Index>(partial.size()));
  for (std::size_t k = 0; k < partial.size(); ++k) {
    for (std::size_t i = 0; i < partial[k].size(); ++i)
      J.block<6, 1>(6 * static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
          partial[k][i].velocity.template cast<double>();
  }
  return J;
}

/// A row of six for each.
template <class R>
Eigen::MatrixXd rows_of(const std::vector<Motion<R>>& motions, Eigen::Matrix<R, 6, 1> Motion<R>::*what) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(motions.size()), 6);
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    rows.row(i) = (motions[static_cast<std::size_t>(i)].*what).template cast<double>().transpose();
  return rows;
}

/// Rates of the frames' velocities along each speed, as the mechanism moves: by jets of jets.
template <class R>
Eigen::MatrixXd jacobian_rates(const Description& description, const State& given) {
  using T = Jet<R>;
  const std::vector<R> no_rates(given.speeds.size(), R(0.0));
  StateOf<T> moving = lifted<T>(given);
  moving.q = trajectory(description, lifted<R>(given), no_rates);
  const Jet<T> t(T(R(given.time), R(1.0), R(0.0)), T(0.0), T(0.0));
  Eigen::MatrixXd J(6 * static_cast<Eigen::Index>(description.frames.size()), description.nv);
  for (int k = 0; k < description.nv; ++k) {
    Eigen::Index row = 0;
    for (const RigidMotion<Jet<T>>& pose : frame_poses(description, unit_motion(description, moving, k), t)) {
      const Vector3<T> omega = angular_velocity(pose);
      for (const T& entry : omega) J(row++, k) = static_cast<double>(entry.first);
      for (const Jet<T>& entry : pose.translation) J(row++, k) = static_cast<double>(entry.first.first);
    }
  }
  return J;
}

/// Of each body the 4x4 matrix of its pose, as twelve entries: columns of R, then a point of the body. `take` is what is
/// taken of each.
template <class T, class Take>
auto pose_entries(const Description& description, const std::vector<RigidMotion<T>>& poses, bool at_centers,
                  Take take) {
  std::vector<decltype(take(poses[0].translation[0]))> entries;
  for (std::size_t b = 0; b < poses.size(); ++b) {
    for (const Vector3<T>& column : poses[b].column)
      for (const T& entry : column) entries.push_back(take(entry));
    const std::array<double, 3>& com = description.bodies[b].com;
    Vector3<T> point = poses[b].translation;
    if (at_centers) point = rotated(poses[b], Vector3<T>{T(com[0]), T(com[1]), T(com[2])}) + point;
    for (const T& entry : point) entries.push_back(take(entry));
  }
  return entries;
}

/// Integral of (x y z 1)^T (x y z 1) dm, of the mass, mass times centre of mass and inertia xx yy zz xy xz yz about the
/// origin.
template <class R>
MatrixOf<R> pseudo_inertia(const std::array<R, 10>& of) {
  const R half = (of[4] + of[5] + of[6]) / R(2);
  MatrixOf<R> S(4, 4);
  S << half - of[4], -of[7], -of[8], of[1], -of[7], half - of[5], -of[9], of[2], -of[8], -of[9], half - of[6],
      of[3], of[1], of[2], of[3], of[0];
  return S;
}

/// C_ij = sum over bodies of tr(D_i W S (d(D_j W)/dt)^T), by jets of jets.
template <class R>
MatrixOf<R> coriolis_matrix(const Description& description, const State& given) {
  using T = Jet<R>;
  const std::vector<R> no_rates(given.speeds.size(), R(0.0));
  StateOf<T> moving = lifted<T>(given);
  moving.q = trajectory(description, lifted<R>(given), no_rates);
  const Jet<T> t(T(R(given.time), R(1.0), R(0.0)), T(0.0), T(0.0));
  const auto rows = static_cast<Eigen::Index>(12 * description.bodies.size());
  MatrixOf<R> along(rows, description.nv), rates(rows, description.nv);
  for (int k = 0; k < description.nv; ++k) {
    const std::vector<T> entries =
        pose_entries(description, world_poses(description, unit_motion(description, moving, k), t), true,
                     [](const Jet<T>& entry) { return entry.first; });
    for (Eigen::Index r = 0; r < rows; ++r) {
      along(r, k) = entries[static_cast<std::size_t>(r)].value;
      rates(r, k) = entries[static_cast<std::size_t>(r)].first;
    }
  }
  MatrixOf<R> C = MatrixOf<R>::Zero(description.nv, description.nv);
  for (std::size_t b = 0; b < description.bodies.size(); ++b) {
    const Body& body = description.bodies[b];
    const std::array<double, 6>& I = body.inertia;  // xx yy zz xy xz yz
    const MatrixOf<R> S = pseudo_inertia<R>(
        {R(body.mass), R(0), R(0), R(0), R(I[0]), R(I[1]), R(I[2]), R(I[3]), R(I[4]), R(I[5])});
    const auto first = static_cast<Eigen::Index>(12 * b);
    for (Eigen::Index r = 0; r < 4; ++r)
      for (Eigen::Index s = 0; s < 4; ++s)
        C += S(r, s) * along.middleRows(first + 3 * r, 3).transpose() * rates.middleRows(first + 3 * s, 3);
  }
  return C;
}

/// The parameters of a body that count in regressors: none without mass, no inertia of a point mass in its origin.
std::size_t standard_parameters(const Body& body) {
  const auto zero = [](double x) { return x == 0; };
  const bool point = std::all_of(body.inertia.begin(), body.inertia.end(), zero);
  if (point && body.mass == 0) return 0;
  return point && std::all_of(body.com.begin(), body.com.end(), zero) ? 4 : 10;
}

/// A row for each of `left`, a column for each parameter of each body: tr(left S right^T) of the S that is the
/// parameter's, of poses as pose_entries gives them.
template <class R>
Eigen::MatrixXd by_parameters(const Description& description, const std::vector<std::vector<R>>& left,
                              const std::vector<std::vector<R>>& right) {
  const auto bodies = static_cast<Eigen::Index>(description.bodies.size());
  Eigen::MatrixXd Y = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(left.size()), 10 * bodies);
  using Pose = Eigen::Map<const Eigen::Matrix<R, 3, 4>>;
  for (Eigen::Index row = 0; row < Y.rows(); ++row) {
    const auto i = static_cast<std::size_t>(row);
    for (Eigen::Index b = 0; b < bodies; ++b) {
      const std::size_t count = standard_parameters(description.bodies[static_cast<std::size_t>(b)]);
      for (std::size_t p = 0; p < count; ++p) {
        std::array<R, 10> one;
        one.fill(R(0));
        one[p] = R(1);
        const Eigen::Matrix<R, 4, 4> S = pseudo_inertia<R>(one);
        const Pose from(left[i].data() + 12 * b), to(right[i].data() + 12 * b);
        Y(row, 10 * b + static_cast<Eigen::Index>(p)) =
            static_cast<double>((from * S * to.transpose()).trace());
      }
    }
  }
  return Y;
}

/// About the centre of mass: momenta of bodies that move so, or the forces that give them these accelerations.
template <class R>
struct Centre {
  using Vector = Eigen::Matrix<R, 3, 1>;
  using Matrix = Eigen::Matrix<R, 3, 3>;
  using Six = Eigen::Matrix<R, 6, 1>;
  const Description& description;
  const std::vector<Motion<R>>& bodies;  ///< where they are
  Vector com = Vector::Zero();
  Centre(const Description& given, const std::vector<Motion<R>>& at) : description(given), bodies(at) {
    R mass(0.0);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      mass += R(given.bodies[i].mass);
      com += R(given.bodies[i].mass) * center(i);
    }
    com /= mass;
  }
  Vector center(std::size_t i) const {
    const Vector own = Eigen::Map<const Eigen::Vector3d>(description.bodies[i].com.data()).template cast<R>();
    return bodies[i].pose.template leftCols<3>() * own + bodies[i].pose.col(3);
  }
  Matrix inertia(std::size_t i) const {
    const std::array<double, 6>& I = description.bodies[i].inertia;
    Matrix own;
    own << R(I[0]), R(I[3]), R(I[4]), R(I[3]), R(I[1]), R(I[5]), R(I[4]), R(I[5]), R(I[2]);
    return bodies[i].pose.template leftCols<3>() * own * bodies[i].pose.template leftCols<3>().transpose();
  }
  /// Velocities or accelerations of bodies less that of their centre of mass: what lever arms are multiplied with.
  std::vector<Vector> from_mean(const std::vector<Motion<R>>& moving, Six Motion<R>::*of) const {
    R mass(0.0);
    Vector mean = Vector::Zero();
    for (std::size_t i = 0; i < moving.size(); ++i) {
      mass += R(description.bodies[i].mass);
      mean += R(description.bodies[i].mass) * (moving[i].*of).template tail<3>();
    }
    mean /= mass;
    std::vector<Vector> all;
    for (const Motion<R>& one : moving) all.push_back((one.*of).template tail<3>() - mean);
    return all;
  }
  Six momentum(const std::vector<Motion<R>>& moving) const {
    const std::vector<Vector> velocity = from_mean(moving, &Motion<R>::velocity);
    Six sum = Six::Zero();
    for (std::size_t i = 0; i < moving.size(); ++i) {
      const R mass(description.bodies[i].mass);
      sum.template head<3>() +=
          inertia(i) * moving[i].velocity.template head<3>() + mass * (center(i) - com).cross(velocity[i]);
      sum.template tail<3>() += mass * moving[i].velocity.template tail<3>();
    }
    return sum;
  }
  Six rate(const std::vector<Motion<R>>& moving) const {
    const std::vector<Vector> acceleration = from_mean(moving, &Motion<R>::acceleration);
    Six sum = Six::Zero();
    for (std::size_t i = 0; i < moving.size(); ++i) {
      const R mass(description.bodies[i].mass);
      const Vector omega = moving[i].velocity.template head<3>();
      sum.template head<3>() += inertia(i) * moving[i].acceleration.template head<3>() +
                                omega.cross(inertia(i) * omega) +
                                mass * (center(i) - com).cross(acceleration[i]);
      sum.template tail<3>() += mass * moving[i].acceleration.template tail<3>();
    }
    return sum;
  }
};

/// The description with each force alone: those of coordinates first.
std::vector<Description> one_by_one(const Description& description) {
  Description none = description;
  none.forces.clear();
  none.force_names.clear();
  for (Coordinate& c : none.coordinates) c.damping = c.friction = c.stiffness = 0;
  std::vector<Description> all;
  for (std::size_t i = 0; i < description.coordinates.size(); ++i) {
    for (double Coordinate::*strength :
         {&Coordinate::damping, &Coordinate::friction, &Coordinate::stiffness}) {
      const double value = description.coordinates[i].*strength;
      if (value != 0) all.emplace_back(none).coordinates[i].*strength = value;
    }
  }
  const std::vector<std::string>& names = description.force_names;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i == 0 || names[i] != names[i - 1]) all.push_back(none);
    all.back().forces.push_back(description.forces[i]);
  }
  return all;
}

Eigen::VectorXd column(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// What functions are made of at one state.
template <class R>
struct Quantities {
  const Description& description;
  const State& state;
  DynamicsOf<R> dynamics;
  std::vector<std::vector<Motion<R>>> bodies, frames;  ///< along each speed
  Motions<R> now;

  Quantities(const Description& given, const State& at)
      : description(given), state(at), dynamics(numeric_lagrangian<R>(given, at)) {
    const auto exact = lifted<R>(state);
    for (int k = 0; k < description.nv; ++k) {
      now = motions(description, unit_motion(description, exact, k), Jet<R>(exact.time, R(0.0), R(0.0)));
      bodies.push_back(now.bodies);
      frames.push_back(now.frames);
    }
  }
  /// As the mechanism moves, with these rates of the speeds.
  Motions<R> moving(const std::vector<double>& rates) const {
    const StateOf<R> exact = lifted<R>(state);
    const std::vector<R> given(rates.begin(), rates.end());
    return motions(description, trajectory(description, exact, given), Jet<R>(exact.time, R(1.0), R(0.0)));
  }
  Motions<R> moving() const { return moving(std::vector<double>(state.rates.size(), 0.0)); }
  const std::pair<MatrixOf<R>, MatrixOf<R>>& force_derivatives() const {
    if (!force_derivatives_) force_derivatives_ = derivatives_of_forces<R>(description, state);
    return *force_derivatives_;
  }
  /// Of all bodies, along each speed, as they move, their accelerations less that of gravity, where they are.
  std::vector<R> along(int k) const {
    const auto poses = world_poses(description, unit_motion(description, lifted<R>(state), k),
                                   Jet<R>(R(state.time), R(0.0), R(0.0)));
    return pose_entries(description, poses, false, [](const Jet<R>& entry) { return entry.first; });
  }
  template <class Take>
  std::vector<R> moving_poses(const std::vector<double>& rates, Take take) const {
    const StateOf<R> exact = lifted<R>(state);
    const auto poses =
        world_poses(description, trajectory(description, exact, std::vector<R>(rates.begin(), rates.end())),
                    Jet<R>(exact.time, R(1.0), R(0.0)));
    return pose_entries(description, poses, false, take);
  }
  std::vector<R> upward() const {
    std::vector<R> all(12 * description.bodies.size(), R(0));
    for (std::size_t i = 0; i < all.size(); ++i)
      if (i % 12 >= 9) all[i] = -R(description.gravity[i % 3]);
    return all;
  }
  Eigen::MatrixXd regressor(std::vector<R> accelerations) const {
    const std::vector<R> up = upward();
    for (std::size_t i = 0; i < accelerations.size(); ++i) accelerations[i] += up[i];
    std::vector<std::vector<R>> left;
    for (int k = 0; k < description.nv; ++k) left.push_back(along(k));
    return by_parameters(description, left, std::vector<std::vector<R>>(left.size(), accelerations));
  }
  MatrixOf<R> inverse() const {
    return dynamics.mass_matrix.ldlt().solve(MatrixOf<R>::Identity(description.nv, description.nv));
  }
  auto forces() const {
    return [this](const StateOf<Jet<R>>& at) { return applied_forces(description, at); };
  }
  Eigen::MatrixXd M() const { return dynamics.mass_matrix.template cast<double>(); }
  Eigen::VectorXd c() const { return dynamics.bias.template cast<double>(); }
  /// -sum m (velocity of the centre of mass along each speed) . (gravity)
  Eigen::VectorXd gravity() const {
    Eigen::VectorXd g = Eigen::VectorXd::Zero(description.nv);
    for (std::size_t k = 0; k < bodies.size(); ++k)
      for (std::size_t i = 0; i < description.bodies.size(); ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
          g[static_cast<Eigen::Index>(k)] -=
              static_cast<double>(R(description.bodies[i].mass * description.gravity[axis]) *
                                  bodies[k][i].velocity[3 + static_cast<Eigen::Index>(axis)]);
    return g;
  }

 private:
  mutable std::optional<std::pair<MatrixOf<R>, MatrixOf<R>>> force_derivatives_;
};

template <class R>
OutputsOf<double> outputs_of(const Quantities<R>& x) {
  const OutputsOf<R> wide = numeric_outputs(x.description, lifted<R>(x.state));
  const auto narrow = [](const std::vector<R>& values) {
    return std::vector<double>(values.begin(), values.end());
  };
  OutputsOf<double> result{narrow(wide.values), narrow(wide.rate), narrow(wide.bias), {}};
  for (const std::vector<R>& column : wide.along) result.along.push_back(narrow(column));
  return result;
}

/// Of the regressor: those of its columns that depend on none before them, told at states of no account. None, where
/// rounding leaves it open.
std::optional<std::vector<Eigen::Index>> independent_columns(const Description& description) {
  using Wide = long double;
  std::mt19937_64 random(11);
  const Eigen::Index columns = 10 * static_cast<Eigen::Index>(description.bodies.size());
  const Eigen::Index states = columns + 4;  // columns may be of one row each
  MatrixOf<Wide> stacked(states * description.nv, columns);
  Eigen::Index have = 0;
  for (int tries = 0; have < states && tries < 100 * states; ++tries) {
    const State state = random_state(description, random);
    const Quantities<Wide> there(description, state);
    const Eigen::MatrixXd Y =
        there.regressor(there.moving_poses(state.rates, [](const Jet<Wide>& entry) { return entry.second; }));
    if (Y.allFinite()) stacked.middleRows(description.nv * have++, description.nv) = Y.cast<Wide>();
  }
  if (have < states) throw std::runtime_error("too few states have a regressor");
  // What is zero and what depends on others is so to rounding.
  const Wide rounding = 1e-16L * stacked.colwise().norm().maxCoeff();
  std::vector<Eigen::Index> found;
  std::vector<VectorOf<Wide>> basis;
  for (Eigen::Index k = 0; k < columns; ++k) {
    VectorOf<Wide> rest = stacked.col(k);
    const Wide before = rest.norm();
    for (int twice = 0; twice < 2; ++twice)
      for (const VectorOf<Wide>& direction : basis) rest -= direction.dot(rest) * direction;
    if (before <= rounding || rest.norm() <= 1e-14L * before) continue;
    if (!(rest.norm() > 1e-9L * before)) return std::nullopt;
    basis.push_back(rest / rest.norm());
    found.push_back(k);
  }
  return found;
}

/// The same, found once for all states of a mechanism: they are asked for one after the other.
const std::optional<std::vector<Eigen::Index>>& known_independent_columns(const Description& description) {
  static std::string last;
  static std::optional<std::vector<Eigen::Index>> columns;
  std::string now = description.text;
  for (const auto& [parameter, value] : description.runtime_parameters)
    now += parameter + std::to_string(value);
  if (now != last) columns = independent_columns(description);
  last = now;
  return columns;
}

template <class R>
using Builders = std::map<std::string, std::function<Arrays(const Quantities<R>&)>>;

/// By function, how its arrays are made: whatever stands here is compared.
template <class R>
const Builders<R>& builders() {
  using From = const Quantities<R>&;
  static const Builders<R> all{
      {"inverse_dynamics",
       [](From x) {
         return Arrays{{"tau", x.dynamics.tau.template cast<double>()}};
       }},
      {"mass_matrix",
       [](From x) {
         return Arrays{{"M", x.M()}};
       }},
      {"bias",
       [](From x) {
         return Arrays{{"c", x.c()}};
       }},
      {"mass_matrix_and_bias",
       [](From x) {
         return Arrays{{"M", x.M()}, {"c", x.c()}};
       }},
      {"coriolis_matrix",
       [](From x) {
         return Arrays{{"C", coriolis_matrix<R>(x.description, x.state).template cast<double>()}};
       }},
      {"gravity",
       [](From x) {
         return Arrays{{"g", x.gravity()}};
       }},
      {"applied_forces",
       [](From x) {
         Eigen::VectorXd Q(x.description.nv);
         Eigen::Index k = 0;
         for (const R& force : applied_forces(x.description, lifted<R>(x.state)))
           Q[k++] = static_cast<double>(force);
         return Arrays{{"Q", Q}};
       }},
      {"force_contributions",
       [](From x) {
         const std::vector<Description> forces = one_by_one(x.description);
         Eigen::MatrixXd Q(static_cast<Eigen::Index>(forces.size()), x.description.nv);
         for (Eigen::Index i = 0; i < Q.rows(); ++i) {
           Eigen::Index k = 0;
           for (const R& force : applied_forces(forces[static_cast<std::size_t>(i)], lifted<R>(x.state)))
             Q(i, k++) = static_cast<double>(force);
         }
         return Arrays{{"Q", Q}};
       }},
      {"input_jacobian",
       [](From x) {
         return Arrays{{"B", derivatives_by<R>(x.state, x.description.inputs, &StateOf<Jet<R>>::inputs,
                                               x.description.nv, x.forces())}};
       }},
      {"state_rates",
       [](From x) {
         const std::vector<R> rates = state_rates(x.description, lifted<R>(x.state));
         return Arrays{{"sdot", column({rates.begin(), rates.end()})}};
       }},
      {"state_jacobian",
       [](From x) {
         return Arrays{{"Q_s", derivatives_by<R>(x.state, x.description.states, &StateOf<Jet<R>>::states,
                                                 x.description.nv, x.forces())}};
       }},
      {"state_rates_derivatives",
       [](From x) { return derivatives_of_state_rates<R>(x.description, x.state); }},
      {"state_input_jacobian",
       [](From x) {
         const auto rates = [&](const StateOf<Jet<R>>& state) { return state_rates(x.description, state); };
         const auto rows = static_cast<Eigen::Index>(x.description.states.size());
         return Arrays{{"r_inputs", derivatives_by<R>(x.state, x.description.inputs, &StateOf<Jet<R>>::inputs,
                                                      rows, rates)}};
       }},
      {"outputs",
       [](From x) {
         return Arrays{{"y", column(outputs_of(x).values)}};
       }},
      {"outputs_jacobian",
       [](From x) {
         const OutputsOf<double> outputs = outputs_of(x);
         Eigen::MatrixXd J(static_cast<Eigen::Index>(outputs.values.size()), x.description.nv);
         for (Eigen::Index k = 0; k < J.cols(); ++k)
           J.col(k) = column(outputs.along[static_cast<std::size_t>(k)]);
         return Arrays{{"J", J}};
       }},
      {"outputs_rate",
       [](From x) {
         return Arrays{{"rate", column(outputs_of(x).rate)}};
       }},
      {"outputs_bias",
       [](From x) {
         return Arrays{{"bias", column(outputs_of(x).bias)}};
       }},
      {"forward_dynamics",
       [](From x) {
         return Arrays{{"qdd", column(x.state.rates)}};
       }},
      {"mass_matrix_inverse",
       [](From x) {
         return Arrays{{"Minv", x.inverse().template cast<double>()}};
       }},
      {"forward_dynamics_derivatives",
       [](From x) {
         const auto& [along, by_speeds] = x.force_derivatives();
         const MatrixOf<R> inverse = x.inverse();
         const auto solved = [&](const MatrixOf<R>& of) -> Eigen::MatrixXd {
           return MatrixOf<R>(-inverse * of).template cast<double>();
         };
         return Arrays{{"qdd_q", solved(along)},
                       {"qdd_qd", solved(by_speeds)},
                       {"qdd_tau", inverse.template cast<double>()}};
       }},
      {"constrained_forward_dynamics",
       [](From x) { return constrained_functions<R>(x.description, x.state, x.dynamics); }},
      {"constrained_forward_dynamics_derivatives",
       [](From x) { return constrained_derivatives<R>(x.description, x.state, x.dynamics); }},
      {"body_velocities",
       [](From x) {
         return Arrays{{"V", rows_of(x.moving().bodies, &Motion<R>::velocity)}};
       }},
      {"body_accelerations",
       [](From x) {
         return Arrays{{"A", rows_of(x.moving(x.state.rates).bodies, &Motion<R>::acceleration)}};
       }},
      {"frame_velocities",
       [](From x) {
         return Arrays{{"V", rows_of(x.moving().frames, &Motion<R>::velocity)}};
       }},
      {"frame_bias_accelerations",
       [](From x) {
         return Arrays{{"bias", rows_of(x.moving().frames, &Motion<R>::acceleration)}};
       }},
      {"frame_jacobian_rates",
       [](From x) {
         return Arrays{{"Jdot", jacobian_rates<R>(x.description, x.state)}};
       }},
      {"centroidal_momentum",
       [](From x) {
         const std::vector<Motion<R>> bodies = x.moving().bodies;
         const Centre<R> centre(x.description, bodies);
         Eigen::MatrixXd A(6, x.description.nv);
         for (Eigen::Index k = 0; k < A.cols(); ++k)
           A.col(k) = centre.momentum(x.bodies[static_cast<std::size_t>(k)]).template cast<double>();
         return Arrays{{"h", centre.momentum(bodies).template cast<double>()},
                       {"A", A},
                       {"bias", centre.rate(bodies).template cast<double>()},
                       {"com", centre.com.template cast<double>()}};
       }},
      {"joint_reactions",
       [](From x) {
         return Arrays{{"w", numeric_reactions<R>(x.description, x.state).template cast<double>()}};
       }},
      {"regressor",
       [](From x) {
         return Arrays{{"Y", x.regressor(x.moving_poses(x.state.rates,
                                                        [](const Jet<R>& entry) { return entry.second; }))}};
       }},
      {"base_regressor",
       [](From x) {
         const Eigen::MatrixXd Y =
             x.regressor(x.moving_poses(x.state.rates, [](const Jet<R>& entry) { return entry.second; }));
         const auto& which = known_independent_columns(x.description);
         if (!which) return Arrays{};
         Eigen::MatrixXd some(Y.rows(), static_cast<Eigen::Index>(which->size()));
         for (Eigen::Index k = 0; k < some.cols(); ++k)
           some.col(k) = Y.col((*which)[static_cast<std::size_t>(k)]);
         return Arrays{{"Y", some}};
       }},
      {"static_regressor",
       [](From x) {
         return Arrays{{"Y", x.regressor(std::vector<R>(12 * x.description.bodies.size(), R(0)))}};
       }},
      {"energy_regressor",
       [](From x) {
         const std::vector<double> none(x.state.rates.size(), 0.0);
         const auto velocities = x.moving_poses(none, [](const Jet<R>& entry) { return entry.first; });
         const auto places = x.moving_poses(none, [](const Jet<R>& entry) { return entry.value; });
         // -g . (place of the mass) is tr(place S upward^T) with upward in the last column.
         Eigen::MatrixXd Y = by_parameters<R>(x.description, {velocities, places}, {velocities, x.upward()});
         Y.row(0) /= 2;
         return Arrays{{"Y", Y}};
       }},
      {"coordinate_rates",
       [](From x) {
         return Arrays{{"qdot", column(coordinate_rates(x.description, x.state.q, x.state.speeds))}};
       }},
      {"energy",
       [](From x) {
         const auto [kinetic, potential] = energy<R>(x.description, x.state);
         return Arrays{{"e", Eigen::Vector2d(static_cast<double>(kinetic), static_cast<double>(potential))}};
       }},
      {"body_inertias",
       [](From x) {
         return Arrays{{"inertias", inertia_rows(x.description)}};
       }},
      {"body_poses",
       [](From x) {
         return Arrays{{"W", pose_rows(x.now.bodies)}};
       }},
      {"frame_poses",
       [](From x) {
         return Arrays{{"F", pose_rows(x.now.frames)}};
       }},
      {"body_jacobians",
       [](From x) {
         return Arrays{{"J", jacobian(x.bodies)}};
       }},
      {"frame_jacobians",
       [](From x) {
         return Arrays{{"J", jacobian(x.frames)}};
       }},
      {"constraints",
       [](From x) {
         const ConstraintRowsOf<R> rows = numeric_constraints<R>(x.description, x.state);
         return Arrays{{"P", rows.P.template cast<double>()},
                       {"gamma", rows.gamma.template cast<double>()},
                       {"velocity", rows.velocity.template cast<double>()},
                       {"position", rows.position.template cast<double>()}};
       }},
      {"inverse_dynamics_second_derivatives",
       [](From x) { return second_derivatives_of_forces<R>(x.description, x.state); }},
      {"inverse_dynamics_parameter_derivatives",
       [](From x) {
         return Arrays{{"tau_p", parameter_derivatives_of_forces(x.description, x.state)}};
       }},
      {"inverse_dynamics_derivatives",
       [](From x) {
         const auto& [along, by_speeds] = x.force_derivatives();
         return Arrays{{"tau_q", along.template cast<double>()},
                       {"tau_qd", by_speeds.template cast<double>()}};
       }},
  };
  return all;
}

}  // namespace

bool is_six_a_row(const std::string& function) {
  static const std::set<std::string> all{"body_velocities", "body_accelerations", "frame_velocities",
                                         "frame_bias_accelerations", "joint_reactions"};
  return all.count(function) != 0;
}

std::set<std::string> numeric_function_names(const Description& description) {
  std::set<std::string> names;
  for (const auto& [name, build] : builders<double>()) names.insert(name);
  if (!description.has_forces())
    for (const char* name : {"applied_forces", "force_contributions"}) names.erase(name);
  if (description.constraints.empty())
    for (const char* name : {"constrained_forward_dynamics", "constrained_forward_dynamics_derivatives"})
      names.erase(name);
  if (description.inputs.empty())
    for (const char* name : {"input_jacobian", "state_input_jacobian"}) names.erase(name);
  if (description.states.empty()) {
    for (const char* name :
         {"state_rates", "state_jacobian", "state_rates_derivatives", "state_input_jacobian"})
      names.erase(name);
  }
  if (description.runtime_parameters.empty()) names.erase("inverse_dynamics_parameter_derivatives");
  if (description.outputs.empty()) names.erase("outputs");
  if (description.outputs.empty() || description.outputs_of_speeds())
    for (const char* name : {"outputs_jacobian", "outputs_rate", "outputs_bias"}) names.erase(name);
  return names;
}

std::set<std::string> functions_in_turn(const std::set<std::string>& functions, std::uint64_t turn) {
  static const std::set<std::string> always = {"inverse_dynamics",
                                               "mass_matrix",
                                               "bias",
                                               "mass_matrix_and_bias",
                                               "forward_dynamics",
                                               "constraints",
                                               "inverse_dynamics_derivatives",
                                               "body_jacobians",
                                               "frame_jacobians"};
  static const std::set<std::string> long_ones = {
      "inverse_dynamics_second_derivatives", "forward_dynamics_derivatives", "constrained_forward_dynamics",
      "constrained_forward_dynamics_derivatives", "base_regressor"};
  std::set<std::string> some;
  for (const std::string& name : functions) {
    if (always.count(name) != 0 || turn % (long_ones.count(name) != 0 ? 13 : 7) == 0) some.insert(name);
    if (always.count(name) == 0) ++turn;
  }
  return some;
}

template <class R>
std::map<std::string, Arrays> numeric_functions(const Description& description, const State& state,
                                                const std::set<std::string>& wanted) {
  const Quantities<R> quantities(description, state);
  const std::set<std::string> names = wanted.empty() ? numeric_function_names(description) : wanted;
  std::map<std::string, Arrays> all;
  for (const auto& [name, build] : builders<R>())
    if (names.count(name) != 0) all[name] = build(quantities);
  return all;
}

template std::map<std::string, Arrays> numeric_functions<double>(const Description&, const State&,
                                                                 const std::set<std::string>&);
template std::map<std::string, Arrays> numeric_functions<long double>(const Description&, const State&,
                                                                      const std::set<std::string>&);

}  // namespace alembert::oracles
