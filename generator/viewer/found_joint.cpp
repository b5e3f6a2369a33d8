// Joints as the motion shows them (looks.hpp).
#include "viewer/found_joint.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "viewer/looks.hpp"

namespace alembert {

namespace {

using Eigen::Index;
using Eigen::Vector3d;

/// Rank is judged relative to the largest singular value: turns of less than this count as none.
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
  const Index n = static_cast<Index>(poses.size());
  Eigen::MatrixXd A(3 * n, 6);
  Eigen::VectorXd b(3 * n);
  for (Index k = 0; k < n; ++k) {
    const auto& pose = poses[static_cast<std::size_t>(k)];
    A.block<3, 3>(3 * k, 0) = pose.linear();
    A.block<3, 3>(3 * k, 3) = -Eigen::Matrix3d::Identity();
    b.segment<3>(3 * k) = -pose.translation();
  }
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeFullV);
  svd.setThreshold(kRank);
  const Eigen::VectorXd point = svd.solve(b);
  if (!((A * point - b).cwiseAbs().maxCoeff() <= kError * size)) return find_slide(poses, size);
  FoundJoint joint;
  joint.in_body = point.head<3>();
  switch (svd.rank()) {
    case 6:
      joint.kind = FoundJoint::Kind::point;
      break;
    case 5: {
      joint.kind = FoundJoint::Kind::axis;
      joint.axis = svd.matrixV().col(5).head<3>().normalized();
      joint.in_body -= joint.in_body.dot(joint.axis) * joint.axis;
      break;
    }
    default:
      joint.kind = FoundJoint::Kind::fixed;
      joint.in_body.setZero();
      break;
  }
  joint.in_parent = poses[0] * joint.in_body;
  return joint;
}

}  // namespace alembert
