// `alembert import` of SDF against libsdformat, which works out poses, names and axes of the same file, and DART, which
// has the dynamics: tau, M and c at random states; of closed chains, the directions that their constraints lock.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <dart/dynamics/BallJoint.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/PrismaticJoint.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <dart/dynamics/ScrewJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/UniversalJoint.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <filesystem>
#include <fstream>
#include <ignition/math/Capsule.hh>
#include <ignition/math/Cylinder.hh>
#include <ignition/math/Ellipsoid.hh>
#include <ignition/math/Inertial.hh>
#include <ignition/math/Sphere.hh>
#include <iterator>
#include <map>
#include <numbers>
#include <random>
#include <regex>
#include <sdf/sdf.hh>
#include <set>
#include <string>

#include "oracles/alembert_process.hpp"
#include "oracles/dart_motion.hpp"
#include "oracles/engines/silence.hpp"

namespace alembert::oracles {
namespace {

namespace dd = dart::dynamics;
namespace fs = std::filesystem;
using Eigen::Isometry3d, Eigen::Vector3d;

constexpr double kTolerance = 1e-9;
constexpr int kStates = 10;
constexpr double kFrictionWidth = 0.01;

/// Mass properties that this version of libsdformat does not work out, by link.
using Inertias = std::map<std::string, ignition::math::Inertiald>;

struct Case {
  std::string name;
  std::map<std::string, Follows> follows = {};
  Inertias (*inertias)() = nullptr;
  std::set<std::string> cuts = {};  ///< joints that close chains
};

Isometry3d pose_of(const ignition::math::Pose3d& pose) {
  Isometry3d out = Isometry3d::Identity();
  out.translation() = Vector3d(pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z());
  out.linear() =
      Eigen::Quaterniond(pose.Rot().W(), pose.Rot().X(), pose.Rot().Y(), pose.Rot().Z()).toRotationMatrix();
  return out;
}

Vector3d vector_of(const ignition::math::Vector3d& v) {
  return {v.X(), v.Y(), v.Z()};
}

dd::Inertia inertia_of(const ignition::math::Inertiald& inertial) {
  const ignition::math::Matrix3d moi = inertial.Moi();  // in the axes of the link
  Eigen::Matrix3d I;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      I(row, column) = moi(static_cast<std::size_t>(row), static_cast<std::size_t>(column));
  return {inertial.MassMatrix().Mass(), vector_of(inertial.Pose().Pos()), I};
}

void require(const sdf::Errors& errors) {
  if (!errors.empty()) throw std::runtime_error(errors[0].Message());
}

struct LoadedLink {
  std::string name;
  Isometry3d world;
  dd::Inertia inertia{0, Vector3d::Zero(), Eigen::Matrix3d::Zero()};
  bool fixed = false, gravity = true;
};

struct LoadedAxis {
  Vector3d xyz;
  double damping, friction, stiffness, rest;
};

struct LoadedJoint {
  std::string name, parent, child;  ///< of links, `world` for what stands still
  sdf::JointType type;
  Isometry3d world;
  std::vector<LoadedAxis> axes;
  double pitch;  ///< metres a turn
};

/// What libsdformat makes of a file, in the world at the beginning.
class LoadedFile {
 public:
  explicit LoadedFile(const fs::path& path) {
    const Silence silence;
    sdf::ParserConfig config;
    config.SetFindCallback([&](const std::string& uri) {
      std::string rest = std::regex_replace(uri, std::regex("^model://"), "");
      return (path.parent_path() / rest).string();
    });
    for (const sdf::Error& error : root_.LoadSdfString(as_it_knows(path), config))
      if (error.Code() != sdf::ErrorCode::LINK_INERTIA_INVALID) throw std::runtime_error(error.Message());
    if (root_.WorldCount() > 0) {
      const sdf::World& world = *root_.WorldByIndex(0);
      gravity = vector_of(world.Gravity());
      std::size_t moving = 0;
      for (std::size_t i = 0; i < world.ModelCount(); ++i) moving += world.ModelByIndex(i)->Static() ? 0 : 1;
      for (std::size_t i = 0; i < world.ModelCount(); ++i) {
        const sdf::Model& model = *world.ModelByIndex(i);
        ignition::math::Pose3d pose;
        require(model.SemanticPose().Resolve(pose));
        read(model, pose_of(pose), moving == 1 && !model.Static() ? "" : model.Name() + "::", false);
      }
    } else {
      const sdf::Model& model = *root_.Model();
      Isometry3d pose = pose_of(model.RawPose());
      if (!model.PlacementFrameName().empty()) {
        const sdf::Frame* frame = model.FrameByName(model.PlacementFrameName());
        ignition::math::Pose3d in_model;
        require(frame->SemanticPose().Resolve(in_model, "__model__"));
        pose = pose * pose_of(in_model).inverse();
      }
      read(model, pose, "", false);
    }
  }

