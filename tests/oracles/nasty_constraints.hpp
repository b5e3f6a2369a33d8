// Constraints that are hard on numbers: loops that nearly close, gears with tiny and late ratios, rolling.
#pragma once

#include <string>
#include <vector>

#include "oracles/late_functions.hpp"
#include "oracles/nasty_numbers.hpp"
#include "oracles/random_constraints.hpp"

namespace alembert::oracles {

/// What constraints can be about.
struct Constrainable {
  std::vector<std::string> coordinates;  ///< real ones
  std::vector<std::string> angles;       ///< those of them that are angles
  std::vector<std::string> speeds;       ///< of all coordinates: d(q0), d(r0).x
  std::vector<RollingBody> rolling;
  int bodies = 0;     ///< body0, body1, ...
  double length = 1;  ///< unit
};

/// Entries of the section `frames` and the section `constraints`.
struct ConstraintSections {
  std::string frames, constraints;
};
/// Fewer rows than speeds, of all three types. Late functions if `is_late`.
ConstraintSections nasty_constraints(RandomExpressions& draw, NastyNumbers& numbers, LateFunctions& late,
                                     bool is_late, const Constrainable& of);

}  // namespace alembert::oracles
