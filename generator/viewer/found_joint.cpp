// Joints as the motion shows them (looks.hpp).
#include "viewer/found_joint.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "viewer/looks.hpp"

namespace alembert {

namespace {

using Eigen::Vector3d;

/// Turns of less than this, in rad, count as none.
constexpr double kRank = 1e-5;
/// Errors relative to the mechanism's size.
constexpr double kError = 1e-6;

/// The straight line, if it is one, that the body's origin runs along in the parent while the body does not
/// turn.
FoundJoint find_slide(std::span<const Eigen::Isometry3d> poses, double size) {
  FoundJoint joint;
  Vector3d mean = Vector3d::Zero();
  for (const auto& pose : poses) {
    if ((pose.linear() - poses[0].linear()).norm() > kRank) return joint;
    mean += pose.translation() / static_cast<double>(poses.size());
  }
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const auto& pose : poses)
    covariance += (pose.translation() - mean) * (pose.translation() - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Vector3d direction = solver.eigenvectors().col(2);
  double from = 0, to = 0;
  for (const auto& pose : poses) {
    const Vector3d d = pose.translation() - mean;
    const double along = d.dot(direction);
    if ((d - along * direction).norm() > kError * size) return joint;
    from = std::min(from, along);
    to = std::max(to, along);
  }
  joint.kind = FoundJoint::Kind::slide;
  joint.in_parent = mean + from * direction;
  joint.end = mean + to * direction;
  joint.axis = poses[0].linear().transpose() * direction;
  return joint;
}

}  // namespace

FoundJoint find_joint(std::span<const Eigen::Isometry3d> poses, double size) {
  // The point p of the body and c of the parent with R_k p + t_k = c in all poses, by least squares: c is the mean.
  const double count = static_cast<double>(poses.size());
  Eigen::Matrix3d mean_turn = Eigen::Matrix3d::Zero();
  Vector3d mean_place = Vector3d::Zero();
  for (const auto& pose : poses) {
    mean_turn += pose.linear() / count;
    mean_place += pose.translation() / count;
  }
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Vector3d right = Vector3d::Zero();
  for (const auto& pose : poses) {
    const Eigen::Matrix3d turn = pose.linear() - mean_turn;
    squares += turn.transpose() * turn;
    right -= turn.transpose() * (pose.translation() - mean_place);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares);
  int rank = 0;
  Vector3d in_body = Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    if (!(solver.eigenvalues()(k) > kRank * kRank * count)) continue;
    ++rank;
    const Vector3d direction = solver.eigenvectors().col(k);
    in_body += direction.dot(right) / solver.eigenvalues()(k) * direction;
  }
  const Vector3d in_parent = mean_turn * in_body + mean_place;
  for (const auto& pose : poses)
    if (!((pose * in_body - in_parent).cwiseAbs().maxCoeff() <= kError * size))
      return find_slide(poses, size);
  FoundJoint joint;
  joint.kind = FoundJoint::Kind::fixed;
  if (rank == 3) joint.kind = FoundJoint::Kind::point;
  if (rank == 2) {
    joint.kind = FoundJoint::Kind::axis;
    joint.axis = solver.eigenvectors().col(0);
  }
  if (rank >= 2) joint.in_body = in_body;
  joint.in_parent = poses[0] * joint.in_body;
  return joint;
}

}  // namespace alembert
