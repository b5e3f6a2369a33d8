// What stands on the diagonal of the inverse of a symmetric positive definite matrix.
#pragma once

#include <Eigen/Core>
#include <optional>

namespace alembert {

/// The diagonal of A^-1, by A = L L^T.
/// \param A  n x n, symmetric
/// \return   nothing where A is not positive definite, or not finite
std::optional<Eigen::VectorXd> inverse_diagonal(const Eigen::MatrixXd& A);

}  // namespace alembert
