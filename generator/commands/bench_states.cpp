// Random states (see the header).
#include "commands/bench_states.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/tree/state_values.hpp"
#include "emit/bench_program.hpp"
#include "functions/array_shape.hpp"

namespace alembert {
namespace {

/// Entries of one coordinate.
void add_coordinate(const Coordinate& coordinate, std::mt19937_64& random, std::vector<double>& out) {
  const std::size_t first = out.size();
  double squares = 0;
  for (const double initial : coordinate.initial) {
    double lower = initial - 1, upper = initial + 1;
    if (coordinate.limits) {
      lower = std::clamp(lower, coordinate.limits->first, coordinate.limits->second);
      upper = std::clamp(upper, coordinate.limits->first, coordinate.limits->second);
    }
    const double place = 0.5 * (1 + uniform(random));
    out.push_back(std::clamp(lower + (upper - lower) * place, lower, upper));
    squares += out.back() * out.back();
  }
  if (coordinate.type != CoordinateType::quaternion) return;
  for (std::size_t i = first; i < out.size(); ++i) out[i] /= std::sqrt(squares);
}

}  // namespace

std::vector<std::vector<double>> bench_states(const Mechanism& mechanism, std::size_t states) {
  std::mt19937_64 random(1);
  std::vector<std::vector<double>> arrays;
  for (const ArgumentKind kind : bench_arguments()) {
    std::vector<double>& array = arrays.emplace_back();
    for (std::size_t s = 0; s < states; ++s) {
      if (kind == ArgumentKind::q) {
        for (const Coordinate& coordinate : mechanism.coordinates) add_coordinate(coordinate, random, array);
      } else {
        for (std::size_t i = 0; i < argument_size(kind, mechanism); ++i) array.push_back(uniform(random));
      }
    }
  }
  return arrays;
}

}  // namespace alembert