  void set(const Inertias& inertias) {
    for (LoadedLink& link : links)
      if (const auto found = inertias.find(link.name); found != inertias.end())
        link.inertia = inertia_of(found->second);
  }

  std::vector<LoadedLink> links;
  std::vector<LoadedJoint> joints;
  Vector3d gravity{0, 0, -9.81};

 private:
  /// This version of the library knows 1.9 and the older way to say what the thread of a screw is.
  static std::string as_it_knows(const fs::path& path) {
    std::ifstream file(path);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    std::string out = std::regex_replace(text, std::regex("version=\"1\\.1[0-9]\""), "version=\"1.9\"");
    // Gazebo's own scenery is not on this machine.
    out = std::regex_replace(
        out, std::regex("<include>\\s*<uri>model://(sun|ground_plane)</uri>\\s*</include>"), "");
    const std::regex pitch("<screw_thread_pitch>([^<]*)</screw_thread_pitch>");
    for (std::smatch found; std::regex_search(out, found, pitch);) {
      std::ostringstream older;
      older.precision(17);
      older << "<thread_pitch>" << -2 * std::numbers::pi / std::stod(found[1]) << "</thread_pitch>";
      out = found.prefix().str() + older.str() + found.suffix().str();
    }
    return out;
  }

  void read(const sdf::Model& model, const Isometry3d& world, const std::string& prefix, bool within_static) {
    const bool fixed = within_static || model.Static();
    for (std::size_t i = 0; i < model.LinkCount(); ++i) {
      const sdf::Link& link = *model.LinkByIndex(i);
      ignition::math::Pose3d pose;
      require(link.SemanticPose().Resolve(pose, "__model__"));
      LoadedLink out;
      out.name = prefix + link.Name();
      out.world = world * pose_of(pose);
      out.fixed = fixed;
      if (link.Element()->HasElement("gravity")) out.gravity = link.Element()->Get<bool>("gravity");
      out.inertia = inertia_of(link.Inertial());
      links.push_back(out);
    }
    for (std::size_t i = 0; i < model.ModelCount(); ++i) {
      const sdf::Model& inner = *model.ModelByIndex(i);
      ignition::math::Pose3d pose;
      require(inner.SemanticPose().Resolve(pose, "__model__"));
      read(inner, world * pose_of(pose), prefix + inner.Name() + "::", fixed);
    }
    for (std::size_t i = 0; i < model.JointCount(); ++i) read(*model.JointByIndex(i), world, prefix);
  }

  void read(const sdf::Joint& joint, const Isometry3d& world, const std::string& prefix) {
    if (joint.Type() == sdf::JointType::GEARBOX) return;
    LoadedJoint out;
    out.name = prefix + joint.Name();
    out.type = joint.Type();
    require(joint.ResolveParentLink(out.parent));
    require(joint.ResolveChildLink(out.child));
    for (std::string* name : {&out.parent, &out.child})
      if (*name != "world") *name = prefix + *name;
    ignition::math::Pose3d pose;
    require(joint.SemanticPose().Resolve(pose, "__model__"));
    out.world = world * pose_of(pose);
    out.pitch = -2 * std::numbers::pi / joint.ThreadPitch();
    for (unsigned a = 0; a < 2; ++a) {
      const sdf::JointAxis* axis = joint.Axis(a);
      if (axis == nullptr) continue;
      ignition::math::Vector3d xyz;
      require(axis->ResolveXyz(xyz));
      out.axes.push_back({vector_of(xyz).normalized(), axis->Damping(), axis->Friction(),
                          axis->SpringStiffness(), axis->SpringReference()});
    }
    joints.push_back(out);
  }

