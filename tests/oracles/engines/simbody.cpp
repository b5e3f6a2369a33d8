// Links and joints to mobilized bodies (see the header).
#include <stdexcept>

#include "oracles/engines/simbody_model.hpp"

namespace alembert::oracles {

namespace {

SimTK::Vec3 vector_of(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

SimTK::Rotation rotation_of(const Eigen::Matrix3d& R) {
  return SimTK::Rotation(
      SimTK::Mat33(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)), true);
}

SimTK::Transform transform_of(const Eigen::Isometry3d& pose) {
  return {rotation_of(pose.linear()), vector_of(pose.translation())};
}

/// Axes whose z (revolute), x (prismatic) is the joint's axis.
Eigen::Isometry3d joint_axes(const Joint& joint) {
  if (joint.kind == Joint::Kind::ball) return Eigen::Isometry3d::Identity();
  const Eigen::Vector3d own =
      joint.kind == Joint::Kind::revolute ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX();
  return Eigen::Isometry3d(Eigen::Quaterniond::FromTwoVectors(own, joint.axis));
}

class TimedSimbody : public TimedModel {
 public:
  TimedSimbody(const JointTree& tree, const SimTK::MultibodySystem& system,
               const SimTK::SimbodyMatterSubsystem& matter, const std::vector<SimTK::MobilizedBody>& links,
               SimTK::State state)
      : tree_(tree),
        system_(system),
        matter_(matter),
        links_(links),
        state_(std::move(state)),
        zero_(state_.getNU(), 0.0),
        rates_(state_.getNU()),
        weights_(matter.getNumBodies(), SimTK::SpatialVec(SimTK::Vec3(0), SimTK::Vec3(0))) {}

  const double* inverse_dynamics(const JointMotion& motion) override {
    set(motion);
    for (int i = 0; i < rates_.size(); ++i) rates_[i] = motion.rate[i];
    matter_.calcResidualForceIgnoringConstraints(state_, zero_, weights_, rates_, result_);
    return &result_[0];
  }
  void mass_matrix(const JointMotion& motion) override {
    for (int i = 0; i < zero_.size(); ++i) state_.updQ()[i] = motion.position[i];
    system_.realize(state_, SimTK::Stage::Position);
    matter_.calcM(state_, M_);
  }
  const double* forward_dynamics(const JointMotion& motion, const Eigen::VectorXd& tau) override {
    set(motion);
    for (int i = 0; i < rates_.size(); ++i) rates_[i] = tau[i];
    system_.realize(state_, SimTK::Stage::Dynamics);
    matter_.calcAccelerationIgnoringConstraints(state_, rates_, weights_, result_, accelerations_);
    return &result_[0];
  }

 private:
  void set(const JointMotion& motion) {
    for (int i = 0; i < zero_.size(); ++i) {
      state_.updQ()[i] = motion.position[i];
      state_.updU()[i] = motion.speed[i];
    }
    system_.realize(state_, SimTK::Stage::Velocity);
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const SimTK::Vec3 force = vector_of(tree_.links[i].mass * tree_.gravity);
      const SimTK::Vec3 arm = links_[i].expressVectorInGroundFrame(state_, vector_of(tree_.links[i].com));
      weights_[links_[i].getMobilizedBodyIndex()] = SimTK::SpatialVec(SimTK::cross(arm, force), force);
    }
  }
  const JointTree& tree_;
  const SimTK::MultibodySystem& system_;
  const SimTK::SimbodyMatterSubsystem& matter_;
  const std::vector<SimTK::MobilizedBody>& links_;
  SimTK::State state_;
  SimTK::Vector zero_, rates_, result_;
  SimTK::Vector_<SimTK::SpatialVec> weights_, accelerations_;
  SimTK::Matrix M_;
};

Eigen::Matrix3d child_in_parent(const SimTK::MobilizedBody& body, const SimTK::State& state) {
  const SimTK::Mat33 R = body.getMobilizerTransform(state).R().asMat33();
  Eigen::Matrix3d result;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) result(r, c) = R(r, c);
  }
  return result;
}

}  // namespace

