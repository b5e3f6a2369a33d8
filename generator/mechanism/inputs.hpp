// Sections `inputs`, what a controller or a player sets, and `states`, what is integrated beside coordinates and
// speeds. Lists of names or mappings in; runtime parameters behind all others out, on which only forces, outputs
// and rates of states may depend.
#pragma once

#include <vector>

#include "mechanism/load.hpp"
#include "mechanism/loading.hpp"

namespace alembert {

/// Makes the names of a list known.
void declare_inputs(Loading& loading, const YamlNode& list);
void declare_states(Loading& loading, const YamlNode& list);
/// Reads their values, once the parameters have theirs: inputs first.
void read_inputs(Loading& loading, const YamlNode& list);
void read_states(Loading& loading, const YamlNode& list);
/// The rest of the states, once forces and outputs are known: rates may use the lengths of paths, and outputs.
void read_state_rates(Loading& loading, const YamlNode& list,
                      const std::vector<ExpressionReader::LocalName>& outputs);
/// Gives inputs the expressions of `NAME=EXPRESSION` (Parameter::law), once everything else is read: they are of what
/// rates of states are of, and of each other.
void read_input_laws(Loading& loading, const std::vector<InputExpression>& given,
                     const std::vector<ExpressionReader::LocalName>& outputs);

}  // namespace alembert
