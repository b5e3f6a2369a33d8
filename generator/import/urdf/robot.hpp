// What a URDF file says of a robot, as it says it: links, joints between them, names and numbers with their
// places. SI units; angles in radians.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "import/common/counts.hpp"
#include "import/common/solid_shape.hpp"
#include "support/error.hpp"

namespace alembert {

/// Shift by xyz, then rotation Rz(yaw) Ry(pitch) Rx(roll), rpy = roll pitch yaw.
struct UrdfPose {
  std::array<double, 3> xyz{}, rpy{};
  SourceLocation where;
};

struct UrdfInertial {
  UrdfPose origin;  ///< of the centre of mass and the axes of the inertia, in the link's frame
  double mass = 0;  ///< kg
  std::array<double, 6> inertia{};  ///< xx yy zz xy xz yz about the centre of mass
  SourceLocation mass_where, inertia_where;
};

/// A shape of <visual>. A mesh's file is as the URDF calls it.
struct UrdfShape : SolidShape {
  UrdfPose origin;
};

struct UrdfLink {
  std::string name;
  std::optional<UrdfInertial> inertial;
  std::vector<UrdfShape> shapes;
  SourceLocation where;
};

/// The joint's position is multiplier times that of another, plus offset.
struct UrdfMimic {
  std::string joint;              ///< its name
  std::optional<std::size_t> of;  ///< its index; none if it is fixed, its position 0
  double multiplier = 1, offset = 0;
  SourceLocation where;
};

/// `spherical` is of PyBullet, not of the format.
enum class UrdfJointType { revolute, continuous, prismatic, fixed, floating, planar, spherical };

struct UrdfJoint {
  std::string name;
  UrdfJointType type = UrdfJointType::fixed;
  std::size_t parent = 0, child = 0;  ///< indices of links
  UrdfPose origin;  ///< of the joint, and of the child where it has not moved, in the parent
  std::array<double, 3> axis{1, 0, 0};
  std::optional<std::array<double, 2>> limits;
  std::optional<UrdfMimic> mimic;
  double damping = 0, friction = 0;         ///< N m s or N s/m, N m or N
  std::optional<double> effort, velocity;   ///< of its drive
  double rotor_inertia = 0, reduction = 1;  ///< of its transmission: the rotor's, kg m^2, and turns to one
  SourceLocation where, type_where;
};

/// Revolute, continuous and prismatic joints: they mimic and are mimicked.
bool has_position(const UrdfJoint& joint);

/// Links make a tree: every one but the root is the child of one joint.
struct UrdfRobot {
  std::string name;
  std::vector<UrdfLink> links;
  std::vector<UrdfJoint> joints;
  std::size_t root = 0;               ///< index of the link that no joint moves
  std::vector<std::size_t> joint_of;  ///< by link: the joint that it is the child of; of the root: none
  std::vector<std::vector<std::size_t>> children;  ///< by link: the joints that it is the parent of
  Counts left_out;                                 ///< elements that have no place in a description
  SourceLocation where;
};

/// Fills in `joint_of` and `children`.
void connect(UrdfRobot& robot);

/// Reads a robot. `warnings` gets what is doubtful, left out or guessed, and does not change the equations.
/// Throws InputError at what is not URDF, cannot be understood or is no tree.
UrdfRobot read_urdf(std::shared_ptr<const SourceText> source, Warnings& warnings);

}  // namespace alembert
