// What acts in a model as entries of `forces`: joints that follow others, tendons, actuators, weight that is borne, and
// what is around.
#pragma once

#include <functional>
#include <map>

#include "import/mjcf/body_nodes.hpp"
#include "import/mjcf/fluid.hpp"

namespace alembert {

class MjcfForceNodes {
 public:
  /// Frames that forces need are added to `frames`.
  MjcfForceNodes(DescriptionNodes& nodes, const MjcfModel& model, MjcfNaming& naming,
                 const DescribeOptions& options, const MjcfBodyNodes& bodies, YamlNode& frames)
      : nodes_(nodes), model_(model), naming_(naming), options_(options), bodies_(bodies), frames_(frames) {}

  void add_forces(YamlNode& list);
  void add_inputs(YamlNode& list) const;
  void add_states(YamlNode& list) const;
  /// Length and its rate of a tendon or an actuator, as outputs have them.
  std::string length(std::size_t tendon) const;
  std::string rate(std::size_t tendon) const;
  std::string actuator_length(const MjcfActuator& actuator) const;
  std::string actuator_rate(const MjcfActuator& actuator) const;
  bool has_path(std::size_t tendon) const { return paths_.contains(tendon); }

 private:
  void add_followers(YamlNode& list);
  void add_springs_of_turns(YamlNode& list);
  std::string turn_energy(std::size_t joint);
  YamlNode& wrap_node(const MjcfWrap& wrap, const SourceLocation& where);
  void add_tendon(YamlNode& list, std::size_t tendon, const std::string& pull);
  void add_actuator(YamlNode& list, std::size_t actuator);
  void add_turn_in_parent(YamlNode& list, const MjcfActuator& actuator, const std::string& force,
                          const Eigen::Vector3d& torque);
  void add_borne_weight(YamlNode& list);
  void add_fluid(YamlNode& list);
  void add_fluid_on_inertia(YamlNode& list, std::size_t body);
  void add_fluid_at(YamlNode& list, std::size_t body, const RigidPose& pose,
                    const std::function<FluidLoads(const FluidMotion&)>& law);
  void add_on(YamlNode& list, const std::string& name, std::size_t joint, const std::string& value,
              const SourceLocation& where);
  static std::string muscle_force(const MjcfMuscle& muscle, const std::string& length,
                                  const std::string& velocity, const std::string& activation);
  std::string law(std::size_t actuator) const;
  static std::string excitation(const MjcfActuator& of, const std::string& input, const std::string& state);
  std::string pull_of(const MjcfTendon& tendon, const std::vector<std::size_t>& actuators) const;
  bool acts(std::size_t actuator) const;
  bool moves(std::size_t body) const;

  DescriptionNodes& nodes_;
  const MjcfModel& model_;
  MjcfNaming& naming_;
  const DescribeOptions& options_;
  const MjcfBodyNodes& bodies_;
  YamlNode& frames_;
  /// A force of an actuator on a joint where what all exert is limited.
  struct DrivePart {
    std::string name, force;
    SourceLocation where;
  };
  std::map<std::size_t, std::vector<DrivePart>> drives_;   ///< by joint
  std::map<std::size_t, std::vector<std::string>> paths_;  ///< by spatial tendon: names of its branches
};

}  // namespace alembert
