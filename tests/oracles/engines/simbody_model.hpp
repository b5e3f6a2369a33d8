// A mechanism in Simbody, open to what a test adds to it: force elements, contacts, constraints. Simbody's own
// header comes with it, which adapters and their tests alone can afford.
#pragma once

#include <Simbody.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "oracles/engines/engine.hpp"

namespace alembert::oracles {

/// One mobilized body a joint, massless ones between the links. Of a ball Simbody's speeds are in the parent's
/// axes, ours in the child's.
class SimbodyModel : public EngineModel {
 public:
  /// Of the tree, which must outlive it.
  /// \param add  to the system, before it is finished
  explicit SimbodyModel(const JointTree& tree, const std::function<void(SimbodyModel&)>& add = {});

  Eigen::VectorXd inverse_dynamics(const JointMotion& motion,
                                   const std::vector<LinkWrench>& wrenches) override;
  Eigen::MatrixXd mass_matrix(const JointMotion& motion) override;
  std::unique_ptr<TimedModel> timed() override;

  SimTK::MultibodySystem& system() { return system_; }
  SimTK::SimbodyMatterSubsystem& matter() { return matter_; }
  SimTK::State& state() { return state_; }
  /// What Simbody refers to of what was added: it goes before the system does.
  void keep(std::shared_ptr<void> added) { kept_ = std::move(added); }
  /// By name, with the last joint before it; "world" is the ground.
  const SimTK::MobilizedBody& link(const std::string& name) const;

  /// Positions and speeds; realized to velocities.
  void set(const JointMotion& motion);
  /// Forces, speeds or rates of our joints from Simbody's, at the positions that are set, and back. What is
  /// Simbody's may go on with what was added.
  Eigen::VectorXd ours(const SimTK::Vector& theirs) const;
  SimTK::Vector theirs(const Eigen::VectorXd& ours) const;

 private:
  template <class Visit>
  void each_joint(Visit visit) const;

  const JointTree& tree_;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_{system_};
  std::vector<SimTK::MobilizedBody> links_, moved_;  // by link, by our joint
  SimTK::State state_;
  std::shared_ptr<void> kept_;
};

}  // namespace alembert::oracles
