// Fixed steps by the runtime library's integrators through the interpreter (see the header).
#include "simulation/trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "alembert/implicit_step.hpp"
#include "alembert/integrate.hpp"
#include "dynamics/checks/state_checks.hpp"
#include "simulation/event_watch.hpp"
#include "simulation/frame_monitor.hpp"
#include "simulation/interpreted_mechanism.hpp"
#include "simulation/step_check.hpp"

namespace alembert {

namespace {

/// So often progress is told, and a step compared with shorter ones.
constexpr long kHundred = 100;
/// Within these, steps that are far too long for stiff forces leave no finite state.
constexpr long kFirstSteps = 100;
/// Shorter steps that make one: two chatter as one does.
constexpr int kParts = 8;

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// A motion as it goes on.
class MovingMechanism {
 public:
  MovingMechanism(const CompiledMechanism& compiled, const EvaluationState& start, const InputTable& inputs)
      : mechanism_(*compiled.mechanism),
        evaluator_(compiled),
        system_(compiled, start, inputs),
        monitor_(compiled),
        q_(vector_of(start.q)),
        u_(vector_of(start.qd)) {}

  double time() const { return system_.time(); }
  /// Time is set from the number of steps, not summed, so that it does not drift.
  void set_time(double t) { system_.set_time(t); }

  /// Energies, reactions and residual here.
  std::optional<InputError> point(TrajectoryPoint& out) {
    out.state = system_.state(q_, u_);
    const std::vector<double> energy = evaluator_(FunctionKind("energy"), out.state);
    out.kinetic = energy[0];
    out.potential = energy[1];
    out.outputs = evaluator_(FunctionKind("outputs"), out.state);
    out.lambda.assign(static_cast<std::size_t>(system_.nc()), 0.0);
    out.residual = worst_violation(system_, q_, u_).size;
    if (!std::isfinite(out.energy())) return failure(Status::not_finite, 0);
    if (system_.nc() == 0) return std::nullopt;
    ConstrainedMotion<double, Eigen::Dynamic, Eigen::Dynamic> motion;
    const Status status = constrained_accelerations(system_, q_, u_, no_force(), {}, motion);
    report_ = motion;
    if (status != Status::ok) return failure(status, 0);
    out.lambda.assign(motion.lambda.begin(), motion.lambda.end());
    return std::nullopt;
  }

  /// Goes on by one step, or says why not; the state is then left as it was.
  std::optional<InputError> step(IntegrationMethod method, double h) {
    const auto force = [this](double, const Eigen::VectorXd&, const Eigen::VectorXd&) { return no_force(); };
    const EvaluationState before = state();
    const auto advance = [&]() -> Status {
      switch (method) {
        case IntegrationMethod::rk4:
          return advance_by_rk4(system_, q_, u_, h, force, {}, report_);
        case IntegrationMethod::semi_implicit_euler:
          return advance_by_semi_implicit_euler(system_, q_, u_, h, force, {}, report_);
        case IntegrationMethod::linearly_implicit_euler:
          return advance_by_linearly_implicit_euler(system_, q_, u_, h, force, {}, report_);
        case IntegrationMethod::implicit_euler:
          return advance_by_implicit_euler(system_, q_, u_, h, force, {}, report_);
      }
      return Status::ok;
    };
    status_ = advance();
    if (status_ != Status::ok) return failure(status_, h);
    if (std::optional<InputError> singular = check_frames()) {
      set_state(before);
      return singular;
    }
    return std::nullopt;
  }

  /// Whether the last step led to no finite state.
  bool diverged() const {
    return status_ == Status::not_finite || status_ == Status::not_positive_definite ||
           status_ == Status::residual_too_large;
  }

  EvaluationState state() const { return system_.state(q_, u_); }
  void set_state(const EvaluationState& state) {
    q_ = vector_of(state.q);
    u_ = vector_of(state.qd);
    system_.set_inputs(state);
  }
  /// Where a step from a state leads, if anywhere; nothing is changed.
  std::optional<EvaluationState> after(const EvaluationState& before, IntegrationMethod method, double h) {
    const EvaluationState here = state();
    std::vector<Eigen::Vector3d> normals = monitor_.normals();
    set_state(before);
    std::optional<EvaluationState> there;
    if (!step(method, h)) there = state();
    set_state(here);
    monitor_.set_normals(std::move(normals));
    return there;
  }

  /// Where shorter steps lead that make one together, if anywhere; nothing is changed.
  std::optional<EvaluationState> after_parts(IntegrationMethod method, double h) {
    std::optional<EvaluationState> there = state();
    for (int i = 0; i < kParts && there; ++i) there = after(*there, method, h / kParts);
    return there;
  }

