// `simulate`: the free motion from a state, handed to the writers that were asked for.
#include "commands/run_simulate.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "commands/common_options.hpp"
#include "commands/csv_writer.hpp"
#include "commands/live_mechanism.hpp"
#include "commands/run_import.hpp"
#include "commands/warnings.hpp"
#include "emit/files/waiting_file.hpp"
#include "emit/files/write_files.hpp"
#include "mechanism/source.hpp"
#include "simulation/input_table.hpp"
#include "simulation/motion_recorder.hpp"
#include "simulation/start_state.hpp"
#include "simulation/trajectory.hpp"
#include "viewer/glb.hpp"
#include "viewer/page.hpp"

namespace alembert {

namespace {

constexpr std::pair<const char*, IntegrationMethod> kIntegrators[] = {
    {"rk4", IntegrationMethod::rk4},
    {"euler", IntegrationMethod::semi_implicit_euler},
    {"linearly-implicit", IntegrationMethod::linearly_implicit_euler},
    {"implicit", IntegrationMethod::implicit_euler}};

const StartOptions kNothingGiven;

/// Numbers that a page or scene may hold: more would fill memory, and no browser would show it.
constexpr double kMostNumbers = 5e7;

void check_outputs(const SimulateOptions& options, const SourceLocation& where) {
  if (!options.html.empty() && page_template().empty()) {
    throw InputError(where, "--html: this alembert was built without its page, which needs npm",
                     "install npm (Debian: apt-get install npm), configure the build of alembert again with "
                     "-DALEMBERT_BUILD_VIEWER=ON and build; --glb works without");
  }
  if (options.html.empty() && options.glb.empty() && !options.scene.empty())
    throw InputError(where, "--scene needs --html or --glb to be seen in");
}

std::size_t path_points(const Mechanism& mechanism) {
  std::size_t count = mechanism.contacts.size();
  for (const Force& force : mechanism.forces) count += force.path.size();
  return count;
}

/// Passes on points of a motion: to a table each so many steps, to a recorder each so many others, and the
/// last one to both.
class PointSplitter {
 public:
  PointSplitter(const SimulateOptions& options, CsvWriter* csv, MotionRecorder* recorder)
      : row_steps_(options.every),
        frame_steps_(steps_per_frame(options.step, options.fps)),
        csv_(csv),
        recorder_(recorder) {}

  /// Steps between points that either of them wants.
  long every() const {
    if (recorder_ == nullptr) return row_steps_;
    return csv_ == nullptr ? frame_steps_ : std::gcd(row_steps_, frame_steps_);
  }

  void take(const TrajectoryPoint& point) {
    any_ = true;
    in_table_ = in_scene_ = false;
    last_ = point;
    if (point.steps % row_steps_ == 0) to_table();
    if (point.steps % frame_steps_ == 0) to_scene();
  }

  void finish() {
    if (!any_) return;
    if (!in_table_) to_table();
    if (!in_scene_) to_scene();
  }

 private:
  void to_table() {
    if (csv_ != nullptr) csv_->write(last_);
    in_table_ = true;
  }
  void to_scene() {
    if (recorder_ != nullptr) recorder_->record(last_);
    in_scene_ = true;
  }

  long row_steps_, frame_steps_;
  CsvWriter* csv_;
  MotionRecorder* recorder_;
  TrajectoryPoint last_;
  bool any_ = false, in_table_ = false, in_scene_ = false;
};

/// The motions of one or several mechanisms, and what is written of them.
class Simulation {
 public:
  Simulation(const SimulateOptions& options, const CommonOptions& common)
      : options_(options),
        common_(common),
        seen_(!options.html.empty() || !options.glb.empty()),
        csv_(options.csv.empty() && !seen_ ? "-" : options.csv) {}

