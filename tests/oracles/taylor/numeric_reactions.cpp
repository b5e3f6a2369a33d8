// Newton and Euler (see the header).
#include "oracles/taylor/numeric_reactions.hpp"

#include "oracles/taylor/applied_forces.hpp"
#include "oracles/taylor/poses.hpp"

namespace alembert::oracles {

namespace {

template <class R>
Vector3<R> part(const Vector3<Jet<R>>& v, R Jet<R>::*of) {
  return {v[0].*of, v[1].*of, v[2].*of};
}

/// A force and a moment about the world's origin, in world axes.
template <class R>
struct WorldWrench {
  Vector3<R> force{R(0.0), R(0.0), R(0.0)}, moment{R(0.0), R(0.0), R(0.0)};
  void add(const Vector3<R>& f, const Vector3<R>& torque, const Vector3<R>& at, double sign) {
    force = force + R(sign) * f;
    moment = moment + R(sign) * (torque + cross(at, f));
  }
};

/// The moment of a body about its centre of mass: the sum over its axes e, which are unit vectors fixed to it, of
/// e x e'' weighed by the second moments of its mass along them, which are those of inertias.
template <class R>
Vector3<R> spin_moment(const Body& body, const RigidMotion<Jet<R>>& pose) {
  const std::array<double, 6>& I = body.inertia;
  const double half = 0.5 * (I[0] + I[1] + I[2]);
  const double second[3][3] = {
      {half - I[0], -I[3], -I[4]}, {-I[3], half - I[1], -I[5]}, {-I[4], -I[5], half - I[2]}};
  Vector3<R> moment{R(0.0), R(0.0), R(0.0)};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      moment = moment + R(second[i][j]) * cross(part(pose.column[i], &Jet<R>::value),
                                                part(pose.column[j], &Jet<R>::second));
  return moment;
}

}  // namespace

template <class R>
MatrixOf<R> numeric_reactions(const Description& description, const State& given) {
  const auto state = lifted<R>(given);
  const auto q = trajectory(description, state, state.rates);
  const Jet<R> t(state.time, R(1.0), R(0.0));
  const auto poses = world_poses(description, q, t);
  const auto frames = frame_poses(description, q, t);
  std::vector<WorldWrench<R>> takes(poses.size());
  for (std::size_t b = 0; b < poses.size(); ++b) {
    const Body& body = description.bodies[b];
    const Vector3<Jet<R>> com =
        rotated(poses[b], Vector3<Jet<R>>{Jet<R>(body.com[0]), Jet<R>(body.com[1]), Jet<R>(body.com[2])}) +
        poses[b].translation;
    const Vector3<R> at = part(com, &Jet<R>::value);
    Vector3<R> force = part(com, &Jet<R>::second);
    for (std::size_t i = 0; i < 3; ++i) force[i] = R(body.mass) * (force[i] - R(description.gravity[i]));
    takes[b].add(force, spin_moment(body, poses[b]), at, 1);
    if (const auto found = given.wrenches.find(body.name); found != given.wrenches.end()) {
      const Wrench& w = found->second;
      takes[b].add({R(w[0]), R(w[1]), R(w[2])}, {R(w[3]), R(w[4]), R(w[5])}, at, -1);
    }
  }
  const auto on_frames = wrenches_on_frames(description, state);
  for (std::size_t f = 0; f < on_frames.size(); ++f) {
    if (description.frames[f].body < 0) continue;
    takes[static_cast<std::size_t>(description.frames[f].body)].add(
        on_frames[f].force, on_frames[f].torque, part(frames[f].translation, &Jet<R>::value), -1);
  }
  MatrixOf<R> rows(static_cast<Eigen::Index>(poses.size()), 6);
  for (std::size_t b = 0; b < poses.size(); ++b) {
    WorldWrench<R> sum;
    for (std::size_t below = b; below < poses.size(); ++below) {
      int above = static_cast<int>(below);
      while (above > static_cast<int>(b)) above = description.bodies[static_cast<std::size_t>(above)].parent;
      if (above != static_cast<int>(b)) continue;
      sum.force = sum.force + takes[below].force;
      sum.moment = sum.moment + takes[below].moment;
    }
    const Vector3<R> origin = part(poses[b].translation, &Jet<R>::value);
    const Vector3<R> moment = sum.moment + R(-1.0) * cross(origin, sum.force);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3<R> axis = part(poses[b].column[i], &Jet<R>::value);
      rows(static_cast<Eigen::Index>(b), static_cast<Eigen::Index>(i)) = dot(axis, moment);
      rows(static_cast<Eigen::Index>(b), static_cast<Eigen::Index>(i) + 3) = dot(axis, sum.force);
    }
  }
  return rows;
}

template MatrixOf<double> numeric_reactions(const Description&, const State&);
template MatrixOf<long double> numeric_reactions(const Description&, const State&);

}  // namespace alembert::oracles
