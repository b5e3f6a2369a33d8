// Section `forces` (see the implementation).
#pragma once

#include "mechanism/loading.hpp"

namespace alembert {

/// Reads the forces of a list, once coordinates, definitions and frames are known.
void read_forces(Loading& loading, const YamlNode& list);

}  // namespace alembert
