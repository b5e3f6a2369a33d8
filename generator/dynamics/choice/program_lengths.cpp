// Optimised programs of candidates, counted (see the header).
#include "dynamics/choice/program_lengths.hpp"

#include <array>

#include "dynamics/tree/symbols.hpp"
#include "program/count.hpp"
#include "program/rewrite/optimize.hpp"

namespace alembert {

ProgramLengths::ProgramLengths(const Mechanism& mechanism, ExprGraph& graph)
    : bindings_(symbol_bindings(mechanism, graph)) {}

Length ProgramLengths::of(std::span<const Expr> values) {
  std::vector<std::uint32_t> key;
  key.reserve(values.size());
  for (const Expr& value : values) key.push_back(value.ref().bits);
  const auto [entry, fresh] = known_.try_emplace(std::move(key));
  Measured& measured = entry->second;
  if (!fresh) return measured.length;
  const std::array<OutputExpressions, 1> output{
      {{"values", static_cast<std::uint32_t>(values.size()), 1, {values.begin(), values.end()}}}};
  measured.program = optimize(lower("candidate", output, bindings_));
  const OperationCount n = count(measured.program);
  return measured.length = {n.all(), n.total()};
}

Program ProgramLengths::optimized(Program lowered, std::span<const OutputExpressions> outputs) const {
  std::vector<std::uint32_t> key;
  for (const OutputExpressions& output : outputs)
    for (const Expr& value : output.values) key.push_back(value.ref().bits);
  const auto found = known_.find(key);
  if (found == known_.end()) return optimize(std::move(lowered));
  Program program = found->second.program;
  program.function = std::move(lowered.function);
  program.formulation = std::move(lowered.formulation);
  auto next = program.outputs.front().values.begin();
  for (OutputArray& output : lowered.outputs)
    for (std::uint32_t& value : output.values) value = *next++;
  program.outputs = std::move(lowered.outputs);
  return program;
}

}  // namespace alembert
