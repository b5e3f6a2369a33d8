// Mechanisms that are hard on numbers: a seed in, the YAML of a description out, and where in its states what
// it does must be looked at.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "oracles/state.hpp"

namespace alembert::oracles {

/// A function of a coordinate (or of "t") that changes near `centre` and is constant to rounding elsewhere.
struct Event {
  std::string of;
  double centre = 0, width = 0;
};

struct NastyMechanism {
  std::string text;
  std::string kind;  ///< which of the difficulties below
  std::vector<Event> events;
  std::map<std::string, double> parameters;  ///< values of runtime parameters, far from their defaults
  std::map<std::string, double> lengths;     ///< unit of each coordinate that is a length
  double length = 1;                         ///< unit of the whole mechanism
  double gravity = 9.81;
};

/// Kinds, in turn by seed:
/// tilts      axes parallel or perpendicular to within 1e-3 to 1e-14 rad
/// offsets    axes at right angles that miss each other by 1e-3 to 1e-14 lengths
/// decimals   angles as exporters write them (1.5708), millimetres with six digits
/// axes       mirrored axes, axis vectors of length 1e12 and 1e-6, tilted ones
/// scales     masses from 1e-7 to 10 kg and lengths from 1e-6 to 1 m in one mechanism
/// units      the whole in micrometres and milligrams, or in kilometres and tonnes
/// late       functions that change far from 0: steps, bumps, detents, splines of coordinates, time and
///            parameters
/// curved     the same in curves, surfaces, mates, matrices and inverses
/// trees      branches, massless links, point masses, quaternions, free bodies
/// mixed      all of these at once
///
/// All have joints of every type, armatures, coordinates that several joints share, splines, motions of time
/// alone and, a quarter of them, runtime parameters in the place of numbers. Half of them have constraints:
/// loops, gears, couplings, and rolling in `curved`.
///
/// At nasty_states of the seed, M and P M^-1 P^T scaled to a unit diagonal have conditions below 1e9. The same
/// seed gives the same text everywhere.
inline constexpr int kNastyStates = 6;
NastyMechanism nasty_mechanism(std::uint64_t seed);

/// States over the ranges of the coordinates, the first at rest, some fast for the mechanism's size; every
/// other one is in the middle of an event, if there are events.
std::vector<State> nasty_states(const NastyMechanism& mechanism, const Description& description,
                                std::uint64_t seed, int count = kNastyStates);

}  // namespace alembert::oracles
