// Key `contact` of a force (see the implementation).
#pragma once

#include <string>
#include <vector>

#include "mechanism/loading.hpp"

namespace alembert {

/// The wrenches of the contact that a mapping describes: on the sphere's frame, and on that which it touches unless
/// that is the world.
std::vector<Force> read_contact(Loading& loading, const YamlNode& node, const std::string& name,
                                const SourceLocation& where);

}  // namespace alembert
