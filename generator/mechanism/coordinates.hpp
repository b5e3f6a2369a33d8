// Coordinates: their section in, names, symbols, initial values and limits out.
#pragma once

#include <span>
#include <string_view>

#include "mechanism/loading.hpp"

namespace alembert {

/// Makes the coordinates of a list known: names, types, indices, symbols (coordinates.cpp).
void declare_coordinates(Loading& loading, const YamlNode& list);
/// Reads their initial values and limits, once parameters have values. `start` replaces initial values, unless
/// empty.
void read_coordinate_values(Loading& loading, const YamlNode& list, std::span<const double> start);
/// Index of the coordinate that a scalar names; `type` is the type it must have.
int expect_coordinate(Loading& loading, const YamlNode& node, CoordinateType type, std::string_view what);

}  // namespace alembert
