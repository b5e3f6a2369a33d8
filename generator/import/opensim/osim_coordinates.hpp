// Coordinates of OpenSim to coordinates, and to parameters and definitions where they are locked, prescribed or
// follow others.
#pragma once

#include "import/opensim/osim_description.hpp"

namespace alembert {

/// Fills in the description's coordinates and their names. Throws InputError at couplers that go in a circle.
void add_osim_coordinates(OsimDescription& out);

/// Elements of the ConstraintSet, and of the model's components that are constraints.
std::vector<pugi::xml_node> osim_constraints(const OsimDescription& of);

/// Whether a constraint acts.
bool osim_is_enforced(const OsimXml& xml, pugi::xml_node constraint);

}  // namespace alembert