  sdf::Root root_;
};

std::string our_name(const std::string& name) {
  return std::regex_replace(name, std::regex("[^A-Za-z0-9]+"), "_");
}

/// The tree in DART: joints in the order of the file, as soon as their parent is there, but for those that are cut.
class Skeleton {
 public:
  Skeleton(const LoadedFile& file, const Case& which) : file_(file), which_(which) {
    const Silence silence;
    skeleton_->setGravity(file.gravity);
    std::map<std::string, bool> is_child;
    for (const LoadedJoint& joint : file.joints) is_child[joint.child] = true;
    std::vector<bool> used(file.joints.size(), false);
    for (std::size_t j = 0; j < used.size(); ++j) used[j] = which.cuts.count(file.joints[j].name) > 0;
    const auto is_there = [&](const std::string& link) {
      return link == "world" || find(link).fixed || nodes_.count(link) > 0;
    };
    const auto grow = [&] {
      for (bool more = true; more;) {
        more = false;
        for (std::size_t j = 0; j < file.joints.size() && !more; ++j) {
          const LoadedJoint& joint = file.joints[j];
          if (used[j] || !is_there(joint.parent) || is_there(joint.child)) continue;
          used[j] = more = true;
          add(joint, false);
        }
        // From the child to the parent, where nothing else leads there.
        for (std::size_t j = 0; j < file.joints.size() && !more; ++j) {
          const LoadedJoint& joint = file.joints[j];
          if (used[j] || !is_there(joint.child) || is_there(joint.parent)) continue;
          used[j] = more = true;
          add(joint, true);
        }
      }
    };
    grow();
    for (const LoadedLink& link : file.links) {
      if (is_there(link.name) || is_child[link.name]) continue;
      const auto [joint, body] = skeleton_->createJointAndBodyNodePair<dd::FreeJoint>();
      nodes_[link.name] = body;
      joints_.push_back({joint, link.name, nullptr});
      finish(*body, link);
      grow();
    }
    for (const LoadedJoint& joint : file.joints)
      if (which.cuts.count(joint.name) > 0) cuts_.push_back(&joint);
  }

  DartMotion at(const Description& ours, const State& state) const {
    const auto n = static_cast<Eigen::Index>(skeleton_->getNumDofs());
    DartMotion motion{Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n), Eigen::MatrixXd::Zero(n, ours.nv)};
    for (const Entry& entry : joints_) {
      if (entry.joint->getNumDofs() == 0) continue;
      const auto at = static_cast<Eigen::Index>(entry.joint->getIndexInSkeleton(0));
      const std::string name = our_name(entry.name);
      if (entry.loaded == nullptr) {
        add_free(motion, ours, state, name, at);
      } else if (entry.loaded->type == sdf::JointType::BALL) {
        const Coordinate& r = coordinate_called(ours, name);
        const double* q = state.q.data() + r.first_q;
        motion.position.segment<3>(at) =
            dd::BallJoint::convertToPositions(Eigen::Quaterniond(q[3], q[0], q[1], q[2]).toRotationMatrix());
        motion.J.block<3, 3>(at, r.first_speed).setIdentity();
      } else {
        const std::size_t axes = entry.loaded->axes.size();
        for (std::size_t a = 0; a < axes; ++a)
          add_single(motion, ours, state, which_.follows,
                     axes == 1 ? name : name + "_" + std::to_string(a + 1),
                     at + static_cast<Eigen::Index>(a));
      }
    }
    return motion;
  }

