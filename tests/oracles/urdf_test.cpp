// `alembert import` against DART, which reads URDF itself: the same file through both, dynamics at random
// states. (DART takes the axis of any planar joint for z.)
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstdlib>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/utils/urdf/DartLoader.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <regex>
#include <string>

#include "oracles/alembert_process.hpp"
#include "oracles/dart_motion.hpp"
#include "oracles/engines/silence.hpp"

namespace alembert::oracles {
namespace {

namespace dd = dart::dynamics;
namespace fs = std::filesystem;

constexpr double kTolerance = 1e-9;
constexpr int kStates = 10;

struct Case {
  std::string file;  ///< URDF; a folder that may be missing is that of Debian's dart-doc
  bool floating;
  std::map<std::string, Follows> follows;
};

const std::string kPackage = "/usr/share/doc/dart/data/";

/// DART refuses robots whose meshes it cannot find, and takes links without inertia for such of 1 kg unless
/// told.
dd::SkeletonPtr read_by_dart(const Case& which) {
  std::ifstream file(which.file);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::regex shapes("<(visual|collision)[ >][^]*?</(visual|collision)>");
  using Loader = dart::utils::DartLoader;
  const Silence silence;
  const dd::Inertia none(0, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero());
  Loader loader(Loader::Options(
      nullptr, which.floating ? Loader::RootJointType::FLOATING : Loader::RootJointType::FIXED, none));
  return loader.parseSkeletonString(std::regex_replace(text, shapes, ""), which.file);
}

class Correspondence {
 public:
  Correspondence(const Description& ours, const dd::SkeletonPtr& theirs, const Case& which)
      : ours_(ours), theirs_(theirs), which_(which) {}

  DartMotion at(const State& state) const {
    const auto n = static_cast<Eigen::Index>(theirs_->getNumDofs());
    DartMotion motion{Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n), Eigen::MatrixXd::Zero(n, ours_.nv)};
    for (std::size_t j = 0; j < theirs_->getNumJoints(); ++j) {
      const dd::Joint* joint = theirs_->getJoint(j);
      const auto dofs = joint->getNumDofs();
      if (dofs == 0) continue;
      const auto at = static_cast<Eigen::Index>(joint->getIndexInSkeleton(0));
      const std::string name = joint->getParentBodyNode() == nullptr && which_.floating
                                   ? joint->getChildBodyNode()->getName()
                                   : our_name(joint->getName());
      if (dofs == 1) {
        add_single(motion, ours_, state, which_.follows, name, at);
      } else if (dofs == 3) {
        for (Eigen::Index i = 0; i < 3; ++i)
          add_single(motion, ours_, state, which_.follows,
                     name + std::array{"_x", "_y", "_angle"}[static_cast<std::size_t>(i)], at + i);
      } else {
        add_free(motion, ours_, state, name, at);
      }
    }
    return motion;
  }

 private:
  static std::string our_name(const std::string& name) { return name.substr(name[0] == '/' ? 1 : 0); }

  const Description& ours_;
  const dd::SkeletonPtr& theirs_;
  const Case& which_;
};

Dynamics dynamics(const dd::SkeletonPtr& skeleton, const DartMotion& motion, const State& state) {
  const auto nv = motion.J.cols();
  const Eigen::Map<const Eigen::VectorXd> speeds(state.speeds.data(), nv), rates(state.rates.data(), nv);
  skeleton->setPositions(motion.position);
  skeleton->setVelocities(motion.J * speeds);
  const auto forces = [&](const Eigen::VectorXd& acceleration) -> Eigen::VectorXd {
    skeleton->setAccelerations(motion.J * acceleration + motion.bias);
    skeleton->computeInverseDynamics();
    return motion.J.transpose() * skeleton->getForces();
  };
  Dynamics out;
  out.tau = forces(rates);
  out.bias = forces(Eigen::VectorXd::Zero(nv));
  out.mass_matrix = motion.J.transpose() * skeleton->getMassMatrix() * motion.J;
  return out;
}

class Urdf : public testing::TestWithParam<Case> {};

TEST_P(Urdf, GivesTheDynamicsThatDartReads) {
  const Case& which = GetParam();
  if (which.file.rfind(kPackage, 0) == 0 && !fs::exists(which.file))
    GTEST_SKIP() << "documents of packages are not installed here";
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = test->name();
  for (char& c : name)
    if (c == '/') c = '_';
  const fs::path description = fs::temp_directory_path() / ("alembert_urdf_" + name + ".yaml");
  const std::string command = std::string(ALEMBERT_EXECUTABLE) + " import '" + which.file + "' --root " +
                              (which.floating ? "floating" : "fixed") + " --no-friction --out " +
                              description.string() + " 2>/dev/null";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const Description ours = read_description(description.string());
  const dd::SkeletonPtr theirs = read_by_dart(which);
  ASSERT_NE(theirs, nullptr);

  std::mt19937_64 random(11);
  std::vector<State> states;
  for (int i = 0; i < kStates; ++i) {
    states.push_back(random_state(ours, random));
    states.back().time = 0;
  }
  const std::vector<Answer> answers = ask_alembert(ALEMBERT_EXECUTABLE, description.string(), states, "auto");
  const Correspondence correspondence(ours, theirs, which);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Dynamics expected = dynamics(theirs, correspondence.at(states[i]), states[i]);
    const Dynamics& found = answers[i].dynamics;
    EXPECT_LE(relative_error(found.tau, expected.tau), kTolerance);
    EXPECT_LE(relative_error(found.mass_matrix, expected.mass_matrix), kTolerance);
    EXPECT_LE(relative_error(found.bias, expected.bias), kTolerance);
  }
  fs::remove(description);
}

const std::string kEveryJoint = ALEMBERT_SOURCE_DIR "/tests/urdf/robots/every_joint.urdf";
const std::string kDoubtful =
    ALEMBERT_SOURCE_DIR "/tests/urdf/doubtful/";  // with warnings, but as it is written
const std::map<std::string, Follows> kFollows = {{"right", {"left", -1.5, 0.01}},
                                                 {"curl", {"left", -30, 0.2}}};

INSTANTIATE_TEST_SUITE_P(Robots, Urdf,
                         testing::Values(Case{kEveryJoint, false, kFollows},
                                         Case{kEveryJoint, true, kFollows},
                                         Case{kDoubtful + "impossible_inertia.urdf", false, {}},
                                         Case{kDoubtful + "inertia_of_fixed.urdf", false, {}},
                                         Case{kDoubtful + "inertia_without_mass.urdf", false, {}},
                                         Case{kDoubtful + "axis_length.urdf", false, {}},
                                         Case{kDoubtful + "inertia_negative.urdf", false, {}},
                                         Case{kDoubtful + "zero_sizes.urdf", false, {}},
                                         Case{kDoubtful + "mimic_fixed.urdf", false, {}},
                                         Case{kDoubtful + "xacro_left.urdf", false, {}},
                                         Case{kPackage + "urdf/KR5/KR5 sixx R650.urdf", false, {}},
                                         Case{kPackage + "urdf/wam/wam.urdf", false, {}},
                                         Case{kPackage + "urdf/drchubo/drchubo.urdf", true, {}},
                                         Case{kPackage + "sdf/atlas/atlas_v3_no_head.urdf", true, {}}),
                         [](const auto& test) {
                           std::string name = fs::path(test.param.file).stem().string();
                           for (char& c : name)
                             if (c == ' ') c = '_';
                           return name + (test.param.floating ? "_floating" : "_fixed");
                         });

}  // namespace
}  // namespace alembert::oracles
