// Fixed-step integration through the interpreter (see the header).
#include "commands/trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace alembert {

namespace {

/// The state's rates, and steps of the integrators over q and speeds.
class Integrator {
 public:
  Integrator(const CompiledMechanism& compiled, EvaluationState state)
      : mechanism_(*compiled.mechanism),
        evaluator_(compiled),
        state_(std::move(state)),
        tau_(state_.qd.size(), 0.0) {}

  const EvaluationState& state() const { return state_; }
  DynamicsEvaluator& evaluator() { return evaluator_; }
  /// Time is set from the number of steps, not summed, so that it does not drift.
  void set_time(double t) { state_.t = t; }

  /// False if M is not positive definite or a value is not finite: the state is then left as it was.
  bool step(IntegrationMethod method, double h) {
    switch (method) {
      case IntegrationMethod::rk4:
        return rk4(h);
      case IntegrationMethod::semi_implicit_euler:
        return semi_implicit_euler(h);
    }
    return false;
  }

 private:
  bool rk4(double h) {
    const EvaluationState start = state_;
    Rates k[4];
    const double at[4] = {0, h / 2, h / 2, h};
    for (int s = 0; s < 4; ++s) {
      EvaluationState stage = start;
      if (s > 0) advance(stage, k[s - 1], at[s]);
      stage.t = start.t + at[s];
      if (!rates(stage, k[s])) return false;
    }
    Rates sum = k[0];
    const double weights[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    for (std::size_t i = 0; i < sum.q.size(); ++i) {
      sum.q[i] = 0;
      for (int s = 0; s < 4; ++s) sum.q[i] += weights[s] * k[s].q[i];
    }
    for (std::size_t i = 0; i < sum.u.size(); ++i) {
      sum.u[i] = 0;
      for (int s = 0; s < 4; ++s) sum.u[i] += weights[s] * k[s].u[i];
    }
    return accept(sum, h);
  }

  bool semi_implicit_euler(double h) {
    Rates now;
    if (!rates(state_, now)) return false;
    EvaluationState faster = state_;
    for (std::size_t i = 0; i < now.u.size(); ++i) faster.qd[i] += h * now.u[i];
    now.q = evaluator_(FunctionKind::coordinate_rates, faster);
    return accept(now, h);
  }

  struct Rates {
    std::vector<double> q, u;
  };

  bool rates(const EvaluationState& state, Rates& out) {
    out.q = evaluator_(FunctionKind::coordinate_rates, state);
    out.u = evaluator_.forward_dynamics(state, tau_);
    return !out.u.empty() || state.qd.empty();
  }
  static void advance(EvaluationState& state, const Rates& rates, double h) {
    for (std::size_t i = 0; i < rates.q.size(); ++i) state.q[i] += h * rates.q[i];
    for (std::size_t i = 0; i < rates.u.size(); ++i) state.qd[i] += h * rates.u[i];
  }
  bool accept(const Rates& rates, double h) {
    EvaluationState next = state_;
    advance(next, rates, h);
    for (const Coordinate& coordinate : mechanism_.coordinates) {
      if (coordinate.type != CoordinateType::quaternion) continue;
      double* x = next.q.data() + coordinate.first_q;
      const double norm = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3]);
      for (int a = 0; a < 4; ++a) x[a] /= norm;
    }
    const auto finite = [](double v) { return std::isfinite(v); };
    if (!std::all_of(next.q.begin(), next.q.end(), finite) ||
        !std::all_of(next.qd.begin(), next.qd.end(), finite))
      return false;
    state_ = std::move(next);
    return true;
  }

  const Mechanism& mechanism_;
  DynamicsEvaluator evaluator_;
  EvaluationState state_;
  std::vector<double> tau_;
};

}  // namespace

std::vector<FunctionKind> trajectory_functions() {
  return {FunctionKind::mass_matrix_and_bias, FunctionKind::coordinate_rates, FunctionKind::energy};
}

std::optional<long> step_count(const TrajectoryOptions& options) {
  const double steps = options.duration / options.step;
  if (!(steps >= 0) || steps > 1e9) return std::nullopt;
  return std::lround(steps);
}

std::optional<InputError> integrate(const CompiledMechanism& compiled, const EvaluationState& start,
                                    const TrajectoryOptions& options,
                                    const std::function<void(const TrajectoryPoint&)>& take) {
  const Mechanism& mechanism = *compiled.mechanism;
  const std::optional<long> count = step_count(options);
  if (!count) {
    throw InputError(mechanism.where, "--duration and --step make no sensible number of steps (at most 1e9)");
  }
  Integrator integrator(compiled, start);
  const auto give = [&] {
    const std::vector<double> energy = integrator.evaluator()(FunctionKind::energy, integrator.state());
    take({integrator.state(), energy[0], energy[1]});
  };
  give();
  for (long i = 1; i <= *count; ++i) {
    if (!integrator.step(options.method, options.step)) {
      return InputError(
          mechanism.where,
          fmt::format("no finite step from t = {:.9g}: the mass matrix is not positive definite there, or "
                      "the motion diverges "
                      "(the output so far is kept)",
                      integrator.state().t));
    }
    integrator.set_time(start.t + static_cast<double>(i) * options.step);
    if (i % options.every == 0 || i == *count) give();
    if (options.progress && i % std::max(1L, *count / 100) == 0)
      options.progress(static_cast<double>(i) / static_cast<double>(*count));
  }
  return std::nullopt;
}

}  // namespace alembert
