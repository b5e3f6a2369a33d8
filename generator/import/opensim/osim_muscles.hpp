// Muscles of OpenSim: their paths, excitations, activations and tensions.
#pragma once

#include "import/opensim/osim_description.hpp"

namespace alembert {

/// Thelen's, with an elastic tendon unless the file says otherwise. False if it has no path of points.
bool add_thelen_muscle(OsimDescription& out, pugi::xml_node element);

/// Millard's, likewise.
bool add_millard_muscle(OsimDescription& out, pugi::xml_node element);

/// That of De Groote and others, likewise.
bool add_degroote_muscle(OsimDescription& out, pugi::xml_node element);

/// That of Schutte and others, likewise.
bool add_schutte_muscle(OsimDescription& out, pugi::xml_node element);

}  // namespace alembert
