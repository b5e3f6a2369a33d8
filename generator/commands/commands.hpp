// The sub-commands: each takes its options and returns the process's exit code. They throw InputError and
// InternalError, which main turns into diagnostics. Data goes to standard output, talk to standard error.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dynamics/equations.hpp"
#include "import/common/described.hpp"
#include "pipeline.hpp"
#include "simulation/start_state.hpp"

namespace alembert {

/// Options of the commands that read descriptions; `check` has file and passes only.
struct CommonOptions {
  std::string file;                               ///< description; `-` is standard input
  std::optional<Formulation> formulation;         ///< none: auto
  std::size_t loop_operations = kLoopOperations;  ///< --loop-operations
  std::size_t loop_results = kLoopResults;        ///< --loop-results
  Passes passes;                                  ///< all, without those named by --without
  bool verbose = false;
  bool strict = false;  ///< warnings are errors
  std::string dump_stage;
};

/// Shows warnings on standard error. If `strict`, they are errors: the last one is thrown.
void report_warnings(const Warnings& warnings, bool strict);

CompiledMechanism compile(const CommonOptions& common, std::vector<FunctionKind> functions,
                          Inapplicable inapplicable = Inapplicable::refuse);

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

struct GenerateOptions {
  std::string out_dir;
  std::string language = "c++";  ///< or c
  std::string depfile, stamp;
  std::string name_space;
  std::vector<std::string> functions;
  std::vector<std::string> scalars;
  std::vector<std::string> batch;               ///< functions over many states; `default`: the usual ones
  std::vector<std::string> batch_instructions;  ///< empty: the usual ones
  std::string expected_name;                    ///< the mechanism must have this name
  int parts = 0;                                ///< files over which definitions are spread; 0: by size
  bool print_outputs = false, dry_run = false, check = false;
};
int run_generate(const CommonOptions& common, const GenerateOptions& options);

struct ReportOptions {
  std::vector<std::string> functions;  ///< none: all whose operations are worth counting
  bool json = false;
  std::string memory;               ///< double or float: also what C99 takes on a machine; empty: not
  std::string compiler = "cc -O2";  ///< for that
};
int run_report(const CommonOptions& common, const ReportOptions& options);

struct EvaluateOptions {
  std::vector<std::string> functions;  ///< none: tau, M, c, qdd and what else a state gives
  bool json = false;
};
int run_evaluate(const CommonOptions& common, const EvaluateOptions& options);

struct CheckOptions {
  int states = 0;  ///< at which every function is measured against the plain equations; 0: not at all
};
int run_check(const CommonOptions& common, const CheckOptions& options);

struct ImportOptions {
  std::string out = "-";  ///< file to be written; `-` is standard output
  DescribeOptions describe;
};
int run_import(const CommonOptions& common, const ImportOptions& options);

struct SimulateOptions {
  double duration = 10, step = 1e-3;
  int every = 10;  ///< one row of output each so many steps
  std::string integrator = "rk4";
  std::string csv;   ///< `-` is standard output, which is the default if nothing else is asked for
  std::string html;  ///< page to be written, if any
  std::string glb;   ///< glTF scene to be written, if any
  double fps = 60;   ///< frames a second of page and scene
  std::vector<std::string> scene;  ///< further descriptions, to be seen beside the first
  StartOptions start;              ///< of the first
};
int run_simulate(const CommonOptions& common, const SimulateOptions& options);

}  // namespace alembert
