// Properties that are not known, told where they stand.
#pragma once

#include "import/opensim/osim_model.hpp"

namespace alembert {

/// Warns of properties of the model, its bodies, joints, coordinates and forces that are neither taken nor known to be
/// passed over. Throws InputError at what is nearly the name of one that the equations are made of.
void check_osim_spelling(const XmlText& xml, const OsimModel& model,
                         const std::vector<pugi::xml_node>& forces);

}  // namespace alembert
