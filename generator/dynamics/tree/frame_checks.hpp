// Frames that exist at the initial state.
#pragma once

#include "mechanism/model.hpp"

namespace alembert {

/// Throws InputError at the first transform factor that has no value at the initial state (a curve or surface
/// frame that is singular there).
void check_transforms(const Mechanism& mechanism, ExprGraph& graph);

}  // namespace alembert
