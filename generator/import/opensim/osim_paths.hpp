// Paths of OpenSim: their points as frames.
#pragma once

#include "import/opensim/osim_description.hpp"

namespace alembert {

/// Puts a `path` of frames, and of what it wraps over (osim_wraps.hpp), into a force, which is that of the element. Throws
/// InputError at points on unknown frames. False, with a warning, if there is no path of points.
bool add_osim_path(OsimDescription& out, YamlNode& force, pugi::xml_node element);

}  // namespace alembert
