// States from a seed (see the header).
#include "dynamics/tree/state_values.hpp"

#include <algorithm>
#include <cmath>

namespace alembert {

double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-52 - 1.0;
}

std::vector<double> state_values(const Mechanism& mechanism, ExprGraph& graph, unsigned seed) {
  std::mt19937_64 random(seed);
  const double spread = seed == 0 ? 0.0 : 1.0;
  std::vector<double> values(graph.symbol_count(), 0.0);
  for (double& value : values) value = spread * uniform(random);
  const auto set = [&](Expr symbol, double value) {
    values[graph.symbol_index(symbol.ref().node())] = value;
  };
  for (const Coordinate& coordinate : mechanism.coordinates) {
    double norm = 0;
    std::vector<double> q = coordinate.initial;
    for (double& x : q) {
      x += spread * uniform(random);
      if (coordinate.limits) x = std::clamp(x, coordinate.limits->first, coordinate.limits->second);
      norm += x * x;
    }
    for (std::size_t a = 0; a < q.size(); ++a) {
      set(coordinate.symbols[a],
          coordinate.type == CoordinateType::quaternion && norm > 0 ? q[a] / std::sqrt(norm) : q[a]);
    }
  }
  set(mechanism.time, 0.0);
  for (const Parameter& parameter : mechanism.parameters) {
    if (parameter.runtime) set(graph.symbol(parameter.name), parameter.value);
  }
  return values;
}

}  // namespace alembert
