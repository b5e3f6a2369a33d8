// `simulate`: the free motion from a state, handed to the writers that were asked for.
#include <fmt/format.h>
#include <unistd.h>

#include <string>

#include "commands/commands.hpp"
#include "commands/csv_writer.hpp"
#include "commands/start_state.hpp"
#include "commands/trajectory.hpp"

namespace alembert {

int run_simulate(const CommonOptions& common, const SimulateOptions& options) {
  const CompiledMechanism compiled = compile(common, trajectory_functions());
  const Mechanism& mechanism = *compiled.mechanism;
  const auto note = [](const std::string& text) { fmt::print(stderr, "note: {}\n", text); };
  const EvaluationState start = start_state(compiled, options.start, note);
  TrajectoryOptions trajectory;
  trajectory.duration = options.duration;
  trajectory.step = options.step;
  trajectory.every = options.every;
  trajectory.method =
      options.integrator == "rk4" ? IntegrationMethod::rk4 : IntegrationMethod::semi_implicit_euler;
  trajectory.note = note;
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
