// Emits the samples into a folder while the tests are built: write_samples DIRECTORY
#include <exception>
#include <fstream>
#include <iostream>
#include <string>

#include "emit/argument_lists.hpp"
#include "emit/emit.hpp"
#include "emit/files/write_files.hpp"
#include "emit/sample.hpp"
#include "functions/array_shape.hpp"

namespace {

/// For each function a line `visit("bias", [&](double* out) { m::bias(q, qd, in, out + 0); });` to be
/// included where these names stand for a sample and its arguments: a new function is called without further
/// edits.
std::string calls(const alembert::Mechanism& mechanism) {
  std::string text;
  for (const alembert::OutputFunction& function : alembert::kOutputFunctions) {
    std::string arguments;
    for (const alembert::ArgumentKind kind : function.arguments)
      arguments += std::string(alembert::argument_name(kind)) + ", ";
    if (function.takes_inputs) arguments += "in, ";
    std::size_t offset = 0;
    for (const alembert::ResultArray& result : function.results) {
      arguments += (offset == 0 ? "out + " : ", out + ") + std::to_string(offset);
      offset += alembert::array_shape(result, mechanism).size();
    }
    const std::string name(function.name);
    text += "visit(\"" + name + "\", [&](double* out) { m::" + name + "(" + arguments + "); });\n";
  }
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    alembert::EmitOptions options;
    for (const sample::Sample& s :
         {sample::every_function(), sample::evil(), sample::big(), sample::stepping(), sample::looping()}) {
      options.parts = 3;
      alembert::write_files(alembert::emit_mechanism(s.mechanism, s.programs, options), argv[1]);
    }
    std::ofstream(std::string(argv[1]) + "/include/sample_calls.inc")
        << calls(sample::every_function().mechanism);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
