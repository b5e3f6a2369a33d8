// Watches frames on curves and surfaces along a motion. In: states, one after the other. Out: an error at the
// first frame that is singular at a state, or was between two of them.
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <utility>
#include <vector>

#include "dynamics/tree/frame_normals.hpp"
#include "pipeline.hpp"
#include "simulation/state_program.hpp"

namespace alembert {

/// Keeps the normals at the state before.
class FrameMonitor {
 public:
  explicit FrameMonitor(const CompiledMechanism& compiled);

  /// An error at the frame's factor if its normal, the cross product of two vectors, is shorter than 1e-9 of
  /// their lengths or has no value, or if it turned by more than a right angle since the state before: so it
  /// does where the motion crossed an inflection or a pole. Names body, coordinates and cure.
  std::optional<InputError> check(const EvaluationState& state);

  /// At the state before: to go back to after a step that is only tried.
  const std::vector<Eigen::Vector3d>& normals() const { return before_; }
  void set_normals(std::vector<Eigen::Vector3d> normals) { before_ = std::move(normals); }

 private:
  const Mechanism& mechanism_;
  std::vector<FrameNormal> frames_;
  StateProgram factors_;  ///< both of each normal, six values a frame
  std::vector<Eigen::Vector3d> before_;
};

}  // namespace alembert
