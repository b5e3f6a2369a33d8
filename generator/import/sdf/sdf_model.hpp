// What a file of SDF says: links where they stand at the beginning, joints between them, gravity. SI units, radians.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "import/common/counts.hpp"
#include "import/common/solid_shape.hpp"

namespace alembert {

inline constexpr std::size_t kSdfWorld = static_cast<std::size_t>(-1);  ///< as the index of a link

struct SdfLink {
  std::string name;  ///< `model::link`
  BodyMass mass;     ///< in its own frame
  RigidPose pose;    ///< in the world
  bool fixed = false, weightless = false;
  std::vector<PlacedShape> shapes;
  SourceLocation where;
};

/// The position is multiplier*(that of another - reference) + offset.
struct SdfMimic {
  std::size_t joint = 0, axis = 0;
  double multiplier = 1, offset = 0, reference = 0;
  SourceLocation where;
};

struct SdfAxis {
  Eigen::Vector3d xyz = Eigen::Vector3d::UnitZ();  ///< of length 1, in the joint's frame
  double damping = 0, friction = 0, stiffness = 0, rest = 0, initial = 0;
  std::optional<std::array<double, 2>> limits;
  std::optional<double> effort, speed;
  std::optional<SdfMimic> mimic;
  SourceLocation where;
};

enum class SdfJointType { fixed, revolute, prismatic, screw, universal, ball };

struct SdfJoint {
  std::string name;
  SdfJointType type = SdfJointType::fixed;
  std::size_t parent = kSdfWorld, child = kSdfWorld;  ///< links
  RigidPose in_parent, in_child;                      ///< its frame in the two links
  std::vector<SdfAxis> axes;                          ///< none, one or two
  double pitch = 0;                                   ///< of a screw, metres per radian
  bool cut_first = false;                             ///< the file asks for the loop to be cut here
  SourceLocation where, type_where;
};

struct SdfFrame {
  std::string name;
  std::size_t link = kSdfWorld;
  RigidPose pose;  ///< in the link
  SourceLocation where;
};

struct SdfModel {
  std::string name;
  Eigen::Vector3d gravity{0, 0, -9.81};
  std::vector<SdfLink> links;
  std::vector<SdfJoint> joints;
  std::vector<SdfFrame> frames;
  Counts left_out;                                     ///< by what it is: sensors and so on
  std::map<const SourceText*, SourceLocation> places;  ///< of included texts, in the first one
  std::vector<std::string> files;                      ///< included ones and meshes
  SourceLocation where;
};

/// Reads a world or models. `warnings` gets what is doubtful or left out and does not change the equations. Throws
/// InputError at what is no SDF, cannot be understood or cannot be expressed.
/// \param folders  where included models are looked for, besides the folder of the file
SdfModel read_sdf(std::shared_ptr<const SourceText> source, const std::vector<std::string>& folders,
                  Warnings& warnings);

}  // namespace alembert
