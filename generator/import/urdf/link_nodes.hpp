// A link's inertia and shapes in; the keys of a body out.
#pragma once

#include "import/common/described.hpp"
#include "import/common/description_nodes.hpp"
#include "import/urdf/joint_factors.hpp"
#include "import/urdf/robot.hpp"

namespace alembert {

class LinkNodes {
 public:
  LinkNodes(DescriptionNodes& nodes, const JointFactors& factors, const DescribeOptions& options)
      : nodes_(nodes), factors_(factors), options_(options) {}

  /// Adds `mass`, `com` and `inertia`, in the axes of the link.
  void add_inertial(YamlNode& node, const UrdfInertial& inertial) const;
  /// Adds what is drawn of a link at `place` in the axes of the body to its `geometry`: of meshes those whose
  /// files are there.
  void add_shapes(YamlNode& shapes, const UrdfLink& link, const UrdfPose& place) const;

 private:
  DescriptionNodes& nodes_;
  const JointFactors& factors_;
  const DescribeOptions& options_;
};

}  // namespace alembert
