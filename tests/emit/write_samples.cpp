// Emits the samples into a folder while the tests are built: write_samples DIRECTORY
#include <exception>
#include <iostream>

#include "emit/emit.hpp"
#include "emit/files/write_files.hpp"
#include "emit/sample.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    alembert::EmitOptions options;
    for (const sample::Sample& s :
         {sample::every_function(), sample::evil(), sample::big(), sample::stepping(), sample::looping()}) {
      options.parts = 3;
      alembert::write_files(alembert::emit_mechanism(s.mechanism, s.programs, options), argv[1]);
    }
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
