// Section `inputs`: what a controller or a player sets. A list of names or mappings in; runtime parameters
// behind all others out, on which only forces may depend.
#pragma once

#include <memory>
#include <string>

#include "mechanism/loading.hpp"

namespace alembert {

/// Makes the names of a list of inputs known.
void declare_inputs(Loading& loading, const YamlNode& list);
/// Reads their values, once the parameters have theirs.
void read_inputs(Loading& loading, const YamlNode& list);
/// Gives an input the expression of `NAME=EXPRESSION` (Parameter::law), once coordinates have values.
void replace_input(Loading& loading, const std::string& name, std::shared_ptr<const SourceText> source);

}  // namespace alembert
