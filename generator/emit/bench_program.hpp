// A program that times the functions of a mechanism, beside the files of C++ that emit_mechanism writes. In: which
// functions. Out: its text, and the headers of the runtime that it needs: no other files of alembert's.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "emit/emit.hpp"
#include "functions/function_table.hpp"

namespace alembert {

/// Behind the names of functions: over many states in one call, and one by one with the results of all states kept.
inline constexpr std::string_view kBatchEnding = "_batch", kKeptEnding = "_kept";

/// Arguments that are read for each state, in the order of the program's file of doubles.
std::vector<ArgumentKind> bench_arguments();

/// src/bench.cpp and include/alembert/*.hpp. The program takes the number of states and the file of their arguments. It
/// prints a line `NAME ns` for each of `programs`; for each of options.batch `NAME_batch ns` and `NAME_kept ns`; then, if
/// there are any, `instructions SET`: which the batches are of.
std::vector<EmittedFile> bench_files(const Mechanism& mechanism, std::span<const Program> programs,
                                     const EmitOptions& options);

}  // namespace alembert
