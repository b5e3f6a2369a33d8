// Generalised forces of a description's forces on numbers: by virtual work, with positions as jets along each speed.
// Outputs, and the rates of states, which are of the same variables.
#pragma once

#include <vector>

#include "oracles/taylor/poses.hpp"

namespace alembert::oracles {

/// By speed. On coordinates: -b u - F tanh(u/v) - k (q - r). Of the others, with D_k the derivative along speed k:
/// -D_k V of a potential, -T D_k L of a tension along a path, f . D_k p + torque . omega_k at a frame.
template <class R>
std::vector<R> applied_forces(const Description& description, const StateOf<R>& state);

/// What forces do to frames, in world axes: a force at the origin and a torque. Forces along speeds do nothing to
/// frames; a potential pulls by its derivatives by positions, rotations and lengths of paths.
template <class R>
struct FrameWrench {
  Vector3<R> force{R(0.0), R(0.0), R(0.0)}, torque{R(0.0), R(0.0), R(0.0)};
};
template <class R>
std::vector<FrameWrench<R>> wrenches_on_frames(const Description& description, const StateOf<R>& state);

/// Sum of the potentials and of k (q - r)^2/2.
template <class R>
R potential_of_forces(const Description& description, const StateOf<R>& state);

/// Of each of the description's states.
template <class R>
std::vector<R> state_rates(const Description& description, const StateOf<R>& state);

/// Outputs of a description: values, derivatives along each speed, first and second derivative in time where the
/// speeds have no rates.
template <class R>
struct OutputsOf {
  std::vector<R> values, rate, bias;
  std::vector<std::vector<R>> along;  ///< by speed
};
template <class R>
OutputsOf<R> numeric_outputs(const Description& description, const StateOf<R>& state);

}  // namespace alembert::oracles
