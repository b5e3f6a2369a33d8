// Forces on a description that is written already.
#pragma once

#include <cstdint>
#include <string>

#include "oracles/random_quantities.hpp"

namespace alembert::oracles {

/// The description, in the layout of random_mechanism and nasty_mechanism, with inputs, states, parameters, frames that
/// may move, forces of every kind, contacts, forces of its coordinates and outputs. Points of paths may stand under conditions.
/// Expressions use everything that forces may use. The same seed gives the same text everywhere.
std::string with_random_forces(const std::string& yaml, std::uint64_t seed, const ForceUnits& units = {});

}  // namespace alembert::oracles
