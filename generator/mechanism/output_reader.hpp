// Section `outputs` (see the implementation).
#pragma once

#include <vector>

#include "mechanism/loading.hpp"

namespace alembert {

/// Reads the outputs of a list, once forces are known. \return them by name, for rates of states.
std::vector<ExpressionReader::LocalName> read_outputs(Loading& loading, const YamlNode& list);

}  // namespace alembert
