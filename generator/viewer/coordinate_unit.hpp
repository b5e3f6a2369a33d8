// Units of coordinates, for plots. Descriptions do not name them: they are read off the transforms. In: a mechanism
// and one of its coordinates. Out: a unit, if it is plain.
#pragma once

#include <string>

#include "viewer/shapes.hpp"

namespace alembert {

/// `rad` for a coordinate that stands in the angle of a rotation or below a sine, cosine or tangent; `m` for one that
/// only shifts, a metre a unit; otherwise, and for quaternions, nothing.
std::string coordinate_unit(const InitialValues& values, const Coordinate& coordinate);

}  // namespace alembert
