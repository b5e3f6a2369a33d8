// What happens along a motion: coordinates and outputs pass their limits, bodies touch, drives are asked for more than they
// can. In: the states at the ends of steps, and within one where it is asked for. Out: lines for a summary.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "simulation/state_program.hpp"

namespace alembert {

/// Something holds while its value is above zero.
struct WatchedEvent {
  std::string what;           ///< contact 'foot'; coordinate 'q' passes its upper limit 2
  std::string most;           ///< the largest value's name and unit, with {} for the number
  long count = 0;             ///< how often it began
  double begin = 0, end = 0;  ///< when it first did, and first ended; infinite: not yet
  double largest = 0;         ///< value at the end of a step
  double largest_time = 0;
};

/// Watches, in this order: the limits, `speed` and `effort` of each coordinate (the sum of the forces `on` it),
/// contacts, and the limits of outputs. What begins and ends within one step is not seen.
class EventWatch {
 public:
  explicit EventWatch(const CompiledMechanism& compiled);

  bool empty() const { return events_.empty(); }
  void start(const EvaluationState& state);
  /// The state after the next step. `within` gives the state after a part of it, 0 to 1, if there is one: the times
  /// of first events are found by bisection among such, to 1e-12 of the step, so that they are as exact as the
  /// method of integration.
  void step(const EvaluationState& after,
            const std::function<std::optional<EvaluationState>(double part)>& within);
  /// A line for each event that there was.
  std::vector<std::string> summary() const;
  const std::vector<WatchedEvent>& events() const { return events_; }

 private:
  using Value = std::function<double(const EvaluationState& state, std::span<const double> computed)>;

  void watch(std::string what, std::string most, Value value);
  void watch_limits(const std::string& what, double lower, double upper, const Value& value);
  void watch_coordinate(const Coordinate& coordinate, const CompiledMechanism& compiled,
                        std::vector<Expr>& wanted);
  const std::vector<double>& values(const EvaluationState& state);

  std::vector<WatchedEvent> events_;
  std::vector<Value> values_of_;
  StateProgram program_;  ///< what takes more than coordinates and speeds
  std::vector<double> now_, last_;
};

}  // namespace alembert
