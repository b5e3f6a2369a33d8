// Files that the program xacro expands to URDF.
#pragma once

#include <memory>
#include <string>

#include "support/error.hpp"

namespace alembert {

/// Reads a file. One that is called `.xacro`, or whose root declares the names of xacro and that uses them, goes through
/// the program `xacro`; the result is called after the file. Throws InputError as read_source does, where there is no such
/// program, and with what it says where it fails.
std::shared_ptr<const SourceText> read_expanded(const std::string& path);

}  // namespace alembert
