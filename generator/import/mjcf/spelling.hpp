// What attributes elements may have that default classes speak of.
#pragma once

#include <initializer_list>
#include <string_view>

#include "import/mjcf/text.hpp"

namespace alembert {

/// Of tendons between sites, and of their defaults.
extern const std::initializer_list<std::string_view> kTendonAttributes;

/// Warns of attributes that nobody knows, and throws at those that are nearly one that makes the equations. Elements of
/// other kinds are passed over.
void check_attributes(const MjcfText& text, pugi::xml_node element);

}  // namespace alembert
