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

/// How a function is called at all states.
enum class Calls { one_by_one, kept, batch };
std::string_view ending(Calls calls) {
  if (calls == Calls::one_by_one) return "";
  return calls == Calls::kept ? kKeptEnding : kBatchEnding;
}

/// A function that calls one of the mechanism's at all states.
std::string timed_function(const OutputFunction& function, const Mechanism& mechanism, Calls calls) {
  std::string arrays, arguments, results;
  for (const ResultArray& result : function.results) {
    const std::size_t size = std::max<std::size_t>(array_shape(result, mechanism).size(), 1);
    if (calls == Calls::one_by_one)
      arrays += fmt::format("static double {}[{}];\n", result.name, size);
    else
      arrays += fmt::format(
          "static std::vector<double> {0}_of_states(static_cast<std::size_t>(states) * {1});\n"
          "double* const {0} = {0}_of_states.data();\n",
          result.name, size);
    results += fmt::format("{}{}{}", results.empty() ? "" : ", ", result.name,
                           calls == Calls::kept ? fmt::format(" + {} * s", size) : "");
  }
  for (const ArgumentKind kind : function.arguments)
    arguments += calls == Calls::batch ? fmt::format("lanes::{}.data(), ", argument_name(kind))
                                       : fmt::format("rows::{}.data() + {} * s, ", argument_name(kind),
                                                     argument_size(kind, mechanism));
  const bool inputs = function.takes_inputs && calls != Calls::batch;
  const std::string call =
      calls == Calls::batch
          ? fmt::format("mechanism::{}_batch(states, states, {}{}{});\n", function.name, arguments,
                        function.takes_inputs ? "mechanism::BatchInputs(), " : "", results)
          : fmt::format("for (std::ptrdiff_t s = 0; s < states; ++s) mechanism::{}<double>({}{}{});\n",
                        function.name, arguments, inputs ? "in, " : "", results);
  return fmt::format(
      "void run_{}{}() {{\n{}}}\n", function.name, ending(calls),
      prefix_lines(arrays + (inputs ? "const mechanism::Inputs<double> in;\n" : "") + call, "  "));
}

}  // namespace

std::vector<ArgumentKind> bench_arguments() {
  return {ArgumentKind::q, ArgumentKind::qd, ArgumentKind::qdd, ArgumentKind::tau, ArgumentKind::mu};
}

std::vector<EmittedFile> bench_files(const Mechanism& mechanism, std::span<const Program> programs,
                                     const EmitOptions& options) {
  std::string arrays, vectors, reads, functions, table;
  for (const ArgumentKind kind : bench_arguments()) {
    const std::string_view name = argument_name(kind);
    const std::size_t size = argument_size(kind, mechanism);
    arrays += fmt::format("{}{:<4} {} of each state", arrays.empty() ? "" : "\n//   ", name, size);
    vectors += fmt::format("{}{}", vectors.empty() ? "" : ", ", name);
    reads += fmt::format("complete = complete && read(file, rows::{0}, lanes::{0}, {1});\n", name, size);
  }
  const auto add = [&](const OutputFunction& function, Calls calls) {
    functions += (functions.empty() ? "" : "\n") + timed_function(function, mechanism, calls);
    table += fmt::format("{{\"{0}{1}\", run_{0}{1}, 1, {{}}}},\n", function.name, ending(calls));
  };
  for (const Program& program : programs) add(*find_function(program.function), Calls::one_by_one);
  for (const OutputFunction* function : batch_signatures(mechanism, programs, options)) {
    add(*function, Calls::kept);
    add(*function, Calls::batch);
  }

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
            {"declarations", fmt::format("namespace rows {{\nstd::vector<double> {0};\n}}\nnamespace lanes "
                                         "{{\nstd::vector<double> {0};\n}}\n",
                                         vectors)},
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