  Dynamics dynamics(const DartMotion& motion, const State& state) const {
    const auto nv = motion.J.cols();
    const Eigen::Map<const Eigen::VectorXd> speeds(state.speeds.data(), nv), rates(state.rates.data(), nv);
    skeleton_->setPositions(motion.position);
    skeleton_->setVelocities(motion.J * speeds);
    const Eigen::VectorXd resisting = resistance();
    const auto forces = [&](const Eigen::VectorXd& acceleration) -> Eigen::VectorXd {
      skeleton_->setAccelerations(motion.J * acceleration + motion.bias);
      skeleton_->computeInverseDynamics();
      return motion.J.transpose() * (skeleton_->getForces() + resisting + resistance_of_cuts());
    };
    Dynamics out;
    out.tau = forces(rates);
    out.bias = forces(Eigen::VectorXd::Zero(nv));
    out.mass_matrix = motion.J.transpose() * skeleton_->getMassMatrix() * motion.J;
    return out;
  }

  /// Motions that the joints which close chains lock, by our speeds.
  Eigen::MatrixXd locked(const DartMotion& motion) const {
    skeleton_->setPositions(motion.position);
    std::vector<Eigen::RowVectorXd> rows;
    for (const LoadedJoint* cut : cuts_) {
      const Eigen::MatrixXd between = jacobian(cut->child, *cut) - jacobian(cut->parent, *cut);
      const Eigen::Matrix3d R = cut->world.linear();
      std::vector<Vector3d> angular, linear;
      const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
      const auto across = [&](const Vector3d& axis) {
        const Vector3d u = axis.unitOrthogonal();
        return std::vector<Vector3d>{u, axis.cross(u)};
      };
      const std::vector<Vector3d> all{axes.col(0), axes.col(1), axes.col(2)};
      linear = all;
      if (cut->type == sdf::JointType::FIXED) angular = all;
      if (cut->type == sdf::JointType::REVOLUTE || cut->type == sdf::JointType::CONTINUOUS)
        angular = across(R * cut->axes[0].xyz);
      if (cut->type == sdf::JointType::PRISMATIC) {
        angular = all;
        linear = across(R * cut->axes[0].xyz);
      }
      if (cut->type == sdf::JointType::UNIVERSAL)
        angular = {(R * cut->axes[0].xyz).cross(R * cut->axes[1].xyz)};
      for (const Vector3d& v : angular) rows.push_back(v.transpose() * between.topRows(3));
      for (const Vector3d& v : linear) rows.push_back(v.transpose() * between.bottomRows(3));
    }
    Eigen::MatrixXd out(static_cast<Eigen::Index>(rows.size()), motion.J.cols());
    for (std::size_t i = 0; i < rows.size(); ++i) out.row(static_cast<Eigen::Index>(i)) = rows[i] * motion.J;
    return out;
  }
  bool has_loops() const { return !cuts_.empty(); }

 private:
  struct Entry {
    dd::Joint* joint;
    std::string name;
    const LoadedJoint* loaded;  ///< null: free
  };

  const LoadedLink& find(const std::string& name) const {
    return *std::find_if(file_.links.begin(), file_.links.end(),
                         [&](const LoadedLink& link) { return link.name == name; });
  }

  template <class Joint>
  std::pair<Joint*, dd::BodyNode*> create(dd::BodyNode* parent) {
    return skeleton_->createJointAndBodyNodePair<Joint>(parent);
  }

