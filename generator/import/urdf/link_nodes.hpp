// A link's inertia and shapes in; the keys of a body out.
#pragma once

#include "import/common/description_nodes.hpp"
#include "import/urdf/joint_factors.hpp"
#include "import/urdf/robot.hpp"

namespace alembert {

class LinkNodes {
 public:
  LinkNodes(DescriptionNodes& nodes, const JointFactors& factors, double snap_angles)
      : nodes_(nodes), factors_(factors), snap_angles_(snap_angles) {}

  /// Adds `mass`, `com` and `inertia`, in the axes of the link.
  void add_inertial(YamlNode& node, const UrdfInertial& inertial) const;
  /// Adds `geometry`.
  void add_shapes(YamlNode& node, const UrdfLink& link) const;

 private:
  DescriptionNodes& nodes_;
  const JointFactors& factors_;
  double snap_angles_;
};

}  // namespace alembert
