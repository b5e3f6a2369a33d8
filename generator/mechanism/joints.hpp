// Joints: a `joint` of a transform in, the factors it stands for out.
#pragma once

#include <string>

#include "mechanism/loading.hpp"

namespace alembert {

/// Appends the factors that a joint stands for (joints.cpp).
void append_joint(Loading& loading, const YamlNode& node, const std::string& what, Transform& transform);

}  // namespace alembert