  void add(const LoadedJoint& joint, bool reversed) {
    const std::string &from = reversed ? joint.child : joint.parent,
                      &to = reversed ? joint.parent : joint.child;
    const bool from_world = from == "world" || find(from).fixed;
    dd::BodyNode* parent = from_world ? nullptr : nodes_.at(from);
    const Isometry3d parent_world = from_world ? Isometry3d::Identity() : find(from).world;
    const LoadedLink& child = find(to);
    const double sign = reversed ? -1 : 1;
    if (reversed && joint.axes.size() != 1)
      throw std::runtime_error("a reversed joint that the oracle does not have");
    dd::Joint* made = nullptr;
    dd::BodyNode* body = nullptr;
    switch (joint.type) {
      case sdf::JointType::REVOLUTE:
      case sdf::JointType::CONTINUOUS: {
        const auto [j, b] = create<dd::RevoluteJoint>(parent);
        j->setAxis(sign * joint.axes[0].xyz);
        made = j, body = b;
        break;
      }
      case sdf::JointType::PRISMATIC: {
        const auto [j, b] = create<dd::PrismaticJoint>(parent);
        j->setAxis(sign * joint.axes[0].xyz);
        made = j, body = b;
        break;
      }
      case sdf::JointType::SCREW: {
        const auto [j, b] = create<dd::ScrewJoint>(parent);
        j->setAxis(sign * joint.axes[0].xyz);
        j->setPitch(joint.pitch);
        made = j, body = b;
        break;
      }
      case sdf::JointType::UNIVERSAL:
      case sdf::JointType::REVOLUTE2: {
        const auto [j, b] = create<dd::UniversalJoint>(parent);
        j->setAxis1(joint.axes[0].xyz);
        j->setAxis2(joint.axes[1].xyz);
        made = j, body = b;
        break;
      }
      case sdf::JointType::BALL: {
        const auto [j, b] = create<dd::BallJoint>(parent);
        made = j, body = b;
        break;
      }
      case sdf::JointType::FIXED: {
        const auto [j, b] = create<dd::WeldJoint>(parent);
        made = j, body = b;
        break;
      }
      case sdf::JointType::GEARBOX:
      case sdf::JointType::INVALID:
        throw std::runtime_error("a joint that the oracle does not have");
    }
    made->setTransformFromParentBodyNode(parent_world.inverse() * joint.world);
    made->setTransformFromChildBodyNode(child.world.inverse() * joint.world);
    nodes_[to] = body;
    joints_.push_back({made, joint.name, &joint});
    finish(*body, child);
  }

  static void finish(dd::BodyNode& body, const LoadedLink& link) {
    body.setInertia(link.inertia);
    body.setGravityMode(link.gravity);
  }

  Eigen::VectorXd resistance() const {
    Eigen::VectorXd out = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(skeleton_->getNumDofs()));
    for (const Entry& entry : joints_) {
      if (entry.loaded == nullptr) continue;
      for (std::size_t a = 0; a < entry.loaded->axes.size(); ++a) {
        const LoadedAxis& axis = entry.loaded->axes[a];
        const double u = entry.joint->getVelocity(a), q = entry.joint->getPosition(a);
        out[static_cast<Eigen::Index>(entry.joint->getIndexInSkeleton(a))] =
            axis.damping * u + axis.friction * std::tanh(u / kFrictionWidth) +
            axis.stiffness * (q - axis.rest);
      }
    }
    return out;
  }

  /// Jacobian of a point of a link that lies at the joint in the beginning, angular first.
  Eigen::MatrixXd jacobian(const std::string& link, const LoadedJoint& joint) const {
    if (link == "world" || find(link).fixed)
      return Eigen::MatrixXd::Zero(6, static_cast<Eigen::Index>(skeleton_->getNumDofs()));
    const Vector3d offset = find(link).world.inverse() * joint.world.translation();
    return skeleton_->getWorldJacobian(nodes_.at(link), offset);
  }
  /// The joint's axis as the link carries it.
  Vector3d carried_axis(const std::string& link, const LoadedJoint& joint) const {
    const Vector3d axis = joint.world.linear() * joint.axes[0].xyz;
    if (link == "world" || find(link).fixed) return axis;
    return nodes_.at(link)->getWorldTransform().linear() * find(link).world.linear().transpose() * axis;
  }

