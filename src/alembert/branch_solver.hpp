// Solves M X = B for many right-hand sides at once. In: a mass matrix. Out: its factors, without the zeros
// between branches, and solutions; or a status that says why there are none. No heap unless M is a HeapMatrix
// (matrix.hpp), no exceptions.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <utility>

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
  /// \param A  n x n; only the upper triangle is read
  /// \return   not_finite or not_positive_definite as of factor_ldlt
  template <class Square>
  [[nodiscard]] Status factor(const Square& A) {
    const S rounding = S(N) * std::numeric_limits<S>::epsilon();
    for (int k = 0; k < N; ++k) {
      S* const row = &rows_(0, k);
      for (int i = 0; i <= k; ++i) row[i] = A(i, k);
      for (int i = k + 1; i < kPadded; ++i) row[i] = S(0);
      carrying_count_[static_cast<std::size_t>(k)] = 0;
    }
    int carried = 0;
    for (int k = N; k-- > 0;) {
      const int first = carried;
      for (int i = k + 1; i < N; ++i) {
        if (rows_(k, i) == S(0)) continue;
        const S l = rows_(k, i) * inverse_pivot_[static_cast<std::size_t>(i)];
        carried_[static_cast<std::size_t>(carried++)] = {-l, i};
        carrying(i)[carrying_count_[static_cast<std::size_t>(i)]++] = {-l, k};
      }
      carried_end_[static_cast<std::size_t>(k)] = carried;
      // What lies beyond the diagonal is not used.
      if (carried > first)
        for (int at = 0; at <= k; at += 4 * kLanes)
          add_up_to_4(std::min(4, (k - at) / kLanes + 1), carried_.data() + first, carried - first,
                      &rows_(0, 0) + at, &rows_(0, k) + at);
      const S pivot = rows_(k, k);
      if (!is_finite(pivot)) return Status::not_finite;
      if (!(pivot > S(0)) || !(pivot > rounding * A(k, k))) return Status::not_positive_definite;
      inverse_pivot_[static_cast<std::size_t>(k)] = S(1) / pivot;
    }
    return Status::ok;
  }

  /// x = A^-1 x.
  void solve(Eigen::Matrix<S, N, 1>& x) const {
    for (int k = N - 1, e = 0; k-- > 0;) {
      S sum = x(k);
      for (; e < carried_end_[static_cast<std::size_t>(k)]; ++e)
        sum += carried_[static_cast<std::size_t>(e)].value * x(carried_[static_cast<std::size_t>(e)].row);
      x(k) = sum;
    }
    for (int k = 0; k < N; ++k) {
      S sum = x(k) * inverse_pivot_[static_cast<std::size_t>(k)];
      for (int e = 0; e < carrying_count_[static_cast<std::size_t>(k)]; ++e)
        sum += carrying(k)[e].value * x(carrying(k)[e].row);
      x(k) = sum;
    }
  }

  /// X = A^-1 X for each of these matrices, n x any, column by column one after the other in memory.
  template <class Columns>
  void solve(std::initializer_list<Columns*> matrices) const {
    alignas(64) S rows[N * kWidth];
    S* columns[kWidth];
    int width = 0;
    const auto finish = [&] {
      const auto of_block = [&](int first) { return std::clamp(width - first, 0, kLanes); };
      for (int first = 0; first < kWidth; first += kLanes)
        load(columns + first, of_block(first), rows + first);
      if (width > kWidth / 2) {
        sweep(rows, kAll);
      } else {
        sweep(rows, kHalf);
      }
      for (int first = 0; first < width; first += kLanes)
        store(rows + first, of_block(first), columns + first);
      width = 0;
    };
    for (Columns* const X : matrices)
      for (Eigen::Index j = 0; j < X->cols(); ++j) {
        columns[width] = &(*X)(0, j);
        if (++width == kWidth) finish();
      }
    if (width > 0) finish();
  }

 private:
  /// An entry of -L, and the row that it multiplies.
  struct Entry {
    S value;
    int row;
  };
  using Packet = typename Eigen::internal::packet_traits<S>::type;
  static constexpr int kLanes = Eigen::internal::unpacket_traits<Packet>::size;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wignored-attributes"
