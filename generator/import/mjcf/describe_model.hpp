// A model in; its description in the language of mechanisms out, every value with its place in the file.
#pragma once

#include "import/common/described.hpp"
#include "import/mjcf/mjcf_model.hpp"

namespace alembert {

/// Bodies are bodies, sites frames. Coordinates follow the order of qpos: a hinge or slide has one, called as the
/// joint; a ball the quaternion of its name; a free joint NAME_x, NAME_y, NAME_z and NAME_rotation, called as the
/// body if it has no name. A joint that an equality ties to another is a definition. Throws InputError where
/// nothing moves, and at what changes the equations and cannot be expressed.
DescribedRobot describe_model(const MjcfModel& model, std::shared_ptr<const SourceText> source,
                              const DescribeOptions& options);

}  // namespace alembert
