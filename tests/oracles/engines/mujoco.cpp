// MuJoCo: the mechanism written as MJCF, contacts and constraints off. All joints of a link go into one body,
// carried to the axes that the body has at zero, because MuJoCo allows no massless bodies that move.
#include <mujoco/mujoco.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <map>

#include "oracles/engines/engine.hpp"

namespace alembert::oracles {

namespace {

std::string text(std::initializer_list<double> values) {
  std::string result;
  for (const double value : values) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.17g ", value);
    result += buffer;
  }
  return result;
}
std::string text(const Eigen::Vector3d& v) {
  return text({v.x(), v.y(), v.z()});
}

struct Deleter {
  void operator()(mjModel* m) const { mj_deleteModel(m); }
  void operator()(mjData* d) const { mj_deleteData(d); }
};

/// The stages that each algorithm needs and no others.
class TimedMujoco : public TimedModel {
 public:
  TimedMujoco(const mjModel* model, mjData* data)
      : model_(model), data_(data), result_(static_cast<std::size_t>(model->nv)) {}

  const double* inverse_dynamics(const JointMotion& motion) override {
    set(motion);
    std::copy_n(motion.rate.data(), model_->nv, data_->qacc);
    mj_kinematics(model_, data_);
    mj_comPos(model_, data_);
    mj_comVel(model_, data_);
    mj_rne(model_, data_, 1, result_.data());
    return result_.data();
  }
  void mass_matrix(const JointMotion& motion) override {
    std::copy_n(motion.position.data(), model_->nq, data_->qpos);
    mj_kinematics(model_, data_);
    mj_comPos(model_, data_);
    mj_crb(model_, data_);
  }
  const double* forward_dynamics(const JointMotion& motion, const Eigen::VectorXd& tau) override {
    set(motion);
    mj_kinematics(model_, data_);
    mj_comPos(model_, data_);
    mj_crb(model_, data_);
    mj_factorM(model_, data_);
    mj_comVel(model_, data_);
    mj_rne(model_, data_, 0, data_->qfrc_bias);
    for (int i = 0; i < model_->nv; ++i) data_->qfrc_smooth[i] = tau[i] - data_->qfrc_bias[i];
    mj_solveM(model_, data_, result_.data(), data_->qfrc_smooth, 1);
    return result_.data();
  }

