// Finds equal results, see the header.
#include "emit/statements/distinct_results.hpp"

#include <map>
#include <utility>

namespace alembert {

DistinctResults distinct_results(Program program) {
  DistinctResults found{std::move(program), {}};
  found.rows.resize(found.program.outputs.size());
  if (!found.program.loops.empty() || !found.program.dot_products.empty()) return found;
  for (std::size_t k = 0; k < found.rows.size(); ++k) {
    OutputArray& output = found.program.outputs[k];
    std::map<std::uint32_t, std::uint32_t> places;
    std::vector<std::uint32_t> distinct, rows;
    for (const std::uint32_t v : output.values) {
      const auto [place, fresh] = places.try_emplace(v, static_cast<std::uint32_t>(distinct.size()));
      if (fresh) distinct.push_back(v);
      rows.push_back(place->second);
    }
    if (distinct.size() == rows.size()) continue;
    output.rows = static_cast<std::uint32_t>(distinct.size());
    output.columns = 1;
    output.values = std::move(distinct);
    found.rows[k] = std::move(rows);
  }
  return found;
}

}  // namespace alembert
