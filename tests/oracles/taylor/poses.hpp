// Poses of bodies on jets: transforms evaluated as they are written, along any motion of coordinates and
// time. R is what the jets are of: double, long double, or jets of these along a parameter of one's own.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "oracles/state.hpp"
#include "oracles/taylor/rigid_motion.hpp"

namespace alembert::oracles {

/// A state on other scalars.
template <class R>
struct StateOf {
  std::vector<R> q, speeds, rates;
  R time;
  std::map<std::string, R> inputs = {}, states = {};
};
template <class R>
StateOf<R> lifted(const State& state) {
  StateOf<R> result{{}, {}, {}, R(state.time)};
  for (const auto& [name, value] : state.inputs) result.inputs.emplace(name, R(value));
  for (const auto& [name, value] : state.states) result.states.emplace(name, R(value));
  for (const double x : state.q) result.q.emplace_back(x);
  for (const double x : state.speeds) result.speeds.emplace_back(x);
  for (const double x : state.rates) result.rates.emplace_back(x);
  return result;
}

/// [p0 p1 n f] of a surface.
template <class R>
RigidMotion<Jet<R>> surface_frame(const Surface& surface, const std::vector<Jet<R>>& q, const Jet<R>& t);

/// Product of factors, left to right.
template <class R>
RigidMotion<Jet<R>> product_of(const std::vector<Factor>& factors, const std::vector<Jet<R>>& q,
                               const Jet<R>& t);

/// Poses in the world of all bodies, as jets along whatever q and t move along.
template <class R>
std::vector<RigidMotion<Jet<R>>> world_poses(const Description& description, const std::vector<Jet<R>>& q,
                                             const Jet<R>& t);

/// The same of all frames.
template <class R>
std::vector<RigidMotion<Jet<R>>> frame_poses(const Description& description, const std::vector<Jet<R>>& q,
                                             const Jet<R>& t);

/// Angular velocity in world axes, along whatever the pose moves along.
template <class R>
Vector3<R> angular_velocity(const RigidMotion<Jet<R>>& pose);

/// q along the motion with the state's speeds, whose rates are given.
template <class R>
std::vector<Jet<R>> trajectory(const Description& description, const StateOf<R>& state,
                               const std::vector<R>& rates);
inline std::vector<Jet<double>> trajectory(const Description& description, const State& state,
                                           const std::vector<double>& rates) {
  return trajectory(description, lifted<double>(state), rates);
}

/// q along a motion with speed k at 1 and all others at 0: velocities along it are derivatives along speed k.
template <class R>
std::vector<Jet<R>> unit_motion(const Description& description, const StateOf<R>& state, int k);
inline std::vector<Jet<double>> unit_motion(const Description& description, const State& state, int k) {
  return unit_motion(description, lifted<double>(state), k);
}

}  // namespace alembert::oracles
