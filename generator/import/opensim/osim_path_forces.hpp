// Forces of OpenSim along paths, but for muscles. Each function is false if the path cannot be read.
#pragma once

#include "import/opensim/osim_description.hpp"

namespace alembert {

bool add_path_actuator(OsimDescription& out, pugi::xml_node element);
bool add_path_spring(OsimDescription& out, pugi::xml_node element);
bool add_ligament(OsimDescription& out, pugi::xml_node element);
bool add_blankevoort_ligament(OsimDescription& out, pugi::xml_node element);

}  // namespace alembert