SimbodyModel::SimbodyModel(const JointTree& tree, const std::function<void(SimbodyModel&)>& add)
    : tree_(tree) {
  for (const Link& link : tree.links) {
    SimTK::MobilizedBody parent = link.parent < 0 ? static_cast<SimTK::MobilizedBody>(matter_.updGround())
                                                  : links_[static_cast<std::size_t>(link.parent)];
    const Eigen::Matrix3d& I = link.inertia;
    const SimTK::Inertia central(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
    const SimTK::Body::Rigid rigid(SimTK::MassProperties(
        link.mass, vector_of(link.com), central.shiftFromMassCenter(vector_of(link.com), link.mass)));
    if (link.joints.empty()) {
      parent = SimTK::MobilizedBody::Weld(parent, transform_of(link.after), rigid, SimTK::Transform());
    }
    for (std::size_t j = 0; j < link.joints.size(); ++j) {
      const Joint& joint = link.joints[j];
      const bool last = j + 1 == link.joints.size();
      const Eigen::Isometry3d axes = joint_axes(joint);
      const SimTK::Transform inboard = transform_of(joint.before * axes);
      const SimTK::Transform outboard = transform_of(last ? link.after.inverse() * axes : axes);
      const SimTK::Body body =
          last ? static_cast<SimTK::Body>(rigid) : static_cast<SimTK::Body>(SimTK::Body::Massless());
      switch (joint.kind) {
        case Joint::Kind::revolute:
          parent = SimTK::MobilizedBody::Pin(parent, inboard, body, outboard);
          break;
        case Joint::Kind::prismatic:
          parent = SimTK::MobilizedBody::Slider(parent, inboard, body, outboard);
          break;
        case Joint::Kind::ball:
          parent = SimTK::MobilizedBody::Ball(parent, inboard, body, outboard);
          break;
      }
      moved_.push_back(parent);
    }
    links_.push_back(parent);
  }
  if (add) add(*this);
  state_ = system_.realizeTopology();
  system_.realizeModel(state_);
}

const SimTK::MobilizedBody& SimbodyModel::link(const std::string& name) const {
  if (name == "world") return matter_.getGround();
  for (std::size_t i = 0; i < links_.size(); ++i)
    if (tree_.links[i].name == name) return links_[i];
  throw std::runtime_error("no link " + name);
}

Eigen::VectorXd SimbodyModel::inverse_dynamics(const JointMotion& motion,
                                               const std::vector<LinkWrench>& wrenches) {
  set(motion);
  SimTK::Vector_<SimTK::SpatialVec> body_forces(matter_.getNumBodies(),
                                                SimTK::SpatialVec(SimTK::Vec3(0), SimTK::Vec3(0)));
  for (std::size_t i = 0; i < tree_.links.size(); ++i) {
    const Link& link = tree_.links[i];
    const SimTK::Vec3 force = vector_of(wrenches[i].force + link.mass * tree_.gravity);
    const SimTK::Vec3 arm = links_[i].expressVectorInGroundFrame(state_, vector_of(link.com));
    body_forces[links_[i].getMobilizedBodyIndex()] =
        SimTK::SpatialVec(vector_of(wrenches[i].torque) + SimTK::cross(arm, force), force);
  }
  SimTK::Vector residual;
  matter_.calcResidualForceIgnoringConstraints(state_, SimTK::Vector(state_.getNU(), 0.0), body_forces,
                                               theirs(motion.rate), residual);
  return ours(residual);
}

Eigen::MatrixXd SimbodyModel::mass_matrix(const JointMotion& motion) {
  set(motion);
  SimTK::Matrix M;
  matter_.calcM(state_, M);
  Eigen::MatrixXd half(tree_.speeds, state_.getNU()), result(tree_.speeds, tree_.speeds);
  for (int c = 0; c < state_.getNU(); ++c) half.col(c) = ours(SimTK::Vector(M(c)));
  for (int r = 0; r < tree_.speeds; ++r) {
    SimTK::Vector row(state_.getNU());
    for (int c = 0; c < state_.getNU(); ++c) row[c] = half(r, c);
    result.row(r) = ours(row).transpose();
  }
  return result;
}

std::unique_ptr<TimedModel> SimbodyModel::timed() {
  return std::make_unique<TimedSimbody>(tree_, system_, matter_, links_, state_);
}

template <class Visit>
void SimbodyModel::each_joint(Visit visit) const {
  std::size_t k = 0;
  for (const Link& link : tree_.links)
    for (const Joint& joint : link.joints) visit(joint, moved_[k++]);
}

void SimbodyModel::set(const JointMotion& motion) {
  each_joint([&](const Joint& joint, const SimTK::MobilizedBody& body) {
    const int position = static_cast<int>(body.getFirstQIndex(state_));
    if (joint.kind == Joint::Kind::ball) {
      state_.updQ()[position] = motion.position[joint.first_position + 3];
      for (int i = 0; i < 3; ++i) state_.updQ()[position + 1 + i] = motion.position[joint.first_position + i];
    } else {
      state_.updQ()[position] = motion.position[joint.first_position];
    }
  });
  system_.realize(state_, SimTK::Stage::Position);
  state_.updU() = theirs(motion.speed);
  system_.realize(state_, SimTK::Stage::Velocity);
}

Eigen::VectorXd SimbodyModel::ours(const SimTK::Vector& theirs) const {
  Eigen::VectorXd result(tree_.speeds);
  each_joint([&](const Joint& joint, const SimTK::MobilizedBody& body) {
    const int first = static_cast<int>(body.getFirstUIndex(state_));
    for (int i = 0; i < joint.speeds(); ++i) result[joint.first_speed + i] = theirs[first + i];
    if (joint.kind == Joint::Kind::ball) {
      const Eigen::Vector3d there = result.segment<3>(joint.first_speed);
      result.segment<3>(joint.first_speed) = child_in_parent(body, state_).transpose() * there;
    }
  });
  return result;
}

// Of rates likewise, since the axes turn about the very velocity: om x om = 0.
SimTK::Vector SimbodyModel::theirs(const Eigen::VectorXd& ours) const {
  SimTK::Vector result(state_.getNU(), 0.0);
  each_joint([&](const Joint& joint, const SimTK::MobilizedBody& body) {
    const int first = static_cast<int>(body.getFirstUIndex(state_));
    Eigen::VectorXd value = ours.segment(joint.first_speed, joint.speeds());
    if (joint.kind == Joint::Kind::ball) value = child_in_parent(body, state_) * value;
    for (int i = 0; i < joint.speeds(); ++i) result[first + i] = value[i];
  });
  return result;
}

std::unique_ptr<EngineModel> make_simbody(const JointTree& tree) {
  return std::make_unique<SimbodyModel>(tree);
}

}  // namespace alembert::oracles
