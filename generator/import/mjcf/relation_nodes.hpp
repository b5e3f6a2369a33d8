// Equalities of a model as entries of `constraints`, sensors as those of `outputs`.
#pragma once

#include "import/mjcf/force_nodes.hpp"

namespace alembert {

class MjcfRelationNodes {
 public:
  /// Frames that constraints need are added to `frames`.
  MjcfRelationNodes(DescriptionNodes& nodes, const MjcfModel& model, MjcfNaming& naming,
                    const MjcfBodyNodes& bodies, const MjcfForceNodes& forces, YamlNode& frames,
                    Warnings& warnings)
      : nodes_(nodes),
        model_(model),
        naming_(naming),
        bodies_(bodies),
        forces_(forces),
        frames_(frames),
        warnings_(warnings) {}

  void add_constraints(YamlNode& list);
  void add_outputs(YamlNode& list);

 private:
  void add_coincidence(std::vector<std::string>& equations, const MjcfEquality& equality,
                       const std::string& name);
  void add_function(std::vector<std::string>& equations, const MjcfEquality& equality) const;
  void add_tendons(std::vector<std::string>& equations, const MjcfEquality& equality) const;
  void add_vector(YamlNode& list, const std::string& name, const std::string (&values)[3],
                  const SourceLocation& where);
  YamlNode& add_output(YamlNode& list, const std::string& name, const std::string& value,
                       const SourceLocation& where);
  void add_sensor(YamlNode& list, const MjcfSensor& sensor);
  void add_limits(YamlNode& list, std::size_t tendon);
  std::size_t rigid_root(std::size_t body) const;

  DescriptionNodes& nodes_;
  const MjcfModel& model_;
  MjcfNaming& naming_;
  const MjcfBodyNodes& bodies_;
  const MjcfForceNodes& forces_;
  YamlNode& frames_;
  Warnings& warnings_;
};

}  // namespace alembert
