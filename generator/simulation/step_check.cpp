// Whether the steps of a motion are short enough (see the header).
#include "simulation/step_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace alembert {

namespace {

/// Of the change of a speed in a step; a method of first order differs by less in steps that show the motion.
constexpr double kOtherwise = 0.5;
/// Of the largest magnitude of a speed, and in rad/s or m/s: less is not seen, or rounding.
constexpr double kSeen = 1e-3, kNothing = 1e-12;
/// Of the steps that are compared: a bounce or two may be coarse.
constexpr double kOften = 0.05;
constexpr std::size_t kFewest = 3;

}  // namespace

StepCheck::StepCheck(const Mechanism& mechanism)
    : mechanism_(mechanism), speeds_(static_cast<std::size_t>(mechanism.nv)) {}

void StepCheck::add(const EvaluationState& before, const EvaluationState& after,
                    const EvaluationState& parts) {
  ++compared_;
  for (std::size_t k = 0; k < speeds_.size(); ++k) {
    Speed& speed = speeds_[k];
    speed.largest = std::max({speed.largest, std::abs(before.qd[k]), std::abs(after.qd[k])});
    const double change =
        std::max(std::abs(after.qd[k] - before.qd[k]), std::abs(parts.qd[k] - before.qd[k]));
    const double difference = std::abs(after.qd[k] - parts.qd[k]);
    if (difference > kOtherwise * change && difference > std::max(kSeen * speed.largest, kNothing))
      ++speed.differ;
  }
}

std::optional<std::string> StepCheck::finding(double step) const {
  const auto worst = std::ranges::max_element(speeds_, {}, [](const Speed& speed) { return speed.differ; });
  if (worst == speeds_.end() || worst->differ < kFewest ||
      static_cast<double>(worst->differ) < kOften * static_cast<double>(compared_))
    return std::nullopt;
  const int k = static_cast<int>(worst - speeds_.begin());
  // The last whose speeds begin there or before.
  const auto coordinate =
      std::prev(std::ranges::upper_bound(mechanism_.coordinates, k, {}, &Coordinate::first_speed));
  return fmt::format(
      "steps of {:.9g} s are too long for coordinate '{}': {} of {} that were tried change its speed "
      "otherwise than shorter ones do; choose a shorter --step or, for stiff forces, --integrator implicit",
      step, coordinate->name, worst->differ, compared_);
}

}  // namespace alembert
