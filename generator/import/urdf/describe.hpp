// A robot in; its description in the language of mechanisms out, every value with its place in the URDF.
#pragma once

#include "import/common/described.hpp"
#include "import/urdf/robot.hpp"

namespace alembert {

/// Links are bodies, joints factors of their transforms. A revolute, continuous or prismatic joint has one
/// coordinate, called as the joint; one that mimics is a definition. A planar joint has NAME_x, NAME_y and
/// NAME_angle: shifts along the two coordinate axes that follow its axis (for another axis: along x and y
/// turned by the shortest rotation from z to it), then a turn about it. A floating joint has NAME_x, NAME_y,
/// NAME_z and the quaternion NAME_rotation, a spherical one the quaternion NAME.
///
/// Coordinates stand in the order of the joints in the file, those of a floating root first. A link without
/// mass and shapes at the end of a fixed joint is a frame. A massless root called world is the world.
/// Throws InputError where nothing moves.
DescribedRobot describe_robot(const UrdfRobot& robot, std::shared_ptr<const SourceText> source,
                              const DescribeOptions& options);

}  // namespace alembert