  /// Along the axes of hinges and slides that close chains.
  Eigen::VectorXd resistance_of_cuts() const {
    Eigen::VectorXd out = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(skeleton_->getNumDofs()));
    for (const LoadedJoint* cut : cuts_) {
      if (cut->axes.size() != 1) continue;
      const Eigen::Index first = cut->type == sdf::JointType::PRISMATIC ? 3 : 0;
      const Eigen::MatrixXd child = jacobian(cut->child, *cut).middleRows(first, 3),
                            parent = jacobian(cut->parent, *cut).middleRows(first, 3);
      const Vector3d ends[] = {carried_axis(cut->parent, *cut), carried_axis(cut->child, *cut)};
      const double rate = ends[0].dot((child - parent) * skeleton_->getVelocities());
      const double force =
          cut->axes[0].damping * rate + cut->axes[0].friction * std::tanh(rate / kFrictionWidth);
      out += force * (child.transpose() * ends[1] - parent.transpose() * ends[0]);
    }
    return out;
  }

  const LoadedFile& file_;
  const Case& which_;
  dd::SkeletonPtr skeleton_ = dd::Skeleton::create();
  std::map<std::string, dd::BodyNode*> nodes_;
  std::vector<Entry> joints_;
  std::vector<const LoadedJoint*> cuts_;
};

/// Files of the tests, and those of Debian's dart-doc where it is installed.
fs::path path_of(const Case& which) {
  if (which.name[0] == '/') return which.name;
  return fs::path(ALEMBERT_SOURCE_DIR) / "tests/sdf/models" / which.name;
}

class Sdf : public testing::TestWithParam<Case> {};

TEST_P(Sdf, GivesTheDynamicsOfDart) {
  const Case& which = GetParam();
  const fs::path path = path_of(which);
  if (!fs::exists(path)) GTEST_SKIP() << "documents of packages are not installed here";
  const fs::path description = fs::temp_directory_path() / ("alembert_sdf_" + path.stem().string() + ".yaml");
  const oracles::Run run =
      run_alembert(ALEMBERT_EXECUTABLE, {"import", path.string(), "--out", description.string()}, "");
  ASSERT_EQ(run.status, 0) << run.err;
  const Description ours = read_description(description.string());
  LoadedFile file(path);
  if (which.inertias != nullptr) file.set(which.inertias());
  const Skeleton theirs(file, which);
  std::mt19937_64 random(12);
  std::vector<State> states;
  for (int i = 0; i < kStates; ++i) {
    states.push_back(random_state(ours, random));
    states.back().time = 0;
  }
  const std::vector<Answer> answers = ask_alembert(ALEMBERT_EXECUTABLE, description.string(), states, "auto");
  double worst = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Dynamics expected = theirs.dynamics(theirs.at(ours, states[i]), states[i]);
    const Dynamics& found = answers[i].dynamics;
    for (const double error :
         {relative_error(found.tau, expected.tau), relative_error(found.bias, expected.bias),
          relative_error(found.mass_matrix, expected.mass_matrix)}) {
      EXPECT_LE(error, kTolerance);
      worst = std::max(worst, error);
    }
  }
  std::ostringstream shown;
  shown << worst;
  RecordProperty("worst_error", shown.str());
  if (theirs.has_loops()) {
    // Where the chains are closed, and at rest: at the beginning.
    State start = states[0];
    std::fill(start.speeds.begin(), start.speeds.end(), 0.0);
    std::fill(start.rates.begin(), start.rates.end(), 0.0);
    for (const Coordinate& c : ours.coordinates)
      for (std::size_t k = 0; k < c.initial.size(); ++k)
        start.q[static_cast<std::size_t>(c.first_q) + k] = c.initial[k];
    const Answer answer = ask_alembert(ALEMBERT_EXECUTABLE, description.string(), {start}, "auto")[0];
    const Eigen::MatrixXd expected = theirs.locked(theirs.at(ours, start));
    const Eigen::MatrixXd& P = answer.rows.P;
    const auto rank = [](const Eigen::MatrixXd& m) {
      Eigen::JacobiSVD<Eigen::MatrixXd> svd(m);
      svd.setThreshold(1e-9);
      return svd.rank();
    };
    Eigen::MatrixXd both(P.rows() + expected.rows(), P.cols());
    both << P, expected;
    EXPECT_GT(rank(expected), 0);
    EXPECT_EQ(rank(P), rank(expected)) << P << "\n\n" << expected;
    EXPECT_EQ(rank(both), rank(expected)) << P << "\n\n" << expected;
  }
  fs::remove(description);
}

