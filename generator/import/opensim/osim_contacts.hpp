// Contacts of OpenSim: spheres on half spaces and on spheres.
#pragma once

#include "import/opensim/osim_description.hpp"

namespace alembert {

/// HuntCrossleyForce: every sphere of its surfaces with every half space and sphere that other bodies carry. False if it
/// has no such pair.
bool add_hunt_crossley(OsimDescription& out, pugi::xml_node element);

/// SmoothSphereHalfSpaceForce.
bool add_smooth_contact(OsimDescription& out, pugi::xml_node element);

}  // namespace alembert
