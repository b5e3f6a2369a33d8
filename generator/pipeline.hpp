// The stages, in order: load, kinematics, equations, optimise, lower, schedule, verify. In: the text of a
// description. Out: the checked mechanism and one straight-line program for each function asked for.
#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "dynamics/checks/axis_check.hpp"
#include "dynamics/checks/measured_error.hpp"
#include "dynamics/choice/equations_of_motion.hpp"
#include "dynamics/equations.hpp"
#include "functions/function_table.hpp"
#include "mechanism/load.hpp"
#include "mechanism/model.hpp"
#include "program/count.hpp"
#include "program/program.hpp"
#include "support/error.hpp"

namespace alembert {

/// Operations, dot products apart, from which repeated steps are written as loops: longer straight code
/// outgrows the instruction cache and is limited by instruction fetch.
inline constexpr std::size_t kLoopOperations = 2500;

/// Results from which dot products of the same rows are written as loops. At about this number, that of a
/// chain of 12 joints, loops are shorter than straight code and as fast.
inline constexpr std::size_t kLoopResults = 30;

/// What becomes of functions that a mechanism has no values for: of forward dynamics where the mass matrix is
/// singular at all states, as where a joint moves no mass (inverse dynamics has values all the same), and of
/// those without results, as poses of frames where there are none.
enum class Inapplicable {
  refuse,           ///< forward_dynamics is an error if it is asked for; what has no results is empty
  refuse_singular,  ///< a singular mass matrix is an error in any case: the caller solves with it
  leave_out         ///< they are left out, forward_dynamics with a warning
};

struct CompileOptions {
  std::optional<Formulation> formulation;  ///< none: the one with fewer operations, function by function
  Passes passes;                           ///< --without
  std::vector<FunctionKind> functions;     ///< in the order wanted
  std::vector<InputExpression> inputs;     ///< what stands in the place of inputs
  std::size_t loop_operations = kLoopOperations;  ///< functions of more have loops over steps
  std::size_t loop_results = kLoopResults;        ///< so many dot products are written as loops; 0: none
  Inapplicable inapplicable = Inapplicable::refuse;
  std::function<void(const Warnings&)> warn;  ///< is told what is doubtful
  bool axes = false;             ///< programs for linearize of the runtime too, where M and c are written
  std::optional<int> states;     ///< at which functions are measured (certificate.hpp); nothing: a few
  std::ostream* talk = nullptr;  ///< time, nodes and operations of each stage (--verbose)
  std::ostream* dump = nullptr;  ///< what a stage made (--dump)
  std::string dump_stage;        ///< load, kinematics, equations, lower, optimise or schedule
};

struct CompiledFunction {
  FunctionKind kind;
  Formulation formulation;
  Program program;
  OperationCount count;
  MeasuredError error;  ///< against the plain equations in 50 digits
};

struct CompiledMechanism {
  std::unique_ptr<ExprGraph> graph;
  std::unique_ptr<const Mechanism> mechanism;
  std::vector<CompiledFunction> functions;
  std::optional<AxisPrograms> axes;  ///< where they were asked for and the mechanism is a tree of axes

  const CompiledFunction& function(
      FunctionKind kind) const;  ///< throws InternalError if it was not asked for
};

/// Throws InputError where the description is at fault, InternalError where verification fails: a program is
/// not equal to the expressions it came from, or no program of a function is near enough to the plain
/// equations (certificate.hpp).
CompiledMechanism compile_mechanism(std::shared_ptr<const SourceText> source, const CompileOptions& options);

/// What a domain_error means that is thrown when equations are derived: a divisor is zero for all values of
/// the coordinates, or a constant is too large, found only once they are simplified. Throws the InputError.
[[noreturn]] void fail_without_value(std::shared_ptr<const SourceText> source,
                                     const std::domain_error& error);

/// Names of the stages that can be dumped.
std::vector<std::string> dump_stages();

/// Functions that `generate` writes unless told otherwise: those of the table that are marked so and have
/// results for this mechanism.
std::vector<FunctionKind> default_functions(const Mechanism& mechanism);

}  // namespace alembert
