// Forces of OpenSim that push a point or turn a body.
#pragma once

#include "import/opensim/osim_description.hpp"

namespace alembert {

/// A torque on one body and its opposite on another. False if nothing can be made of it.
bool add_torque_actuator(OsimDescription& out, pugi::xml_node element);

/// A force at a point of a body. False if the point is not the body's.
bool add_point_actuator(OsimDescription& out, pugi::xml_node element);

/// A force and a torque that time prescribes, the force at a point that time moves.
bool add_prescribed_force(OsimDescription& out, pugi::xml_node element);

}  // namespace alembert
