// The program that times functions (see the header).
#include "emit/bench_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "emit/argument_lists.hpp"
#include "emit/statements/batch.hpp"
#include "emit/statements/literals.hpp"
#include "emit/text_template.hpp"
#include "functions/array_shape.hpp"

namespace alembert {
namespace {

/// A function that calls one of the mechanism's at all states: one by one, or as a batch.
std::string timed_function(const OutputFunction& function, const Mechanism& mechanism, bool batch) {
  std::string arrays;
  for (const ResultArray& result : function.results)
    arrays += fmt::format("static double {}[{}{}];\n", result.name,
                          std::max<std::size_t>(array_shape(result, mechanism).size(), 1),
                          batch ? " * kStates" : "");
  std::string arguments;
  for (const ArgumentKind kind : function.arguments)
    arguments +=
        batch ? fmt::format("lanes::{}, ", argument_name(kind))
              : fmt::format("rows::{} + {} * s, ", argument_name(kind), argument_size(kind, mechanism));
  std::string results;
  for (const ResultArray& result : function.results)
    results += fmt::format("{}{}", results.empty() ? "" : ", ", result.name);
  const std::string inputs = batch || !function.takes_inputs ? "" : "const mechanism::Inputs<double> in;\n";
  const std::string call =
      batch ? fmt::format("mechanism::{}_batch(kStates, kStates, {}{}{});\n", function.name, arguments,
                          function.takes_inputs ? "mechanism::BatchInputs(), " : "", results)
            : fmt::format("for (int s = 0; s < kStates; ++s) mechanism::{}<double>({}{}{});\n", function.name,
                          arguments, function.takes_inputs ? "in, " : "", results);
  return fmt::format("void run_{}{}() {{\n{}}}\n", function.name, batch ? "_batch" : "",
                     prefix_lines(arrays + inputs + call, "  "));
}

}  // namespace

std::vector<ArgumentKind> bench_arguments() {
  return {ArgumentKind::q, ArgumentKind::qd, ArgumentKind::qdd, ArgumentKind::tau, ArgumentKind::mu};
}

std::vector<EmittedFile> bench_files(const Mechanism& mechanism, std::span<const Program> programs,
                                     const EmitOptions& options, int states) {
  std::string arrays, rows, lanes, reads, functions, table;
  for (const ArgumentKind kind : bench_arguments()) {
    const std::string_view name = argument_name(kind);
    const std::size_t size = argument_size(kind, mechanism);
    arrays += fmt::format("{}{:<4} {} states x {}", arrays.empty() ? "" : "\n//   ", name, states, size);
    rows += fmt::format("double {}[kStates * {}];\n", name, size);
    lanes += fmt::format("double {}[kStates * {}];\n", name, size);
    reads += fmt::format("complete = complete && read(file, rows::{0}, lanes::{0}, {1});\n", name, size);
  }
  const auto add = [&](const OutputFunction& function, bool batch) {
    functions += (functions.empty() ? "" : "\n") + timed_function(function, mechanism, batch);
    table += fmt::format("{{\"{0}{1}\", run_{0}{1}, 1, {{}}}},\n", function.name, batch ? "_batch" : "");
  };
  for (const Program& program : programs) add(*find_function(program.function), false);
  for (const OutputFunction* function : batch_signatures(mechanism, programs, options)) add(*function, true);

  std::string instructions;
  if (!options.batch.empty()) {
    instructions = "const char* set = \"baseline\";\n";
    for (const std::string_view set : batch_instruction_sets())
      if (std::ranges::find(options.batch_instructions, set) != options.batch_instructions.end())
        instructions += fmt::format(
            "{0}if (::alembert::has_instructions(::alembert::Instructions::{1})) set = \"{1}\";\n",
            instructions.find("if") == std::string::npos ? "" : "else ", set);
    instructions += "std::printf(\"instructions %s\\n\", set);\n";
  }
  const std::string banner =
      fill_template("banner.txt", {{"name", mechanism.name}, {"version", std::string(generator_version())}});
  std::vector<EmittedFile> files = {
      {"src/bench.cpp",
       fill_template(
           "bench.cpp",
           {{"banner", prefix_lines(banner, "// ")},
            {"arrays", arrays},
            {"name", mechanism.name},
            {"namespace", options.outer_namespace + "::" + mechanism.name},
            {"includes",
             options.batch.empty() ? "" : fmt::format("#include <{0}/{0}_batch.hpp>\n", mechanism.name)},
            {"states", std::to_string(states)},
            {"declarations", fmt::format("namespace rows {{\n{}}}\nnamespace lanes {{\n{}}}\n", rows, lanes)},
            {"functions", functions},
            {"reads", reads},
            {"table", table},
            {"instructions", instructions}})}};
  for (const char* header :
       {"batch", "floating_point", "pack", "pack_window", "sines_and_cosines", "sines_and_cosines_lanes"})
    files.push_back({fmt::format("include/alembert/{}.hpp", header),
                     std::string(template_text(fmt::format("alembert/{}.hpp", header)))});
  return files;
}

}  // namespace alembert
