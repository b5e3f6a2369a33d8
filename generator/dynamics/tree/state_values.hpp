// Reproducible states of a mechanism.
#pragma once

#include <random>
#include <vector>

#include "mechanism/model.hpp"

namespace alembert {

/// Uniform in [-1, 1), the same on every platform (std::uniform_real_distribution is not).
double uniform(std::mt19937_64& random);

/// Values of all symbols of the graph at a state: the initial one for `seed` 0, else a reproducible random
/// one around it. Speeds, rates and wrenches are zero at the initial state and random elsewhere; runtime
/// parameters have their defaults.
std::vector<double> state_values(const Mechanism& mechanism, ExprGraph& graph, unsigned seed);

}  // namespace alembert
