// Linear equations of a mass matrix bordered by constraints, with rows that may depend on each other. In: M
// and P. Out: x and lambda with M x = b + P^T lambda and P x = r, the rank of P, which of its rows are
// redundant and which row contradicts the others. Sizes are fixed or dynamic; fixed ones take no heap unless
// a matrix is too large for the stack (matrix.hpp).
#pragma once

#include <cmath>
#include <limits>

#include "alembert/forward_dynamics.hpp"

namespace alembert {

/// The Schur complement of the factor of M, factored itself:
///
///   M = L D L^T,  Y = L^-1 P^T,  S = Y^T D^-1 Y = P M^-1 P^T,  S = G E G^T over the rows that are
///   independent.
///
/// S is factored by Gram-Schmidt's method with pivoting. A pivot of S over its diagonal entry is the square of the sine of
/// the angle, in the metric of M^-1, between a row of P and the rows taken before it. A row is *redundant* if
/// that is at most 16 max(n, k) epsilon (an angle of about 1e-7 in double precision), or if the row is zero:
/// shorter than 64 max(n, k) epsilon times the longest row, both over the lengths that the caller gives. A
/// redundant row gets the multiplier zero. Among rows that could be taken next, the first one of at least a
/// quarter of the best pivot is, so that of two equal rows the first stays.
///
/// Angles do not depend on the units of rows, speeds or masses. Which rows are zero does, on those of rows: where
/// all terms of a row cancel, as those of the axis of a hinge that closes a chain in a plane, what is left is as
/// independent as any row, and only beside other rows is it seen to be rounding. So the lengths say how long rows
/// are whose terms do not cancel, in the metric of M^-1 and relative to each other; generated mechanisms know them
/// (kRowLengths). Without them rows, positions and angles alike, may differ by 1 / (64 max(n, k) epsilon): about
/// 1e12 in double and 1e4 in single precision.
///
/// S scalar, N speeds n, K rows k of constraints; N and K may be Eigen::Dynamic.
/// Golub and Van Loan, Matrix Computations, 5.2.8 and 5.4.1; one step of refinement as in the corrected
/// semi-normal equations, Bjoerck, Linear Algebra and its Applications 88/89 (1987).
template <class S, int N, int K>
class ConstraintFactorization {
 public:
  using SpeedMatrix = SizedMatrix<S, N, N>;
  using SpeedVector = Eigen::Matrix<S, N, 1>;
  using ConstraintMatrix = SizedMatrix<S, K, N>;
  using ConstraintVector = Eigen::Matrix<S, K, 1>;
  using Flags = Eigen::Array<bool, K, 1>;

  /// \param M        n x n, symmetric, only the lower triangle is read
  /// \param P        k x n
  /// \param lengths  k x 1, positive: how long rows are, the longest 1
  /// \return         ok, or not_finite or not_positive_definite as factor_ldlt says of M
  [[nodiscard]] Status factor(const SpeedMatrix& M, const ConstraintMatrix& P) {
    return factor(M, P, ConstraintVector::Ones(P.rows()));
  }
  [[nodiscard]] Status factor(const SpeedMatrix& M, const ConstraintMatrix& P,
                              const ConstraintVector& lengths) {
    const int n = static_cast<int>(M.rows()), k = static_cast<int>(P.rows());
    if (!detail::all_finite(P)) return Status::not_finite;
    mass_ = M;
    lengths_ = lengths;
    if (const Status status = factor_ldlt(mass_); status != Status::ok) return status;
    Y_ = P.transpose();
    for (int r = 0; r < k; ++r)
      for (int j = 0; j < n; ++j)
        for (int i = j + 1; i < n; ++i) Y_(i, r) -= mass_(i, j) * Y_(j, r);
    rest_ = Y_;
    diagonal_.resize(k);
    for (int r = 0; r < k; ++r) diagonal_(r) = product(r, r);
    if (!detail::all_finite(diagonal_)) return Status::not_finite;
    factor_schur_complement(n, k);
    return Status::ok;
  }

  /// Number of independent rows.
  int rank() const { return rank_; }
  /// k flags: true for the rows that follow from the others.
  const Flags& redundant() const { return redundant_; }
  bool redundant(int row) const { return redundant_(row); }

  /// Solves M x = b + P^T lambda, P x = r.
  ///
  /// \param b       n x 1
  /// \param r       k x 1
  /// \param x       result, n x 1
  /// \param lambda  result, k x 1; zero for redundant rows
  /// \param motion  length sqrt(u^T M u) of the motion of which P x - r is a part, if b and r alone do not
  ///                tell
  /// \return        -1, or the redundant row that P x = r fails most: its right side does not follow from
  ///                the others'. It may fail by sqrt(16 max(n, k) epsilon) of the terms that it is made of,
  ///                lengths in the metric of M times the length of the row, and by 1024 epsilon in SI units
  ///                times the length that the caller gave. x and lambda then solve the other rows. Where such
  ///                a length overflows, x is NaN.
  int solve(const SpeedVector& b, const ConstraintVector& r, SpeedVector& x, ConstraintVector& lambda,
            S motion = S(0)) const {
    using std::abs;
    using std::sqrt;
    const int n = static_cast<int>(mass_.rows()), k = static_cast<int>(Y_.cols());
    // x = L^-T D^-1 (L^-1 b + Y lambda); `w` is L^T x.
    SpeedVector w = b;
    S squares(0);
    for (int j = 0; j < n; ++j)
      for (int i = j + 1; i < n; ++i) w(i) -= mass_(i, j) * w(j);
    for (int i = 0; i < n; ++i) {
      squares += w(i) * w(i) / mass_(i, i);
      w(i) /= mass_(i, i);
    }
    const S free_length = sqrt(squares);
    ConstraintVector residual, correction;
    lambda.setZero(k);
    for (int pass = 0; pass < 2; ++pass) {
      residual_of(w, r, residual);
      solve_schur_complement(residual, correction);
      lambda += correction;
      add_reaction(correction, w);
    }
    residual_of(w, r, residual);
    int worst_row = -1;
    if (rank_ < k) {
      SpeedVector reaction;
      reaction.setZero(n);
      add_reaction(lambda, reaction);
      squares = S(0);
      for (int i = 0; i < n; ++i) squares += reaction(i) * reaction(i) * mass_(i, i);
      const S length = free_length + sqrt(squares) + motion;
      if (!detail::is_finite(length)) {  // no row can be told from another then
        x.setConstant(n, std::numeric_limits<S>::quiet_NaN());
        return -1;
      }
      const S relative = sqrt(threshold(n, k)), floor = S(1024) * std::numeric_limits<S>::epsilon();
      S worst(1);
      for (int i = 0; i < k; ++i) {
        if (!redundant_(i)) continue;
        const S share =
            abs(residual(i)) / (relative * (abs(r(i)) + sqrt(diagonal_(i)) * length) + floor * lengths_(i));
        if (share > worst) {
          worst = share;
          worst_row = i;
        }
      }
    }
    x = w;
    for (int i = n - 1; i >= 0; --i)
      for (int j = i + 1; j < n; ++j) x(i) -= mass_(j, i) * x(j);
    return worst_row;
  }

