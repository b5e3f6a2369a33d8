// Events along a motion (see the header).
#include "simulation/event_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/recursions/frame_values.hpp"

namespace alembert {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

}  // namespace

EventWatch::EventWatch(const CompiledMechanism& compiled) {
  const Mechanism& mechanism = *compiled.mechanism;
  std::vector<Expr> wanted;
  for (const Coordinate& coordinate : mechanism.coordinates) watch_coordinate(coordinate, compiled, wanted);
  for (const SphereContact& contact : mechanism.contacts) {
    watch(fmt::format("contact '{}'", contact.name), "deepest {:.6g} m",
          [place = wanted.size()](const EvaluationState&, std::span<const double> computed) {
            return computed[place];
          });
    wanted.push_back(contact.depth);
  }
  for (const Output& output : mechanism.outputs) {
    if (!output.limits) continue;
    const auto [lower, upper] = *output.limits;
    const std::string name = fmt::format("output '{}'", output.name);
    watch_limits(name, lower, upper,
                 [place = wanted.size()](const EvaluationState&, std::span<const double> computed) {
                   return computed[place];
                 });
    wanted.push_back(output.value);
  }
  if (wanted.empty()) return;
  ExprGraph& graph = *compiled.graph;
  const SpeedDerivatives derivatives(mechanism, graph);
  const MotionTree tree = motion_tree(mechanism, derivatives, graph);
  program_ = StateProgram(with_moving_values(wanted, mechanism, tree, derivatives, graph), compiled);
}

void EventWatch::watch(std::string what, std::string most, Value value) {
  events_.push_back({std::move(what), std::move(most), 0, kNever, kNever, 0, 0});
  values_of_.push_back(std::move(value));
}

void EventWatch::watch_limits(const std::string& what, double lower, double upper, const Value& value) {
  watch(fmt::format("{} passes its lower limit {:.6g}", what, lower), "by up to {:.6g}",
        [=](const EvaluationState& state, std::span<const double> computed) {
          return lower - value(state, computed);
        });
  watch(fmt::format("{} passes its upper limit {:.6g}", what, upper), "by up to {:.6g}",
        [=](const EvaluationState& state, std::span<const double> computed) {
          return value(state, computed) - upper;
        });
}

void EventWatch::watch_coordinate(const Coordinate& coordinate, const CompiledMechanism& compiled,
                                  std::vector<Expr>& wanted) {
  const auto q = static_cast<std::size_t>(coordinate.first_q);
  const auto u = static_cast<std::size_t>(coordinate.first_speed),
             speeds = static_cast<std::size_t>(coordinate.nv());
  if (coordinate.limits) {
    watch_limits(fmt::format("coordinate '{}'", coordinate.name), coordinate.limits->first,
                 coordinate.limits->second,
                 [q](const EvaluationState& state, std::span<const double>) { return state.q[q]; });
  }
  const auto largest = [](std::span<const double> of, std::size_t first, std::size_t count) {
    double most = 0;
    for (std::size_t i = first; i < first + count; ++i) most = std::max(most, std::abs(of[i]));
    return most;
  };
  if (coordinate.speed_limit) {
    watch(fmt::format("coordinate '{}' is faster than its drive's speed {:.6g}", coordinate.name,
                      *coordinate.speed_limit),
          "by up to {:.6g}",
          [=, limit = *coordinate.speed_limit](const EvaluationState& state, std::span<const double>) {
            return largest(state.qd, u, speeds) - limit;
          });
  }
  const auto drives = [&](const Force& force, std::size_t k) {
    return force.kind == ForceKind::on_speed && !force.passive && force.speed == static_cast<int>(u + k);
  };
  std::vector<Expr> efforts;
  bool driven = false;
  for (std::size_t k = 0; coordinate.effort_limit && k < speeds; ++k) {
    Expr effort = compiled.graph->zero();
    for (const Force& force : compiled.mechanism->forces) {
      if (!drives(force, k)) continue;
      effort += force.value;
      driven = true;
    }
    efforts.push_back(effort);
  }
  if (!driven) return;
  watch(fmt::format("coordinate '{}' is driven by more than its drive's effort {:.6g}", coordinate.name,
                    *coordinate.effort_limit),
        "by up to {:.6g}",
        [=, first = wanted.size(), limit = *coordinate.effort_limit](const EvaluationState&,
                                                                     std::span<const double> computed) {
          return largest(computed, first, speeds) - limit;
        });
  wanted.insert(wanted.end(), efforts.begin(), efforts.end());
}

const std::vector<double>& EventWatch::values(const EvaluationState& state) {
  const std::span<const double> computed = program_(state);
  now_.clear();
  for (const Value& value : values_of_) now_.push_back(value(state, computed));
  return now_;
}

void EventWatch::start(const EvaluationState& state) {
  if (empty()) return;
  last_ = values(state);
  for (std::size_t i = 0; i < events_.size(); ++i) {
    if (!(last_[i] > 0)) continue;
    events_[i].count = 1;
    events_[i].begin = events_[i].largest_time = state.t;
    events_[i].largest = last_[i];
  }
}

void EventWatch::step(const EvaluationState& after,
                      const std::function<std::optional<EvaluationState>(double part)>& within) {
  if (empty()) return;
  constexpr int kHalvings = 40;
  const std::vector<double> now = values(after);
  const auto change = [&](std::size_t i) {
    double low = 0, high = 1, time = after.t;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = (low + high) / 2;
      const std::optional<EvaluationState> state = within(middle);
      if (!state) break;
      const bool changed = (values(*state)[i] > 0) == (now[i] > 0);
      (changed ? high : low) = middle;
      if (changed) time = state->t;
    }
    return time;
  };
  for (std::size_t i = 0; i < events_.size(); ++i) {
    WatchedEvent& event = events_[i];
    const bool was = last_[i] > 0, is = now[i] > 0;
    if (is && !was && ++event.count == 1) event.begin = change(i);
    if (was && !is && event.end == kNever) event.end = change(i);
    if (now[i] > event.largest) {
      event.largest = now[i];
      event.largest_time = after.t;
    }
  }
  last_ = now;
}

std::vector<std::string> EventWatch::summary() const {
  std::vector<std::string> lines;
  for (const WatchedEvent& event : events_) {
    if (event.count == 0) continue;
    const std::string times = event.count == 1 ? "once" : fmt::format("{} times, first", event.count);
    const std::string end = event.end == kNever ? "the end" : fmt::format("{:.9g}", event.end);
    lines.push_back(fmt::format("{}: {} from t = {:.9g} to {}; {} at t = {:.6g}", event.what, times,
                                event.begin, end, fmt::format(fmt::runtime(event.most), event.largest),
                                event.largest_time));
  }
  return lines;
}

}  // namespace alembert
