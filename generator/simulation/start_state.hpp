// Where a motion starts. In: the description's initial state, or the one of the command line. Out: the
// nearest state that keeps the constraints, and what had to change.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pipeline.hpp"
#include "simulation/dynamics_evaluator.hpp"

namespace alembert {

struct StartOptions {
  std::vector<double> q, qd, states;    ///< instead of the description's, if not empty
  std::vector<std::string> parameters;  ///< NAME=VALUE: runtime parameters instead of their defaults
  bool assemble = true;                 ///< bring the state onto the constraints; else it must keep them
  std::vector<std::string> hold;        ///< coordinates that assembling must not change, nor their speeds
};

/// The state to start from, its quaternions of unit length. Newton's method changes the coordinates, and then
/// the speeds are changed least in the metric of the kinetic energy (alembert/consistent_state.hpp); `note`
/// is told what changed. Throws InputError where sizes or names are wrong, or no such state is found: at the
/// constraint, with its row.
EvaluationState start_state(const CompiledMechanism& compiled, const StartOptions& options,
                            const std::function<void(const std::string&)>& note);

}  // namespace alembert
