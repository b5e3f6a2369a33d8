// A <link> in; its mass and what is drawn of it out.
#pragma once

#include "import/sdf/sdf_model.hpp"
#include "import/sdf/sdf_scopes.hpp"

namespace alembert {

/// Throws InputError at what cannot be understood or expressed. `left_out` counts what has no place in a description.
SdfLink read_sdf_link(const SdfFiles& files, SdfScopes& scopes, std::size_t scope, std::size_t named,
                      Counts& left_out);

}  // namespace alembert
