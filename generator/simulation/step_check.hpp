// Whether the steps of a motion are short enough. In: where some of its steps led, and where shorter ones do.
// Out: what to say of it at the end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mechanism/model.hpp"
#include "simulation/dynamics_evaluator.hpp"

namespace alembert {

/// Stiff forces make explicit methods chatter: the speeds stay finite, and are wrong.
class StepCheck {
 public:
  explicit StepCheck(const Mechanism& mechanism);

  /// Where one step leads, and where several lead together, as long as it is.
  void add(const EvaluationState& before, const EvaluationState& after, const EvaluationState& parts);

  /// What to say of the coordinate whose speed most steps change otherwise than shorter ones do; nothing if few do.
  std::optional<std::string> finding(double step) const;

 private:
  struct Speed {
    double largest = 0;      ///< magnitude so far
    std::size_t differ = 0;  ///< steps that change it otherwise than shorter ones
  };
  const Mechanism& mechanism_;
  std::vector<Speed> speeds_;
  std::size_t compared_ = 0;
};

}  // namespace alembert
