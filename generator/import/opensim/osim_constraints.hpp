// Constraints of OpenSim between points and frames to holonomic constraints.
#pragma once

#include "import/opensim/osim_description.hpp"

namespace alembert {

/// All that act, but couplers of coordinates; what the language has no words for is left out, with a warning. Throws
/// InputError at what cannot be understood.
void add_osim_constraints(OsimDescription& out);

}  // namespace alembert