  std::optional<InputError> check_frames() { return monitor_.check(system_.state(q_, u_)); }

  /// Names of the rows that follow from the others, at the last step or point.
  std::string redundant_rows() const {
    std::string out;
    for (std::size_t i = 0; i < system_.rows().size(); ++i) {
      if (static_cast<Eigen::Index>(i) < report_.redundant.rows() &&
          report_.redundant(static_cast<Eigen::Index>(i)))
        out += (out.empty() ? "" : ", ") + system_.rows()[i].name;
    }
    return out;
  }

 private:
  Eigen::VectorXd no_force() const { return Eigen::VectorXd::Zero(mechanism_.nv); }

  /// Why there is no step of this length from here.
  InputError failure(Status status, double h) {
    const double t = time();
    const auto row_at_fault = [&](int row) -> const ConstraintRow& {
      return system_.rows()[static_cast<std::size_t>(row)];
    };
    switch (status) {
      case Status::ok:
        break;
      case Status::inconsistent_constraints: {
        const ConstraintRow& row = row_at_fault(report_.inconsistent_row);
        return InputError(
            mechanism_.constraints[row.constraint].where,
            fmt::format(
                "the constraints contradict each other at t = {:.9g}: row {} cannot be kept beside those it "
                "depends on, or the mechanism is at a singular position there (the output so far is kept)",
                t, row.name));
      }
      case Status::no_convergence:
        return InputError(mechanism_.where,
                          fmt::format("after the step from t = {:.9g} the state finds no way back to the "
                                      "constraints: try a shorter --step (the output so far is kept)",
                                      t));
      case Status::singular_step:
        return InputError(
            mechanism_.where,
            fmt::format("the equations of the implicit step from t = {:.9g} are singular: try another --step "
                        "(the output so far is kept)",
                        t));
      case Status::not_positive_definite:
      case Status::not_finite:
      case Status::residual_too_large:
      case Status::missing_function:
        return no_finite_step(h);
    }
    return InputError(mechanism_.where, "no step");
  }

  InputError no_finite_step(double h) {
    if (const Violation none = worst_violation(system_, q_, u_); std::isnan(none.size)) {
      const ConstraintRow& row = system_.rows()[static_cast<std::size_t>(none.row)];
      return InputError(
          mechanism_.constraints[row.constraint].where,
          fmt::format("row {} has no value at t = {:.9g} (the output so far is kept)", row.name, time()));
    }
    const Eigen::VectorXd rate = system_.coordinate_rates(q_, u_);
    for (const double part : {0.0, 0.5, 1.0}) {  // where the stages of the step were
      EvaluationState ahead = system_.state(q_ + part * h * rate, u_);
      ahead.t += part * h;
      if (const std::optional<InputError> singular = monitor_.check(ahead)) return InputError(*singular);
    }
    Eigen::MatrixXd mass;
    Eigen::VectorXd c;
    system_.mass_matrix_and_bias(q_, u_, mass, c);
    if (mass.allFinite() && mass.size() > 0) {
      const std::optional<WithoutInertia> culprit =
          coordinate_without_inertia(mechanism_, {mass.data(), static_cast<std::size_t>(mass.size())});
      if (culprit) {
        return InputError(
            culprit->coordinate->where,
            fmt::format("the mass matrix is singular at t = {:.9g}: nothing with mass or inertia moves "
                        "with coordinate '{}' alone there, a pole of these coordinates; describe "
                        "the motion by others, for rotations by a quaternion (the output so far "
                        "is kept)",
                        time(), culprit->coordinate->name));
      }
    }
    return InputError(
        mechanism_.where,
        fmt::format(
            "no finite step from t = {:.9g}: the mass matrix is not positive definite there, or "
            "the motion diverges; try a shorter --step, or --integrator implicit (the output so far is kept)",
            time()));
  }

