// A model of OpenSim in, its description out.
#pragma once

#include "import/common/described.hpp"

namespace alembert {

/// `warnings` gets what is doubtful as it is found. Throws InputError at what is no model, cannot be understood
/// or cannot be expressed.
DescribedRobot describe_osim(const std::shared_ptr<const SourceText>& source, const DescribeOptions& options,
                             Warnings& warnings);

}  // namespace alembert
