// Bodies of a model as entries of `bodies`, its joints as those of `coordinates`, sites as `frames`.
#pragma once

#include "import/common/described.hpp"
#include "import/common/transform_factors.hpp"
#include "import/mjcf/naming.hpp"

namespace alembert {

class MjcfBodyNodes {
 public:
  MjcfBodyNodes(DescriptionNodes& nodes, const MjcfModel& model, const MjcfNaming& naming,
                const DescribeOptions& options, Warnings& warnings)
      : nodes_(nodes),
        model_(model),
        naming_(naming),
        options_(options),
        warnings_(warnings),
        factors_(nodes, options.snap_angles) {}

  void add_coordinates(YamlNode& list) const;
  void add_body(YamlNode& list, std::size_t body) const;
  /// What of the world is drawn.
  void add_scenery(YamlNode& list) const;
  /// The inertia of a tendon: a mass that shifts by its length, across gravity.
  void add_tendon_armature(YamlNode& list, std::size_t tendon, const std::string& length) const;
  void add_frame(YamlNode& list, const std::string& name, std::size_t body, const RigidPose& pose,
                 const SourceLocation& where) const;

 private:
  void add_coordinate(YamlNode& list, std::size_t joint, std::size_t first, std::size_t first_speed,
                      double armature) const;
  std::vector<double> all_armatures() const;
  void add_joints(YamlNode& factors, const MjcfBody& body) const;
  void add_turn(YamlNode& factors, std::size_t joint) const;
  void add_shapes(YamlNode& node, const MjcfBody& body) const;

  DescriptionNodes& nodes_;
  const MjcfModel& model_;
  const MjcfNaming& naming_;
  const DescribeOptions& options_;
  Warnings& warnings_;
  TransformFactors factors_;
};

}  // namespace alembert