#endif
  using Block = Eigen::internal::PacketBlock<Packet, kLanes>;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
  /// Columns that are done together, in so many registers: sums that do not wait for each other.
  static constexpr std::make_index_sequence<8> kAll{};
  static constexpr std::make_index_sequence<4> kHalf{};
  static constexpr int kWidth = 8 * kLanes;
  static constexpr int kPadded = (N + kLanes - 1) / kLanes * kLanes;
  static constexpr std::size_t kMost = N > 1 ? static_cast<std::size_t>(N) * (N - 1) / 2 : 1;

  /// Row k of L: what carries k.
  Entry* carrying(int k) {
    return carrying_.data() + k * (k - 1) / 2;
  }
  const Entry* carrying(int k) const {
    return carrying_.data() + k * (k - 1) / 2;
  }

  /// Up to kLanes columns, and zeros for the others, turned into rows kWidth apart; and back.
  static void load(S* const* columns, int count, S* rows) {
    using namespace Eigen::internal;
    const bool whole = for_blocks(count, [&](int first) {
      Block block;
      for (int j = 0; j < kLanes; ++j) block.packet[j] = ploadu<Packet>(columns[j] + first);
      ptranspose(block);
      for (int i = 0; i < kLanes; ++i) pstoreu(rows + (first + i) * kWidth, block.packet[i]);
    });
    if (whole) return;
    for (int j = 0; j < kLanes; ++j)
      for (int i = 0; i < N; ++i) rows[i * kWidth + j] = j < count ? columns[j][i] : S(0);
  }
  static void store(const S* rows, int count, S* const* columns) {
    using namespace Eigen::internal;
    const bool whole = for_blocks(count, [&](int first) {
      Block block;
      for (int i = 0; i < kLanes; ++i) block.packet[i] = ploadu<Packet>(rows + (first + i) * kWidth);
      ptranspose(block);
      for (int j = 0; j < kLanes; ++j) pstoreu(columns[j] + first, block.packet[j]);
    });
    if (whole) return;
    for (int j = 0; j < count; ++j)
      for (int i = 0; i < N; ++i) columns[j][i] = rows[i * kWidth + j];
  }
  /// The first rows of square blocks of so many columns, the last of which may overlap the one before; false if
  /// there are none.
  template <class Do>
  static bool for_blocks(int count, const Do& block) {
    if (N < kLanes || count < kLanes) return false;
    int first = 0;
    for (; first + kLanes <= N; first += kLanes) block(first);
    if (first < N) block(N - kLanes);
    return true;
  }

  template <class Packets>
  void sweep(S* rows, Packets packets) const {
    for (int k = N, first = 0; k-- > 0;) {
      const int last = carried_end_[static_cast<std::size_t>(k)];
      if (last > first)
        add(packets, carried_.data() + first, last - first, S(1), rows, kWidth, rows + k * kWidth);
      first = last;
    }
    for (int k = 0; k < N; ++k)
      add(packets, carrying(k), carrying_count_[static_cast<std::size_t>(k)],
          inverse_pivot_[static_cast<std::size_t>(k)], rows, kWidth, rows + k * kWidth);
  }

  /// row = scale row + (entries times their rows, so far apart), for some packets.
  template <std::size_t... p>
  static void add(std::index_sequence<p...>, const Entry* entries, int count, S scale, const S* rows,
                  int stride, S* row) {
    using namespace Eigen::internal;
    const Packet factor = pset1<Packet>(scale);
    Packet x[] = {pmul(factor, ploadu<Packet>(row + p * kLanes))...};
    for (int e = 0; e < count; ++e) {
      const Packet l = pset1<Packet>(entries[e].value);
      const S* const from = rows + entries[e].row * stride;
      ((x[p] = pmadd(l, ploadu<Packet>(from + p * kLanes), x[p])), ...);
    }
    (pstoreu(row + p * kLanes, x[p]), ...);
  }

  static void add_up_to_4(int packets, const Entry* entries, int count, const S* rows, S* row) {
    switch (packets) {
      case 1:
        return add(std::make_index_sequence<1>(), entries, count, S(1), rows, kPadded, row);
      case 2:
        return add(std::make_index_sequence<2>(), entries, count, S(1), rows, kPadded, row);
      case 3:
        return add(std::make_index_sequence<3>(), entries, count, S(1), rows, kPadded, row);
      default:
        return add(std::make_index_sequence<4>(), entries, count, S(1), rows, kPadded, row);
    }
  }

  SizedMatrix<S, kPadded, N> rows_;  // row k of A, then of L times its pivot, in column k up to the diagonal
  std::array<S, static_cast<std::size_t>(N)> inverse_pivot_;
  std::array<Entry, kMost> carrying_, carried_;  // the other way round: what k carries, from the last row up
  std::array<int, static_cast<std::size_t>(N)> carrying_count_, carried_end_;
};

}  // namespace detail
}  // namespace alembert
