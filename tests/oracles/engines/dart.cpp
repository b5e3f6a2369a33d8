// DART: one body node a joint, massless ones between the links.
#include <dart/dynamics/BallJoint.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/PrismaticJoint.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/WeldJoint.hpp>

#include "oracles/engines/engine.hpp"
#include "oracles/engines/silence.hpp"

namespace alembert::oracles {

namespace {

namespace dd = dart::dynamics;

class TimedDart : public TimedModel {
 public:
  explicit TimedDart(dd::SkeletonPtr skeleton) : skeleton_(std::move(skeleton)) {}

  const double* inverse_dynamics(const JointMotion& motion) override {
    skeleton_->setPositions(motion.position);
    skeleton_->setVelocities(motion.speed);
    skeleton_->setAccelerations(motion.rate);
    skeleton_->computeInverseDynamics();
    result_ = skeleton_->getForces();
    return result_.data();
  }
  void mass_matrix(const JointMotion& motion) override {
    skeleton_->setPositions(motion.position);
    sum_ += skeleton_->getMassMatrix()(0, 0);
  }
  const double* forward_dynamics(const JointMotion& motion, const Eigen::VectorXd& tau) override {
    skeleton_->setPositions(motion.position);
    skeleton_->setVelocities(motion.speed);
    skeleton_->setForces(tau);
    skeleton_->computeForwardDynamics();
    result_ = skeleton_->getAccelerations();
    return result_.data();
  }

 private:
  dd::SkeletonPtr skeleton_;
  Eigen::VectorXd result_;
  double sum_ = 0;
};

class DartModel : public EngineModel {
 public:
  explicit DartModel(const JointTree& tree) : tree_(tree) {
    const Silence silence;
    skeleton_->setGravity(tree.gravity);
    for (const Link& link : tree.links) {
      dd::BodyNode* node = link.parent < 0 ? nullptr : nodes_[static_cast<std::size_t>(link.parent)];
      if (link.joints.empty()) {
        const auto [joint, body] = skeleton_->createJointAndBodyNodePair<dd::WeldJoint>(node);
        joint->setTransformFromParentBodyNode(link.after);
        node = body;
        massless(*node);
      }
      for (const Joint& joint : link.joints) {
        node = child(node, joint);
        massless(*node);
        last_joint_of_.push_back(node);
      }
      if (!link.joints.empty()) node->getParentJoint()->setTransformFromChildBodyNode(link.after.inverse());
      const Eigen::Matrix3d& I = link.inertia;
      node->setInertia(dd::Inertia(link.mass, link.com, I));
      nodes_.push_back(node);
    }
  }

  Eigen::VectorXd inverse_dynamics(const JointMotion& motion,
                                   const std::vector<LinkWrench>& wrenches) override {
    set(motion);
    for (std::size_t i = 0; i < wrenches.size(); ++i) {
      nodes_[i]->setExtForce(wrenches[i].force, tree_.links[i].com, false, true);
      nodes_[i]->addExtTorque(wrenches[i].torque,
                              false);  // `set` would drop the force's torque about the origin
    }
    skeleton_->computeInverseDynamics(true);
    return to_joints(skeleton_->getForces());
  }

  Eigen::MatrixXd mass_matrix(const JointMotion& motion) override {
    set(motion);
    const Eigen::MatrixXd M = skeleton_->getMassMatrix();
    Eigen::MatrixXd half(tree_.speeds, tree_.speeds), result(tree_.speeds, tree_.speeds);
    for (int c = 0; c < tree_.speeds; ++c) half.col(c) = to_joints(M.col(c));
    for (int r = 0; r < tree_.speeds; ++r) result.row(r) = to_joints(half.row(r).transpose()).transpose();
    return result;
  }

  std::unique_ptr<TimedModel> timed() override { return std::make_unique<TimedDart>(skeleton_); }

 private:
  dd::BodyNode* child(dd::BodyNode* parent, const Joint& joint) {
    dd::Joint* made = nullptr;
    dd::BodyNode* body = nullptr;
    switch (joint.kind) {
      case Joint::Kind::revolute: {
        const auto [j, b] = skeleton_->createJointAndBodyNodePair<dd::RevoluteJoint>(parent);
        j->setAxis(joint.axis);
        made = j, body = b;
        break;
      }
      case Joint::Kind::prismatic: {
        const auto [j, b] = skeleton_->createJointAndBodyNodePair<dd::PrismaticJoint>(parent);
        j->setAxis(joint.axis);
        made = j, body = b;
        break;
      }
      case Joint::Kind::ball: {
        const auto [j, b] = skeleton_->createJointAndBodyNodePair<dd::BallJoint>(parent);
        made = j, body = b;
        break;
      }
    }
    made->setTransformFromParentBodyNode(joint.before);
    return body;
  }

  static void massless(dd::BodyNode& node) {
    node.setInertia(dd::Inertia(0, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero()));
  }

  template <class Visit>
  void each_joint(Visit visit) const {
    std::size_t k = 0;
    for (const Link& link : tree_.links) {
      for (const Joint& joint : link.joints) visit(joint, *last_joint_of_[k++]->getParentJoint());
    }
  }

  void set(const JointMotion& motion) {
    each_joint([&](const Joint& joint, dd::Joint& theirs) {
      if (joint.kind == Joint::Kind::ball) {
        const Eigen::Quaterniond turn(Eigen::Vector4d(motion.position.segment<4>(joint.first_position)));
        theirs.setPositions(dd::BallJoint::convertToPositions(turn.toRotationMatrix()));
        theirs.setVelocities(motion.speed.segment<3>(joint.first_speed));
        theirs.setAccelerations(motion.rate.segment<3>(joint.first_speed));
      } else {
        theirs.setPosition(0, motion.position[joint.first_position]);
        theirs.setVelocity(0, motion.speed[joint.first_speed]);
        theirs.setAcceleration(0, motion.rate[joint.first_speed]);
      }
    });
  }

  Eigen::VectorXd to_joints(const Eigen::VectorXd& forces) const {
    Eigen::VectorXd result(tree_.speeds);
    each_joint([&](const Joint& joint, const dd::Joint& theirs) {
      for (int i = 0; i < joint.speeds(); ++i) {
        result[joint.first_speed + i] =
            forces[static_cast<int>(theirs.getIndexInSkeleton(static_cast<std::size_t>(i)))];
      }
    });
    return result;
  }

  const JointTree& tree_;
  dd::SkeletonPtr skeleton_ = dd::Skeleton::create();
  std::vector<dd::BodyNode*> nodes_;          // by link
  std::vector<dd::BodyNode*> last_joint_of_;  // by our joint: the node it moves
};

}  // namespace

std::unique_ptr<EngineModel> make_dart(const JointTree& tree) {
  return std::make_unique<DartModel>(tree);
}

}  // namespace alembert::oracles
