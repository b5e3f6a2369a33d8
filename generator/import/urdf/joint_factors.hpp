// Origins and joints of a robot in, factors of transforms out.
#pragma once

#include <string>
#include <vector>

#include "import/common/transform_factors.hpp"
#include "import/urdf/robot.hpp"

namespace alembert {

class JointFactors {
 public:
  /// Angles of origins within `snap_angles` radians of a multiple of pi/12 are that multiple.
  JointFactors(DescriptionNodes& nodes, const UrdfRobot& robot, double snap_angles);

  /// Appends an origin: a shift and up to three turns.
  void add_origin(YamlNode& factors, const UrdfPose& pose) const;
  /// Appends a joint with these coordinates; that of a mimicking joint is a definition.
  void add_joint(YamlNode& factors, const UrdfJoint& joint, const std::vector<std::string>& names) const;
  /// Appends three shifts and a quaternion.
  void add_free(YamlNode& factors, const std::vector<std::string>& names, const SourceLocation& where) const {
    factors_.add_free(factors, names, where);
  }

 private:
  void add_planar(YamlNode& factors, const UrdfJoint& joint, const std::vector<std::string>& names) const;

  DescriptionNodes& nodes_;
  TransformFactors factors_;
  double snap_angles_, longest_;
};

}  // namespace alembert
