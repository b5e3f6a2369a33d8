// How DART's coordinates go with ours at one state.
#pragma once

#include <Eigen/Geometry>
#include <dart/dynamics/FreeJoint.hpp>
#include <map>
#include <stdexcept>
#include <string>

#include "oracles/description/description.hpp"
#include "oracles/state.hpp"

namespace alembert::oracles {

/// Of a mimicking joint, in terms of one that is not.
struct Follows {
  std::string joint;
  double multiplier, offset;
};

/// Positions, and speeds J u with rates J du/dt + bias.
struct DartMotion {
  Eigen::VectorXd position, bias;
  Eigen::MatrixXd J;
};

inline const Coordinate& coordinate_called(const Description& ours, const std::string& name) {
  for (const Coordinate& c : ours.coordinates)
    if (c.name == name) return c;
  throw std::runtime_error("no coordinate " + name);
}

inline void add_single(DartMotion& motion, const Description& ours, const State& state,
                       const std::map<std::string, Follows>& follows, const std::string& name,
                       Eigen::Index at) {
  const auto found = follows.find(name);
  const Follows of = found == follows.end() ? Follows{name, 1, 0} : found->second;
  const Coordinate& c = coordinate_called(ours, of.joint);
  motion.position[at] = of.multiplier * state.q[static_cast<std::size_t>(c.first_q)] + of.offset;
  motion.J(at, c.first_speed) = of.multiplier;
}

/// DART: the twist in the body's axes, angular first. Ours: the velocity in the parent's axes, the angular velocity in
/// the body's.
inline void add_free(DartMotion& motion, const Description& ours, const State& state, const std::string& name,
                     Eigen::Index at) {
  const Coordinate &x = coordinate_called(ours, name + "_x"),
                   &r = coordinate_called(ours, name + "_rotation");
  const double* q = state.q.data() + r.first_q;
  const Eigen::Matrix3d R = Eigen::Quaterniond(q[3], q[0], q[1], q[2]).toRotationMatrix();
  const Eigen::Map<const Eigen::Vector3d> p(state.q.data() + x.first_q),
      v(state.speeds.data() + x.first_speed), w(state.speeds.data() + r.first_speed);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = R;
  pose.translation() = p;
  motion.position.segment<6>(at) = dart::dynamics::FreeJoint::convertToPositions(pose);
  motion.J.block<3, 3>(at, r.first_speed).setIdentity();
  motion.J.block<3, 3>(at + 3, x.first_speed) = R.transpose();
  motion.bias.segment<3>(at + 3) = -w.cross(R.transpose() * v);
}

}  // namespace alembert::oracles
