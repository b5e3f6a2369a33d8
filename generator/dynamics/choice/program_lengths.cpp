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
  if (!fresh) return entry->second;
  const std::array<OutputExpressions, 1> output{
      {{"values", static_cast<std::uint32_t>(values.size()), 1, {values.begin(), values.end()}}}};
  const OperationCount n = count(optimize(lower("candidate", output, bindings_)));
  const std::size_t others = n.mul + n.add + n.div + n.other;
  return entry->second = {others + n.trig, others};
}

}  // namespace alembert
