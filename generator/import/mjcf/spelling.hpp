// What attributes elements may have that default classes speak of.
#pragma once

#include "import/mjcf/text.hpp"

namespace alembert {

/// Warns of attributes that nobody knows, and throws at those that are nearly one that makes the equations. Elements of
/// other kinds are passed over.
void check_attributes(const MjcfText& text, pugi::xml_node element);

}  // namespace alembert