/// What the shapes of inertia.sdf weigh.
Inertias inertias_of_shapes() {
  namespace im = ignition::math;
  const auto at = [](const im::MassMatrix3d& mass, const im::Pose3d& pose) {
    return im::Inertiald(mass, pose);
  };
  const auto mass_of = [](const auto& shape) {
    im::MassMatrix3d out;
    if (!shape.MassMatrix(out)) throw std::runtime_error("no mass of a shape");
    return out;
  };
  const auto box = [](double density, const im::Vector3d& size) {
    return im::MassMatrix3d(
        density * size.X() * size.Y() * size.Z(),
        density * size.X() * size.Y() * size.Z() / 12 *
            im::Vector3d(size.Y() * size.Y() + size.Z() * size.Z(), size.X() * size.X() + size.Z() * size.Z(),
                         size.X() * size.X() + size.Y() * size.Y()),
        im::Vector3d::Zero);
  };
  im::Cylinderd rod(0.4, 0.04, im::Material(500));
  const im::Inertiald solid =
      at(mass_of(rod), {0, 0, 0.2, 0, 0.1, 0}) +
      at(mass_of(im::Sphered(0.06, im::Material(800))), {0.1, 0, 0, 0, 0, 0}) +
      at(box(500, {0.1, 0.2, 0.3}), {0, 0.2, 0, 0.3, 0, 0}) +
      at(*im::Ellipsoidd({0.1, 0.05, 0.03}, im::Material(500)).MassMatrix(), {0, -0.2, 0, 0, 0, 0.4});
  im::Inertiald weighed =
      at(*im::Capsuled(0.4, 0.04, im::Material(1000)).MassMatrix(), {0, 0, 0.2, 0, 0.1, 0}) +
      at(box(1000, {0.1, 0.2, 0.3}), {0.35, 0.1, 0.15, 0, 0, 0});
  im::MassMatrix3d scaled = weighed.MassMatrix();
  const double factor = 2 / scaled.Mass();
  scaled.SetMass(2);
  scaled.SetDiagonalMoments(factor * scaled.DiagonalMoments());
  scaled.SetOffDiagonalMoments(factor * scaled.OffDiagonalMoments());
  return {{"solid", solid},
          {"weighed", {scaled, weighed.Pose()}},
          {"bare", {{0, im::Vector3d::Zero, im::Vector3d::Zero}, im::Pose3d::Zero}}};
}

const std::string kDartData = "/usr/share/doc/dart/data/sdf/";

INSTANTIATE_TEST_SUITE_P(
    Files, Sdf,
    testing::Values(Case{"joints.sdf"}, Case{"old.sdf"}, Case{"middle.sdf"}, Case{"merged.sdf"},
                    Case{"names_of_joints.sdf"},
                    Case{"frames.sdf", {{"hand_curl", {"hand_grip", -1.5, 0.35}}}},
                    Case{"gears.sdf", {{"out", {"in", 2.5, 0}}}},
                    Case{"loops.sdf", {}, nullptr, {"d", "e", "i", "pq", "sr"}},
                    Case{"inertia.sdf", {}, inertias_of_shapes}, Case{kDartData + "double_pendulum.world"},
                    Case{kDartData + "double_pendulum_with_base.world"}, Case{kDartData + "quad.sdf"},
                    Case{kDartData + "atlas/atlas_v3_no_head.sdf"},
                    Case{kDartData + "test/issue1193_revolute_with_offset_test.sdf"},
                    Case{kDartData + "test/test_skeleton_joint.world"}),
    [](const auto& test) {
      return std::regex_replace(fs::path(test.param.name).stem().string(), std::regex("[^A-Za-z0-9]"), "_");
    });

}  // namespace
}  // namespace alembert::oracles
