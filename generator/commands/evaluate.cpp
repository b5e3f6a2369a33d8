// `evaluate`: states in, one JSON object a line; tau, M, c and the accelerations of forward dynamics out.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "commands/commands.hpp"
#include "commands/dynamics_evaluator.hpp"

namespace alembert {

namespace {

constexpr std::size_t kLineLimit = 1 << 24;

/// A state being read, with its place for messages.
class StateReader {
 public:
  StateReader(const Mechanism& mechanism, const EvaluationState& defaults)
      : mechanism_(mechanism), defaults_(defaults) {}

  EvaluationState read(const std::string& text, int line) {
    line_ = line;
    text_ = std::make_shared<const SourceText>(
        SourceText{"<stdin>", std::string(static_cast<std::size_t>(line - 1), '\n') + text});
    nlohmann::json object;
    try {
      object = nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& error) {
      fail("this is no JSON object: " + printable(error.what(), 200),
           static_cast<int>(std::max<std::size_t>(error.byte, 1)));
    } catch (const nlohmann::json::exception& error) {
      fail("this is no JSON object: " + printable(error.what(), 200));
    }
    if (!object.is_object()) fail("expected a JSON object with q, qd, qdd, t, tau, parameters, wrenches");
    EvaluationState state = defaults_;
    static const std::vector<std::string> kKeys{"q", "qd", "qdd", "t", "parameters", "wrenches"};
    for (const auto& [key, value] : object.items()) {
      if (std::find(kKeys.begin(), kKeys.end(), key) == kKeys.end()) {
        fail("unknown key '" + printable(key) + "'" + did_you_mean(key, kKeys));
      }
    }
    array(object, "q", state.q);
    array(object, "qd", state.qd);
    array(object, "qdd", state.qdd);
    if (object.contains("t")) state.t = number(object["t"], "t");
    if (object.contains("parameters")) parameters(object["parameters"], state);
    if (object.contains("wrenches")) wrenches(object["wrenches"], state);
    unit_quaternions(state);
    return state;
  }

 private:
  [[noreturn]] void fail(const std::string& message, int column = 1) const {
    throw InputError({text_, line_, column}, message);
  }

  double number(const nlohmann::json& value, const std::string& what) const {
    if (!value.is_number() || !std::isfinite(value.get<double>()))
      fail("'" + what + "' must be a finite number");
    return value.get<double>();
  }
  void numbers(const nlohmann::json& value, const std::string& what, std::span<double> out) const {
    if (!value.is_array() || value.size() != out.size()) {
      fail(fmt::format("'{}' must be an array of {} numbers", what, out.size()));
    }
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = number(value[i], what);
  }
  void array(const nlohmann::json& object, const std::string& key, std::vector<double>& out) const {
    if (object.contains(key)) numbers(object[key], key, out);
  }
  void parameters(const nlohmann::json& values, EvaluationState& state) const {
    if (!values.is_object()) fail("'parameters' must be an object of runtime parameters by name");
    std::vector<std::string> names;
    for (const Parameter& parameter : mechanism_.parameters) {
      if (parameter.runtime) names.push_back(parameter.name);
    }
    for (const auto& [name, value] : values.items()) {
      const auto found = std::find(names.begin(), names.end(), name);
      if (found == names.end())
        fail("there is no runtime parameter '" + printable(name) + "'" + did_you_mean(name, names));
      state.parameters[static_cast<std::size_t>(found - names.begin())] = number(value, name);
    }
  }
  void wrenches(const nlohmann::json& values, EvaluationState& state) const {
    if (!values.is_object()) fail("'wrenches' must be an object of [fx, fy, fz, tx, ty, tz] by body");
    std::vector<std::string> names;
    for (const Body& body : mechanism_.bodies) {
      if (body.external_wrench) names.push_back(body.name);
    }
    for (const auto& [name, value] : values.items()) {
      const auto found = std::find(names.begin(), names.end(), name);
      if (found == names.end())
        fail("there is no body with external_wrench called '" + printable(name) + "'" +
             did_you_mean(name, names));
      numbers(value, name,
              std::span(state.wrenches).subspan(6 * static_cast<std::size_t>(found - names.begin()), 6));
    }
  }
  void unit_quaternions(const EvaluationState& state) const {
    for (const Coordinate& coordinate : mechanism_.coordinates) {
      if (coordinate.type != CoordinateType::quaternion) continue;
      double norm = 0;
      for (int a = 0; a < 4; ++a)
        norm += std::pow(state.q[static_cast<std::size_t>(coordinate.first_q + a)], 2);
      if (std::abs(norm - 1) > 1e-6) fail("quaternion '" + coordinate.name + "' is not of unit length");
    }
  }

  const Mechanism& mechanism_;
  const EvaluationState& defaults_;
  std::shared_ptr<const SourceText> text_;
  int line_ = 1;
};

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
  std::string out = fmt::format("{:<4}", name);
  for (const double value : values) out += fmt::format(" {:>14.7g}", value);
  return out + "\n";
}

constexpr std::size_t kPoseSize = 12;  // rows [R | p]

}  // namespace

int run_evaluate(const CommonOptions& common, bool json) {
  if (common.file == "-") {
    throw InputError({std::make_shared<const SourceText>(SourceText{"<stdin>", ""}), 1, 1},
                     "evaluate reads states from standard input, so the description must be a file");
  }
  const CompiledMechanism compiled =
      compile(common, {FunctionKind::inverse_dynamics, FunctionKind::mass_matrix_and_bias,
                       FunctionKind::coordinate_rates, FunctionKind::body_poses});
  const Mechanism& mechanism = *compiled.mechanism;
  const std::size_t nv = static_cast<std::size_t>(mechanism.nv);
  DynamicsEvaluator evaluator(compiled);
  const EvaluationState defaults = evaluator.initial_state();
  StateReader reader(mechanism, defaults);

  std::string text;
  for (int line = 1; std::getline(std::cin, text); ++line) {
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    if (text.size() > kLineLimit) {
      throw InputError({std::make_shared<const SourceText>(SourceText{"<stdin>", ""}), line, 1},
                       "this line is too long for a state");
    }
    const EvaluationState state = reader.read(text, line);
    const std::vector<double> tau = evaluator(FunctionKind::inverse_dynamics, state);
    const std::vector<double> values = evaluator(FunctionKind::mass_matrix_and_bias, state);
    const std::span<const double> M = std::span(values).first(nv * nv),
                                  c = std::span(values).subspan(nv * nv);
    const std::vector<double> qdd = evaluator.forward_dynamics(state, tau);
    if (json) {
      fmt::print("{{\"tau\": {}, \"M\": {}, \"c\": {}, \"qdd\": {}, \"qdot\": {}, \"poses\": {}}}\n",
                 json_array(tau), json_matrix(M, nv), json_array(c), qdd.empty() ? "null" : json_array(qdd),
                 json_array(evaluator(FunctionKind::coordinate_rates, state)),
                 json_matrix(evaluator(FunctionKind::body_poses, state), kPoseSize));
    } else {
      std::string out = text_row("tau", tau);
      for (std::size_t r = 0; r < nv; ++r) out += text_row(r == 0 ? "M" : "", M.subspan(r * nv, nv));
      out += text_row("c", c);
      out += qdd.empty() ? "qdd  none: M is not positive definite here\n" : text_row("qdd", qdd);
      fmt::print("{}\n", out);
    }
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace alembert
