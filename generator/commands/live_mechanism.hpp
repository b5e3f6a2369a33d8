// What a page needs to go on with a motion by itself. In: a compiled mechanism and the state it starts from. Out:
// JavaScript of its functions, and what the hand may change.
#pragma once

#include <memory>
#include <vector>

#include "pipeline.hpp"
#include "simulation/force_readings.hpp"
#include "viewer/scene.hpp"

namespace alembert {

/// Adds what the page calls and is not there yet.
void add_live_functions(const std::shared_ptr<const SourceText>& source,
                        std::vector<FunctionKind>& functions);

LiveMechanism live_mechanism(const CompiledMechanism& compiled, const EvaluationState& start,
                             const ForceReadings& readings);

}  // namespace alembert
