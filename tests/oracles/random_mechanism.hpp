// Random mechanisms: a seed in, the YAML of a description out that uses all of the language's factors and
// joints.
#pragma once

#include <cstdint>
#include <string>

namespace alembert::oracles {

/// A tree of one to five bodies with full mass properties, at most eleven speeds in all. M is well
/// conditioned at random states, with runtime parameters at their defaults and at random_parameters of the
/// seed (the numeric Lagrangian is asked). The same seed gives the same text everywhere.
std::string random_mechanism(std::uint64_t seed);

}  // namespace alembert::oracles
