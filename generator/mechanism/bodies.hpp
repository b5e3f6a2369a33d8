// Bodies and frames: their sections in, typed ones out.
#pragma once

#include <string>

#include "mechanism/loading.hpp"

namespace alembert {

/// Reads bodies and frames into the mechanism, parents first (bodies.cpp).
void read_bodies(Loading& loading, const YamlNode& list);
void read_frames(Loading& loading, const YamlNode& list);
/// Index of the body that a scalar names, -1 for the world.
int expect_body(const Loading& loading, const YamlNode& node, const std::string& what);

}  // namespace alembert
