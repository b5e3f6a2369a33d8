// A mechanism as multibody engines can take it: rigid links, and between them fixed poses and joints about
// one axis, along one axis or spherical. A joint's position may be any function of coordinates and time: with
// joint positions phi(q, t), engines work in phi and  tau = J^T tau_phi,  M = J^T M_phi J,  J = dphi/du.
// Frames on curves and surfaces and matrices that vary are not joints, and such mechanisms are not
// expressible.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "oracles/state.hpp"

namespace alembert::oracles {

/// An engine, or engines as such, have no words for a mechanism; says why.
struct NotExpressible : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Joint {
  enum class Kind { revolute, prismatic, ball };
  Kind kind;
  Eigen::Isometry3d before;  ///< from the previous joint (or the parent link) to this one
  Eigen::Vector3d axis;      ///< of length 1
  Expression position;       ///< angle or distance, unless a ball
  int first_q = 0;           ///< of a ball: its quaternion
  int first_position = 0, first_speed = 0;

  int positions() const { return kind == Kind::ball ? 4 : 1; }
  int speeds() const { return kind == Kind::ball ? 3 : 1; }
};

/// A body with mass, and the joints from its nearest ancestor with mass. Joints of massless bodies are given
/// to each of their children.
struct Link {
  std::string name;
  int parent = -1;  ///< index of an earlier link; -1: the world
  std::vector<Joint> joints;
  Eigen::Isometry3d after;  ///< from the last joint to the link
  double mass = 0;
  Eigen::Vector3d com;      ///< in the link
  Eigen::Matrix3d inertia;  ///< about the centre of mass
};

/// Motion of all joints. A ball has the position x y z w and the angular velocity in the child's axes.
struct JointMotion {
  Eigen::VectorXd position, speed, rate;
};

/// By link; zero where nothing acts.
struct LinkWrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< at the centre of mass, world axes
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();  ///< world axes
};

struct JointTree {
  explicit JointTree(const Description& description);  ///< throws NotExpressible

  JointMotion motion(const State& state, bool with_rates) const;
  Eigen::MatrixXd jacobian(const State& state) const;  ///< speeds of joints by speeds of the mechanism
  std::vector<LinkWrench> wrenches(const State& state) const;

  Description description;
  Eigen::Vector3d gravity;
  std::vector<Link> links;  ///< parents first
  int positions = 0, speeds = 0;
};

}  // namespace alembert::oracles
