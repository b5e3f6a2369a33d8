// Forces of OpenSim to inputs and forces of the description.
#pragma once

#include "import/opensim/osim_description.hpp"

namespace alembert {

/// All of the ForceSet, and what the model has besides: controllers and the like are told as left out. Throws InputError at what cannot be understood.
void add_osim_forces(OsimDescription& out);

/// Forces that act and are taken, by their type.
std::vector<pugi::xml_node> osim_known_forces(const OsimDescription& of);

/// The smallest and the largest control of an actuator; infinite if nothing is said.
std::array<double, 2> osim_control_limits(const OsimXml& xml, pugi::xml_node actuator);

/// The input that an actuator is controlled by: the name that it gets.
std::string osim_control(OsimDescription& out, pugi::xml_node actuator);

}  // namespace alembert
