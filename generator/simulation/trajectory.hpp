// The motion of a mechanism in time, by fixed steps through the interpreter, without forces. In: a compiled
// mechanism, a state, a step. Out: points of the motion to whoever wants them (CSV, pages, scenes), and what
// stopped it, if something did.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pipeline.hpp"
#include "simulation/dynamics_evaluator.hpp"
#include "simulation/input_table.hpp"
#include "support/error.hpp"

namespace alembert {

/// One moment of a motion.
struct TrajectoryPoint {
  long steps = 0;              ///< made so far
  EvaluationState state;       ///< t, q and qd (speeds) of the moment; parameters and wrenches
  double kinetic = 0;          ///< J
  double potential = 0;        ///< J
  std::vector<double> lambda;  ///< reactions, one a row of the constraints; 0 for redundant rows
  std::vector<double> outputs;
  double residual = 0;  ///< largest violation of a constraint, position or velocity
  double energy() const { return kinetic + potential; }
};

enum class IntegrationMethod { rk4, semi_implicit_euler, linearly_implicit_euler, implicit_euler };

struct TrajectoryOptions {
  double duration = 10;  ///< s
  double step = 1e-3;    ///< s
  long every = 10;       ///< a point each so many steps, besides the first and the last
  IntegrationMethod method = IntegrationMethod::rk4;
  InputTable inputs;                          ///< what inputs are over time
  std::function<void(double done)> progress;  ///< called now and then with the fraction that is done, 0 to 1
  std::function<void(const std::string&)> note;   ///< told of redundant rows, and of steps that are too long
  std::function<void(const std::string&)> event;  ///< told at the end what happened (event_watch.hpp)
};

/// Functions that must have been compiled for a motion.
std::vector<FunctionKind> trajectory_functions(IntegrationMethod method);

/// Number of steps that the options ask for, or none if that makes no sense. Where the duration is no
/// multiple of the step, the last one is shorter.
std::optional<long> step_count(const TrajectoryOptions& options);

/// Whether forces or rates of states, which may be stiff, let one of the first steps from `start` lead to no finite state.
bool diverges_at_once(const CompiledMechanism& compiled, const EvaluationState& start,
                      const TrajectoryOptions& options);

/// Integrates from `start`, for the duration exactly, and gives each point to `take`, in order, as soon as it
/// is known. Under constraints the state is projected on them after each step. \return nothing if the motion
/// reached its end, else why it stopped, where and when: constraints that contradict each other (with the
/// row), a frame that is singular (with body, coordinates and cure), a mass matrix that is (with the
/// coordinate), a step without a finite state. The points up to there were given. Throws InputError if the
/// options make no sensible number of steps.
std::optional<InputError> integrate(const CompiledMechanism& compiled, const EvaluationState& start,
                                    const TrajectoryOptions& options,
                                    const std::function<void(const TrajectoryPoint&)>& take);

}  // namespace alembert
