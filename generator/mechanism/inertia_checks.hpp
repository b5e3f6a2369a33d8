// Checks of inertias.
#pragma once

#include "mechanism/loading.hpp"

namespace alembert {

/// Warns of inertias that no body can have (inertia_checks.cpp).
void check_inertias(Loading& loading);

}  // namespace alembert
