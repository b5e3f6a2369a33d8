// Coordinates: their section in, names, symbols, initial values and limits out.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "mechanism/loading.hpp"
#include "mechanism/section.hpp"

namespace alembert {

/// A coordinate that is a mapping.
Section coordinate_section(const Document& document, const YamlNode& item);
/// A lower and a larger upper limit of something that starts at `start` (given at `initial`, unless null), if that is known.
std::pair<double, double> read_limits(Loading& loading, const YamlNode& node, const std::string& of,
                                      double start = std::numeric_limits<double>::quiet_NaN(),
                                      const YamlNode* initial = nullptr);
/// Makes the coordinates of a list known: names, types, indices, symbols (coordinates.cpp).
void declare_coordinates(Loading& loading, const YamlNode& list);
/// Reads their initial values and limits, once parameters have values. `start` replaces initial values, unless
/// empty.
void read_coordinate_values(Loading& loading, const YamlNode& list, std::span<const double> start);
/// Index of the coordinate that a scalar names; `type` is the type it must have.
int expect_coordinate(Loading& loading, const YamlNode& node, CoordinateType type, std::string_view what);

}  // namespace alembert
