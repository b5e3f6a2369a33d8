// Writes the CUDA header of a mechanism (see the header).
#include "emit/cuda.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include "emit/argument_lists.hpp"
#include "emit/common_slots.hpp"
#include "emit/function_docs.hpp"
#include "emit/statements/literals.hpp"
#include "mechanism/parameter_places.hpp"

namespace alembert {
namespace {

std::string arguments_of(const OutputFunction& function) {
  return argument_list(function, "[[maybe_unused]] In {}",
                       function.takes_inputs ? "[[maybe_unused]] const Inputs<S, Given>& in" : "",
                       "[[maybe_unused]] Out {}");
}

std::string definition(const WrittenFunction& written, const Mechanism& mechanism, const Slots& common) {
  const OutputFunction& function = *written.signature;
  const std::string name(function.name);
  const std::string_view inputs = function.takes_inputs ? "in" : "";
  const std::vector<CodeBlock>& blocks = written.body.blocks;
  std::string before, statements = blocks[0].using_lines + blocks[0].statement_lines;
  if (blocks.size() > 1) {
    statements = fmt::format("S kept[{}];\n", std::max<std::size_t>(written.body.crossing, 1));
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const std::string block = fmt::format("{}_block{}", name, i + 1);
      before += fill_template("cuda_block.cuh",
                              {{"block", block},
                               {"arguments", wrap_behind("ALEMBERT_DEVICE_NOINLINE void " + block + "(",
                                                         arguments_of(function))},
                               {"using", blocks[i].using_lines},
                               {"statements", blocks[i].statement_lines}}) +
                "\n";
      statements +=
          fmt::format("detail::{}<S>({}, kept);\n", block, argument_list(function, "{}", inputs, "{}"));
    }
  }
  return fill_template(
      "cuda_function.cuh",
      {{"blocks", before},
       {"doc", prefix_lines(function_doc(function, mechanism, written.counts, std::nullopt), "/// ")},
       {"function", name},
       {"arguments", wrap_behind("ALEMBERT_HOST_DEVICE void " + name + "(", arguments_of(function))},
       {"statements", statements},
       {"kernel_parameters",
        argument_list(function, "const S* {}", function.takes_inputs ? "BatchInputs<S> in" : "", "S* {}")},
       {"kernel_arguments", argument_list(function, "{}", inputs, "{}")},
       {"kernel_inputs",
        function.takes_inputs ? "const Inputs<S, Lane<const S>> inputs = in.of(state, stride);" : ""},
       {"lanes", argument_list(function, "Lane<const S>{{{} + state, stride}}",
                               function.takes_inputs ? "inputs" : "", "Lane<S>{{{} + state, stride}}")}},
      common);
}

/// Where there is what steps need: rates of speeds, coordinates and states, and no constraints.
std::string rollout(const Mechanism& mechanism, std::span<const WrittenFunction> functions) {
  const auto has = [&](std::string_view name) {
    return std::ranges::any_of(functions,
                               [&](const WrittenFunction& f) { return f.signature->name == name; });
  };
  if (!has("forward_dynamics") || !has("coordinate_rates")) return "";
  const bool states = !placed_parameters(mechanism, ParameterRole::state).empty();
  if (!mechanism.constraints.empty() || (states && !has("state_rates"))) return "";
  std::vector<int> offsets;
  for (const Coordinate& coordinate : mechanism.coordinates)
    if (coordinate.type == CoordinateType::quaternion) offsets.push_back(coordinate.first_q);
  offsets.push_back(-1);
  return fill_template("cuda_rollout.cuh",
                       {{"quaternions", fmt::format("{{{}}}", fmt::join(offsets, ", "))},
                        {"state_rates", states ? "state_rates<S>(q, qd, in, sdot);" : ""}});
}

}  // namespace

std::string cuda_header(const Mechanism& mechanism, std::span<const WrittenFunction> functions,
                        const Slots& common) {
  std::string definitions, helpers;
  std::set<std::string> called;
  for (const WrittenFunction& written : functions) {
    definitions += (definitions.empty() ? "" : "\n") + definition(written, mechanism, common);
    for (const CodeBlock& block : written.body.blocks)
      called.insert(block.helpers.begin(), block.helpers.end());
  }
  for (const std::string_view helper : kHelpers)
    if (called.contains(std::string(helper)))
      helpers += fill_template(fmt::format("cuda_{}.cuh", helper), {}) + "\n";
  const auto wrenches = std::ranges::count_if(mechanism.bodies, &Body::external_wrench);
  const std::vector<std::string> zeros(std::max<std::size_t>(6 * static_cast<std::size_t>(wrenches), 1), "0");
  std::vector<std::string> defaults;
  for (const Parameter& parameter : mechanism.parameters)
    if (parameter.runtime) defaults.push_back(fmt::format("S({})", number_literal(parameter.value)));
  if (defaults.empty()) defaults.emplace_back("0");
  Slots slots;
  slots["banner"] = prefix_lines(common.at("banner"), "// ");
  slots["description"] =
      mechanism.description.empty()
          ? ""
          : "//\n" + prefix_lines(wrap_words(comment_text(mechanism.description), 3, 0, 110), "// ");
  slots["parameter_defaults"] = fmt::format("{{{}}}", fmt::join(defaults, ", "));
  slots["no_wrenches"] = fmt::format("{{{}}}", fmt::join(zeros, ", "));
  slots["state_arguments"] = prefix_lines(state_arguments(functions, common, 5, "[{}]"), "//   ");
  slots["helpers"] = helpers;
  slots["definitions"] = definitions;
  slots["rollout"] = rollout(mechanism, functions);
  return fill_template("mechanism.cuh", slots, common);
}

}  // namespace alembert
