// The diagonal of an inverse (see the header).
#include "support/inverse_diagonal.hpp"

#include <Eigen/Cholesky>

namespace alembert {

std::optional<Eigen::VectorXd> inverse_diagonal(const Eigen::MatrixXd& A) {
  const Eigen::LLT<Eigen::MatrixXd> factor(A);
  if (!A.allFinite() || factor.info() != Eigen::Success) return std::nullopt;
  // A^-1 = B^T B with B = L^-1.
  const Eigen::MatrixXd B = factor.matrixL().solve(Eigen::MatrixXd::Identity(A.rows(), A.cols()));
  return Eigen::VectorXd(B.colwise().squaredNorm().transpose());
}

}  // namespace alembert
