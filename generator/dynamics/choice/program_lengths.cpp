// Optimised candidates, counted (see the header).
#include "dynamics/choice/program_lengths.hpp"

#include "symbolic/count_operations.hpp"
#include "symbolic/rewrite/optimize.hpp"

namespace alembert {

const ProgramLengths::Measured& ProgramLengths::measured(std::span<const Expr> values) {
  std::vector<std::uint32_t> key;
  key.reserve(values.size());
  for (const Expr& value : values) key.push_back(value.ref().bits);
  const auto [entry, fresh] = known_.try_emplace(std::move(key));
  Measured& found = entry->second;
  if (fresh) {
    found.values = optimize(values);
    const OperationCount n = count_operations(found.values);
    found.length = {n.all(), n.total()};
  }
  return found;
}

}  // namespace alembert
