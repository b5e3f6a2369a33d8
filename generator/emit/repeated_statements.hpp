// A long program as blocks that are called many times with other places of their values: for functions whose
// straight-line code would be too large to be fast. In: a program. Out: text of blocks, tables and the
// function that calls them.
#pragma once

#include "emit/function_signature.hpp"
#include "emit/statements.hpp"
#include "program/program.hpp"

namespace alembert {

/// Text of a function whose blocks repeat. Every block is
///
///     const Index* block(S* v, const Index* at, const double* constants, results...)
///
/// and takes from the table at `at` the places in v, in `constants` and in the results that differ from call
/// to call; it gives the place in the table for the next call. v holds inputs, sines and cosines, and what
/// blocks hand to each other. Operations and their order on each value are those of the program.
FunctionBody repeated_body(const Program& program, const FunctionSignature& signature);

}  // namespace alembert
