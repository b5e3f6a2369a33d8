// Files in, their text out.
#pragma once

#include <memory>
#include <string>

#include "support/error.hpp"

namespace alembert {

/// Reads a whole file (`-`: standard input). Throws InputError at 1:1 if it cannot be read, is a directory,
/// is empty or is over 16 MiB.
std::shared_ptr<const SourceText> read_source(const std::string& path);

}  // namespace alembert
