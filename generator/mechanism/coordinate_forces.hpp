// Forces that coordinates have by their own keys (see the implementation).
#pragma once

#include "mechanism/loading.hpp"

namespace alembert {

/// Appends them to the mechanism's forces. `list` is the section `coordinates`, which has been read.
void read_coordinate_forces(Loading& loading, const YamlNode& list);

}  // namespace alembert
