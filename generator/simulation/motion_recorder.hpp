// Keeps what is to be seen of a motion: frames of about equal distance in time, with the poses of all bodies
// and what acts on them.
// In: points of a trajectory. Out: the motion as the viewer takes it.
#pragma once

#include "simulation/force_readings.hpp"
#include "simulation/trajectory.hpp"
#include "viewer/scene.hpp"

namespace alembert {

class MotionRecorder {
 public:
  /// The mechanism must have been compiled with body_poses.
  explicit MotionRecorder(const CompiledMechanism& compiled) : evaluator_(compiled), readings_(compiled) {
    motion_.acting = readings_.nothing_yet();
  }
  /// Keeps a point, unless it has no finite picture or is no later than the last one.
  void record(const TrajectoryPoint& point);
  const BakedMotion& motion() const { return motion_; }
  const ForceReadings& readings() const { return readings_; }

 private:
  DynamicsEvaluator evaluator_;
  ForceReadings readings_;
  BakedMotion motion_;
};

/// Steps between frames, so that there are about `fps` frames a second.
long steps_per_frame(double step, double fps);

}  // namespace alembert
