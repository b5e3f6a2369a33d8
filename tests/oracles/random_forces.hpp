// Forces on a description that is written already.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace alembert::oracles {

/// What a mechanism's forces are drawn in.
struct ForceUnits {
  double length = 1, force = 1;
  std::map<std::string, double> lengths = {};  ///< of coordinates that are lengths
};

/// The description, in the layout of random_mechanism and nasty_mechanism, with inputs, parameters, frames that may
/// move, forces of every kind, forces of its coordinates, contacts and outputs. Their expressions use everything that
/// forces may use. The same seed gives the same text everywhere.
std::string with_random_forces(const std::string& yaml, std::uint64_t seed, const ForceUnits& units = {});

}  // namespace alembert::oracles
