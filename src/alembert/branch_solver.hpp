// Solves M X = B for many right-hand sides at once. In: a mass matrix. Out: its factors, without the zeros
// between branches, and solutions; or a status that says why there are none. No heap unless M is a HeapMatrix
// (matrix.hpp), no exceptions.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <limits>

#include "alembert/floating_point.hpp"
#include "alembert/matrix.hpp"
#include "alembert/status.hpp"

namespace alembert {
namespace detail {

/// A = L^T D L for a symmetric positive definite A, from the last row up: where rows are speeds of a tree, each
/// joint after those that carry it, L keeps the zeros of A between branches. After Featherstone, Rigid Body
/// Dynamics Algorithms, 2008, section 6.5.
template <class S, int N>
class BranchSolver {
  static_assert(N > 0, "the size must be positive");

 public:
  /// \param A  n x n; only the upper triangle is read. It is spoilt.
  /// \return   not_finite or not_positive_definite as of factor_ldlt
  template <class Square>
  [[nodiscard]] Status factor(Square& A) {
    const S rounding = S(N) * std::numeric_limits<S>::epsilon();
    const Eigen::Matrix<S, N, 1> diagonal = A.diagonal();
    for (int k = N; k-- > 0;) {
      const S pivot = A(k, k);
      if (!is_finite(pivot)) return Status::not_finite;
      if (!(pivot > S(0)) || !(pivot > rounding * diagonal(k))) return Status::not_positive_definite;
      inverse_pivot_[static_cast<std::size_t>(k)] = S(1) / pivot;
      const S* const column = &A(0, k);
      for (int i = k; i-- > 0;) {
        if (column[i] == S(0)) continue;
        const S l = column[i] * inverse_pivot_[static_cast<std::size_t>(k)];
        S* const target = &A(0, i);
        for (int j = 0; j <= i; ++j) target[j] -= l * column[j];
        A(i, k) = l;
      }
    }
    // Column k above the diagonal is row k of L: what carries k. The other way round: what k carries.
    int carrying = 0, carried = 0;
    for (int k = 0; k < N; ++k) {
      for (int i = 0; i < k; ++i)
        if (A(i, k) != S(0)) carrying_[static_cast<std::size_t>(carrying++)] = {A(i, k), i};
      for (int i = k + 1; i < N; ++i)
        if (A(k, i) != S(0)) carried_[static_cast<std::size_t>(carried++)] = {A(k, i), i};
      carrying_end_[static_cast<std::size_t>(k)] = carrying;
      carried_end_[static_cast<std::size_t>(k)] = carried;
    }
    return Status::ok;
  }

  /// X = A^-1 X for each of these matrices, n x any, column by column one after the other in memory.
  template <class Columns>
  void solve(std::initializer_list<Columns*> matrices) const {
    alignas(64) S rows[N * kWidth];
    S* columns[kWidth];
    int width = 0;
    const auto finish = [&] {
      for (int j = width; j < kWidth; ++j)
        for (int i = 0; i < N; ++i) rows[i * kWidth + j] = S(0);
      sweep(rows);
      for (int j = 0; j < width; ++j)
        for (int i = 0; i < N; ++i) columns[j][i] = rows[i * kWidth + j];
      width = 0;
    };
    for (Columns* const X : matrices)
      for (Eigen::Index j = 0; j < X->cols(); ++j) {
        columns[width] = &(*X)(0, j);
        for (int i = 0; i < N; ++i) rows[i * kWidth + width] = columns[width][i];
        if (++width == kWidth) finish();
      }
    if (width > 0) finish();
  }

 private:
  struct Entry {
    S value;
    int row;
  };
  using Packet = typename Eigen::internal::packet_traits<S>::type;
  static constexpr int kLanes = Eigen::internal::unpacket_traits<Packet>::size;
  /// Columns that are done together, in four registers.
  static constexpr int kWidth = 4 * kLanes;
  static constexpr std::size_t kMost = N > 1 ? static_cast<std::size_t>(N) * (N - 1) / 2 : 1;

  void sweep(S* rows) const {
    int first = 0, last = carried_end_[static_cast<std::size_t>(N - 1)];
    for (int k = N; k-- > 0; last = first) {
      first = k == 0 ? 0 : carried_end_[static_cast<std::size_t>(k - 1)];
      subtract(carried_.data(), first, last, S(1), rows, rows + k * kWidth);
    }
    first = 0;
    for (int k = 0; k < N; ++k, first = last) {
      last = carrying_end_[static_cast<std::size_t>(k)];
      subtract(carrying_.data(), first, last, inverse_pivot_[static_cast<std::size_t>(k)], rows,
               rows + k * kWidth);
    }
  }

  /// row = scale row - (entries first ... last - 1 of L, times their rows).
  static void subtract(const Entry* entries, int first, int last, S scale, const S* rows, S* row) {
    using namespace Eigen::internal;
    const Packet factor = pset1<Packet>(scale);
    Packet x0 = pmul(factor, ploadu<Packet>(row)), x1 = pmul(factor, ploadu<Packet>(row + kLanes)),
           x2 = pmul(factor, ploadu<Packet>(row + 2 * kLanes)),
           x3 = pmul(factor, ploadu<Packet>(row + 3 * kLanes));
    for (int e = first; e < last; ++e) {
      const Packet l = pset1<Packet>(-entries[e].value);
      const S* const from = rows + entries[e].row * kWidth;
      x0 = pmadd(l, ploadu<Packet>(from), x0);
      x1 = pmadd(l, ploadu<Packet>(from + kLanes), x1);
      x2 = pmadd(l, ploadu<Packet>(from + 2 * kLanes), x2);
      x3 = pmadd(l, ploadu<Packet>(from + 3 * kLanes), x3);
    }
    pstoreu(row, x0);
    pstoreu(row + kLanes, x1);
    pstoreu(row + 2 * kLanes, x2);
    pstoreu(row + 3 * kLanes, x3);
  }

  std::array<S, static_cast<std::size_t>(N)> inverse_pivot_;
  std::array<Entry, kMost> carrying_, carried_;
  std::array<int, static_cast<std::size_t>(N)> carrying_end_, carried_end_;
};

}  // namespace detail
}  // namespace alembert
