// From options of the command line to what the pipeline takes (see the header).
#include "commands/common_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <memory>
#include <utility>

#include "commands/run_import.hpp"
#include "commands/warnings.hpp"
#include "emit/argument_lists.hpp"
#include "emit/statements/batch.hpp"
#include "functions/function_table.hpp"

namespace alembert {

namespace {

InputExpression input_expression(const std::string& text) {
  const auto source = std::make_shared<const SourceText>(SourceText{"--input", text});
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos || sign == 0)
    throw InputError({source, 1, 1}, "expected NAME=EXPRESSION",
                     "for example --input \"throttle=0.5*sin(3*t)\"");
  return {text.substr(0, sign), source};
}

/// Dot products over many states are loops where there are so many times more: near there, on chains of 30
/// joints, M and c take the same time either way.
constexpr std::size_t kBatchFactor = 12;

}  // namespace

CompiledMechanism compile(const CommonOptions& common, std::vector<FunctionKind> functions,
                          Inapplicable inapplicable) {
  return compile(common, description_of(common), std::move(functions), inapplicable);
}

CompiledMechanism compile(const CommonOptions& common, std::shared_ptr<const SourceText> source,
                          std::vector<FunctionKind> functions, Inapplicable inapplicable, bool axes) {
  CompileOptions options;
  options.axes = axes;
  options.inapplicable = inapplicable;
  if (!common.warned)
    options.warn = [&common](const Warnings& warnings) { report_warnings(warnings, common.strict); };
  options.formulation = common.formulation;
  options.passes = common.passes;
  options.loop_operations = common.loop_operations;
  options.loop_results = common.loop_results;
  options.functions = std::move(functions);
  for (const std::string& text : common.inputs) options.inputs.push_back(input_expression(text));
  if (common.verbose) options.talk = &std::cerr;
  if (!common.dump_stage.empty()) {
    options.dump = &std::cout;
    options.dump_stage = common.dump_stage;
  }
  return compile_mechanism(std::move(source), options);
}

std::vector<Program> programs_of(const CompiledMechanism& compiled) {
  std::vector<Program> programs;
  for (const CompiledFunction& function : compiled.functions) programs.push_back(function.program);
  return programs;
}

void set_batch(EmitOptions& emit, const CommonOptions& common, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (name != "default") emit.batch.push_back(name);
    if (name == "default") std::ranges::copy(default_batch_functions(), std::back_inserter(emit.batch));
  }
  emit.batch_dot_products = kBatchFactor * common.loop_results;
}

namespace {

/// The function that is meant, likely, or those whose names have the given one in them.
std::string near_functions(const std::string& name) {
  constexpr std::size_t kListed = 6;
  std::vector<std::string> known, near;
  for (const OutputFunction& row : kOutputFunctions) known.emplace_back(row.name);
  const std::string nearest = did_you_mean(name, known);
  if (!nearest.empty()) return nearest;
  for (const std::string& each : known)
    if (!name.empty() && near.size() < kListed && each.find(name) != std::string::npos) near.push_back(each);
  return near.empty() ? "" : fmt::format(" (near ones: {})", fmt::join(near, ", "));
}

}  // namespace

FunctionChoice function_choice(const std::vector<std::string>& names) {
  FunctionChoice choice;
  if (names == std::vector<std::string>{"all"}) {
    for (const OutputFunction& row : kOutputFunctions) choice.kinds.emplace_back(row);
    choice.inapplicable = Inapplicable::leave_out;
    return choice;
  }
  for (const std::string& name : names) {
    const SourceLocation here{std::make_shared<const SourceText>(SourceText{"--functions", name}), 1, 1};
    const OutputFunction* row = find_function(name);
    if (row == nullptr)
      throw InputError(here, "there is no function '" + printable(name) + "'" + near_functions(name),
                       "`--functions help` lists them");
    const FunctionKind kind(*row);
    if (std::ranges::find(choice.kinds, kind) != choice.kinds.end())
      throw InputError(here, name + " is given twice");
    choice.kinds.push_back(kind);
  }
  return choice;
}

std::string function_list() {
  std::string out = "Output functions; * marks those that `generate` writes unless told otherwise.\n";
  for (const auto& [topic, title] : {std::pair(Topic::dynamics, "Dynamics"),
                                     {Topic::kinematics, "Kinematics"},
                                     {Topic::derivatives, "Derivatives"}}) {
    out += fmt::format("\n{}\n", title);
    for (const OutputFunction& row : kOutputFunctions) {
      if (row.topic != topic) continue;
      out +=
          fmt::format("{} {}({}) -> {}\n      {}\n", row.by_default ? "*" : " ", row.name,
                      fmt::join(argument_names(row), ", "), fmt::join(result_names(row), ", "), row.summary);
    }
  }
  return out;
}

}  // namespace alembert
