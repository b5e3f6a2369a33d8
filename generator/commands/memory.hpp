// Code and stack of functions on a machine: C99 is compiled, by any compiler at hand, and nothing is run. In:
// a compiled mechanism. Out: bytes.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline.hpp"

namespace alembert {

struct FunctionMemory {
  std::size_t code = 0;   ///< bytes of instructions, blocks of long functions included
  std::size_t stack = 0;  ///< bytes, blocks and helpers included, what the C library takes apart
};

struct MechanismMemory {
  std::vector<FunctionMemory> functions;  ///< in the order of the mechanism's
  std::size_t shared_code = 0;            ///< helpers that several functions call
  std::size_t constants = 0;              ///< read-only data of the whole file: numbers, names
};

/// \param scalar    double or float
/// \param compiler  a command like gcc's, with its flags: words with blanks between them
/// InputError if the compiler fails or does not say what functions take.
MechanismMemory measured_memory(const CompiledMechanism& compiled, const std::string& scalar,
                                const std::string& compiler);

}  // namespace alembert
