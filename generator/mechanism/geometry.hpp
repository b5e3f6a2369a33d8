// Shapes of bodies.
#pragma once

#include <string>
#include <vector>

#include "mechanism/loading.hpp"

namespace alembert {

/// Reads the shapes of a body (geometry.cpp).
std::vector<Shape> read_geometry(Loading& loading, const YamlNode& list, const std::string& body);

}  // namespace alembert