 private:
  void set(const JointMotion& motion) {
    std::copy_n(motion.position.data(), model_->nq, data_->qpos);
    std::copy_n(motion.speed.data(), model_->nv, data_->qvel);
  }
  const mjModel* model_;
  mjData* data_;
  std::vector<double> result_;
};

class MujocoModel : public EngineModel {
 public:
  explicit MujocoModel(const JointTree& tree) : tree_(tree) {
    // Joints of one link may be dependent; MuJoCo warns of it, and into a file.
    mju_user_warning = [](const char*) {};
    std::string xml = "<mujoco><compiler angle='radian' inertiafromgeom='false'/><option gravity='" +
                      text(tree.gravity) +
                      "'><flag constraint='disable' contact='disable'/></option><worldbody>" +
                      bodies_under(-1) + "</worldbody></mujoco>";
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), "model.xml", static_cast<int>(xml.size()));
    std::memcpy(files->filedata[0], xml.data(), xml.size());
    char error[1000] = "";
    model_.reset(mj_loadXML("model.xml", files.get(), error, sizeof error));
    mj_deleteVFS(files.get());
    if (!model_) throw NotExpressible(std::string("MuJoCo: ") + error);
    data_.reset(mj_makeData(model_.get()));
  }

  Eigen::VectorXd inverse_dynamics(const JointMotion& motion,
                                   const std::vector<LinkWrench>& wrenches) override {
    set(motion);
    mj_inverse(model_.get(), data_.get());
    Eigen::VectorXd applied = Eigen::VectorXd::Zero(model_->nv);
    for (std::size_t i = 0; i < wrenches.size(); ++i) {
      const int body = mj_name2id(model_.get(), mjOBJ_BODY, tree_.links[i].name.c_str());
      mj_applyFT(model_.get(), data_.get(), wrenches[i].force.data(), wrenches[i].torque.data(),
                 data_->xipos + 3 * body, body, applied.data());
    }
    return to_joints(Eigen::Map<Eigen::VectorXd>(data_->qfrc_inverse, model_->nv) - applied);
  }

  Eigen::MatrixXd mass_matrix(const JointMotion& motion) override {
    set(motion);
    mj_inverse(model_.get(), data_.get());
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> M(model_->nv, model_->nv);
    mj_fullM(model_.get(), M.data(), data_->qM);
    Eigen::MatrixXd half(tree_.speeds, model_->nv), result(tree_.speeds, tree_.speeds);
    for (int c = 0; c < model_->nv; ++c) half.col(c) = to_joints(M.col(c));
    for (int r = 0; r < tree_.speeds; ++r) result.row(r) = to_joints(half.row(r).transpose()).transpose();
    return result;
  }

  std::unique_ptr<TimedModel> timed() override {
    return std::make_unique<TimedMujoco>(model_.get(), data_.get());
  }

 private:
  std::string bodies_under(int parent) {
    std::string xml;
    for (std::size_t i = 0; i < tree_.links.size(); ++i) {
      const Link& link = tree_.links[i];
      if (link.parent != parent) continue;
      std::vector<Eigen::Isometry3d> at;  // of each joint, and of the link, at zero
      Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
      for (const Joint& joint : link.joints) at.push_back(pose = pose * joint.before);
      pose = pose * link.after;
      const Eigen::Quaterniond turn(pose.linear());
      xml += "<body name='" + link.name + "' pos='" + text(Eigen::Vector3d(pose.translation())) + "' quat='" +
             text({turn.w(), turn.x(), turn.y(), turn.z()}) + "'>";
      // Principal axes are found here: MuJoCo's own are good to 1e-7 only.
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(link.inertia);
      Eigen::Matrix3d axes = principal.eigenvectors();
      if (axes.determinant() < 0) axes.col(0) *= -1;
      const Eigen::Quaterniond tilt(axes);
      xml += "<inertial pos='" + text(link.com) + "' quat='" +
             text({tilt.w(), tilt.x(), tilt.y(), tilt.z()}) + "' mass='" + text({link.mass}) +
             "' diaginertia='" + text(Eigen::Vector3d(principal.eigenvalues())) + "'/>";
      for (std::size_t j = 0; j < link.joints.size(); ++j) {
        const Joint& joint = link.joints[j];
        const Eigen::Isometry3d local = pose.inverse() * at[j];
        frame_[joint.first_speed] = local.linear();
        const char* type = joint.kind == Joint::Kind::ball       ? "ball"
                           : joint.kind == Joint::Kind::revolute ? "hinge"
                                                                 : "slide";
        xml += std::string("<joint name='") + name(joint) + "' type='" + type + "' pos='" +
               text(Eigen::Vector3d(local.translation())) + "' axis='" + text(local.linear() * joint.axis) +
               "'/>";
      }
      xml += bodies_under(static_cast<int>(i)) + "</body>";
    }
    return xml;
  }

  static std::string name(const Joint& joint) { return "joint" + std::to_string(joint.first_speed); }

  template <class Visit>
  void each_joint(Visit visit) const {
    for (const Link& link : tree_.links) {
      for (const Joint& joint : link.joints) {
        const int id = mj_name2id(model_.get(), mjOBJ_JOINT, name(joint).c_str());
        visit(joint, model_->jnt_qposadr[id], model_->jnt_dofadr[id], frame_.at(joint.first_speed));
      }
    }
  }

  void set(const JointMotion& motion) {
    mj_resetData(model_.get(), data_.get());
    each_joint([&](const Joint& joint, int position, int speed, const Eigen::Matrix3d& frame) {
      if (joint.kind != Joint::Kind::ball) {
        data_->qpos[position] = motion.position[joint.first_position];
        data_->qvel[speed] = motion.speed[joint.first_speed];
        data_->qacc[speed] = motion.rate[joint.first_speed];
        return;
      }
      const Eigen::Vector3d v = frame * motion.position.segment<3>(joint.first_position);
      const Eigen::Vector3d w = frame * motion.speed.segment<3>(joint.first_speed);
      const Eigen::Vector3d wd = frame * motion.rate.segment<3>(joint.first_speed);
      data_->qpos[position] = motion.position[joint.first_position + 3];
      for (int i = 0; i < 3; ++i) {
        data_->qpos[position + 1 + i] = v[i];
        data_->qvel[speed + i] = w[i];
        data_->qacc[speed + i] = wd[i];
      }
    });
  }

  /// MuJoCo's order and axes of speeds to ours.
  Eigen::VectorXd to_joints(const Eigen::VectorXd& forces) const {
    Eigen::VectorXd result(tree_.speeds);
    each_joint([&](const Joint& joint, int, int speed, const Eigen::Matrix3d& frame) {
      if (joint.kind == Joint::Kind::ball) {
        result.segment<3>(joint.first_speed) = frame.transpose() * forces.segment<3>(speed);
      } else {
        result[joint.first_speed] = forces[speed];
      }
    });
    return result;
  }

  const JointTree& tree_;
  std::map<int, Eigen::Matrix3d> frame_;  // by a joint's first speed: its axes in the body's
  std::unique_ptr<mjModel, Deleter> model_;
  std::unique_ptr<mjData, Deleter> data_;
};

}  // namespace

std::unique_ptr<EngineModel> make_mujoco(const JointTree& tree) {
  return std::make_unique<MujocoModel>(tree);
}

}  // namespace alembert::oracles