  /// Simulates one description and adds it to the scene. Only the first one has a CSV and a given start.
  /// \return why it stopped early, if it did.
  std::optional<InputError> add(const std::string& file, bool first) {
    CommonOptions common = common_;
    common.file = file;
    if (!first) common.inputs.clear();
    const std::shared_ptr<const SourceText> source = description_of(common);
    CompiledMechanism compiled =
        compile(common, source, functions(source, method()), Inapplicable::refuse_singular);
    check_outputs(options_, compiled.mechanism->where);
    const auto table = first && !options_.inputs.empty() ? read_source(options_.inputs) : nullptr;
    const StartOptions& given = first ? options_.start : kNothingGiven;
    const auto set_out = [&](IntegrationMethod how) {
      TrajectoryOptions out = trajectory_options(*compiled.mechanism);
      out.method = how;
      if (table) out.inputs = InputTable(table, *compiled.mechanism);
      return out;
    };
    TrajectoryOptions trajectory = set_out(method());
    EvaluationState start = start_state(compiled, given, trajectory.note);
    // Elastic tendons, say, are too stiff for explicit steps.
    if (options_.integrator.empty() && diverges_at_once(compiled, start, trajectory)) {
      const IntegrationMethod implicit = IntegrationMethod::implicit_euler;
      common.warned = true;
      CompiledMechanism explicit_one = std::exchange(
          compiled, compile(common, source, functions(source, implicit), Inapplicable::refuse_singular));
      if (diverges_at_once(compiled, start, set_out(implicit))) {
        compiled = std::move(explicit_one);
      } else {
        trajectory = set_out(implicit);
        trajectory.note(fmt::format(
            "explicit steps of {:.9g} s diverge at once: these are implicit (--integrator chooses)",
            options_.step));
      }
    }
    const Mechanism& mechanism = *compiled.mechanism;

    std::optional<CsvWriter> csv;
    if (first && !csv_.empty()) csv.emplace(compiled, csv_);
    MotionRecorder recorder(compiled);
    PointSplitter points(options_, csv ? &*csv : nullptr, seen_ ? &recorder : nullptr);
    trajectory.every = points.every();
    std::vector<std::string> events;
    if (first) trajectory.event = [&](const std::string& line) { events.push_back(line); };
    std::optional<InputError> stopped =
        integrate(compiled, start, trajectory, [&](const TrajectoryPoint& point) { points.take(point); });
    points.finish();
    if (trajectory.progress) tell("\r");
    for (const std::string& event : events) trajectory.note(event);
    if (csv) csv->finish();
    if (!recorder.motion().times.empty()) {
      Warnings warnings;
      add_mechanism(scene_, mechanism, *compiled.graph, recorder.motion(), warnings);
      report_warnings(warnings, common_.strict);
      if (!options_.html.empty())
        scene_.mechanisms.back().live = live_mechanism(compiled, start, recorder.readings());
    }
    return stopped;
  }

  void write() {
    if (scene_.mechanisms.empty()) return;
    place_side_by_side(scene_);
    if (!options_.html.empty()) write_file(options_.html, html_page(scene_));
    if (!options_.glb.empty()) write_file(options_.glb, glb_file(scene_));
  }

 private:
  /// The one that was asked for, or what is tried first.
  IntegrationMethod method() const {
    const auto* row =
        std::ranges::find(kIntegrators, options_.integrator, [](const auto& x) { return x.first; });
    return row == std::end(kIntegrators) ? IntegrationMethod::rk4 : row->second;
  }

  /// What must be compiled for a motion by a method, and for what is written of it.
  std::vector<FunctionKind> functions(const std::shared_ptr<const SourceText>& source,
                                      IntegrationMethod how) const {
    std::vector<FunctionKind> out = trajectory_functions(how);
    if (seen_ && std::ranges::find(out, FunctionKind("body_poses")) == out.end())
      out.push_back(FunctionKind("body_poses"));
    if (!options_.html.empty()) add_live_functions(source, out);
    return out;
  }

  TrajectoryOptions trajectory_options(const Mechanism& mechanism) const {
    TrajectoryOptions out;
    out.note = [](const std::string& text) { tell("note: " + text + "\n"); };
    out.duration = options_.duration;
    out.step = options_.step;
    if (isatty(STDERR_FILENO) != 0 && csv_ != "-")
      out.progress = [](double done) { tell(fmt::format("\r{:3.0f} %", 100 * done)); };
    const std::optional<long> steps = step_count(out);
    if (!steps) {
      throw InputError(mechanism.where,
                       "--duration and --step make no sensible number of steps (at most 1e9)");
    }
    const double frames = static_cast<double>(*steps / steps_per_frame(options_.step, options_.fps) + 1);
    const double numbers = frames * static_cast<double>(12 * mechanism.bodies.size() + mechanism.nq + 3 +
                                                        mechanism.forces.size() + mechanism.outputs.size() +
                                                        3 * path_points(mechanism));
    if (seen_ && numbers > kMostNumbers)
      throw InputError(mechanism.where, fmt::format("{:.3g} frames are too many to be seen", frames),
                       "choose a smaller --duration or --fps");
    return out;
  }

  const SimulateOptions& options_;
  const CommonOptions& common_;
  bool seen_;
  std::string csv_;
  Scene scene_;
};

}  // namespace

std::vector<std::string> integrator_names() {
  std::vector<std::string> names;
  for (const auto& [name, method] : kIntegrators) names.emplace_back(name);
  return names;
}

int run_simulate(const CommonOptions& common, const SimulateOptions& options) {
  std::vector<NamedFile> written, read{{"the description", common.file}};
  for (const NamedFile& file :
       {NamedFile{"--csv", options.csv}, {"--html", options.html}, {"--glb", options.glb}}) {
    if (!file.path.empty() && file.path != "-") written.push_back(file);
  }
  if (!options.inputs.empty()) read.push_back({"--inputs", options.inputs});
  for (const std::string& file : options.scene) read.push_back({"a description of --scene", file});
  check_distinct(written, read);
  Simulation simulation(options, common);
  std::optional<InputError> stopped = simulation.add(common.file, true);
  for (const std::string& file : options.scene) {
    std::optional<InputError> other = simulation.add(file, false);
    if (!stopped) stopped = std::move(other);
  }
  simulation.write();
  if (stopped) throw InputError(*stopped);
  return 0;
}

}  // namespace alembert
