// Orocos KDL: recursive Newton-Euler on its trees (chains where the mechanism is one), and its composite-body
// joint space inertia on chains. Revolute and prismatic joints.
#include <kdl/chaindynparam.hpp>
#include <kdl/chainfdsolver_recursive_newton_euler.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <kdl/tree.hpp>
#include <kdl/treeidsolver_recursive_newton_euler.hpp>

#include "oracles/engines/engine.hpp"

namespace alembert::oracles {

namespace {

KDL::Vector vector_of(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

KDL::Frame frame_of(const Eigen::Isometry3d& pose) {
  const Eigen::Matrix3d R = pose.linear();
  return {KDL::Rotation(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)),
          vector_of(pose.translation())};
}

KDL::RigidBodyInertia inertia_of(const Link& link) {
  const Eigen::Matrix3d& I = link.inertia;
  return KDL::RigidBodyInertia(link.mass, vector_of(link.com),
                               KDL::RotationalInertia(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)));
}

/// A chain with a segment a link: what lies before the next joint belongs to the segment.
class TimedKdl : public TimedModel {
 public:
  explicit TimedKdl(const JointTree& tree)
      : chain_(compact(tree)),
        inverse_(chain_, vector_of(tree.gravity)),
        forward_(chain_, vector_of(tree.gravity)),
        parameters_(chain_, vector_of(tree.gravity)),
        q_(chain_.getNrOfJoints()),
        qd_(q_),
        qdd_(q_),
        tau_(q_),
        no_force_(chain_.getNrOfSegments()),
        M_(chain_.getNrOfJoints()) {}

  const double* inverse_dynamics(const JointMotion& motion) override {
    q_.data = motion.position;
    qd_.data = motion.speed;
    qdd_.data = motion.rate;
    check(inverse_.CartToJnt(q_, qd_, qdd_, no_force_, tau_));
    return tau_.data.data();
  }
  void mass_matrix(const JointMotion& motion) override {
    q_.data = motion.position;
    check(parameters_.JntToMass(q_, M_));
  }
  const double* forward_dynamics(const JointMotion& motion, const Eigen::VectorXd& tau) override {
    q_.data = motion.position;
    qd_.data = motion.speed;
    tau_.data = tau;
    check(forward_.CartToJnt(q_, qd_, tau_, no_force_, qdd_));
    return qdd_.data.data();
  }

 private:
  static KDL::Chain compact(const JointTree& tree) {
    KDL::Chain chain;
    for (std::size_t i = 0; i < tree.links.size(); ++i) {
      const Link& link = tree.links[i];
      if (link.joints.size() != 1 || link.parent != static_cast<int>(i) - 1 ||
          link.joints[0].kind == Joint::Kind::ball) {
        throw NotExpressible("timed: no chain with a joint a link");
      }
      const Joint& joint = link.joints[0];
      if (i == 0 && !joint.before.isApprox(Eigen::Isometry3d::Identity(), 1e-12))
        chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), frame_of(joint.before)));
      const KDL::Frame next = i + 1 < tree.links.size() ? frame_of(tree.links[i + 1].joints.at(0).before)
                                                        : KDL::Frame::Identity();
      chain.addSegment(KDL::Segment(
          KDL::Joint(KDL::Vector::Zero(), vector_of(joint.axis),
                     joint.kind == Joint::Kind::revolute ? KDL::Joint::RotAxis : KDL::Joint::TransAxis),
          frame_of(link.after) * next, next.Inverse() * inertia_of(link)));
    }
    return chain;
  }
  static void check(int status) {
    if (status < 0) throw std::logic_error("KDL: a solver failed");
  }

  KDL::Chain chain_;
  KDL::ChainIdSolver_RNE inverse_;
  KDL::ChainFdSolver_RNE forward_;
  KDL::ChainDynParam parameters_;
  KDL::JntArray q_, qd_, qdd_, tau_;
  KDL::Wrenches no_force_;
  KDL::JntSpaceInertiaMatrix M_;
};