 private:
  static S threshold(int n, int k) { return S(16) * S(n > k ? n : k) * std::numeric_limits<S>::epsilon(); }

  /// Of columns of rest_, in the metric of D^-1.
  S product(int r, int s) const {
    S sum(0);
    for (int i = 0; i < rest_.rows(); ++i) sum += rest_(i, r) * rest_(i, s) / mass_(i, i);
    return sum;
  }

  /// G and E of S = rest_^T D^-1 rest_ by modified Gram-Schmidt with pivoting: of rows that are nearly parallel, what
  /// the others leave keeps its digits, which a difference of entries of S would lose. Spoils rest_.
  void factor_schur_complement(int n, int k) {
    using std::sqrt;
    ConstraintVector left = diagonal_;
    factor_.setZero(k, k);
    pivots_.setZero(k);
    order_.setZero(k);
    redundant_.setConstant(k, true);
    rank_ = 0;
    S longest(0);
    const auto length = [&](int i) { return S(sqrt(diagonal_(i)) / lengths_(i)); };
    for (int i = 0; i < k; ++i) longest = length(i) > longest ? length(i) : longest;
    const S zero = S(4) * threshold(n, k) * longest;
    const auto share = [&](int i) { return length(i) > zero ? S(left(i) / diagonal_(i)) : S(0); };
    for (int step = 0; step < k; ++step) {
      S best(0);
      for (int i = 0; i < k; ++i)
        if (redundant_(i) && share(i) > best) best = share(i);
      if (!(best > threshold(n, k))) return;
      int chosen = 0;
      while (!redundant_(chosen) || !(S(4) * share(chosen) >= best) || !(share(chosen) > threshold(n, k)))
        ++chosen;
      const S pivot = left(chosen);
      redundant_(chosen) = false;
      order_(step) = chosen;
      pivots_(step) = pivot;
      for (int i = 0; i < k; ++i) {
        if (!redundant_(i)) continue;
        factor_(i, step) = product(i, chosen) / pivot;
        for (int j = 0; j < n; ++j) rest_(j, i) -= factor_(i, step) * rest_(j, chosen);
        left(i) = product(i, i);
      }
      rank_ = step + 1;
    }
  }

  /// S x = r over the independent rows; x is zero in the others.
  void solve_schur_complement(const ConstraintVector& r, ConstraintVector& x) const {
    x.setZero(r.rows());
    for (int a = 0; a < rank_; ++a) x(order_(a)) = r(order_(a));
    for (int a = 0; a < rank_; ++a)
      for (int b = a + 1; b < rank_; ++b) x(order_(b)) -= factor_(order_(b), a) * x(order_(a));
    for (int a = 0; a < rank_; ++a) x(order_(a)) /= pivots_(a);
    for (int a = rank_ - 1; a >= 0; --a)
      for (int b = a + 1; b < rank_; ++b) x(order_(a)) -= factor_(order_(b), a) * x(order_(b));
  }

  /// r - P x = r - Y^T w.
  void residual_of(const SpeedVector& w, const ConstraintVector& r, ConstraintVector& residual) const {
    residual = r;
    for (int i = 0; i < residual.rows(); ++i)
      for (int j = 0; j < w.rows(); ++j) residual(i) -= Y_(j, i) * w(j);
  }

  /// w += D^-1 Y lambda.
  void add_reaction(const ConstraintVector& lambda, SpeedVector& w) const {
    for (int j = 0; j < w.rows(); ++j) {
      S sum(0);
      for (int i = 0; i < lambda.rows(); ++i) sum += Y_(j, i) * lambda(i);
      w(j) += sum / mass_(j, j);
    }
  }

  SpeedMatrix mass_;                // L and D of M
  SizedMatrix<S, N, K> Y_;          // L^-1 P^T
  SizedMatrix<S, N, K> rest_;       // what those before leave of Y's columns
  SizedMatrix<S, K, K> factor_;     // G: rows as in P, columns in the order of the pivots
  ConstraintVector diagonal_;       // of S
  ConstraintVector lengths_;        // those that the caller gives
  ConstraintVector pivots_;         // E
  Eigen::Matrix<int, K, 1> order_;  // row of each pivot
  Flags redundant_;
  int rank_ = 0;
};

}  // namespace alembert
