// A description as a tree in, its YAML text out.
#pragma once

#include <string>

#include "mechanism/document.hpp"

namespace alembert {

/// Short lists and mappings of scalars stand on one line, all else line by line.
std::string yaml_text(const YamlNode& root);

}  // namespace alembert
