// A file of SDF in; its description in the language of mechanisms out, every value with its place in the file.
#pragma once

#include <memory>

#include "import/common/described.hpp"

namespace alembert {

/// Links are bodies, joints factors of their transforms, each with coordinates of its name; a joint with two axes has
/// NAME_1 and NAME_2, a ball the quaternion NAME. A link that no joint holds is free: LINK_x, LINK_y, LINK_z and the
/// quaternion LINK_rotation, which come before those of joints. Joints that close chains are holonomic constraints.
/// Throws InputError.
DescribedRobot describe_sdf(const std::shared_ptr<const SourceText>& source, const DescribeOptions& options,
                            Warnings& warnings);

}  // namespace alembert
