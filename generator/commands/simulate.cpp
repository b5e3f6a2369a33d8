// `simulate`: fixed-step integration through the interpreter, unforced; t, q, qd and energy as CSV.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "commands/commands.hpp"
#include "commands/dynamics_evaluator.hpp"

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

 private:
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

struct CloseFile {
  void operator()(std::FILE* file) const {
    if (file != stdout) std::fclose(file);
  }
};

std::string header(const Mechanism& mechanism) {
  std::string out = "t";
  const auto names = [&](const std::string& name, int size) {
    static constexpr const char* kParts[] = {".x", ".y", ".z", ".w"};
    for (int i = 0; i < size; ++i) out += "," + name + (size == 1 ? "" : kParts[i]);
  };
  for (const Coordinate& c : mechanism.coordinates) names(c.name, c.nq());
  for (const Coordinate& c : mechanism.coordinates) names("d(" + c.name + ")", c.nv());
  return out + ",kinetic,potential,energy\n";
}

std::string row(Integrator& integrator) {
  const EvaluationState& state = integrator.state();
  std::string out = fmt::format("{:.17g}", state.t);
  for (const double x : state.q) out += fmt::format(",{:.17g}", x);
  for (const double x : state.qd) out += fmt::format(",{:.17g}", x);
  const std::vector<double> energy = integrator.evaluator()(FunctionKind::energy, state);
  return out + fmt::format(",{:.17g},{:.17g},{:.17g}\n", energy[0], energy[1], energy[0] + energy[1]);
}

}  // namespace

int run_simulate(const CommonOptions& common, const SimulateOptions& options) {
  const CompiledMechanism compiled = compile(
      common, {FunctionKind::mass_matrix_and_bias, FunctionKind::coordinate_rates, FunctionKind::energy});
  const Mechanism& mechanism = *compiled.mechanism;
  const auto fail = [&](const std::string& message) { throw InputError(mechanism.where, message); };

  EvaluationState state = DynamicsEvaluator(compiled).initial_state();
  if (!options.q.empty() && options.q.size() != state.q.size())
    fail(fmt::format("--q takes {} values", state.q.size()));
  if (!options.qd.empty() && options.qd.size() != state.qd.size())
    fail(fmt::format("--qd takes {} values", state.qd.size()));
  if (!options.q.empty()) state.q = options.q;
  if (!options.qd.empty()) state.qd = options.qd;
  const double steps = options.duration / options.step;
  if (!(steps >= 0) || steps > 1e9)
    fail("--duration and --step make no sensible number of steps (at most 1e9)");

  std::unique_ptr<std::FILE, CloseFile> file(options.csv == "-" ? stdout
                                                                : std::fopen(options.csv.c_str(), "w"));
  if (!file) fail("cannot write " + printable(options.csv, 300));
  const auto write = [&](const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size())
      fail("cannot write " + printable(options.csv, 300));
  };

  Integrator integrator(compiled, std::move(state));
  write(header(mechanism));
  write(row(integrator));
  const long count = std::lround(steps);
  const bool progress = isatty(STDERR_FILENO) != 0 && options.csv != "-";
  for (long i = 1; i <= count; ++i) {
    const bool good = options.integrator == "rk4" ? integrator.rk4(options.step)
                                                  : integrator.semi_implicit_euler(options.step);
    if (!good) {
      std::fflush(file.get());
      fail(
          fmt::format("no finite step from t = {:.9g}: the mass matrix is not positive definite there, or "
                      "the motion diverges "
                      "(the rows so far are kept)",
                      integrator.state().t));
    }
    integrator.set_time(static_cast<double>(i) * options.step);
    if (i % options.every == 0 || i == count) write(row(integrator));
    if (progress && i % std::max(1L, count / 100) == 0) fmt::print(stderr, "\r{:3d} %", 100 * i / count);
  }
  if (progress) fmt::print(stderr, "\r");
  if (std::fflush(file.get()) != 0) fail("cannot write " + printable(options.csv, 300));
  return 0;
}

}  // namespace alembert
