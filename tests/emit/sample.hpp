// Mechanisms and programs made by hand and at random, for tests of emission. The same ones are emitted and
// compiled when the tests are built, and interpreted when they run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mechanism/model.hpp"
#include "program/program.hpp"

namespace sample {

struct Sample {
  alembert::Mechanism mechanism;
  std::vector<alembert::Program> programs;
};

/// `sample_all`: 3 real coordinates and a quaternion, runtime parameters, wrenches, frames; every function,
/// each a random program that has every operation, but for mass_matrix and energy: these are short and
/// smooth.
Sample every_function();

/// `sample_big`: 6 coordinates; inverse_dynamics and mass_matrix of several thousand statements, so that they
/// are cut into blocks.
Sample big();

/// `sample_steps`: 24 coordinates; inverse_dynamics and mass_matrix_and_bias are recursions along them in
/// loops, and M has dot products.
Sample stepping();

/// `sample_loops`: 14 coordinates; mass_matrix and, cut into blocks, mass_matrix_and_bias have dot products
/// in loops, those of one symmetric.
Sample looping();

/// `sample_evil`: every_function with this text for the description and for names. It ends comments and
/// strings if let.
inline constexpr const char* kEvilText =
    "x*/\n#error \"\\ ?\?/\xE2\x80\xAE\\\n#error b // /* \r\n#error c \\";
Sample evil();

/// Operations at random on the inputs: all of them, or if `smooth` only + - * and cosine; values used often,
/// seldom or never.
alembert::Program random_program(std::string function, std::vector<alembert::InputSlot> inputs,
                                 std::vector<alembert::OutputArray> outputs, std::size_t operations,
                                 std::uint64_t seed, bool smooth = false);

/// A splitmix64 sequence: the same numbers with every compiler and library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next();
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(next() % n); }
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(next() >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

}  // namespace sample