class KdlModel : public EngineModel {
 public:
  explicit KdlModel(const JointTree& tree) : joints_(tree) {
    std::string last = "root";
    bool serial = true;
    for (std::size_t i = 0; i < tree.links.size(); ++i) {
      const Link& link = tree.links[i];
      serial = serial && link.parent == static_cast<int>(i) - 1;
      std::string parent = link.parent < 0 ? "root" : tree.links[static_cast<std::size_t>(link.parent)].name;
      const std::size_t n = link.joints.size();
      // A segment is a joint and then a pose, so the pose before the first joint is a segment of its own.
      add(parent, link.name + "/base", KDL::Joint(KDL::Joint::None),
          n == 0 ? link.after : link.joints[0].before, n == 0 ? &link : nullptr);
      for (std::size_t j = 0; j < n; ++j) {
        const Joint& joint = link.joints[j];
        if (joint.kind == Joint::Kind::ball) throw NotExpressible("KDL has no spherical joint");
        const bool is_last = j + 1 == n;
        const KDL::Joint kdl_joint(
            KDL::Vector::Zero(), vector_of(joint.axis),
            joint.kind == Joint::Kind::revolute ? KDL::Joint::RotAxis : KDL::Joint::TransAxis);
        add(parent, link.name + "/" + std::to_string(j), kdl_joint,
            is_last ? link.after : link.joints[j + 1].before, is_last ? &link : nullptr);
        joint_segment_.push_back(parent);
      }
      last = parent;
    }
    for (const std::string& name : joint_segment_) index_.push_back(tree_.getSegment(name)->second.q_nr);
    if (serial && !tree_.getChain("root", last, chain_)) throw std::logic_error("KDL: no chain");
    serial_ = serial;
    gravity_ = vector_of(tree.gravity);
  }

  Eigen::VectorXd inverse_dynamics(const JointMotion& motion,
                                   const std::vector<LinkWrench>& wrenches) override {
    const KDL::JntArray q = ordered(motion.position), qd = ordered(motion.speed), qdd = ordered(motion.rate);
    std::map<std::string, KDL::Wrench> forces;
    for (std::size_t i = 0; i < wrenches.size(); ++i) {
      const KDL::Frame pose = pose_of(i, motion.position);
      const KDL::Vector force = pose.M.Inverse(vector_of(wrenches[i].force));
      const KDL::Vector torque = pose.M.Inverse(vector_of(wrenches[i].torque));
      forces[joints_.links[i].name] = KDL::Wrench(force, torque + vector_of(joints_.links[i].com) * force);
    }
    KDL::JntArray tau(tree_.getNrOfJoints());
    if (serial_) {
      std::vector<KDL::Wrench> by_segment;
      for (const KDL::Segment& segment : chain_.segments) by_segment.push_back(forces[segment.getName()]);
      KDL::ChainIdSolver_RNE solver(chain_, gravity_);
      KDL::JntArray tau_chain(chain_.getNrOfJoints());
      // A chain counts its joints from the root, as our joints are.
      if (solver.CartToJnt(plain(motion.position), plain(motion.speed), plain(motion.rate), by_segment,
                           tau_chain) < 0) {
        throw std::logic_error("KDL: inverse dynamics failed");
      }
      return tau_chain.data;
    }
    KDL::TreeIdSolver_RNE solver(tree_, gravity_);
    if (solver.CartToJnt(q, qd, qdd, forces, tau) < 0) throw std::logic_error("KDL: inverse dynamics failed");
    Eigen::VectorXd result(joints_.speeds);
    for (std::size_t j = 0; j < index_.size(); ++j) result[static_cast<int>(j)] = tau(index_[j]);
    return result;
  }

