// Normals of frames along a motion (see the header).
#include "simulation/frame_monitor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace alembert {

namespace {

/// `s = 1.57, r = 0.2` of the coordinates named.
std::string values_of(const std::vector<std::string>& names, const Mechanism& mechanism,
                      const EvaluationState& state) {
  std::string out;
  for (const Coordinate& coordinate : mechanism.coordinates) {
    if (std::find(names.begin(), names.end(), coordinate.name) == names.end()) continue;
    out += fmt::format("{}{} = {:.6g}", out.empty() ? "" : ", ", coordinate.name,
                       state.q[static_cast<std::size_t>(coordinate.first_q)]);
  }
  return out;
}

}  // namespace

FrameMonitor::FrameMonitor(const CompiledMechanism& compiled)
    : mechanism_(*compiled.mechanism), frames_(frame_normals(mechanism_)) {
  if (frames_.empty()) return;
  std::vector<Expr> factors;
  for (const FrameNormal& frame : frames_) {
    for (const Vec3& v : {frame.factors.first, frame.factors.second})
      factors.insert(factors.end(), v.entries.begin(), v.entries.end());
  }
  factors_ = StateProgram(std::move(factors), compiled);
}

std::optional<InputError> FrameMonitor::check(const EvaluationState& state) {
  constexpr double kSingular = 1e-9;
  if (frames_.empty()) return std::nullopt;
  const std::span<const double> values = factors_(state);
  std::vector<Eigen::Vector3d> now;
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const Eigen::Map<const Eigen::Vector3d> first(&values[6 * i]), second(&values[6 * i + 3]);
    now.emplace_back(first.cross(second));
    const bool singular = !(now[i].norm() > kSingular * first.norm() * second.norm());
    const bool crossed = !before_.empty() && before_[i].dot(now[i]) < 0;
    if (!singular && !crossed) continue;
    return InputError(frames_[i].where,
                      fmt::format("{} of {} is singular {} t = {:.9g}, {}: {}", frames_[i].frame,
                                  frames_[i].owner, singular ? "at" : "just before", state.t,
                                  values_of(frames_[i].coordinates, mechanism_, state), frames_[i].cure));
  }
  before_ = std::move(now);
  return std::nullopt;
}

}  // namespace alembert
