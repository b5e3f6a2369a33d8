#include "simulation/state_program.hpp"

#include "dynamics/tree/symbols.hpp"
#include "program/interpret.hpp"
#include "program/lower.hpp"
#include "symbolic/rewrite/optimize.hpp"

namespace alembert {

StateProgram::StateProgram(std::vector<Expr> values, const CompiledMechanism& compiled)
    : values_(values.size()) {
  if (values.empty()) return;
  const std::vector<OutputExpressions> outputs{
      {"values", static_cast<std::uint32_t>(values.size()), 1, optimize(values)}};
  program_ =
      without_unused_inputs(lower("values", outputs, symbol_bindings(*compiled.mechanism, *compiled.graph)));
}

std::span<const double> StateProgram::operator()(const EvaluationState& state) {
  if (empty()) return {};
  program_inputs(program_, state, inputs_);
  interpret(program_, inputs_, values_, scratch_);
  return values_;
}

}  // namespace alembert
