// A <joint> in; its frames, axes and what acts along them out.
#pragma once

#include "import/sdf/sdf_model.hpp"
#include "import/sdf/sdf_scopes.hpp"

namespace alembert {

/// All joints of all scopes, in their order, of which named things have the index already. Gearboxes become mimics.
/// Throws InputError at what cannot be understood or expressed.
void read_sdf_joints(const SdfFiles& files, SdfScopes& scopes, SdfModel& model);

}  // namespace alembert
