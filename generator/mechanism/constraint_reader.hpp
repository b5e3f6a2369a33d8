// Constraints: their section in, typed ones out.
#pragma once

#include "mechanism/loading.hpp"

namespace alembert {

/// Reads constraints, once bodies and frames are known (constraints.cpp).
void read_constraints(Loading& loading, const YamlNode& list);

}  // namespace alembert
