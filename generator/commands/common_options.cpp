// From options of the command line to what the pipeline takes (see the header).
#include "commands/common_options.hpp"

#include <algorithm>
#include <iostream>
#include <memory>
#include <utility>

#include "commands/warnings.hpp"
#include "mechanism/source.hpp"

namespace alembert {

CompiledMechanism compile(const CommonOptions& common, std::vector<FunctionKind> functions,
                          SingularMass singular) {
  CompileOptions options;
  options.singular = singular;
  options.warn = [&common](const Warnings& warnings) { report_warnings(warnings, common.strict); };
  options.formulation = common.formulation;
  options.passes = common.passes;
  options.loop_operations = common.loop_operations;
  options.loop_results = common.loop_results;
  options.functions = std::move(functions);
  if (common.verbose) options.talk = &std::cerr;
  if (!common.dump_stage.empty()) {
    options.dump = &std::cout;
    options.dump_stage = common.dump_stage;
  }
  return compile_mechanism(read_source(common.file), options);
}

std::vector<FunctionKind> function_kinds(const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const FunctionKind kind : all_function_kinds()) known.emplace_back(to_string(kind));
  std::vector<FunctionKind> kinds;
  for (const std::string& name : names) {
    const SourceLocation here{std::make_shared<const SourceText>(SourceText{"--functions", name}), 1, 1};
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end())
      throw InputError(here, "there is no function '" + printable(name) + "'" + did_you_mean(name, known));
    const FunctionKind kind = all_function_kinds()[static_cast<std::size_t>(found - known.begin())];
    if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end())
      throw InputError(here, name + " is given twice");
    kinds.push_back(kind);
  }
  return kinds;
}

}  // namespace alembert
