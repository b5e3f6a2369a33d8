// `evaluate`: states in, one JSON object a line; tau, M, c and the accelerations of forward dynamics out, and
// with constraints their rows, residuals and reactions; or the results of the functions asked for.
#include "commands/run_evaluate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "commands/common_options.hpp"
#include "commands/state_reader.hpp"
#include "functions/array_shape.hpp"
#include "simulation/dynamics_evaluator.hpp"
#include "simulation/interpreted_mechanism.hpp"
#include "support/error.hpp"

namespace alembert {

namespace {

constexpr std::size_t kLineLimit = 1 << 24;

std::string json_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.17g}", value) : "null";
}

std::string json_array(std::span<const double> values) {
  std::string out = "[";
  for (std::size_t i = 0; i < values.size(); ++i) out += (i == 0 ? "" : ",") + json_number(values[i]);
  return out + "]";
}

std::string json_matrix(std::span<const double> values, std::size_t columns) {
  std::string out = "[";
  for (std::size_t r = 0; r * columns < values.size(); ++r) {
    out += (r == 0 ? "" : ",") + json_array(values.subspan(r * columns, columns));
  }
  return out + "]";
}

std::string text_row(std::string_view name, std::span<const double> values) {
  std::string out = fmt::format("{:<8}", name);
  for (const double value : values) out += fmt::format(" {:>14.7g}", value);
  return out + "\n";
}

SourceLocation in_stdin(int line) {
  return {std::make_shared<const SourceText>(SourceText{"<stdin>", ""}), line, 1};
}

/// Names of the arrays of one state that are not finite.
using Lost = std::vector<std::string>;
void add_if_lost(std::string name, std::span<const double> values, Lost& lost) {
  if (!std::ranges::all_of(values, [](double x) { return std::isfinite(x); }))
    lost.push_back(std::move(name));
}

constexpr std::size_t kPoseSize = 12;  // rows [R | p]

/// Names as JSON: they are names of the language, with nothing to escape.
std::string json_names(const std::vector<std::string>& names) {
  std::string out = "[";
  for (std::size_t i = 0; i < names.size(); ++i) out += (i == 0 ? "\"" : ",\"") + names[i] + "\"";
  return out + "]";
}

/// Forward dynamics under tau, and the constraints at the state.
struct ForwardDynamics {
  Status status = Status::ok;
  ConstrainedMotion<double, Eigen::Dynamic, Eigen::Dynamic> motion;
  std::vector<std::string> redundant;  ///< names of rows
};

ForwardDynamics forward_dynamics(InterpretedMechanism& system, const EvaluationState& state,
                                 const std::vector<double>& tau) {
  system.set_inputs(state);
  const auto vector_of = [](const std::vector<double>& values) -> Eigen::VectorXd {
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  };
  const Eigen::VectorXd u = vector_of(state.qd), force = vector_of(tau);
  ForwardDynamics out;
  out.status = constrained_accelerations(system, vector_of(state.q), u, force, {}, out.motion);
  for (Eigen::Index i = 0; i < out.motion.redundant.rows(); ++i) {
    if (out.motion.redundant(i)) out.redundant.push_back(system.rows()[static_cast<std::size_t>(i)].name);
  }
  return out;
}

/// What a state gave.
struct Answer {
  std::size_t nv, nc;
  std::vector<double> tau, mass_matrix_and_bias, constraints, rates, poses;
  ForwardDynamics forward;
  std::span<const double> M() const { return std::span(mass_matrix_and_bias).first(nv * nv); }
  std::span<const double> c() const { return std::span(mass_matrix_and_bias).subspan(nv * nv); }
  std::span<const double> P() const { return std::span(constraints).first(nc * nv); }
  std::span<const double> gamma() const { return std::span(constraints).subspan(nc * nv, nc); }
  std::span<const double> velocity() const { return std::span(constraints).subspan(nc * nv + nc, nc); }
  std::span<const double> position() const { return std::span(constraints).subspan(nc * nv + 2 * nc, nc); }
  std::span<const double> qdd() const { return {forward.motion.qdd.data(), nv}; }
  std::span<const double> lambda() const { return {forward.motion.lambda.data(), nc}; }
};

std::string json_answer(const Answer& a) {
  const bool ok = a.forward.status == Status::ok;
  std::string out =
      fmt::format("{{\"tau\": {}, \"M\": {}, \"c\": {}, \"qdd\": {}, \"qdot\": {}, \"poses\": {}",
                  json_array(a.tau), json_matrix(a.M(), a.nv), json_array(a.c()),
                  ok ? json_array(a.qdd()) : "null", json_array(a.rates), json_matrix(a.poses, kPoseSize));
  if (a.nc > 0) {
    out += fmt::format(
        ", \"lambda\": {}, \"P\": {}, \"gamma\": {}, \"velocity\": {}, \"position\": {}, \"redundant\": {}, "
        "\"status\": \"{}\"",
        ok ? json_array(a.lambda()) : "null", json_matrix(a.P(), a.nv), json_array(a.gamma()),
        json_array(a.velocity()), json_array(a.position()), json_names(a.forward.redundant),
        to_string(a.forward.status));
  }
  return out + "}\n";
}

std::string text_matrix(std::string_view name, std::span<const double> values, std::size_t columns) {
  std::string out;
  for (std::size_t r = 0; r * columns < values.size(); ++r)
    out += text_row(r == 0 ? name : "", values.subspan(r * columns, columns));
  return out;
}

