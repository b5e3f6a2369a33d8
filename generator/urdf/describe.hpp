// A robot in; its description in the language of mechanisms out, every value with its place in the URDF.
#pragma once

#include "mechanism/document.hpp"
#include "urdf/massless.hpp"
#include "urdf/robot.hpp"

namespace alembert {

struct DescribeOptions {
  bool floating = false;       ///< the root moves freely, by a position and a quaternion
  double snap_angles = 1e-10;  ///< angles of origins so near to a multiple of pi/12 are that multiple, rad
  Massless massless = Massless::keep;  ///< what becomes of joints that move no mass
  double armature = 1e-4;              ///< kg m^2 or kg, of their coordinates, if they get one
};

struct DescribedRobot {
  Document document;
  Warnings warnings;  ///< what is doubtful or left out
};

/// Links are bodies, joints factors of their transforms. A revolute, continuous or prismatic joint has one
/// coordinate, called as the joint; one that mimics is a definition. A planar joint has NAME_x, NAME_y and
/// NAME_angle: shifts along the two coordinate axes that follow its axis (for another axis: along x and y
/// turned by the shortest rotation from z to it), then a turn about it. A floating joint has NAME_x, NAME_y,
/// NAME_z and the quaternion NAME_rotation.
///
/// Coordinates stand in the order of the joints in the file, those of a floating root first. A link without
/// mass and shapes at the end of a fixed joint is a frame. A massless root called world is the world.
/// Throws InputError where nothing moves.
DescribedRobot describe_robot(const UrdfRobot& robot, std::shared_ptr<const SourceText> source,
                              const DescribeOptions& options);

}  // namespace alembert
