// What an adapter to a multibody engine offers, and the list of engines this build has.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "oracles/engines/joint_tree.hpp"

namespace alembert::oracles {

/// One algorithm of an engine at one state, as a user of the engine would call it: sets the state and runs,
/// without a detour through the types used here. For serial chains of revolute and prismatic joints, a joint
/// a link; motion and forces in the order of the joints. The results (of the mass matrix: whatever the engine
/// stores) lie in the engine.
class TimedModel {
 public:
  virtual ~TimedModel() = default;
  virtual const double* inverse_dynamics(const JointMotion& motion) = 0;
  virtual void mass_matrix(const JointMotion& motion) = 0;
  virtual const double* forward_dynamics(const JointMotion& motion, const Eigen::VectorXd& tau) = 0;
};

/// One mechanism inside one engine.
class EngineModel {
 public:
  virtual ~EngineModel() = default;
  /// Forces on joints that give this motion under gravity and wrenches (one per link).
  virtual Eigen::VectorXd inverse_dynamics(const JointMotion& motion,
                                           const std::vector<LinkWrench>& wrenches) = 0;
  virtual Eigen::MatrixXd mass_matrix(const JointMotion& motion) = 0;
  /// For timing; refers to this model.
  virtual std::unique_ptr<TimedModel> timed() = 0;
};

struct Engine {
  std::string name;
  double tolerance;  ///< relative, on tau, M and c
  /// Throws NotExpressible. Empty: the engine was not there when this was built.
  std::function<std::unique_ptr<EngineModel>(const JointTree&)> make;
};

/// KDL, MuJoCo, DART and Simbody, installed or not.
std::vector<Engine> engines();

std::unique_ptr<EngineModel> make_kdl(const JointTree& tree);
std::unique_ptr<EngineModel> make_mujoco(const JointTree& tree);
std::unique_ptr<EngineModel> make_dart(const JointTree& tree);
std::unique_ptr<EngineModel> make_simbody(const JointTree& tree);

/// The engine's answer, carried from its joints to the mechanism's speeds.
Dynamics engine_dynamics(EngineModel& model, const JointTree& tree, const State& state);

}  // namespace alembert::oracles