std::string text_answer(const Answer& a) {
  std::string out = text_row("tau", a.tau) + text_matrix("M", a.M(), a.nv) + text_row("c", a.c());
  if (a.forward.status == Status::ok) {
    out += text_row("qdd", a.qdd());
  } else {
    out += fmt::format("qdd      none: {} here\n", to_string(a.forward.status));
  }
  if (a.nc > 0) {
    if (a.forward.status == Status::ok) out += text_row("lambda", a.lambda());
    out += text_matrix("P", a.P(), a.nv) + text_row("gamma", a.gamma()) + text_row("velocity", a.velocity()) +
           text_row("position", a.position());
    for (const std::string& name : a.forward.redundant)
      out += fmt::format("{} follows from the other rows\n", name);
  }
  return out + "\n";
}

/// tau, M, c, accelerations, rates and poses, and the constraints there are.
class WholeDynamics {
 public:
  WholeDynamics(const CompiledMechanism& compiled, const EvaluationState& defaults)
      : compiled_(compiled), evaluator_(compiled), system_(compiled, defaults) {}
  static std::vector<FunctionKind> functions() {
    return {FunctionKind("inverse_dynamics"), FunctionKind("mass_matrix_and_bias"),
            FunctionKind("coordinate_rates"), FunctionKind("body_poses"), FunctionKind("constraints")};
  }

  std::string at(const EvaluationState& state, bool json, Lost& lost) {
    Answer answer;
    answer.nv = static_cast<std::size_t>(compiled_.mechanism->nv);
    answer.nc = system_.rows().size();
    answer.tau = evaluator_(FunctionKind("inverse_dynamics"), state);
    answer.mass_matrix_and_bias = evaluator_(FunctionKind("mass_matrix_and_bias"), state);
    answer.constraints = evaluator_(FunctionKind("constraints"), state);
    answer.rates = evaluator_(FunctionKind("coordinate_rates"), state);
    answer.poses = evaluator_(FunctionKind("body_poses"), state);
    answer.forward = forward_dynamics(system_, state, state.tau.empty() ? answer.tau : state.tau);
    add_if_lost("tau", answer.tau, lost);
    add_if_lost("M", answer.M(), lost);
    add_if_lost("c", answer.c(), lost);
    if (answer.forward.status == Status::ok) add_if_lost("qdd", answer.qdd(), lost);
    add_if_lost("poses", answer.poses, lost);
    add_if_lost("qdot", answer.rates, lost);
    if (answer.forward.status == Status::ok) add_if_lost("lambda", answer.lambda(), lost);
    add_if_lost("P", answer.P(), lost);
    add_if_lost("gamma", answer.gamma(), lost);
    add_if_lost("velocity", answer.velocity(), lost);
    add_if_lost("position", answer.position(), lost);
    return json ? json_answer(answer) : text_answer(answer);
  }

 private:
  const CompiledMechanism& compiled_;
  DynamicsEvaluator evaluator_;
  InterpretedMechanism system_;
};

/// Results of each compiled function: arrays as the generated function fills them, by function and name.
std::string function_results(const CompiledMechanism& compiled, const EvaluationState& state, bool json,
                             Lost& lost) {
  DynamicsEvaluator evaluator(compiled);
  std::string out;
  for (const CompiledFunction& function : compiled.functions) {
    const std::vector<double> values = evaluator(function.kind, state);
    std::span<const double> left = values;
    std::string arrays;
    for (const ResultArray& result : function.kind.row().results) {
      const TableShape shape = table_shape(result, *compiled.mechanism);
      const std::span<const double> array = left.first(shape.rows * shape.columns);
      left = left.subspan(array.size());
      add_if_lost(fmt::format("{} of {}", result.name, to_string(function.kind)), array, lost);
      const bool is_vector = result.per == Per::mechanism && result.columns == 1;
      if (json) {
        arrays += fmt::format("{}\"{}\": {}", arrays.empty() ? "" : ", ", result.name,
                              is_vector ? json_array(array) : json_matrix(array, shape.columns));
      } else {
        arrays += is_vector ? text_row(result.name, array) : text_matrix(result.name, array, shape.columns);
      }
    }
    out += json ? fmt::format("{}\"{}\": {{{}}}", out.empty() ? "" : ", ", to_string(function.kind), arrays)
                : fmt::format("{}\n{}", to_string(function.kind), arrays);
  }
  return json ? "{" + out + "}\n" : out + "\n";
}

}  // namespace

int run_evaluate(const CommonOptions& common, const EvaluateOptions& options) {
  if (common.file == "-") {
    throw InputError(in_stdin(1),
                     "evaluate reads states from standard input, so the description must be a file");
  }
  const FunctionChoice choice = function_choice(options.functions);
  const bool all_at_once = choice.kinds.empty();
  const CompiledMechanism compiled =
      compile(common, all_at_once ? WholeDynamics::functions() : choice.kinds, choice.inapplicable);
  const EvaluationState defaults = DynamicsEvaluator(compiled).initial_state();
  std::optional<WholeDynamics> whole;
  if (all_at_once) whole.emplace(compiled, defaults);
  const StateReader reader(*compiled.mechanism, defaults);

  std::size_t without_value = 0;
  std::string text;
  for (int line = 1; std::getline(std::cin, text); ++line) {
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    if (text.size() > kLineLimit) {
      throw InputError(in_stdin(line), "this line is too long for a state");
    }
    const EvaluationState state = reader.read(text, line);
    Lost lost;
    fmt::print("{}", whole ? whole->at(state, options.json, lost)
                           : function_results(compiled, state, options.json, lost));
    std::fflush(stdout);
    if (!lost.empty() && ++without_value == 1) {
      tell(warning_text(in_stdin(line),
                        fmt::format("no finite value at this state: {}", fmt::join(lost, ", "))) +
           "\n");
    }
  }
  if (without_value > 1)
    tell(fmt::format("note: {} states in all have results without a finite value\n", without_value));
  return 0;
}

}  // namespace alembert
