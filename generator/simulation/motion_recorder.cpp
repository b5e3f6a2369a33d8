// Frames of a motion (see the header).
#include "simulation/motion_recorder.hpp"

#include <algorithm>
#include <cmath>

namespace alembert {

void MotionRecorder::record(const TrajectoryPoint& point) {
  std::vector<double> poses = evaluator_(FunctionKind("body_poses"), point.state);
  const auto finite = [](double x) { return std::isfinite(x); };
  if (!std::ranges::all_of(poses, finite) || !finite(point.energy())) return;
  if (!motion_.times.empty() && point.state.t <= motion_.times.back()) return;
  motion_.times.push_back(point.state.t);
  motion_.q.push_back(point.state.q);
  motion_.poses.push_back(std::move(poses));
  motion_.kinetic.push_back(point.kinetic);
  motion_.potential.push_back(point.potential);
  readings_.append(point.state, motion_.acting);
}

long steps_per_frame(double step, double fps) {
  const double steps = std::round(1 / (step * fps));
  return static_cast<long>(std::clamp(steps, 1.0, 1e9));
}

}  // namespace alembert
