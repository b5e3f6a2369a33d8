// Which elements and attributes SDF has.
#pragma once

#include "import/sdf/sdf_files.hpp"

namespace alembert {

/// Warns of what nobody knows in an element, and throws InputError at what is nearly a name that makes the equations.
/// Elements of kinds that make none are passed over.
void check_sdf_spelling(const SdfFiles& files, pugi::xml_node element);

}  // namespace alembert
