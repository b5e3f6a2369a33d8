// Paths of OpenSim over cylinders and spheres, by OpenSim's own rules of which way they go.
#pragma once

#include <vector>

#include "oracles/osim/skeleton.hpp"

namespace alembert::oracles {

/// A point of a path in the ground, and its number in the file.
struct PathStop {
  SimTK::Vec3 at;
  std::size_t number = 0;
  bool beside_conditional = false;  ///< it or the next one of the file has a condition
};

/// Length of a path through these points, around what its <PathWrapSet> names: cylinders, and spheres without a
/// quadrant, in their order, each once on a stretch. The path is straight past the rest, and past what is beside conditional
/// points.
double wrapped_length(const OsimSkeleton& skeleton, pugi::xml_node path, const std::vector<PathStop>& stops);

}  // namespace alembert::oracles
