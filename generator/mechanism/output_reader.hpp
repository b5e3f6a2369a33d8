// Section `outputs` (see the implementation).
#pragma once

#include "mechanism/loading.hpp"

namespace alembert {

/// Reads the outputs of a list, once forces are known.
void read_outputs(Loading& loading, const YamlNode& list);

}  // namespace alembert