  Eigen::MatrixXd mass_matrix(const JointMotion& motion) override {
    if (serial_) {
      KDL::ChainDynParam parameters(chain_, KDL::Vector::Zero());
      KDL::JntSpaceInertiaMatrix inertia(chain_.getNrOfJoints());
      if (parameters.JntToMass(plain(motion.position), inertia) < 0)
        throw std::logic_error("KDL: no mass matrix");
      return inertia.data;
    }
    // KDL has no joint space inertia of trees: unit accelerations, one after another.
    KDL::TreeIdSolver_RNE solver(tree_, KDL::Vector::Zero());
    Eigen::MatrixXd M(joints_.speeds, joints_.speeds);
    const KDL::JntArray q = ordered(motion.position), rest(tree_.getNrOfJoints());
    for (int k = 0; k < joints_.speeds; ++k) {
      const KDL::JntArray unit = ordered(Eigen::VectorXd::Unit(joints_.speeds, k));
      KDL::JntArray tau(tree_.getNrOfJoints());
      if (solver.CartToJnt(q, rest, unit, {}, tau) < 0)
        throw std::logic_error("KDL: inverse dynamics failed");
      for (int j = 0; j < joints_.speeds; ++j) M(j, k) = tau(index_[static_cast<std::size_t>(j)]);
    }
    return M;
  }

  std::unique_ptr<TimedModel> timed() override { return std::make_unique<TimedKdl>(joints_); }

 private:
  /// Adds a segment at `parent` and makes it the next parent. A link's own segment bears its name.
  void add(std::string& parent, const std::string& name, const KDL::Joint& joint,
           const Eigen::Isometry3d& after, const Link* link) {
    const KDL::RigidBodyInertia inertia = link != nullptr ? inertia_of(*link) : KDL::RigidBodyInertia::Zero();
    const std::string own = link != nullptr ? link->name : name;
    if (!tree_.addSegment(KDL::Segment(own, joint, frame_of(after), inertia), parent)) {
      throw std::logic_error("KDL: cannot add " + own);
    }
    parent = own;
  }

  /// Pose of a link in the world, along its own chain: KDL's forward kinematics of trees works on a copy of
  /// the tree, and copies number their joints anew.
  KDL::Frame pose_of(std::size_t link, const Eigen::VectorXd& positions) const {
    std::vector<double> along;
    for (int i = static_cast<int>(link); i >= 0; i = joints_.links[static_cast<std::size_t>(i)].parent) {
      const auto& joints = joints_.links[static_cast<std::size_t>(i)].joints;
      for (auto joint = joints.rbegin(); joint != joints.rend(); ++joint)
        along.push_back(positions[joint->first_position]);
    }
    KDL::Chain chain;
    KDL::JntArray q(static_cast<unsigned>(along.size()));
    for (unsigned k = 0; k < along.size(); ++k) q(k) = along[along.size() - 1 - k];
    KDL::Frame pose;
    if (!tree_.getChain("root", joints_.links[link].name, chain) ||
        KDL::ChainFkSolverPos_recursive(chain).JntToCart(q, pose) < 0) {
      throw std::logic_error("KDL: no pose");
    }
    return pose;
  }
  KDL::JntArray plain(const Eigen::VectorXd& values) const {
    KDL::JntArray result(static_cast<unsigned>(values.size()));
    result.data = values;
    return result;
  }
  KDL::JntArray ordered(const Eigen::VectorXd& values) const {
    KDL::JntArray result(tree_.getNrOfJoints());
    for (std::size_t j = 0; j < index_.size(); ++j) result(index_[j]) = values[static_cast<int>(j)];
    return result;
  }

  const JointTree& joints_;
  KDL::Tree tree_{"root"};
  KDL::Chain chain_;
  KDL::Vector gravity_;
  bool serial_ = false;
  std::vector<std::string> joint_segment_;  // by our joint
  std::vector<unsigned> index_;             // by our joint: KDL's number
};

}  // namespace

std::unique_ptr<EngineModel> make_kdl(const JointTree& tree) {
  return std::make_unique<KdlModel>(tree);
}

}  // namespace alembert::oracles
