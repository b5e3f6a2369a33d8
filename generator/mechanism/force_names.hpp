// Names of forces: a mechanism in, each name once, in the order of the forces, out.
#pragma once

#include <string>
#include <vector>

#include "mechanism/model.hpp"

namespace alembert {

/// Several forces may share a name: those of a contact, or the damping of a quaternion's three speeds.
std::vector<std::string> force_names(const Mechanism& mechanism);

}  // namespace alembert
