// A program as statements: which values get a name, which are written into the expression that uses them, and
// how a long function is cut into blocks. In: Program. Out: lines of C++ over a scalar type S,
// or of another language (syntax.hpp).
//
// A value is written into its user if it has one use only and the expression stays small; the operations and
// their association stay those of the program, so that compiled code gives the interpreter's results bit for
// bit. Results of function calls always get a name. Sines and cosines of two or more angles known at the
// start come from one call, which a library can vectorise.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "emit/argument_lists.hpp"
#include "emit/statements/syntax.hpp"
#include "program/program.hpp"
#include "registers/statement_layout.hpp"

namespace alembert {

/// Body of a function or of a block: using-declarations for the functions it calls, then statements, a line
/// each.
struct CodeBlock {
  std::string using_lines;
  std::string statement_lines;
  std::size_t statements = 0;
  std::set<std::string> helpers;  ///< of kHelpers, those that it calls
};

/// One block: a plain function. More: blocks to be called in order, with `crossing` values handed over in an
/// array w.
struct FunctionBody {
  std::vector<CodeBlock> blocks;
  std::size_t crossing = 0;
};

/// Who decides what registers hold: the compiler, or a plan (register_plan.hpp), where the program has no
/// loops. With a plan w is a parameter, and what is read from memory again stands behind
/// ALEMBERT_FROM_MEMORY.
enum class Registers { compiled, planned };

FunctionBody function_body(const Program& program, const OutputFunction& signature,
                           const BlockSizes& sizes = {}, Registers registers = Registers::compiled,
                           const Syntax& syntax = cpp_syntax());

}  // namespace alembert
