// Forward dynamics: accelerations from forces. In: a mechanism's M and c, and generalized forces. Out: the
// rates of the speeds, or a status that says why there are none; never a NaN passed off as a result, not even
// under -ffast-math. No heap unless M is a HeapMatrix (matrix.hpp), no exceptions.
#pragma once

#include <cmath>
#include <limits>

#include "alembert/articulated_solver.hpp"
#include "alembert/axis_state.hpp"
#include "alembert/branch_solver.hpp"
#include "alembert/mechanism.hpp"
#include "alembert/status.hpp"

namespace alembert {

namespace detail {

inline constexpr int kLargestByRows = 12;  // measured: from here on columns are faster

}  // namespace detail

/// Factors a symmetric matrix in place, A = L D L^T.
///
/// \param A  n x n, of fixed or dynamic size; only the lower triangle is read. On success it holds L below
///           the diagonal (its diagonal is 1) and D on the diagonal.
/// \return   not_finite or not_positive_definite if a pivot is not finite, or not above n * epsilon * A_ii:
///           below that, cancellation has left no correct digit in it. A is spoilt then.
///
/// Written out here because Eigen's blocked factorisations take memory from the heap from 32 rows on. Small
/// matrices go row by row, in registers; larger ones column by column (right-looking), whose inner loops run
/// down columns and vectorize. Golub and Van Loan, Matrix Computations, sections 4.1 and 4.2.
template <class S, int N>
[[nodiscard]] Status factor_ldlt(Eigen::Matrix<S, N, N>& A) {
  static_assert(N > 0 || N == Eigen::Dynamic, "the size must be positive");
  constexpr bool by_rows = N != Eigen::Dynamic && N <= detail::kLargestByRows;
  const int n = static_cast<int>(A.rows());  // N, unless that is Eigen::Dynamic
  const Eigen::Matrix<S, N, 1> diagonal = A.diagonal();
  Eigen::Matrix<S, N, 1> scaled = diagonal;  // L_jk D_k of row j, or L_ij D_j of column j
  for (int j = 0; j < n; ++j) {
    S pivot = A(j, j);
    if constexpr (by_rows) {
      for (int k = 0; k < j; ++k) {
        scaled(k) = A(j, k) * A(k, k);
        pivot -= A(j, k) * scaled(k);
      }
      A(j, j) = pivot;
    }
    if (const Status status = detail::status_of_pivot(pivot, diagonal(j), n); status != Status::ok)
      return status;
    S* const column = &A(0, j);
    if constexpr (by_rows) {
      for (int i = j + 1; i < n; ++i) {
        S sum = column[i];
        for (int k = 0; k < j; ++k) sum -= A(i, k) * scaled(k);
        column[i] = sum / pivot;
      }
    } else {
      const S inverse = S(1) / pivot;
      for (int i = j + 1; i < n; ++i) {
        scaled(i) = column[i];
        column[i] *= inverse;
      }
      for (int k = j + 1; k < n; ++k) {
        const S factor = column[k];
        S* const target = &A(0, k);
        for (int i = k; i < n; ++i) target[i] -= factor * scaled(i);
      }
    }
  }
  return Status::ok;
}

/// Solves A x = b in place, with A as factor_ldlt leaves it.
template <class S, int N, int K>
void solve_ldlt(const Eigen::Matrix<S, N, N>& A, Eigen::Matrix<S, K, 1>& x) {
  const int n = static_cast<int>(A.rows());
  for (int j = 0; j < n; ++j)
    for (int i = j + 1; i < n; ++i) x(i) -= A(i, j) * x(j);
  for (int i = 0; i < n; ++i) x(i) /= A(i, i);
  for (int i = n - 1; i >= 0; --i)
    for (int k = i + 1; k < n; ++k) x(i) -= A(k, i) * x(k);
}

namespace detail {

/// x = M^-1 (tau - x), given x = c; M is left as factor_ldlt leaves it. Both are spoilt unless the status is
/// ok.
template <class S, int N, int K>
[[nodiscard]] Status solve_for_rates(const Eigen::Matrix<S, K, 1>& tau, Eigen::Matrix<S, N, N>& mass,
                                     Eigen::Matrix<S, K, 1>& x) {
  x = tau - x;
  if (!all_finite(mass) || !all_finite(x)) return Status::not_finite;
  if (const Status status = factor_ldlt(mass); status != Status::ok) return status;
  solve_ldlt(mass, x);
  return all_finite(x) ? Status::ok : Status::not_finite;
}

/// Measured: of more speeds BranchSolver takes less time, of a chain too.
inline constexpr int kMostByFactor = 8;

/// x = M^-1 (tau - x), given x = c. Both are spoilt unless the status is ok; what becomes of `mass` is left open.
template <class M>
[[nodiscard]] Status rates_of(const SpeedVector<M>& tau, SpeedMatrix<M>& mass, SpeedVector<M>& x) {
  using S = typename M::Scalar;
  if constexpr (M::kNv > kMostByFactor && is_machine_number_v<S>) {
    x = tau - x;
    if (!all_finite(x)) return Status::not_finite;
    BranchSolver<S, SpeedTree<M>> solver;
    if (const Status status = solver.factor(mass); status != Status::ok) return status;
    solver.solve(x);
    return all_finite(x) ? Status::ok : Status::not_finite;
  } else {
    return solve_for_rates(tau, mass, x);
  }
}

/// x = M^-1 (tau - c) by the rows of M::Axes.
/// \param solver  which has factors of M
template <class M, class Solver>
[[nodiscard]] Status rates_by_axes(AxisState<M>& state, const Solver& solver, const SpeedVector<M>& tau,
                                   SpeedVector<M>& x) {
  typename AxisState<M>::Rows c;
  state.bias(c);
  for (int row = 0; row < M::kNv; ++row) x(row) = tau(state.speed(row)) - c(row);
  solver.solve(x);
  return all_finite(x) ? Status::ok : Status::not_finite;
}

/// qdd is left as it was unless the status is ok.
template <class M>
[[nodiscard]] Status rates_by_bodies(const CoordinateVector<M>& q, const SpeedVector<M>& qd,
                                     const SpeedVector<M>& tau, const typename M::Inputs& in,
                                     SpeedVector<M>& qdd) {
  AxisState<M> state(q, qd, in);
  ArticulatedSolver<M> solver;
  if (const Status status = solver.factor(state.tree()); status != Status::ok) return status;
  SpeedVector<M> x;
  if (const Status status = rates_by_axes<M>(state, solver, tau, x); status != Status::ok) return status;
  for (int row = 0; row < M::kNv; ++row) qdd(state.speed(row)) = x(row);
  return Status::ok;
}

/// Whether the largest of written rates tells that M is not singular. Zero does not: nothing drives what M leaves
/// open then.
template <class S>
bool is_ordinary_rate(S largest) {
  using std::sqrt;
  return largest > S(0) && largest < S(1) / sqrt(std::numeric_limits<S>::epsilon());
}

/// The generated forward dynamics has no checks. What a mass matrix that is not positive definite leads to, at
/// a singular state of coordinates, is not finite, large or, without driving forces, zero; then, and where
/// masses may be negative because parameters are arguments, M decides.
///
/// \return whether x are the rates
template <class M>
[[nodiscard]] bool written_rates([[maybe_unused]] const CoordinateVector<M>& q,
                                 [[maybe_unused]] const SpeedVector<M>& qd,
                                 [[maybe_unused]] const SpeedVector<M>& tau,
                                 [[maybe_unused]] const typename M::Inputs& in,
                                 [[maybe_unused]] SpeedVector<M>& x) {
  if constexpr (HasForwardDynamics<M>::value && RuntimeParameterCount<M>::value == 0) {
    x = M::forward_dynamics(q, qd, tau, in);
    return all_finite(x) && is_ordinary_rate(x.cwiseAbs().maxCoeff());
  } else {
    return false;
  }
}

}  // namespace detail

/// Checked forward dynamics: rates of the speeds under given forces, qdd = M(q)^-1 (tau - c(q, qd)), or why there
/// are none; as if there were no constraints (constrained_dynamics.hpp has those). The generated
/// M::forward_dynamics, which has no checks, is used where M has it and no runtime parameters, which may be
/// masses. Otherwise, and where that finds rates that are not finite, large or all zero, M is factored
/// and tells whether it is singular; of long chains with M::Axes by articulated bodies, without M.
///
/// The generated function keeps its digits closer to a singular state than M does. There, where forces move some
/// coordinates and leave alone what M leaves open, its rates may be the result, with ok: they solve
/// M qdd = tau - c, and change without bounds as the state does.
///
/// \param q    coordinates, n_q x 1
/// \param qd   speeds, n_v x 1
/// \param tau  generalized forces, n_v x 1, one per speed: N m for an angle, N for a length
/// \param in   time, runtime parameters, external wrenches
/// \param qdd  result, n_v x 1; left as it was unless the status is ok
/// \return     ok, or why there is no result. A sum that overflows counts as not_finite.
template <class M>
[[nodiscard]] Status forward_dynamics(const CoordinateVector<M>& q, const SpeedVector<M>& qd,
                                      const SpeedVector<M>& tau, const typename M::Inputs& in,
                                      SpeedVector<M>& qdd) {
  static_assert(is_mechanism_v<M>,
                "generate M with mass_matrix_and_bias and coordinate_rates (alembert/mechanism.hpp)");
  if (!detail::is_finite_state(in.t, q, qd)) return Status::not_finite;
  SpeedVector<M> x;
  if (detail::written_rates<M>(q, qd, tau, in, x)) {
    qdd = x;
    return Status::ok;
  }
  if constexpr (detail::kSolvesByBodies<M>) {
    return detail::rates_by_bodies<M>(q, qd, tau, in, qdd);
  } else {
    SpeedMatrix<M> mass;
    M::mass_matrix_and_bias(q, qd, in, mass, x);
    if (const Status status = detail::rates_of<M>(tau, mass, x); status != Status::ok) return status;
    qdd = x;
    return Status::ok;
  }
}

}  // namespace alembert
