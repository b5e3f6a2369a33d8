// States at which functions are timed. In: a mechanism. Out: entries of its arguments, reproducible.
#pragma once

#include <cstddef>
#include <vector>

#include "mechanism/model.hpp"

namespace alembert {

/// One array a kind of argument (bench_arguments), state after state. Coordinates are within their limits and not
/// further than 1 from their initial values, quaternions have norm 1; all else is between -1 and 1.
std::vector<std::vector<double>> bench_states(const Mechanism& mechanism, std::size_t states);

}  // namespace alembert
