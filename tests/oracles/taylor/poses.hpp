// Poses of bodies on jets: transforms evaluated as they are written, along any motion of coordinates and
// time.
#pragma once

#include <vector>

#include "oracles/state.hpp"
#include "oracles/taylor/rigid_motion.hpp"

namespace alembert::oracles {

/// [p0 p1 n f] of a surface.
RigidMotion<Jet<double>> surface_frame(const Surface& surface, const std::vector<Jet<double>>& q,
                                       const Jet<double>& t);

/// Product of factors, left to right.
RigidMotion<Jet<double>> product_of(const std::vector<Factor>& factors, const std::vector<Jet<double>>& q,
                                    const Jet<double>& t);

/// Poses in the world of all bodies, as jets along whatever q and t move along.
std::vector<RigidMotion<Jet<double>>> world_poses(const Description& description,
                                                  const std::vector<Jet<double>>& q, const Jet<double>& t);

/// q along the motion with the state's speeds, whose rates are given.
std::vector<Jet<double>> trajectory(const Description& description, const State& state,
                                    const std::vector<double>& rates);

/// q along a motion with speed k at 1 and all others at 0: velocities along it are derivatives along speed k.
std::vector<Jet<double>> unit_motion(const Description& description, const State& state, int k);

}  // namespace alembert::oracles