  const Mechanism& mechanism_;
  DynamicsEvaluator evaluator_;
  InterpretedMechanism system_;
  FrameMonitor monitor_;
  Eigen::VectorXd q_, u_;
  ConstraintReport<Eigen::Dynamic> report_;
  Status status_ = Status::ok;
};

}  // namespace

std::vector<FunctionKind> trajectory_functions(IntegrationMethod method) {
  std::vector<FunctionKind> kinds = interpreted_functions();
  kinds.push_back(FunctionKind("energy"));
  kinds.push_back(FunctionKind("outputs"));
  if (method == IntegrationMethod::linearly_implicit_euler || method == IntegrationMethod::implicit_euler) {
    kinds.push_back(FunctionKind("inverse_dynamics_derivatives"));
    kinds.push_back(FunctionKind("state_rates_derivatives"));
  }
  return kinds;
}

std::optional<long> step_count(const TrajectoryOptions& options) {
  constexpr double kRounding = 1e-12;  // of decimals: 0.3 / 0.1 is 3
  const double steps = options.duration / options.step;
  if (!(steps >= 0) || steps > 1e9) return std::nullopt;
  const double whole = std::round(steps);
  return static_cast<long>(std::abs(steps - whole) <= kRounding * steps ? whole : std::ceil(steps));
}

bool diverges_at_once(const CompiledMechanism& compiled, const EvaluationState& start,
                      const TrajectoryOptions& options) {
  const Mechanism& mechanism = *compiled.mechanism;
  if (mechanism.forces.empty() && std::ranges::none_of(mechanism.parameters, &Parameter::is_state))
    return false;
  MovingMechanism motion(compiled, start, options.inputs);
  for (long i = 1; i <= std::min(kFirstSteps, step_count(options).value_or(0)); ++i) {
    if (motion.step(options.method, options.step)) return motion.diverged();
    motion.set_time(start.t + static_cast<double>(i) * options.step);
  }
  return false;
}

std::optional<InputError> integrate(const CompiledMechanism& compiled, const EvaluationState& start,
                                    const TrajectoryOptions& options,
                                    const std::function<void(const TrajectoryPoint&)>& take) {
  const std::optional<long> count = step_count(options);
  if (!count) {
    throw InputError(compiled.mechanism->where,
                     "--duration and --step make no sensible number of steps (at most 1e9)");
  }
  MovingMechanism motion(compiled, start, options.inputs);
  std::optional<EventWatch> watch;
  if (options.event) watch.emplace(compiled);
  if (watch) watch->start(motion.state());
  const auto go_on = [&](double h) -> std::optional<InputError> {
    if (!watch || watch->empty()) return motion.step(options.method, h);
    const EvaluationState before = motion.state();
    std::optional<InputError> stopped = motion.step(options.method, h);
    if (!stopped)
      watch->step(motion.state(),
                  [&](double part) { return motion.after(before, options.method, part * h); });
    return stopped;
  };
  StepCheck check(*compiled.mechanism);
  const auto checked = [&](double h) {
    const EvaluationState before = motion.state();
    const std::optional<EvaluationState> parts = motion.after_parts(options.method, h);
    std::optional<InputError> stopped = go_on(h);
    if (parts && !stopped) check.add(before, motion.state(), *parts);
    return stopped;
  };
  const auto tell_end = [&](std::optional<InputError> stopped) {
    if (const std::optional<std::string> finding = check.finding(options.step); finding && options.note)
      options.note(*finding);
    if (watch)
      for (const std::string& line : watch->summary()) options.event(line);
    return stopped;
  };
  bool noted = false;
  const auto give = [&](long steps) -> std::optional<InputError> {
    TrajectoryPoint point;
    point.steps = steps;
    std::optional<InputError> stopped = motion.point(point);
    if (std::isfinite(point.energy())) take(point);
    const std::string redundant = noted ? "" : motion.redundant_rows();
    if (!redundant.empty() && !stopped) {
      noted = true;
      if (options.note) {
        options.note(
            fmt::format("rows of the constraints that follow from the others at t = {:.9g}: {} (their lambda "
                        "is 0)",
                        motion.time(), redundant));
      }
    }
    return stopped;
  };
  if (std::optional<InputError> stopped = motion.check_frames()) return stopped;
  if (std::optional<InputError> stopped = give(0)) return stopped;
  const auto time_after = [&](long steps) {
    return start.t + (steps == *count ? options.duration : static_cast<double>(steps) * options.step);
  };
  for (long i = 1; i <= *count; ++i) {
    const double rest = options.duration - static_cast<double>(*count - 1) * options.step;
    const double h = i == *count ? std::min(rest, options.step) : options.step;
    const bool is_hundredth = i % std::max(1L, *count / kHundred) == 0;
    if (std::optional<InputError> stopped = options.note && is_hundredth ? checked(h) : go_on(h)) {
      if ((i - 1) % options.every != 0) give(i - 1);  // the last state that is good
      return tell_end(std::move(stopped));
    }
    motion.set_time(time_after(i));
    if (i % options.every == 0 || i == *count) {
      if (std::optional<InputError> stopped = give(i)) return tell_end(std::move(stopped));
    }
    if (options.progress && is_hundredth)
      options.progress(static_cast<double>(i) / static_cast<double>(*count));
  }
  return tell_end(std::nullopt);
}

}  // namespace alembert
