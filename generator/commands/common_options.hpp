// Options that the commands share, and what is made of them. Commands return the process's exit code; they
// throw InputError and InternalError, which main turns into diagnostics. Data goes to standard output, talk
// to standard error.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dynamics/choice/equations_of_motion.hpp"
#include "dynamics/equations.hpp"
#include "emit/emit.hpp"
#include "import/common/described.hpp"
#include "pipeline.hpp"

namespace alembert {

/// Options of the commands that read descriptions; `check` has file and passes only.
struct CommonOptions {
  std::string file;                               ///< description; `-` is standard input
  std::optional<Formulation> formulation;         ///< none: auto
  std::size_t loop_operations = kLoopOperations;  ///< --loop-operations
  std::size_t loop_results = kLoopResults;        ///< --loop-results
  Passes passes;                                  ///< all, without those named by --without
  bool verbose = false;
  bool strict = false;       ///< warnings are errors
  bool warned = false;       ///< warnings of this description have been told
  DescribeOptions describe;  ///< how a file of another format becomes a description
  std::string dump_stage;
  std::vector<std::string> inputs;  ///< --input: NAME=EXPRESSION
};

CompiledMechanism compile(const CommonOptions& common, std::vector<FunctionKind> functions,
                          Inapplicable inapplicable = Inapplicable::refuse);

/// The same for a text that has been read already.
/// \param axes  as in CompileOptions
CompiledMechanism compile(const CommonOptions& common, std::shared_ptr<const SourceText> source,
                          std::vector<FunctionKind> functions, Inapplicable inapplicable, bool axes = false);

/// Programs of the functions, as they are emitted.
std::vector<Program> programs_of(const CompiledMechanism& compiled);

/// What --batch and --loop-results ask for: functions over many states, where `default` stands for some.
void set_batch(EmitOptions& emit, const CommonOptions& common, const std::vector<std::string>& names);

/// Functions, and what becomes of those among them that the mechanism has none of.
struct FunctionChoice {
  std::vector<FunctionKind> kinds;
  Inapplicable inapplicable = Inapplicable::refuse;
};

/// The functions with these names, as `--functions` takes them; `all` stands for all that the mechanism has.
/// A name that is unknown or given twice is an InputError.
FunctionChoice function_choice(const std::vector<std::string>& names);

/// The table of functions, for `--functions help`.
std::string function_list();

}  // namespace alembert
