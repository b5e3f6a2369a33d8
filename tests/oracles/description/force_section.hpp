// The sections `inputs`, `states`, `forces` and `outputs`, and the forces of coordinates: YAML in, their part of a Description out.
#pragma once

#include <yaml-cpp/yaml.h>

#include <map>
#include <string>

#include "oracles/description/description.hpp"

namespace alembert::oracles {

using Names = std::map<std::string, Expression>;

Expression variable(int index);
Expression expression_of(const YAML::Node& node, const Names& names);

/// Gives speeds, inputs, states, and what is known of frames and paths their names. The coordinates are read before, nothing
/// else needs to be.
void declare_quantities(const YAML::Node& root, Names& names, Description& result);

/// Damping, friction and stiffness of a coordinate, which is a map.
void read_coordinate_forces(const YAML::Node& node, const Names& names, Coordinate& coordinate);

/// After the frames. Gives tensions their names, for what follows.
void read_forces(const YAML::Node& root, Names& names, Description& result);
/// Each may use those before it.
void read_outputs(const YAML::Node& root, Names& names, Description& result);
/// After the outputs, which they may use.
void read_state_rates(const YAML::Node& root, const Names& names, Description& result);

}  // namespace alembert::oracles
