// The live part of a page (see the header).
#include "commands/live_mechanism.hpp"

#include <algorithm>
#include <cmath>

#include "emit/emit.hpp"
#include "functions/array_shape.hpp"
#include "mechanism/load.hpp"
#include "mechanism/parameter_places.hpp"

namespace alembert {

namespace {

/// With forces, which may be stiff, derivatives; without these and constraints, accelerations at once.
std::vector<FunctionKind> live_functions(const Mechanism& mechanism) {
  std::vector<FunctionKind> kinds = {FunctionKind("coordinate_rates"), FunctionKind("energy"),
                                     FunctionKind("body_poses"),       FunctionKind("body_jacobians"),
                                     FunctionKind("constraints"),      FunctionKind("state_rates")};
  const auto add = [&](std::initializer_list<FunctionKind> more) {
    kinds.insert(kinds.end(), more.begin(), more.end());
  };
  const bool free = mechanism.forces.empty() && mechanism.constraints.empty();
  add({free ? FunctionKind("forward_dynamics") : FunctionKind("mass_matrix_and_bias")});
  if (!mechanism.forces.empty())
    add({FunctionKind("inverse_dynamics_derivatives"), FunctionKind("state_rates_derivatives")});
  std::erase_if(kinds, [&](FunctionKind kind) { return !has_results(kind.row(), mechanism); });
  return kinds;
}

/// Limits, or a range about the value: what is positive stays so.
Slider slider_of(const PlacedParameter& placed, double value) {
  const Parameter& parameter = placed.parameter;
  const double most = std::max(1.0, std::pow(10.0, std::ceil(std::log10(std::max(std::abs(value), 1e-300)))));
  Slider slider{parameter.name, placed.place, -10 * most, 10 * most, parameter.is_input()};
  if (!parameter.is_input() && value > 0) std::tie(slider.low, slider.high) = std::pair(value / 5, value * 3);
  if (!parameter.is_input() && value < 0) std::tie(slider.low, slider.high) = std::pair(value * 3, value / 5);
  if (!parameter.limits) return slider;
  if (std::isfinite(parameter.limits->first)) slider.low = parameter.limits->first;
  if (std::isfinite(parameter.limits->second)) slider.high = parameter.limits->second;
  if (!(slider.low < slider.high))
    std::tie(slider.low, slider.high) = std::pair(slider.low - 1, slider.low + 1);
  return slider;
}

}  // namespace

void add_live_functions(const std::shared_ptr<const SourceText>& source,
                        std::vector<FunctionKind>& functions) {
  ExprGraph graph;
  for (const FunctionKind kind : live_functions(load_mechanism(source, graph)))
    if (std::ranges::count(functions, kind) == 0) functions.push_back(kind);
}

LiveMechanism live_mechanism(const CompiledMechanism& compiled, const EvaluationState& start,
                             const ForceReadings& readings) {
  const Mechanism& mechanism = *compiled.mechanism;
  std::vector<Program> programs;
  for (const FunctionKind kind : live_functions(mechanism))
    programs.push_back(compiled.function(kind).program);
  EmitOptions options;
  options.language = Language::javascript;
  options.scalars = {"double"};
  if (!readings.program().empty()) {
    const Program& program = readings.program().program();
    const Extent size = static_cast<int>(program.outputs.front().values.size());
    options.extra.push_back(
        {{"readings",
          Topic::kinematics,
          false,
          {ArgumentKind::q, ArgumentKind::qd},
          true,
          "What plots and pictures show.",
          "",
          {{"values", "forces, inputs, states, outputs, points of lines and of contacts", size}},
          "",
          ""},
         program});
  }
  LiveMechanism live;
  live.module = emit_mechanism(mechanism, programs, options).front().text;
  live.q = start.q;
  live.qd = start.qd;
  live.t = start.t;
  live.parameters = start.parameters;
  for (const ParameterRole role : {ParameterRole::input, ParameterRole::parameter})
    for (const PlacedParameter& placed : placed_parameters(mechanism, role))
      if (!placed.parameter.law) live.sliders.push_back(slider_of(placed, start.parameters[placed.place]));
  return live;
}

}  // namespace alembert
