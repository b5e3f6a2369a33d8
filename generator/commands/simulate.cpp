// `simulate`: the free motion from a state, handed to the writers that were asked for.
#include <fmt/format.h>
#include <unistd.h>

#include <string>

#include "commands/commands.hpp"
#include "commands/csv_writer.hpp"
#include "commands/trajectory.hpp"

namespace alembert {

namespace {

/// The description's initial state, or the one of the command line.
EvaluationState start_state(const CompiledMechanism& compiled, const SimulateOptions& options) {
  EvaluationState state = DynamicsEvaluator(compiled).initial_state();
  const auto replace = [&](const char* option, const std::vector<double>& given,
                           std::vector<double>& values) {
    if (given.empty()) return;
    if (given.size() != values.size())
      throw InputError(compiled.mechanism->where, fmt::format("{} takes {} values", option, values.size()));
    values = given;
  };
  replace("--q", options.q, state.q);
  replace("--qd", options.qd, state.qd);
  return state;
}

}  // namespace

int run_simulate(const CommonOptions& common, const SimulateOptions& options) {
  const CompiledMechanism compiled = compile(common, trajectory_functions());
  const Mechanism& mechanism = *compiled.mechanism;
  const EvaluationState start = start_state(compiled, options);
  TrajectoryOptions trajectory;
  trajectory.duration = options.duration;
  trajectory.step = options.step;
  trajectory.every = options.every;
  trajectory.method =
      options.integrator == "rk4" ? IntegrationMethod::rk4 : IntegrationMethod::semi_implicit_euler;
  const bool progress = isatty(STDERR_FILENO) != 0 && options.csv != "-";
  if (progress) trajectory.progress = [](double done) { fmt::print(stderr, "\r{:3.0f} %", 100 * done); };
  if (!step_count(trajectory))
    throw InputError(mechanism.where, "--duration and --step make no sensible number of steps (at most 1e9)");

  CsvWriter csv(mechanism, options.csv);
  const std::optional<InputError> stopped =
      integrate(compiled, start, trajectory, [&](const TrajectoryPoint& point) { csv.write(point); });
  if (progress) fmt::print(stderr, "\r");
  csv.flush();
  if (stopped) throw InputError(*stopped);
  return 0;
}

}  // namespace alembert
