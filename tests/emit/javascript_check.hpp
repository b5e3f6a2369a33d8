// A mechanism's JavaScript run by node at random states, against the interpreter (check_module.mjs).
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "emit/c_library.hpp"
#include "emit/c_state.hpp"
#include "emit/emit.hpp"
#include "emit/sample.hpp"

namespace sample {

inline std::string json_numbers(std::span<const double> values) {
  std::string out;
  for (const double x : values)
    out += (out.empty() ? "" : ",") + (std::isfinite(x) ? fmt::format("{}", x) : "null");
  return "[" + out + "]";
}

/// One call: arguments, inputs and what they must give.
inline std::string json_call(const Program& program, const CState<double>& state) {
  std::string args, results;
  for (const ArgumentKind kind : alembert::find_function(program.function)->arguments)
    args += (args.empty() ? "" : ",") + json_numbers(state.array(kind));
  const std::vector<double> expected = state.interpreted(program);
  std::size_t first = 0;
  for (const alembert::OutputArray& output : program.outputs) {
    results += fmt::format("{}{{\"name\":\"{}\",\"values\":{}}}", results.empty() ? "" : ",", output.name,
                           json_numbers(std::span(expected).subspan(first, output.values.size())));
    first += output.values.size();
  }
  return fmt::format(
      R"({{"args":[{}],"inputs":{{"t":{},"parameters":{},"wrenches":{}}},"results":[{}],"by_default":{}}})",
      args, state.t, json_numbers(state.parameters), json_numbers(state.wrenches), results, state.t == 0);
}

/// Checks these functions, or all. Random functions multiply a sine's last digit, which differs between libraries,
/// beyond all bounds. Where node is missing, nothing is checked.
inline void check_javascript(const Mechanism& mechanism, const std::vector<Program>& programs,
                             const std::vector<std::string>& compared = {}) {
  const std::string node = ALEMBERT_NODE_COMMAND;
  if (node.empty()) return;
  alembert::EmitOptions options;
  options.language = alembert::Language::javascript;
  options.scalars = {"double"};
  std::vector<alembert::EmittedFile> files = alembert::emit_mechanism(mechanism, programs, options);
  ASSERT_EQ(files.size(), 1u);
  EXPECT_EQ(files[0].path, "javascript/" + mechanism.name + ".mjs");
  EXPECT_EQ(files[0].text, alembert::emit_mechanism(mechanism, programs, options)[0].text);
  std::string functions, names;
  for (const Program& program : programs) {
    if (!compared.empty() && std::ranges::count(compared, program.function) == 0) continue;
    std::string states;
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      CState<double> state(mechanism, seed);
      if (seed == 2) {  // what the description says
        std::size_t k = 0;
        for (const alembert::Parameter& parameter : mechanism.parameters)
          if (parameter.runtime) state.parameters[k++] = parameter.value;
        state.wrenches.assign(state.wrenches.size(), 0);
        state.t = 0;
      }
      states += (seed == 0 ? "" : ",") + json_call(program, state);
    }
    functions +=
        fmt::format(R"({}{{"name":"{}","takes_inputs":{},"states":[{}]}})", functions.empty() ? "" : ",",
                    program.function, alembert::find_function(program.function)->takes_inputs, states);
  }
  for (const alembert::Coordinate& c : mechanism.coordinates) {
    const bool real = c.type == alembert::CoordinateType::real;
    for (const char* part : {".x", ".y", ".z", ".w"}) {
      std::string name;
      // Bytes, as JavaScript has them.
      for (const char character : c.name + (real ? "" : part))
        name += fmt::format("\\u{:04x}", static_cast<unsigned>(static_cast<unsigned char>(character)));
      names += fmt::format("{}\"{}\"", names.empty() ? "" : ",", name);
      if (real) break;
    }
  }
  files.push_back({"calls.json", fmt::format(R"({{"names":[{}],"functions":[{}]}})", names, functions)});
  const Folder folder;
  put(files, folder.path);
  const std::string command = fmt::format("'{}' '{}/tests/emit/check_module.mjs' '{}/{}' '{}/calls.json'",
                                          node, ALEMBERT_SOURCE_DIR, folder.path, files[0].path, folder.path);
  EXPECT_EQ(std::system(command.c_str()), 0) << mechanism.name;
}

}  // namespace sample
